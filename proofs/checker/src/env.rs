//! The names that are known at a place of a certificate, integer expressions, and lists with `each`.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::error::{Reason, Result};
use crate::family::Family;
use crate::fraction::Fraction;
use crate::poly::Poly;
use crate::token::{Kind, Node};
use crate::work::{keep, spend};

/// No integer of a certificate is larger: indices and degrees are small, and nothing can overflow.
const LARGEST: i64 = 1_000_000;
/// The steps of all `each` in the copies of a section for one degree, and the elements that they make, are so many at
/// most.
const STEPS: usize = 100_000;

/// What a name stands for.
#[derive(Clone)]
pub(crate) enum Meaning {
    /// A parameter: a variable of the polynomials.
    Variable(usize),
    /// An abbreviation, or what `u` or a parameter of the family has been replaced by.
    Value(Rc<Fraction>),
    Window(Rc<Window>),
}

/// The known part of a knot vector.
pub(crate) struct Window {
    pub(crate) name: String,
    pub(crate) first: i64,
    /// Measured from the first one, times the scale.
    pub(crate) knots: Vec<Poly>,
    /// A positive number, the same for all windows: equal weights in two of them are the same polynomials.
    pub(crate) scale: Poly,
    /// Those parameters of the family that belong to its knots, by name, index of the knot, and degree.
    pub(crate) parameters: Rc<Own>,
}

/// The parameters of a window.
pub(crate) type Own = BTreeMap<(String, Vec<i64>), Fraction>;

impl Window {
    pub(crate) fn knot(&self, index: i64) -> Result<&Poly> {
        let at = usize::try_from(index - self.first).ok();
        let unknown = || Reason::NotDetermined(self.name.clone(), format!("t_{index}"));
        at.and_then(|at| self.knots.get(at)).ok_or_else(unknown)
    }

    pub(crate) fn parameter(&self, name: &str, indices: &[i64]) -> Result<Fraction> {
        let known = self.parameters.get(&(name.to_owned(), indices.to_vec())).cloned();
        known.ok_or_else(|| Reason::NotDetermined(self.name.clone(), format!("{name} {indices:?}")))
    }
}

/// All names, those with indices once for every choice of them.
#[derive(Clone)]
pub(crate) struct Env<'t> {
    pub(crate) family: Rc<Family<'t>>,
    /// The member that a reflection leads to: the window where the parameters were before, and the index of t_m there.
    pub(crate) dual: Option<(&'t str, i64)>,
    names: Rc<BTreeMap<(&'t str, Vec<i64>), Meaning>>,
    integers: Vec<(&'t str, i64)>,
    steps: Rc<Cell<usize>>,
}

impl<'t> Env<'t> {
    pub(crate) fn new(family: Rc<Family<'t>>) -> Self {
        Env { family, dual: None, names: Rc::default(), integers: Vec::new(), steps: Rc::default() }
    }

    /// No name hides another, nor what a gap is called. With other indices it may come back, but not as the name of something without.
    pub(crate) fn check_free(&self, name: &'t str, indices: &[i64]) -> Result<()> {
        // Whoever looks a name up goes through those of the integers.
        spend(1 + self.integers.len())?;
        let first = self.names.range((name, Vec::new())..).next().filter(|((known, _), _)| *known == name);
        let fits = first.is_none_or(|((_, first), _)| !first.is_empty() && !indices.is_empty());
        let again = self.names.contains_key(&(name, indices.to_vec()));
        let word = matches!(name, "any" | "some");
        let free = !word && fits && !again && self.integers.iter().all(|(known, _)| *known != name);
        if free { Ok(()) } else { Err(Reason::Taken(name.to_owned())) }
    }

    /// Another meaning than before, if there was one.
    pub(crate) fn set(&mut self, name: &'t str, indices: Vec<i64>, is: Meaning) -> Result<()> {
        if Rc::strong_count(&self.names) > 1 {
            keep(self.names.len())?;
        }
        Rc::make_mut(&mut self.names).insert((name, indices), is);
        Ok(())
    }

    pub(crate) fn meaning(&self, name: &'t str, indices: Vec<i64>) -> Result<&Meaning> {
        self.names.get(&(name, indices)).ok_or_else(|| Reason::Unknown(name.to_owned()))
    }

    pub(crate) fn value(&self, name: &'t str, indices: Vec<i64>) -> Result<Fraction> {
        match self.meaning(name, indices)? {
            Meaning::Variable(index) => Ok(Poly::variable(*index).into()),
            Meaning::Value(value) => spend(value.size()).map(|()| value.as_ref().clone()),
            Meaning::Window(_) => Err(Reason::Unknown(name.to_owned())),
        }
    }

    pub(crate) fn window(&self, name: &Node<'t>) -> Result<&Rc<Window>> {
        let name = name.name()?;
        match self.meaning(name, Vec::new())? {
            Meaning::Window(window) => Ok(window),
            _ => Err(Reason::Unknown(name.to_owned())),
        }
    }

    pub(crate) fn integer(&self, node: &Node<'t>) -> Result<i64> {
        spend(1 + self.integers.len())?;
        match &node.kind {
            Kind::Number(..) => return small(node.whole()?),
            Kind::Name(name) => {
                let known = self.integers.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
                return known.ok_or_else(|| Reason::Unknown((*name).to_owned()));
            }
            _ => {}
        }
        let (head, parts) = node.headed("an integer")?;
        let values = self.integers(parts)?;
        match (head, values.as_slice()) {
            ("+", [_, ..]) => values.iter().try_fold(0, |sum, part| small(sum + part)),
            ("*", [_, ..]) => values.iter().try_fold(1, |product, part| small(product * part)),
            ("-", [a, b]) => small(a - b),
            ("binomial", [n, m]) => binomial(*n, *m),
            _ => node.wrong("an integer"),
        }
    }

    pub(crate) fn integers(&self, nodes: &[Node<'t>]) -> Result<Vec<i64>> {
        nodes.iter().map(|node| self.integer(node)).collect()
    }

    /// One integer more.
    pub(crate) fn with(&self, name: &'t str, value: i64) -> Result<Self> {
        self.check_free(name, &[])?;
        self.step(1)?;
        let mut env = self.clone();
        env.integers.push((name, value));
        Ok(env)
    }

    /// So many elements more in the copies of this section.
    fn step(&self, count: usize) -> Result<()> {
        self.steps.set(self.steps.get().saturating_add(count));
        if self.steps.get() > STEPS { Err(Reason::Limits("the expansion")) } else { Ok(()) }
    }

    /// One integer more, once for every value in LO ≤ NAME ≤ HI.
    pub(crate) fn each(&self, name: &Node<'t>, low: &Node<'t>, high: &Node<'t>) -> Result<Vec<Self>> {
        let name = name.name()?;
        (self.integer(low)?..=self.integer(high)?).map(|value| self.with(name, value)).collect()
    }

    /// The elements of a list, those in `each` repeated, with the names that each of them sees.
    pub(crate) fn expand<'n>(&self, items: &'n [Node<'t>]) -> Result<Vec<(&'n Node<'t>, Self)>> {
        let mut found = Vec::new();
        for item in items {
            match item.headed("") {
                Ok(("each", [name, low, high, inside @ ..])) if !inside.is_empty() => {
                    for env in self.each(name, low, high)? {
                        let inside = env.expand(inside)?;
                        self.step(inside.len())?;
                        found.extend(inside);
                    }
                }
                Ok(("each", _)) => return item.wrong("a name, two integers and what is repeated"),
                _ => found.push((item, self.clone())),
            }
        }
        Ok(found)
    }
}

/// Two integers in the limits have a product that fits, so it is enough to look after every step.
pub(crate) fn small(value: i64) -> Result<i64> {
    if (-LARGEST..=LARGEST).contains(&value) { Ok(value) } else { Err(Reason::Limits("an integer")) }
}

/// The number of choices of m among n ≥ 0; 0 for m < 0 and for m > n.
pub(crate) fn binomial(n: i64, m: i64) -> Result<i64> {
    // Every partial product is a binomial coefficient: the division leaves no rest.
    let choose = |value: i64, step: i64| small(value * (n - step + 1) / step);
    match n {
        ..0 => Err(Reason::Limits("the upper number of a binomial")),
        _ if m < 0 || m > n => Ok(0),
        _ => (1..=m.min(n - m)).try_fold(1, choose),
    }
}
