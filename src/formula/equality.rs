//! Is an expression that somebody wrote a basis function? Decided exactly, or refuted at a point.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::analysis::{FormalBasis, FormalFunction, FormalPiece, Whose};
use crate::scalar::{Multivariate, Quotient, RationalAlgebra, Ring, integer, rational, rationals_between};
use crate::spline::Span;

use super::script::{Definition, Node, Script, ScriptError};

/// A point at which an expression is not the function.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// x.
    pub x: BigRational,
    /// α, where it is a symbol.
    pub alpha: Option<BigRational>,
    /// The value of the expression; `None` if it has none there.
    pub found: Option<BigRational>,
    /// The value of the function.
    pub expected: BigRational,
}

/// The highest degree of a numerator or a denominator in either letter: products of two have room in a [`Quotient`].
const DEGREE: usize = 60;
/// The longest coefficient, in bits.
const BITS: u64 = 100_000;
/// The most products of terms in all.
const WORK: usize = 20_000_000;

impl Script {
    /// A point where a definition is not G_i, on the whole line or on one span; `None` if it is G_i there.
    ///
    /// A quotient is what it is after all has been cancelled, as for Maxima: (x − 1)/(x − 1) is 1. With α as a symbol it is
    /// compared for every α < 0 and α > 1. At t_m a function has its limit from the left.
    ///
    /// # Errors
    /// [`ScriptError`] if the expression divides by 0, has too high a degree or too long numbers, takes too long, or has the
    /// letter α where α = ∞.
    pub fn counterexample(
        &self,
        definition: &Definition,
        formal: &FormalBasis,
        function: &FormalFunction,
        span: Option<Span>,
    ) -> Result<Option<Counterexample>, ScriptError> {
        let mut ends: Vec<_> = function.pieces.iter().flat_map(|p| [p.from.clone(), p.to.clone()]).collect();
        let domain = span.and_then(|span| formal.basis().knots().ends(span).ok());
        ends.extend(domain.iter().flat_map(|(from, to)| [(*from).clone(), (*to).clone()]));
        definition.body.ends(&mut ends);
        ends.sort();
        ends.dedup();
        if let Some((from, to)) = domain {
            ends.retain(|x| from <= x && x <= to);
        } else if let (Some(first), Some(last)) = (ends.first(), ends.last()) {
            // Beyond its ends an expression stays the same.
            let (before, after) = (first - integer(1), last + integer(1));
            ends.insert(0, before);
            ends.push(after);
        } else {
            ends = vec![integer(0), integer(1)];
        }
        let closed =
            |x: &BigRational| domain.is_none_or(|(_, to)| x < to || to == formal.basis().knots().last());
        let mut judge = Judge { script: self, formal, function, work: 0 };
        for (at, x) in ends.iter().enumerate() {
            if closed(x)
                && let Some(found) = judge.at_point(definition, x)?
            {
                return Ok(Some(found));
            }
            if let Some(next) = ends.get(at + 1)
                && let Some(found) = judge.between(definition, x, next)?
            {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }
}

struct Judge<'a> {
    script: &'a Script,
    formal: &'a FormalBasis,
    function: &'a FormalFunction,
    work: usize,
}

impl Judge<'_> {
    /// Candidates for α: the one there is, or simple ones on both sides of [0, 1].
    fn indices(&self) -> Vec<Option<BigRational>> {
        if !self.formal.is_symbolic() {
            return vec![None];
        }
        (1..=150).flat_map(|n| [rational(-n, 1), rational(n + 1, 1)].map(Some)).collect()
    }

    /// The quotient that the function is around x.
    fn function_around(&self, x: &BigRational) -> Result<Quotient, ScriptError> {
        match self.function.pieces.iter().find(|piece| piece.holds_at(x)) {
            Some(piece) => self.checked(quotient(piece), 0),
            None => Ok(Quotient::constant(&integer(0))),
        }
    }

    /// Looks at one point.
    fn at_point(
        &mut self,
        definition: &Definition,
        x: &BigRational,
    ) -> Result<Option<Counterexample>, ScriptError> {
        let found = value_at(&self.value(&definition.body, x, 0)?, x);
        let Some(expected) = value_at(&self.function_around(x)?, x) else {
            unreachable!("a piece has no pole where it holds")
        };
        if found.as_ref() == Some(&expected) {
            return Ok(None);
        }
        let at = |alpha: &BigRational, value: &Quotient| value.evaluate(alpha, |_| alpha.clone());
        for index in self.indices() {
            let alpha = index.clone().unwrap_or_else(|| integer(0));
            let Some(expected) = at(&alpha, &expected) else { continue };
            let value = found.as_ref().map(|value| at(&alpha, value));
            // Where what cancels is 0 there is nothing to see, but next to it.
            if value == Some(None) {
                continue;
            }
            let found = value.flatten();
            if found.as_ref() != Some(&expected) {
                return Ok(Some(Counterexample { x: x.clone(), alpha: index, found, expected }));
            }
        }
        unreachable!("two functions of α of degree up to {DEGREE} agree in less than 300 places")
    }

    /// Looks at every point between two: there the expression is one quotient, and so is the function.
    fn between(
        &mut self,
        definition: &Definition,
        from: &BigRational,
        to: &BigRational,
    ) -> Result<Option<Counterexample>, ScriptError> {
        let inside = (from + to) / integer(2);
        let found = self.value(&definition.body, &inside, 0)?;
        let expected = self.function_around(&inside)?;
        if found == expected {
            return Ok(None);
        }
        // Simple points first. The difference has few zeros, and so have the denominators.
        for index in self.indices() {
            let alpha = index.clone().unwrap_or_else(|| integer(0));
            for x in rationals_between(from, to).take(300) {
                let at = |value: &Quotient| {
                    value.evaluate(&x, |v| if v == FormalBasis::X { x.clone() } else { alpha.clone() })
                };
                if let (Some(found), Some(expected)) = (at(&found), at(&expected))
                    && found != expected
                {
                    return Ok(Some(Counterexample { x, alpha: index, found: Some(found), expected }));
                }
            }
        }
        unreachable!("two quotients of degree up to {DEGREE} agree in less than 300 places")
    }

    /// The quotient that an expression is around x.
    fn value(&mut self, node: &Node, x: &BigRational, place: usize) -> Result<Quotient, ScriptError> {
        let fail = |message: &str| ScriptError::at(&self.script.text, place, message);
        Ok(match node {
            Node::Number(value) => Quotient::constant(value),
            Node::X => Quotient::variable(FormalBasis::X),
            Node::Alpha | Node::Ratio => {
                let ratio = *node == Node::Ratio;
                match self.formal.basis().weights() {
                    Whose::EveryIndex => {
                        let alpha = Quotient::variable(FormalBasis::ALPHA);
                        let below = alpha.minus(&alpha.one());
                        if ratio { alpha.over(&below).unwrap_or(alpha) } else { alpha }
                    }
                    Whose::Index(index) if ratio => Quotient::constant(index.ratio()),
                    Whose::Index(index) => match index.alpha() {
                        Some(alpha) => Quotient::constant(&alpha),
                        None => return Err(fail("α is infinite here: `alpha` is no number")),
                    },
                    Whose::Member(member) => {
                        let message = format!(
                            "the functions are those of {member}, which have no index: write a number"
                        );
                        return Err(fail(&message));
                    }
                }
            }
            Node::At(place, node) => self.value(node, x, *place)?,
            Node::Negative(node) => self.value(node, x, place)?.negate(),
            Node::Sum(terms) => {
                let mut sum = Quotient::constant(&integer(0));
                for (minus, term) in terms {
                    let term = self.value(term, x, place)?;
                    self.spend(&sum, &term, place)?;
                    sum = self.checked(if *minus { sum.minus(&term) } else { sum.plus(&term) }, place)?;
                }
                sum
            }
            Node::Product(factors) => {
                let mut product = Quotient::constant(&integer(1));
                for (over, factor, place) in factors {
                    let factor = self.value(factor, x, *place)?;
                    product = self.product(&product, &factor, *over, *place)?;
                }
                product
            }
            Node::Power(base, exponent) => {
                let base = self.value(base, x, place)?;
                let mut power = base.one();
                for _ in 0..exponent.unsigned_abs() {
                    power = self.product(&power, &base, *exponent < 0, place)?;
                }
                power
            }
            Node::Choice(branches, otherwise) => {
                let chosen = branches.iter().find(|(condition, _)| condition.holds(x));
                self.work = self.work.saturating_add(branches.len());
                self.value(chosen.map_or(otherwise, |(_, node)| node), x, place)?
            }
        })
    }

    fn product(
        &mut self,
        left: &Quotient,
        right: &Quotient,
        over: bool,
        place: usize,
    ) -> Result<Quotient, ScriptError> {
        self.spend(left, right, place)?;
        let product = if over { left.over(right) } else { Some(left.times(right)) };
        let product = product
            .ok_or_else(|| ScriptError::at(&self.script.text, place, "the divisor is 0, for every x"))?;
        self.checked(product, place)
    }

    /// Is there time for an operation? All costs something.
    fn spend(&mut self, left: &Quotient, right: &Quotient, place: usize) -> Result<(), ScriptError> {
        let size = |q: &Quotient| {
            let factors = q.factors().map(|(factor, power)| factor.terms().len() * power);
            1 + q.numerator().terms().len() + factors.sum::<usize>()
        };
        self.work = self.work.saturating_add(size(left).saturating_mul(size(right)));
        if self.work > WORK {
            let message =
                "the expression takes too long to compare: write it shorter, or compare one span with --span";
            return Err(ScriptError::at(&self.script.text, place, message));
        }
        Ok(())
    }

    /// The value, if it is not too large to go on with.
    fn checked(&self, value: Quotient, place: usize) -> Result<Quotient, ScriptError> {
        let degree = |v: usize| {
            let below: usize = value.factors().map(|(factor, power)| factor.degree_in(v) * power).sum();
            below.max(value.numerator().degree_in(v))
        };
        let high = degree(FormalBasis::X).max(degree(FormalBasis::ALPHA));
        let long = value.numerator().terms().map(|(_, c)| c.bits()).max().unwrap_or(0);
        let message = match (high > DEGREE, long.max(value.divisor().bits()) > BITS) {
            (true, _) => {
                format!("the degree is too high to compare: {high}, and at most {DEGREE} is possible")
            }
            (_, true) => format!("the numbers are too long to compare: more than {BITS} bits"),
            _ => return Ok(value),
        };
        Err(ScriptError::at(&self.script.text, place, message))
    }
}

/// The piece as a quotient with its known factors.
fn quotient(piece: &FormalPiece) -> Quotient {
    let content = BigRational::from_integer(piece.denominator.content().clone());
    let factors = piece.denominator.factors().iter().flat_map(|(factor, power)| vec![factor; *power]);
    let divisors = factors.map(|factor| Quotient::from_polynomial(factor.clone()));
    let mut quotient = Quotient::from_polynomial(piece.numerator.expanded());
    for divisor in divisors.chain([Quotient::constant(&content)]) {
        quotient = match quotient.over(&divisor) {
            Some(quotient) => quotient,
            None => unreachable!("a denominator has no factor 0"),
        };
    }
    quotient
}

/// The value at x, a function of α, after what vanishes in both the numerator and the denominator there is cancelled.
/// `None` at a pole.
fn value_at(quotient: &Quotient, x: &BigRational) -> Option<Quotient> {
    let (mut above, mut below) = (quotient.numerator().clone(), quotient.denominator());
    let root = Multivariate::variable(FormalBasis::X)
        .scaled(x.denom())
        .minus(&Multivariate::constant(BigInt::clone(x.numer())));
    while let (Some(a), Some(b)) = (above.divided_by(&root), below.divided_by(&root)) {
        if a.is_zero() {
            return Some(Quotient::constant(&integer(0)));
        }
        (above, below) = (a, b);
    }
    let like = Quotient::constant(x);
    let at = |p: &Multivariate| {
        p.evaluate(&like, |v| {
            if v == FormalBasis::X { like.clone() } else { Quotient::variable(FormalBasis::ALPHA) }
        })
    };
    at(&above).over(&at(&below))
}
