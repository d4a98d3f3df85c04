//! The numbers that a parameter of a family may be: by their height, at random, and simpler ones.

use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};

use crate::language::{Parameter, Relation};
use crate::scalar::{BigInt, BigRational, height, integer, rational, rationals_between};

/// What numbers are ordered by: the height max(|p|, q) of p/q, then the absolute value, and of ±v the positive one first: 0, 1,
/// −1, 1/2, −1/2, 2, −2, 1/3, …
pub(super) type Simplicity = (BigInt, BigRational, bool);

/// The key of a number in that order.
pub(super) fn simplicity(value: &BigRational) -> Simplicity {
    (height(value), value.abs(), value.is_negative())
}

/// The numbers that a parameter may be, up to a height, in order.
#[derive(Debug, Clone)]
pub(super) struct Numbers {
    /// Entry h − 1: (p, q) for the numbers p/q of height h.
    by_height: Vec<Vec<(i64, i64)>>,
}

impl Numbers {
    /// Those up to a height.
    pub(super) fn new(parameter: &Parameter, tallest: u64) -> Self {
        let admitted = |h: u64| {
            let h = i64::try_from(h).unwrap_or(i64::MAX);
            let all = of_height(h).filter(|(p, q)| parameter.admits(&rational(*p, *q)));
            all.collect()
        };
        Self { by_height: (1..=tallest).map(admitted).collect() }
    }

    /// Entry c: how many there are of height c + 1.
    pub(super) fn ways(&self) -> Vec<u64> {
        self.by_height.iter().map(|numbers| numbers.len() as u64).collect()
    }

    /// The one of height c + 1 with this place among them.
    pub(super) fn at(&self, cost: u64, place: u64) -> Option<BigRational> {
        let of_height = self.by_height.get(usize::try_from(cost).ok()?)?;
        of_height.get(usize::try_from(place).ok()?).map(|(p, q)| rational(*p, *q))
    }
}

/// (p, q) in lowest terms with max(|p|, q) = h, in order.
fn of_height(h: i64) -> impl Iterator<Item = (i64, i64)> {
    let below = (0..h).map(move |p| (p, h));
    let above = (1..=h).rev().map(move |q| (h, q));
    let coprime = below.chain(above).filter(|(p, q)| p.gcd(q) == 1);
    coprime.flat_map(|(p, q)| [(p, q), (-p, q)].into_iter().take(if p == 0 { 1 } else { 2 }))
}

/// The interval that the bounds of a parameter leave; `None` for an end that is open.
fn range(parameter: &Parameter) -> (Option<BigRational>, Option<BigRational>) {
    let (mut least, mut most): (Option<BigRational>, Option<BigRational>) = (None, None);
    for (relation, bound) in &parameter.bounds {
        let (from, to) = match relation {
            Relation::Greater | Relation::AtLeast => (true, false),
            Relation::Less | Relation::AtMost => (false, true),
            Relation::Equal => (true, true),
            Relation::Unequal => (false, false),
        };
        if from && least.as_ref().is_none_or(|least| bound > least) {
            least = Some(bound.clone());
        }
        if to && most.as_ref().is_none_or(|most| bound < most) {
            most = Some(bound.clone());
        }
    }
    (least, most)
}

/// The simplest number that a parameter may be, or, of bounds with large numbers, a simple one; `None` if none is found.
pub(super) fn simplest(parameter: &Parameter) -> Option<BigRational> {
    /// As far as all numbers are tried.
    const TALLEST: i64 = 32;
    let small = (1..=TALLEST).flat_map(of_height).map(|(p, q)| rational(p, q));
    let (least, most) = range(parameter);
    let (from, to) = match (&least, &most) {
        (None, None) => (integer(0), integer(1)),
        (Some(least), None) => (least.clone(), least + integer(1)),
        (None, Some(most)) => (most - integer(1), most.clone()),
        (Some(least), Some(most)) => (least.clone(), most.clone()),
    };
    // As many as there are bounds that are no more than ≠, and one.
    let between = rationals_between(&from, &to).take(parameter.bounds.len() + 1);
    let ends = [from.clone(), to.clone()];
    small.chain(between).chain(ends).find(|value| parameter.admits(value))
}

/// The number for a spread z > 0 and a sign: z above the least, or below the most, or as z : 1 between both.
pub(super) fn spread(parameter: &Parameter, z: &BigRational, negative: bool) -> Option<BigRational> {
    let value = match range(parameter) {
        (Some(least), Some(most)) => &least + (&most - &least) * z / (z + integer(1)),
        (Some(least), None) => least + z,
        (None, Some(most)) => most - z,
        (None, None) if negative => -z,
        (None, None) => z.clone(),
    };
    if parameter.admits(&value) { Some(value) } else { simplest(parameter) }
}

/// The numbers on the Stern–Brocot path to a number, and 0, that a parameter may be and that are simpler, simplest first.
pub(super) fn simpler(parameter: &Parameter, value: &BigRational) -> Vec<BigRational> {
    let parts = value.numer().abs().to_u64().zip(value.denom().to_u64());
    let path = parts.map(|(p, q)| stern_brocot_path(p, q)).unwrap_or_default();
    let on_path = path.into_iter().map(|(p, q)| BigRational::new(p.into(), q.into()));
    let signed = on_path.map(|number| if value.is_negative() { -number } else { number });
    let own = simplicity(value);
    let mut all: Vec<_> = signed.chain([integer(0)]).chain(simplest(parameter)).collect();
    all.retain(|number| parameter.admits(number) && simplicity(number) < own);
    all.sort_by_cached_key(simplicity);
    all.dedup();
    all
}

/// Fractions c/d > 0 on the Stern–Brocot path from 0/1, 1/0 to a/b: the simplest fraction of any interval around a/b is on that
/// path. Of a long run into one direction, 1, 2, 3 steps and then twice as many each time.
pub(super) fn stern_brocot_path(mut a: u64, mut b: u64) -> Vec<(u64, u64)> {
    // Two fractions around a/b: the last ones that the path turned at, the nearer one second.
    let (mut before, mut last) = ((0, 1), (1, 0));
    let mut path = Vec::new();
    while b > 0 {
        let steps = a / b;
        for n in std::iter::successors(Some(1), |&n| Some(if n < 3 { n + 1 } else { 2 * n }))
            .take_while(|&n| n < steps)
            .chain((steps > 0).then_some(steps))
        {
            let (c, d) = (before.0 + n * last.0, before.1 + n * last.1);
            if c > 0 && d > 0 {
                path.push((c, d));
            }
        }
        (before, last) = (last, (before.0 + steps * last.0, before.1 + steps * last.1));
        (a, b) = (b, a % b);
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(bounds: &[(Relation, (i64, i64))]) -> Parameter {
        let bounds = bounds.iter().map(|(relation, (p, q))| (*relation, rational(*p, *q))).collect();
        Parameter { name: "q".into(), indices: Vec::new(), bounds, says: String::new() }
    }

    #[test]
    fn numbers_come_by_height_each_once() {
        let all: Vec<_> = (1..=3).flat_map(of_height).collect();
        let positive: Vec<_> = all.iter().filter(|(p, _)| *p > 0).collect();
        assert_eq!(positive, [&(1, 1), &(1, 2), &(2, 1), &(1, 3), &(2, 3), &(3, 2), &(3, 1)]);
        assert_eq!(all.len(), 2 * positive.len() + 1);
        assert!(all.is_sorted_by_key(|(p, q)| simplicity(&rational(*p, *q))));
        let above_one = Numbers::new(&parameter(&[(Relation::Greater, (1, 1))]), 4);
        assert_eq!(above_one.ways(), [0, 1, 2, 2]);
        assert_eq!((above_one.at(2, 0), above_one.at(2, 2)), (Some(rational(3, 2)), None));
    }

    #[test]
    fn every_number_is_within_the_bounds() {
        use Relation::{AtLeast, AtMost, Equal, Greater, Less, Unequal};
        for bounds in [
            &[][..],
            &[(Greater, (0, 1))],
            &[(AtLeast, (0, 1))],
            &[(Greater, (1000, 1))],
            &[(Greater, (0, 1)), (Less, (1, 1000))],
            &[(Less, (-70, 1))],
            &[(Unequal, (0, 1)), (Unequal, (1, 1))],
            &[(Equal, (77, 100))],
            &[(AtLeast, (77, 100)), (AtMost, (77, 100))],
        ] {
            let own = parameter(bounds);
            let simplest = simplest(&own).unwrap();
            assert!(own.admits(&simplest), "{bounds:?}");
            for z in [rational(1, 1000), rational(1, 1), rational(77, 3)] {
                for negative in [true, false] {
                    let value = spread(&own, &z, negative).unwrap();
                    assert!(own.admits(&value), "{bounds:?}: {value}");
                    let simpler = simpler(&own, &value);
                    assert!(simpler.iter().all(|number| own.admits(number)));
                    assert!(simpler.iter().all(|number| simplicity(number) < simplicity(&value)));
                }
            }
        }
        assert_eq!(super::simplest(&parameter(&[(Less, (0, 1)), (Greater, (0, 1))])), None);
    }
}
