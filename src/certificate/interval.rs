//! The weights of a family on an interval, as quotients in all parameters.

use crate::language::{Family, Int, Name, Real};
use crate::scalar::{BigRational, Jet, Quotient, RationalAlgebra, Ring, integer};

use super::error::{Evaluated, EvaluationError};

/// The interval of a weight, in a unit of length: all of it as jets in x.
pub(super) struct Interval {
    pub(super) x: Jet<Quotient>,
    pub(super) a: Jet<Quotient>,
    pub(super) b: Jet<Quotient>,
    pub(super) unit: Jet<Quotient>,
    pub(super) i: i64,
    pub(super) d: i64,
    /// For a dual: t_i is reflected to t_{m−i}.
    pub(super) m: Option<i64>,
}

/// The value of a parameter with its indices.
pub(super) type Parameters<'a> = dyn Fn(&Name, &[i64]) -> Evaluated + 'a;

/// A product of so many lengths.
type Quantity = (Jet<Quotient>, usize);

fn unsaid<T>(what: impl Into<String>) -> Evaluated<T> {
    Err(EvaluationError::Weight(what.into()))
}

impl Interval {
    /// rise and fall, as products of equally many lengths.
    pub(super) fn shares(&self, family: &Family, known: &Parameters<'_>) -> Evaluated<[Jet<Quotient>; 2]> {
        let (rise, fall) = (self.quantity(&family.rise, known)?, self.quantity(&family.fall, known)?);
        let lengths = rise.1.max(fall.1);
        Ok([self.of_lengths(rise, lengths), self.of_lengths(fall, lengths)])
    }

    /// The value of a term without x.
    pub(super) fn number(&self, term: &Real, known: &Parameters<'_>) -> Evaluated {
        Ok(self.quantity(term, known)?.0.coefficients()[0].clone())
    }

    fn of_lengths(&self, (value, own): Quantity, lengths: usize) -> Jet<Quotient> {
        (own..lengths).fold(value, |value, _| value.times(&self.unit))
    }

    fn quantity(&self, term: &Real, known: &Parameters<'_>) -> Evaluated<Quantity> {
        let of = |term| self.quantity(term, known);
        let number = |value: &BigRational| (self.unit.embed(value), 0);
        let sum = |a: Quantity, b: Quantity| {
            let lengths = a.1.max(b.1);
            (self.of_lengths(a, lengths).plus(&self.of_lengths(b, lengths)), lengths)
        };
        let negated = |(a, lengths): Quantity| (a.negate(), lengths);
        Ok(match term {
            Real::Number(value) => number(value),
            Real::Whole(value) => number(&integer(self.int(value)?)),
            Real::Bound(name) => match &**name {
                "x" => (self.x.clone(), 1),
                "a" => (self.a.clone(), 1),
                "b" => (self.b.clone(), 1),
                other => return unsaid(other),
            },
            Real::Parameter(name, indices) => {
                let indices = indices.iter().map(|index| self.int(index)).collect::<Evaluated<Vec<_>>>()?;
                (Jet::constant(known(name, &indices)?, self.unit.order()), 0)
            }
            Real::Plus(a, b) => sum(of(a)?, of(b)?),
            Real::Minus(a, b) => sum(of(a)?, negated(of(b)?)),
            Real::Negated(a) => negated(of(a)?),
            Real::Times(a, b) => {
                let ((a, of_a), (b, of_b)) = (of(a)?, of(b)?);
                (a.times(&b), of_a + of_b)
            }
            Real::Over(a, b) => {
                let ((a, lengths), (b, 0)) = (of(a)?, of(b)?) else {
                    return unsaid("a divisor with a length");
                };
                match a.over(&b) {
                    Some(value) => (value, lengths),
                    None => return Err(EvaluationError::Division("a weight".into())),
                }
            }
            Real::Power(a, e) => {
                let (a, lengths) = of(a)?;
                let e = usize::try_from(self.int(e)?).ok().filter(|e| *e <= 100);
                let Some(e) = e else { return unsaid("an exponent") };
                ((0..e).fold(self.unit.one(), |power, _| power.times(&a)), lengths * e)
            }
            _ => return unsaid("a term that certificates don't have in a weight"),
        })
    }

    fn int(&self, term: &Int) -> Evaluated<i64> {
        let of = |a: &Int, b: &Int, with: fn(i64, i64) -> Option<i64>| {
            with(self.int(a)?, self.int(b)?).ok_or_else(|| EvaluationError::Weight("an index".into()))
        };
        match term {
            Int::Number(value) => Ok(*value),
            Int::Bound(name) if **name == *"i" => Ok(self.i),
            Int::Bound(name) if **name == *"d" => Ok(self.d),
            Int::M if self.m.is_some() => Ok(self.m.unwrap_or_default()),
            Int::Plus(a, b) => of(a, b, i64::checked_add),
            Int::Minus(a, b) => of(a, b, i64::checked_sub),
            Int::Times(a, b) => of(a, b, i64::checked_mul),
            _ => unsaid("an index that certificates don't have in a weight"),
        }
    }
}
