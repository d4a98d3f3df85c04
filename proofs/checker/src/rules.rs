//! The rules: does this one prove that formula?

use crate::error::Reason;
use crate::integer::Scope;
use crate::number::Ratio;
use crate::poly::{Poly, Sign};
use crate::section::{Section, U, Values};
use crate::syntax::{Formula, Options, Place, PlaceKind, Rule, Term};
use crate::terms::{Evaluator, Mode};

/// What a formula or a rule of a section is about.
pub(crate) struct Context<'a> {
    pub(crate) section: &'a Section<'a>,
    pub(crate) values: &'a Values,
    /// The equations proved so far, by label.
    pub(crate) lemmas: &'a [(i64, &'a Formula)],
}

impl Rule {
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Rule::By(_) => "by",
            Rule::Split(..) => "split",
            Rule::Orders => "orders",
            Rule::Functional(_) => "functional",
            Rule::Evaluate => "evaluate",
        }
    }
}

impl Context<'_> {
    /// The formula is read with the integers of `scope`, the rule with those of the section.
    pub(crate) fn prove(&self, formula: &Formula, scope: &mut Scope, rule: &Rule) -> Result<(), Reason> {
        match (formula, rule) {
            (Formula::Equal(a, b), Rule::By(options)) => self.equal(a, b, scope, options),
            (Formula::Greater(a, b), Rule::By(_) | Rule::Split(..)) => {
                self.compare(a, b, scope, rule, Sign::Positive)
            }
            (Formula::AtLeast(a, b), Rule::By(_) | Rule::Split(..)) => {
                self.compare(a, b, scope, rule, Sign::Nonnegative)
            }
            (Formula::Defined(term), Rule::By(options))
                if options.functions.is_none() && options.using.is_empty() =>
            {
                // A denominator without a sign would have ended the evaluation.
                self.evaluator(options, true).term(term, scope, self.values).map(|_| ())
            }
            (Formula::Order(i, d, place, claimed), Rule::Orders) => {
                if place.kind != PlaceKind::In {
                    return Err(Reason::Inside);
                }
                let mut evaluator = Evaluator::new(self.section, Mode::default());
                let spot = evaluator.spot(place, scope, self.values)?;
                let order = evaluator.order(scope.value(i)?, scope.value(d)?, &spot, U)?;
                if order == scope.value(claimed)? { Ok(()) } else { Err(Reason::Order(order)) }
            }
            (Formula::Outside(place, term, list), Rule::Functional(pairs)) => {
                self.inside(place, scope)?;
                self.outside(term, list, scope, pairs)
            }
            (Formula::Pole(place, list, point), Rule::Evaluate) => {
                self.inside(place, scope)?;
                self.pole(list, scope, point)
            }
            _ => Err(Reason::WrongRule),
        }
    }

    fn evaluator(&self, options: &Options, equation: bool) -> Evaluator<'_> {
        Evaluator::new(
            self.section,
            Mode { weights: options.weights, functions: options.functions, equation },
        )
    }

    fn equal(&self, a: &Term, b: &Term, scope: &mut Scope, options: &Options) -> Result<(), Reason> {
        let mut evaluator = self.evaluator(options, true);
        let difference = |evaluator: &mut Evaluator<'_>, a, b, scope: &mut Scope| {
            let left = evaluator.term(a, scope, self.values)?;
            left.minus(&evaluator.term(b, scope, self.values)?)
        };
        let mut rest = difference(&mut evaluator, a, b, scope)?;
        for (label, factor) in &options.using {
            let mut scope = self.section.scope.clone();
            let (left, right) = match self.lemmas.iter().find(|(known, _)| known == label) {
                Some((_, Formula::Equal(left, right))) => (left, right),
                Some(_) => return Err(Reason::NoEquation(*label)),
                None => return Err(Reason::NoLemma(*label)),
            };
            let factor = evaluator.term(factor, &mut scope, self.values)?;
            rest = rest.minus(&factor.times(&difference(&mut evaluator, left, right, &mut scope)?)?)?;
        }
        if rest.is_zero() { Ok(()) } else { Err(Reason::Differ) }
    }

    /// a − b is at least as positive as `want` says.
    fn compare(&self, a: &Term, b: &Term, scope: &mut Scope, rule: &Rule, want: Sign) -> Result<(), Reason> {
        let none = Options::default();
        let options = if let Rule::By(options) = rule { options } else { &none };
        if !options.using.is_empty() {
            return Err(Reason::WrongRule);
        }
        let mut evaluator = self.evaluator(options, false);
        let left = evaluator.term(a, scope, self.values)?;
        let difference = left.minus(&evaluator.term(b, scope, self.values)?)?;
        match rule {
            Rule::Split(..) => self.split(&difference.num, &evaluator.signs, rule, want),
            _ => show(&difference.num, &evaluator.signs, want),
        }
    }

    fn split(&self, num: &Poly, signs: &[Sign], rule: &Rule, want: Sign) -> Result<(), Reason> {
        match rule {
            Rule::By(Options { weights: None, functions: None, using }) if using.is_empty() => {
                show(num, signs, want)
            }
            Rule::Split(at, bound, first, second) => {
                let variable = self.section.find(at, &self.section.scope)?;
                let mut signs = signs.to_vec();
                match signs.get_mut(variable) {
                    Some(sign) if *sign != Sign::Real => {
                        self.split(&num.below(variable, bound)?, &signs, first, want)?;
                    }
                    _ => return Err(Reason::Split(at.0.clone())),
                }
                // What is left of the parameter beyond the bound may be 0.
                if let Some(sign) = signs.get_mut(variable) {
                    *sign = Sign::Nonnegative;
                }
                self.split(&num.beyond(variable, bound)?, &signs, second, want)
            }
            _ => Err(Reason::WrongRule),
        }
    }

    /// The place is a span that is not empty, with u free on it.
    fn inside(&self, place: &Place, scope: &Scope) -> Result<(), Reason> {
        let evaluator = Evaluator::new(self.section, Mode::default());
        evaluator.spot(place, scope, self.values)?;
        if place.kind == PlaceKind::In { Ok(()) } else { Err(Reason::Inside) }
    }

    /// Numerator and denominator of a function of u alone.
    fn function(&self, term: &Term, scope: &mut Scope) -> Result<(Poly, Poly), Reason> {
        let value = Evaluator::new(self.section, Mode::default()).term(term, scope, self.values)?;
        let (den, num) = (value.denominator()?, value.num);
        if num.is_only_in(U) && den.is_only_in(U) { Ok((num, den)) } else { Err(Reason::NotOnlyU) }
    }

    /// Some functional that is 0 on the list is not 0 for the term: it is no combination of the list.
    fn outside(
        &self,
        term: &Term,
        list: &[Term],
        scope: &mut Scope,
        pairs: &[(Ratio, Ratio)],
    ) -> Result<(), Reason> {
        for (position, term) in std::iter::once(term).chain(list).enumerate() {
            let (num, den) = self.function(term, scope)?;
            let mut sum = Ratio::zero();
            for (factor, point) in pairs {
                let (above, below) = (num.at(U, point)?, den.at(U, point)?);
                if below.is_zero() {
                    return Err(Reason::NoValue(position));
                }
                sum = sum.plus(&factor.times(&above.over(&below)?)?)?;
            }
            match (position, sum.is_zero()) {
                (0, true) => return Err(Reason::Vanishes),
                (1.., false) => return Err(Reason::Functional(position)),
                _ => {}
            }
        }
        Ok(())
    }

    fn pole(&self, list: &[Term], scope: &mut Scope, point: &Ratio) -> Result<(), Reason> {
        let mut found = false;
        for term in list {
            let (num, den) = self.function(term, scope)?;
            found |= den.at(U, point)?.is_zero() && !num.at(U, point)?.is_zero();
        }
        if found { Ok(()) } else { Err(Reason::NoPole) }
    }
}

fn show(num: &Poly, signs: &[Sign], want: Sign) -> Result<(), Reason> {
    match num.sign(signs) {
        sign if sign >= want => Ok(()),
        Sign::Nonnegative => Err(Reason::Signs("no monomial in positive parameters only")),
        _ => Err(Reason::Signs("a coefficient below 0, or a real parameter")),
    }
}
