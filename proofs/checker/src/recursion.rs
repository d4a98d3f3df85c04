//! The definition: weights (D2.3), basis functions (D3.3) and de Boor's algorithm (Theorem 4.1) at a place.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::env::{Env, Window};
use crate::error::{Reason, Result};
use crate::fraction::Fraction;
use crate::poly::{Poly, Sign};
use crate::section::U;
use crate::terms::{Evaluator, Key};
use crate::token::Node;
use crate::work::{keep, spend};

/// Higher degrees are not computed; all recursion over them is bounded by this.
const DEGREE: i64 = 100;

/// A place with polynomials for its names: x = (V·t_s + U·t_{s+1}) / (U + V).
pub(crate) struct Spot {
    window: Rc<Window>,
    span: i64,
    /// U and V.
    u: (Poly, Poly),
    /// R and S with r = R/S.
    r: (Poly, Poly),
}

impl Spot {
    /// The point, measured from the first knot.
    pub(crate) fn x(&self, signs: &[Sign]) -> Result<Fraction> {
        Fraction::new(self.beyond(&Poly::default())?, self.whole().times(&self.window.scale)?, signs)
    }

    /// U + V.
    fn whole(&self) -> Poly {
        self.u.0.clone().plus(&self.u.1)
    }

    /// (x − a)·(U + V), times the scale of the knots.
    fn beyond(&self, a: &Poly) -> Result<Poly> {
        let (left, right) = (self.window.knot(self.span)?, self.window.knot(self.span + 1)?);
        let ((u, v), (left, right)) = (&self.u, (left.clone().minus(a), right.clone().minus(a)));
        Ok(v.times(&left)?.plus(&u.times(&right)?))
    }

    fn key(&self, what: &'static str, of: [i64; 3]) -> Result<Key> {
        let place = [self.u.clone(), self.r.clone()];
        keep(place.iter().map(|(up, down)| up.size() + down.size()).sum())?;
        Ok(Key::Function(what, of, self.window.name.clone(), self.span, place))
    }
}

fn check_degree(degree: i64) -> Result<()> {
    if (0..=DEGREE).contains(&degree) { Ok(()) } else { Err(Reason::Limits("a degree")) }
}

impl Evaluator {
    /// The place, if it is in a span that is not empty.
    pub(crate) fn spot<'t>(&self, node: &Node<'t>, env: &Env<'t>) -> Result<Spot> {
        let (kind, [window, span]) = node.headed("a place")? else { return node.wrong("a place") };
        let name = |name| {
            let value = env.value(name, Vec::new())?;
            Ok((value.denominator()?, value.num))
        };
        let ((v, u), (s, r)) = (name("u")?, name("r")?);
        let u = match kind {
            "in" => (u, v),
            "from" => (Poly::default(), Poly::constant(1)),
            "to" => (Poly::constant(1), Poly::default()),
            _ => return node.wrong("in, from or to"),
        };
        let (window, span) = (env.window(window)?.clone(), env.integer(span)?);
        let (left, right) = (window.knot(span)?, window.knot(span + 1)?);
        spend(left.size() + right.size())?;
        let gap = right.clone().minus(left);
        Fraction::from(gap).positive(&format!("span {span} of {}", window.name), &self.signs)?;
        Ok(Spot { window, span, u, r: (r, s) })
    }

    /// For the interval from a to b of w_i^d, which has to contain the span by index: p = r·(x − a) and q = b − x, times
    /// the denominators in them, p + q, and b − a.
    fn ends(&self, i: i64, d: i64, spot: &Spot) -> Result<[Poly; 4]> {
        if i > spot.span || i + d <= spot.span {
            let what = format!("w_{i}^{d} on span {}", spot.span);
            return Err(Reason::NotDetermined(spot.window.name.clone(), what));
        }
        let (a, b) = (spot.window.knot(i)?, spot.window.knot(i + d)?);
        let p = spot.r.0.times(&spot.beyond(a)?)?;
        let q = spot.r.1.times(&spot.beyond(b)?.negated())?;
        let (whole, length) = (p.clone().plus(&q), b.clone().minus(a));
        // Positive wherever the span is: said again here, as everything else rests on it.
        let positive = whole.sign(&self.signs) == Sign::Positive;
        if positive { Ok([p, q, whole, length]) } else { Err(Reason::Divisor) }
    }

    /// w_i^d and 1 − w_i^d.
    pub(crate) fn weight(&mut self, i: i64, d: i64, spot: &Spot) -> Result<[Fraction; 2]> {
        let [p, q, whole, _] = self.ends(i, d, spot)?;
        let one = Fraction::integer(1);
        if p.is_zero() {
            return Ok([Fraction::integer(0), one]);
        }
        if q.is_zero() {
            return Ok([one, Fraction::integer(0)]);
        }
        if self.mode.weights.is_none_or(|least| d < least) {
            let over = |part| Fraction::new(part, whole.clone(), &self.signs);
            return Ok([over(p)?, over(q)?]);
        }
        if !self.mode.equation || p == q {
            return Ok([self.ratio(&p, &q)?, self.ratio(&q, &p)?]);
        }
        // One orientation for both: [q|p] is 1 − [p|q].
        let smaller = self.ratio((&p).min(&q), (&p).max(&q))?;
        let other = one.minus(&smaller)?;
        Ok(if p < q { [smaller, other] } else { [other, smaller] })
    }

    /// The unknown [p|q], which is p/(p + q): of the sign of p, if q has one as well.
    fn ratio(&mut self, p: &Poly, q: &Poly) -> Result<Fraction> {
        let real = q.sign(&self.signs) == Sign::Real;
        let sign = if real { Sign::Real } else { p.sign(&self.signs) };
        self.unknown(Key::Weight(p.clone(), q.clone()), sign)
    }

    /// The derivative of w_i^d: with x = (V·t_s + U·t_{s+1})/(U + V), it is R·S·(b − a)·(U + V)²/(p + q)².
    pub(crate) fn slope(&mut self, i: i64, d: i64, spot: &Spot) -> Result<Fraction> {
        let [p, q, whole, length] = self.ends(i, d, spot)?;
        let num = spot.r.0.times(&spot.r.1)?.times(&length)?.times(&spot.whole().to_power(2)?)?;
        // p, q and b − a are all times the scale: it remains once above the line.
        let num = num.times(&spot.window.scale)?;
        if self.mode.weights.is_some_and(|least| d >= least) && !p.is_zero() && !q.is_zero() {
            return self.unknown(Key::Slope(p, q, num), Sign::Real);
        }
        let inverse = Fraction::new(Poly::constant(1), whole, &self.signs)?;
        Fraction::from(num).times(&inverse)?.times(&inverse)
    }

    /// G_i^d, or its derivative.
    pub(crate) fn basis(&mut self, i: i64, d: i64, spot: &Spot, derived: bool) -> Result<Fraction> {
        check_degree(d)?;
        if i > spot.span || i + d < spot.span {
            return Ok(Fraction::integer(0));
        }
        let key = spot.key(if derived { "DG" } else { "G" }, [i, d, 0])?;
        if self.mode.functions.is_some_and(|most| d <= most) {
            return self.unknown(key, Sign::Real);
        }
        if d == 0 {
            return Ok(Fraction::integer(i64::from(!derived)));
        }
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        let mut sum = Fraction::integer(0);
        for (j, rising) in [(i, true), (i + 1, false)] {
            let value = self.basis(j, d - 1, spot, false)?;
            let factor = if derived { self.basis(j, d - 1, spot, true)? } else { value.clone() };
            // A summand with G = 0 is 0: its weight need not be known.
            if !factor.is_zero() || !value.is_zero() {
                let [rise, fall] = self.weight(j, d, spot)?;
                sum = sum.plus(&factor.times(if rising { &rise } else { &fall })?)?;
            }
            if derived && !value.is_zero() {
                let change = self.slope(j, d, spot)?.times(&value)?;
                sum = if rising { sum.plus(&change)? } else { sum.minus(&change)? };
            }
        }
        self.known.insert(key, sum.clone());
        Ok(sum)
    }

    /// d_i^q of Theorem 4.1 for degree k: d_i^q = w_i^{k+1−q} d_i^{q−1} + (1 − w_i^{k+1−q}) d_{i−1}^{q−1}.
    pub(crate) fn de_boor<'t>(&mut self, of: [i64; 3], spot: &Spot, env: &Env<'t>) -> Result<Fraction> {
        let ([i, q, k], key) = (of, spot.key("de-boor", of)?);
        check_degree(k)?;
        match (q, self.known.get(&key)) {
            (0, _) => return env.value("d", vec![i]),
            (_, Some(known)) => return Ok(known.clone()),
            _ if q < 0 || q > k => return Err(Reason::Limits("a level")),
            _ => {}
        }
        let [rise, fall] = self.weight(i, k + 1 - q, spot)?;
        let here = self.de_boor([i, q - 1, k], spot, env)?;
        let before = self.de_boor([i - 1, q - 1, k], spot, env)?;
        let value = rise.times(&here)?.plus(&fall.times(&before)?)?;
        self.known.insert(key, value.clone());
        Ok(value)
    }

    /// The E with G_i^d = c·u^E + … for u → 0 and c > 0, by min for + and + for ·.
    pub(crate) fn order(&mut self, i: i64, d: i64, spot: &Spot) -> Result<i64> {
        check_degree(d)?;
        let mut level = BTreeMap::from([(spot.span, 0)]);
        for degree in 1..=d {
            let mut next = BTreeMap::new();
            // Of both degrees only those functions that G_i^d is built from.
            let last = i + d - degree;
            for (j, order) in level.range(i..=last + 1) {
                let [p, q, whole, _] = self.ends(*j, degree, spot)?;
                for (index, part) in [(*j, p), (j - 1, q)] {
                    if i <= index && index <= last {
                        let order = order + self.lowest(&part)? - self.lowest(&whole)?;
                        let least = next.entry(index).or_insert(order);
                        *least = order.min(*least);
                    }
                }
            }
            level = next;
        }
        level.remove(&i).ok_or(Reason::NotShown("the function is 0"))
    }

    /// The lowest exponent of u, if its coefficient is positive.
    fn lowest(&self, poly: &Poly) -> Result<i64> {
        match poly.by_powers(U).pop_first() {
            Some((exponent, rest)) if rest.sign(&self.signs) == Sign::Positive => Ok(exponent.into()),
            _ => Err(Reason::NotShown("a lowest coefficient in u without a sign")),
        }
    }
}
