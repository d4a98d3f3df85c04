//! Knots that are numbers, those of an example; or none, where a sentence is about weights alone.

use std::cmp::Ordering;

use crate::certificate::weights::{Class, Weighted};
use crate::language::{self, Interval, Name, Real, Relation, Side};
use crate::scalar::{BigRational, Quotient, Ring, integer};

use super::case::{At, Bound, Case, Known, Numbers, Other, Truth, Value, WINDOW, undecided};
use super::index::{Facts, Index};
use super::place::{Copies, Place};

/// What was before.
pub(super) struct Located<'a> {
    place: Place,
    facts: Facts,
    numbers: Option<Numbers<'a>>,
}

/// The name of a distance from all knots.
const OUTSIDE: &str = "outside";

/// How many places x has against these knots.
pub(super) fn places(knots: &[BigRational]) -> usize {
    2 * knots.windows(2).filter(|pair| pair[0] < pair[1]).count() + 3
}

impl<'a> Case<'a> {
    /// The x of a place, in their order: before all knots, at each and behind it, after all.
    pub(super) fn x_at(&mut self, place: usize, knots: &[BigRational]) -> Known<Value> {
        let ends: Vec<_> = knots.windows(2).filter(|pair| pair[0] < pair[1]).collect();
        let (first, last) =
            (Value::number(ends[0][0].clone()), Value::number(ends[ends.len() - 1][1].clone()));
        let mut outside = || self.parameters.value(OUTSIDE.into(), Class::Positive);
        Ok(match place.checked_sub(1) {
            None => first.minus(outside()?),
            Some(at) if at == 2 * ends.len() => last,
            Some(at) if at > 2 * ends.len() => last.plus(outside()?),
            Some(at) => {
                let [left, right] = [0, 1].map(|end| Value::number(ends[at / 2][end].clone()));
                if at % 2 == 0 { left } else { self.inside(&left, &right)? }
            }
        })
    }

    /// (a + u·b)/(1 + u): all numbers between.
    fn inside(&mut self, a: &Value, b: &Value) -> Known<Value> {
        let u = self.parameters.value("u".into(), Class::Positive)?;
        let above = a.clone().plus(u.clone().times(b.clone()));
        self.over(above, Value::whole(1).plus(u))
    }

    /// The number of a rank: o, and what each is more than the one before.
    pub(super) fn ranked(&mut self, rank: usize) -> Known<Value> {
        let mut value = self.parameters.value("o".into(), Class::Real)?;
        for step in 0..rank {
            value = value.plus(self.parameters.value(format!("({WINDOW} {step})"), Class::Positive)?);
        }
        Ok(value)
    }

    /// The left end of an interval, all of its inside, or the right end; `None`, if there is nothing.
    pub(super) fn between(&mut self, interval: &Interval, part: usize) -> Known<Option<Value>> {
        let (left, right) = (self.real(&interval.from)?, self.real(&interval.to)?);
        if self.compare(Relation::Less, &left, &right).is_true() {
            return Ok(match part {
                0 => interval.from_closed.then_some(left),
                1 => Some(self.inside(&left, &right)?),
                _ => interval.to_closed.then_some(right),
            });
        }
        if !self.compare(Relation::AtLeast, &left, &right).is_true() {
            return undecided("whether an interval is empty");
        }
        let one = interval.from_closed && interval.to_closed && part == 0;
        Ok((one && self.compare(Relation::Equal, &left, &right).is_true()).then_some(left))
    }

    /// Puts x in its place among the knots.
    pub(super) fn locate(&mut self, x: Value) -> Known<Located<'a>> {
        let Some(mut numbers) = self.numbers.clone() else {
            return undecided("a function at another point than x");
        };
        let knots = numbers.knots();
        let beside: Vec<_> = knots.iter().map(|t| self.side_of(&x, &Value::number(t.clone()))).collect();
        let copies = beside.iter().filter(|order| **order == Some(Ordering::Equal)).count();
        let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
        let span = beside.windows(2).enumerate().find_map(|(s, pair)| match (pair[0]?, pair[1]?) {
            (Ordering::Greater, Ordering::Less) => Some((s, Place::Inside)),
            (Ordering::Equal, Ordering::Less) => {
                let copies = Copies::Exactly(count(copies));
                let first = x.number_is(&knots[0]);
                Some((s, if first { Place::First(copies) } else { Place::Knot(copies) }))
            }
            (Ordering::Greater, Ordering::Equal) if x.number_is(&knots[knots.len() - 1]) => {
                Some((s, Place::Last(Copies::Exactly(count(copies)))))
            }
            _ => None,
        });
        let (s, place) = match (span, beside.first(), beside.last()) {
            (Some(found), ..) => found,
            (None, Some(Some(Ordering::Less)), _) => (0, Place::Before),
            (None, _, Some(Some(Ordering::Greater))) => (0, Place::After),
            (None, None, _) => (0, self.place),
            _ => return undecided("where the argument of a function is"),
        };
        numbers.u = None;
        if place == Place::Inside && !knots.is_empty() {
            let [left, right] = [s, s + 1].map(|at| Value::number(knots[at].clone()));
            let u = self.over(x.clone().minus(left), right.minus(x.clone()))?;
            let own = self.parameters.value("u".into(), Class::Positive)?;
            if u.plain() != own.plain() {
                numbers.u = Some(u.term);
            }
        }
        numbers.x = Some(x);
        let facts = match knots.len().checked_sub(1) {
            Some(m) => {
                let (s, n) = (count(s), count(m) - self.k - 1);
                let exactly = |value| (Some(value), Some(value));
                Facts::new(exactly(s), exactly(n - s)).or_else(|_| undecided("knots that are none"))?
            }
            None => self.facts.clone(),
        };
        Ok(Located {
            place: std::mem::replace(&mut self.place, place),
            facts: std::mem::replace(&mut self.facts, facts),
            numbers: self.numbers.replace(numbers),
        })
    }

    pub(super) fn restore(&mut self, before: Located<'a>) {
        let Located { place, facts, numbers } = before;
        (self.place, self.facts, self.numbers) = (place, facts, numbers);
    }

    fn side_of(&mut self, a: &Value, b: &Value) -> Option<Ordering> {
        let known = [
            (Relation::Less, Ordering::Less),
            (Relation::Equal, Ordering::Equal),
            (Relation::Greater, Ordering::Greater),
        ];
        a.plain()?;
        known
            .into_iter()
            .find_map(|(relation, order)| self.compare(relation, a, b).is_true().then_some(order))
    }

    /// G_i^d at x, by its recursion.
    pub(super) fn basis_value(&mut self, i: i64, d: i64) -> Known<Value> {
        let Some(s) = self.facts.value(&Index::span(0)) else { return undecided("the span of x") };
        if !(i <= s && s <= i + d) {
            return Ok(Value::whole(0));
        }
        if d == 0 {
            return Ok(Value::whole(1));
        }
        let mut sum = Value::whole(0);
        for (j, rises) in [(i, true), (i + 1, false)] {
            let below = self.basis_value(j, d - 1)?;
            if below.plain().is_some_and(Ring::is_zero) {
                continue;
            }
            let [a, b] = [j, j + d].map(|i| self.knot(&Index::number(i)));
            let weight = self.weight_on(false, [&a?, &b?], At::Point(None), 0)?;
            let weight = if rises { weight } else { Value::whole(1).minus(weight) };
            sum = sum.plus(weight.times(below));
        }
        Ok(sum)
    }

    /// Whether something is true at a knot of an example, or in the middle between two.
    pub(super) fn some_real(
        &mut self,
        name: &Name,
        interval: &Interval,
        body: &language::Formula,
    ) -> Known<Truth> {
        let knots = self.numbers.as_ref().map(Numbers::knots).unwrap_or_default();
        let middles = knots.windows(2).map(|pair| (&pair[0] + &pair[1]) / integer(2));
        for x in knots.iter().cloned().chain(middles) {
            self.scope.reals.push((name.clone(), Bound::Free(Value::number(x))));
            let within = language::Formula::Within(Real::Bound(name.clone()), interval.clone());
            let exact = std::mem::replace(&mut self.exact, true);
            let holds = self.formula(&within).and(self.formula(body));
            self.exact = exact;
            self.scope.reals.pop();
            if holds.is_true() {
                return Ok(holds);
            }
        }
        undecided("whether there is such a number")
    }

    /// The weight of an interval, or a derivative of it; φ is 0 outside of it.
    pub(super) fn weight_on(&mut self, cut: bool, [a, b]: [&Value; 2], at: At, order: usize) -> Known<Value> {
        let x = self.x()?;
        if cut {
            let [from, to] = match (at, order) {
                (At::Point(Some(Side::Left)), _) => [Relation::Less, Relation::AtMost],
                (At::Point(None), 1..) => [Relation::Less; 2],
                _ => [Relation::AtMost, Relation::Less],
            };
            let inside = self.compare(from, a, &x).and(self.compare(to, &x, b));
            if inside == Truth::False && order == 0 {
                return Ok(Value::whole(0));
            }
            if !inside.is_true() {
                return undecided("whether x is in the interval of φ");
            }
        }
        let Weighted::Family(family) = self.weighted else { return undecided("the weights of any family") };
        let [rise, fall] = [self.jet(&family.rise, [a, b])?, self.jet(&family.fall, [a, b])?];
        let below = sum(&rise, &fall);
        // By the quotient rule, rise'·fall − rise·fall' over the square of the sum.
        let bent = |by: usize| {
            let falling = rise[0].clone().times(fall[by].clone());
            rise[by].clone().times(fall[0].clone()).minus(falling)
        };
        let square = below[0].clone().times(below[0].clone());
        match order {
            0 => self.over(rise[0].clone(), below[0].clone()),
            1 => self.over(bent(1), square),
            _ => {
                let turned = bent(1).times(below[1].clone()).times(Value::whole(-2));
                let bend = bent(2).times(below[0].clone()).plus(turned);
                self.over(bend, square.times(below[0].clone()))
            }
        }
    }

    /// A term of the weight of [a, b] with its derivatives by x.
    fn jet(&mut self, t: &Real, ends: [&Value; 2]) -> Known<Jet> {
        let constant = |value| [value, Value::whole(0), Value::whole(0)];
        let minus = constant(Value::whole(-1));
        Ok(match t {
            Real::Bound(name) if &**name == "x" => [self.x()?, Value::whole(1), Value::whole(0)],
            Real::Bound(name) => constant(ends[usize::from(&**name == "b")].clone()),
            Real::Number(_) | Real::Whole(_) => constant(self.real(t)?),
            Real::Parameter(name, of) if of.is_empty() => constant(match &self.other {
                None if &**name == "r" => self.r()?,
                None => self.family_parameter(name, of)?,
                Some(Other::Ratio(ratio)) if &**name == "r" => ratio.clone(),
                Some(_) => return undecided("a weight of another member"),
            }),
            Real::Plus(a, b) => sum(&self.jet(a, ends)?, &self.jet(b, ends)?),
            Real::Minus(a, b) => sum(&self.jet(a, ends)?, &product(&minus, &self.jet(b, ends)?)),
            Real::Negated(a) => product(&minus, &self.jet(a, ends)?),
            Real::Times(a, b) => product(&self.jet(a, ends)?, &self.jet(b, ends)?),
            Real::Power(a, e) => {
                let (a, e) = (self.jet(a, ends)?, self.int(e)?);
                match self.facts.value(&e) {
                    Some(e @ 0..=100) => {
                        (0..e).fold(constant(Value::whole(1)), |power, _| product(&power, &a))
                    }
                    _ => return undecided("an exponent"),
                }
            }
            Real::Over(a, b) => match self.jet(b, ends)? {
                [b, slope, _] if slope.is_zero() => {
                    let inverse = self.over(Value::whole(1), b)?;
                    product(&self.jet(a, ends)?, &constant(inverse))
                }
                _ => return undecided("a divisor with x in it"),
            },
            _ => return undecided("a weight that is not one of the ends alone"),
        })
    }
}

/// A value with its first two derivatives by x.
type Jet = [Value; 3];

fn sum(a: &Jet, b: &Jet) -> Jet {
    [0, 1, 2].map(|order| a[order].clone().plus(b[order].clone()))
}

fn product(a: &Jet, b: &Jet) -> Jet {
    let of = |i: usize, j: usize| a[i].clone().times(b[j].clone());
    let bend = of(2, 0).plus(of(1, 1).times(Value::whole(2))).plus(of(0, 2));
    [of(0, 0), of(1, 0).plus(of(0, 1)), bend]
}

impl Value {
    fn number_is(&self, number: &BigRational) -> bool {
        self.plain().is_some_and(|plain| *plain == Quotient::constant(number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn x_is_before_at_between_and_after_knots() {
        let knots: Vec<BigRational> = [0, 0, 1, 3, 3].map(integer).to_vec();
        assert_eq!(places(&knots), 7);
    }
}
