//! A sentence as a proposition of Coq, over the definitions of `proofs/theory`: U is `t`, of which `t_0, …, t_m` count, α is its
//! slope ratio `r`, G_i^d(x) is `value r t m d i x`.
//!
//! Integers are natural numbers there, in which 0 − 1 is 0, and every G_i exists. So a sentence is printed twice: what it says,
//! and that everything exists that it names (`defined`): indices are in their ranges, nothing is divided by 0.

mod formula;
mod number;
mod term;
mod walk;

use std::collections::BTreeMap;

use super::super::syntax::{Adjective, Binder, Definition, Sentence};
use formula::Bind;
use number::{Linear, relation};
use walk::{Walk, not_in_coq};

pub use walk::{NotInCoq, Proposition};

/// The proposition that a sentence is, with the definitions of its file put in.
///
/// # Errors
/// [`NotInCoq`], if it names what the theory does not define.
pub fn coq(sentence: &Sentence, definitions: &[Definition]) -> Result<Proposition, NotInCoq> {
    let mut walk = Walk {
        definitions,
        open: Vec::new(),
        integers: BTreeMap::new(),
        reals: BTreeMap::new(),
        names: ["r", "k", "n", "m", "t", "R"].map(str::to_owned).to_vec(),
        ratio: "r".to_owned(),
        steps: Vec::new(),
    };
    walk.bind("r : R".to_owned());
    walk.assume("0 < r".to_owned());
    for binder in &sentence.given {
        walk.binder(binder)?;
    }
    for formula in &sentence.assume {
        let assumed = walk.formula(formula, Bind::Arrow)?;
        walk.assume(assumed);
    }
    let then: Result<Vec<_>, _> = sentence.then.iter().map(|one| walk.formula(one, Bind::And)).collect();
    let conclusion = then?.join(" /\\\n  ");
    Ok(walk.proposition(&conclusion))
}

impl Walk<'_> {
    fn binder(&mut self, of: &Binder) -> Result<(), NotInCoq> {
        match of {
            Binder::Degree { least, most } => {
                self.bind("k : nat".to_owned());
                if *least > 0 {
                    self.assume(format!("({least} <= k)%N"));
                }
                if let Some(most) = most {
                    self.assume(format!("(k <= {most})%N"));
                }
            }
            Binder::Knots(adjectives) => {
                self.bind("(n m : nat) (t : nat -> R)".to_owned());
                self.assume("m = (n + k.+1)%N".to_owned());
                self.assume("knots t m".to_owned());
                for adjective in adjectives {
                    self.assume(said_of_knots(*adjective).to_owned());
                }
            }
            Binder::Integer(range) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                self.need_at_most(&Linear::default(), &from);
                let name = self.fresh(&range.name);
                self.bind(format!("{name} : nat"));
                let own = Linear::name(&name);
                self.integers.insert(range.name.clone(), own.clone());
                let ends = [self.at_most(&from, &own), self.at_most(&own, &to)];
                ends.into_iter().flatten().for_each(|end| self.assume(end));
            }
            Binder::Point(name, interval) => {
                let own = self.fresh(name);
                let inside = self.interval(&own, interval)?;
                self.bind(format!("{own} : R"));
                self.reals.insert(name.clone(), own);
                self.assume(inside);
            }
            Binder::Real { name, sign } => {
                let own = self.fresh(name);
                self.bind(format!("{own} : R"));
                self.reals.insert(name.clone(), own.clone());
                if let Some(sign) = sign {
                    self.assume(relation(*sign, &own, "0"));
                }
            }
            Binder::Points(name) => {
                let own = self.fresh(name);
                self.bind(format!("{own} : nat -> R"));
                self.reals.insert(name.clone(), own);
            }
            Binder::Gaps(_) => return not_in_coq("knots by their gaps"),
            Binder::Instances(_) | Binder::Indices(_) => return not_in_coq("which example is meant"),
            Binder::Index(_) => return not_in_coq("two indices that are free"),
        }
        Ok(())
    }
}

fn said_of_knots(adjective: Adjective) -> &'static str {
    match adjective {
        Adjective::Open => "Uopen t n k",
        Adjective::Clamped => "Uclamped t n k",
        Adjective::Symmetric => "Usymmetric t n k",
        Adjective::Simple => "Usimple t m",
        Adjective::Equidistant => "Uequidistant t m",
        Adjective::Bernstein => "Ubernstein t n k",
        Adjective::Inner => "Uinner t n k",
        Adjective::Interior => "Uinterior t n k",
    }
}
