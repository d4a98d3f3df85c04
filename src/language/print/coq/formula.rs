//! Formulas: what is true or false.

use super::super::super::syntax::{
    Argument, Formula, Function, Int, Interval, Item, Name, Over, Real, Relation, Side, Use,
};
use super::super::super::words::Word;
use super::number::{Level, Linear, compared, relation, sign_of, truncated, within};
use super::walk::{NotInCoq, Text, Walk, not_in_coq};

/// The same for propositions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Bind {
    /// The right of an arrow.
    Top,
    /// The left of an arrow.
    Arrow,
    /// Next to `/\`.
    And,
    /// Next to `~`.
    Not,
}

impl Walk<'_> {
    pub(super) fn formula(&mut self, of: &Formula, level: Bind) -> Text {
        Ok(match of {
            Formula::Chain(first, rest) => self.chain(first, rest, level)?,
            Formula::Within(x, interval) => {
                let x = self.real(x, Level::Top)?;
                let inside = self.interval(&x, interval)?;
                within(level == Bind::Not, inside)
            }
            Formula::Among(j, from, to) => {
                let (j, from, to) = (self.linear(j)?, self.linear(from)?, self.linear(to)?);
                let ends: Vec<_> =
                    [self.at_most(&from, &j), self.at_most(&j, &to)].into_iter().flatten().collect();
                within(ends.len() > 1, ends.join(" /\\ "))
            }
            Formula::Not(of) => format!("~ {}", self.formula(of, Bind::Not)?),
            Formula::And(all) => {
                let all: Result<Vec<_>, _> = all.iter().map(|one| self.formula(one, Bind::And)).collect();
                within(level > Bind::Top, all?.join(" /\\ "))
            }
            Formula::Or(all) => {
                let all: Result<Vec<_>, _> = all.iter().map(|one| self.formula(one, Bind::And)).collect();
                within(level > Bind::Top, all?.join(" \\/ "))
            }
            Formula::Implies(a, b) => {
                let a = self.formula(a, Bind::Arrow)?;
                let b = self.under("", std::slice::from_ref(&a), |walk| walk.formula(b, Bind::Top))?;
                within(level > Bind::Top, format!("{a} -> {b}"))
            }
            Formula::Iff(a, b) => {
                let (a, b) = (self.formula(a, Bind::And)?, self.formula(b, Bind::And)?);
                within(level > Bind::Top, format!("{a} <-> {b}"))
            }
            Formula::All(over, of) => {
                let (bound, assumed, of) = self.quantified(over, of, Bind::Top)?;
                let assumed: String = assumed.iter().map(|one| format!("{one} -> ")).collect();
                within(level > Bind::Top, format!("forall {bound}, {assumed}{of}"))
            }
            Formula::Some(over, of) => {
                let (bound, assumed, of) = self.quantified(over, of, Bind::And)?;
                let assumed: String = assumed.iter().map(|one| format!("{one} /\\ ")).collect();
                within(level > Bind::Top, format!("exists {bound}, {assumed}{of}"))
            }
            Formula::One(..) => return not_in_coq("that there is exactly one"),
            Formula::Word(of) => self.word(of, level)?,
            Formula::Instance(_) => return not_in_coq("which example is meant"),
            Formula::Claim { id, .. } => return not_in_coq(format!("the sentence {id}")),
        })
    }

    pub(super) fn quantified(
        &mut self,
        over: &Over,
        of: &Formula,
        level: Bind,
    ) -> Result<(String, Vec<String>, String), NotInCoq> {
        match over {
            Over::Integers(range) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                self.need_at_most(&Linear::default(), &from);
                let (name, of) = self.scoped(range, (&from, &to), |walk| walk.formula(of, level))?;
                let own = Linear::name(&name);
                let ends =
                    [self.at_most(&from, &own), self.at_most(&own, &to)].into_iter().flatten().collect();
                Ok((format!("{name} : nat"), ends, of))
            }
            Over::Reals(name, interval) => {
                let own = self.fresh(name);
                let inside = self.interval(&own, interval)?;
                let before = self.reals.insert(name.clone(), own.clone());
                let bound = format!("{own} : R");
                let of = self.under(&bound, std::slice::from_ref(&inside), |walk| walk.formula(of, level))?;
                self.unbind(name, &own, before);
                Ok((bound, vec![inside], of))
            }
        }
    }

    /// Of equalities every pair is meant; that neighbours are equal says as much where everything exists.
    pub(super) fn chain(&mut self, first: &Real, rest: &[(Relation, Real)], level: Bind) -> Text {
        let terms: Vec<&Real> = std::iter::once(first).chain(rest.iter().map(|(_, term)| term)).collect();
        let mut parts = Vec::new();
        if let ([Real::Index(name), Real::Infinity], [(sign, _)]) = (terms.as_slice(), rest)
            && &**name == "alpha"
        {
            return Ok(within(level == Bind::Not, relation(*sign, &self.ratio, "1")));
        }
        if let ([Real::Whole(Int::Word(of)), Real::Whole(dimension)], [(Relation::Equal, _)]) =
            (terms.as_slice(), rest)
            && let (Word::Rank, [Item::Int(degree)]) = (of.word, of.of.as_slice())
        {
            return Ok(within(level > Bind::Top, self.independent(degree, dimension)?));
        }
        if terms.iter().all(|term| matches!(term, Real::Whole(_))) {
            let mut values = Vec::new();
            for term in &terms {
                if let Real::Whole(int) = term {
                    values.push(self.linear(int)?);
                }
            }
            for ((sign, _), pair) in rest.iter().zip(values.windows(2)) {
                parts.push(compared(*sign, &pair[0], &pair[1]));
            }
        } else {
            let mut values = Vec::new();
            for term in &terms {
                values.push(self.real(term, Level::Top)?);
            }
            // a <= b < c is one term there.
            let rising = |sign: &Relation| matches!(sign, Relation::Less | Relation::AtMost);
            if let ([(one, _), (other, _)], [a, b, c]) = (rest, values.as_slice())
                && rising(one)
                && rising(other)
            {
                let (one, other) = (sign_of(*one), sign_of(*other));
                return Ok(within(level == Bind::Not, format!("{a} {one} {b} {other} {c}")));
            }
            for ((sign, _), pair) in rest.iter().zip(values.windows(2)) {
                parts.push(relation(*sign, &pair[0], &pair[1]));
            }
        }
        let several = parts.len() > 1;
        Ok(within((several && level > Bind::Top) || level == Bind::Not, parts.join(" /\\ ")))
    }

    /// The words that the theory defines.
    pub(super) fn word(&mut self, of: &Use, level: Bind) -> Text {
        match (of.word, of.of.as_slice()) {
            (Word::Rational, [Item::Expression(of, variable, Some(interval))]) => {
                self.on_interval("rational_on", of, variable, interval, level)
            }
            (Word::Smooth, [Item::Expression(of, variable, Some(interval))]) => {
                self.on_interval("smooth", of, variable, interval, level)
            }
            (Word::Defined, [Item::Real(Real::Value(function, at))]) => {
                let exists = self.expansion(function, at)?;
                Ok(within(level > Bind::Top, exists))
            }
            (other, _) => not_in_coq(format!("the word {}", other.name())),
        }
    }

    /// A property of a function on an open interval.
    pub(super) fn on_interval(
        &mut self,
        property: &str,
        of: &Real,
        variable: &Name,
        interval: &Interval,
        level: Bind,
    ) -> Text {
        if interval.from_closed || interval.to_closed {
            return not_in_coq("that on a closed interval");
        }
        let (from, to) = (self.real(&interval.from, Level::Atom)?, self.real(&interval.to, Level::Atom)?);
        let own = self.fresh(variable);
        let inside = self.interval(&own, interval)?;
        let before = self.reals.insert(variable.clone(), own.clone());
        let bound = format!("{own} : R");
        let body = self.under(&bound, std::slice::from_ref(&inside), |walk| walk.real(of, Level::Top))?;
        self.unbind(variable, &own, before);
        Ok(within(level == Bind::Not, format!("{property} {from} {to} (fun {own} => {body})")))
    }

    /// That a limit or a derivative from one side exists: the function has an expansion there.
    pub(super) fn expansion(&mut self, function: &Function, at: &Argument) -> Text {
        let basis = match function {
            Function::Derivative(of, Int::Number(1)) => of,
            other => other,
        };
        let (Function::Basis { i, degree }, Some(side), None) = (basis, at.side, &at.member) else {
            return not_in_coq("that this exists");
        };
        let (x, (d, i)) = (self.real(&at.at, Level::Atom)?, self.basis(i, degree.as_ref())?);
        let side = if side == Side::Left { "left" } else { "right" };
        let r = &self.ratio;
        Ok(format!("exists v l : R, {side}_taylor (G (wt {r} t) t {d} {i}) {x} v l"))
    }

    /// That the functions of a degree have as many dimensions as there are of them.
    pub(super) fn independent(&mut self, degree: &Int, dimension: &Int) -> Text {
        let (d, wanted) = (self.linear(degree)?, self.linear(dimension)?);
        let count = Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 };
        let count = count.added(&d.negated());
        if wanted.clone().added(&count.negated()) != Linear::default() {
            return not_in_coq("a dimension below the number of functions");
        }
        let (r, degree) = (self.ratio.clone(), self.index(degree)?);
        self.need_at_most(&d, &Linear::name("k"));
        let below = truncated(&count);
        Ok(format!(
            "forall c : nat -> R, (forall x : R, t 0%N <= x <= t m -> \\sum_(0 <= i < {below}) c i * value {r} t m {degree} i x = 0) -> forall i : nat, (i < {below})%N -> c i = 0"
        ))
    }
}
