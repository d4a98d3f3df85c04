//! The definition: weights (D2.3), basis functions (D3.3) and de Boor's algorithm (Theorem 4.1) at a place.

use std::collections::BTreeMap;

use crate::error::Reason;
use crate::fraction::Fraction;
use crate::integer::Scope;
use crate::poly::{Poly, Sign};
use crate::section::{Values, Window};
use crate::syntax::{Place, PlaceKind};
use crate::terms::{Evaluator, Unknown};

/// Higher degrees are not computed.
const DEGREE: i64 = 100;

/// A place with numbers and polynomials for its names: x = (V·t_s + U·t_{s+1}) / (U + V).
pub(crate) struct Spot<'v> {
    window: &'v Window,
    pub(crate) span: i64,
    /// U and V.
    u: (Poly, Poly),
    /// R and S with r = R/S.
    r: (Poly, Poly),
    scale: Poly,
}

/// w and 1 − w; p and q with w = p/(p + q).
pub(crate) struct Weight {
    pub(crate) rise: Fraction,
    pub(crate) fall: Fraction,
    pub(crate) p: Poly,
    pub(crate) q: Poly,
}

impl Spot<'_> {
    /// The point, measured from the first knot.
    pub(crate) fn x(&self, values: &Values, signs: &[Sign]) -> Result<Fraction, Reason> {
        let (left, right) = (self.window.knot(self.span)?, self.window.knot(self.span + 1)?);
        let num = self.u.1.times(left)?.plus(&self.u.0.times(right)?);
        Fraction::new(num, self.whole().scaled(&values.scale)?, signs)
    }

    /// U + V.
    fn whole(&self) -> Poly {
        self.u.0.clone().plus(&self.u.1)
    }

    /// The interval of w_i^d, which has to contain the span by index.
    fn interval(&self, i: i64, d: i64) -> Result<(&Poly, &Poly), Reason> {
        if i > self.span || i + d <= self.span {
            let window = self.window.name.clone();
            return Err(Reason::Interval { window, i, d, span: self.span });
        }
        Ok((self.window.knot(i)?, self.window.knot(i + d)?))
    }

    /// r·(x − a) and b − x, times the denominators in them and the scale of the knots.
    fn p_and_q(&self, i: i64, d: i64) -> Result<(Poly, Poly), Reason> {
        let (a, b) = self.interval(i, d)?;
        let (left, right) = (self.window.knot(self.span)?, self.window.knot(self.span + 1)?);
        let ((u, v), (r, s)) = (&self.u, &self.r);
        let from_a = v.times(&left.clone().minus(a))?.plus(&u.times(&right.clone().minus(a))?);
        let to_b = v.times(&b.clone().minus(left))?.plus(&u.times(&b.clone().minus(right))?);
        Ok((r.times(&from_a)?, s.times(&to_b)?))
    }
}

fn check_degree(degree: i64) -> Result<(), Reason> {
    match degree {
        ..0 => Err(Reason::Negative("a degree")),
        0..=DEGREE => Ok(()),
        _ => Err(Reason::TooLarge("a degree")),
    }
}

impl Evaluator<'_> {
    pub(crate) fn spot<'v>(
        &self,
        place: &Place,
        scope: &Scope,
        values: &'v Values,
    ) -> Result<Spot<'v>, Reason> {
        let (window, span) = (values.window(&place.window)?, scope.value(&place.span)?);
        let gap = window.knot(span + 1)?.clone().minus(window.knot(span)?);
        if gap.sign(&self.signs) != Sign::Positive {
            return Err(Reason::Span(place.window.clone(), span));
        }
        let (u, r) = (values.u.num_and_den()?, values.r.num_and_den()?);
        let u = match place.kind {
            PlaceKind::In => u,
            PlaceKind::From => (Poly::zero(), Poly::one()),
            PlaceKind::To => (Poly::one(), Poly::zero()),
        };
        Ok(Spot { window, span, u, r, scale: Poly::constant(values.scale.clone()) })
    }

    pub(crate) fn weight(&mut self, i: i64, d: i64, spot: &Spot<'_>) -> Result<Weight, Reason> {
        let (p, q) = spot.p_and_q(i, d)?;
        // Positive wherever the span is: said again here, as everything else rests on it.
        let whole = p.clone().plus(&q);
        if whole.sign(&self.signs) != Sign::Positive {
            return Err(Reason::Divisor);
        }
        let (rise, fall) = if p.is_zero() {
            (Fraction::zero(), Fraction::one())
        } else if q.is_zero() {
            (Fraction::one(), Fraction::zero())
        } else if self.mode.weights.is_none_or(|least| d < least) {
            (
                Fraction::new(p.clone(), whole.clone(), &self.signs)?,
                Fraction::new(q.clone(), whole, &self.signs)?,
            )
        } else if !self.mode.equation {
            (self.ratio(&p, &q), self.ratio(&q, &p))
        } else if p <= q {
            // One orientation for both: [q|p] is 1 − [p|q].
            let rise = self.ratio(&p, &q);
            let fall = if p == q { rise.clone() } else { Fraction::one().minus(&rise)? };
            (rise, fall)
        } else {
            let fall = self.ratio(&q, &p);
            (Fraction::one().minus(&fall)?, fall)
        };
        Ok(Weight { rise, fall, p, q })
    }

    /// The unknown [p|q], which is p/(p + q).
    fn ratio(&mut self, p: &Poly, q: &Poly) -> Fraction {
        let sign = match (p.sign(&self.signs), q.sign(&self.signs)) {
            (Sign::Real, _) | (_, Sign::Real) => Sign::Real,
            (sign, _) => sign,
        };
        self.unknown(Unknown::Weight(p.clone(), q.clone()), sign).into()
    }

    /// The derivative of w_i^d: with x = (V·t_s + U·t_{s+1})/(U + V), it is R·S·(b − a)·(U + V)²/(p + q)².
    pub(crate) fn slope(&mut self, i: i64, d: i64, spot: &Spot<'_>) -> Result<Fraction, Reason> {
        let (p, q) = spot.p_and_q(i, d)?;
        let (a, b) = spot.interval(i, d)?;
        // p, q and b − a are all times the scale: it remains once above the line.
        let length = spot.scale.times(&b.clone().minus(a))?;
        let num = spot.r.0.times(&spot.r.1)?.times(&length)?.times(&spot.whole().to_power(2)?)?;
        if self.mode.weights.is_some_and(|least| d >= least) && !p.is_zero() && !q.is_zero() {
            return Ok(self.unknown(Unknown::Slope(p, q, num), Sign::Real).into());
        }
        let inverse = Fraction::new(Poly::one(), p.plus(&q), &self.signs)?;
        Fraction::from(num).times(&inverse)?.times(&inverse)
    }

    /// G_i^d and, if it is wanted, its derivative.
    pub(crate) fn basis(
        &mut self,
        i: i64,
        d: i64,
        spot: &Spot<'_>,
        derivative: bool,
    ) -> Result<(Fraction, Fraction), Reason> {
        let s = spot.span;
        check_degree(d)?;
        if i > s || i + d < s {
            return Ok((Fraction::zero(), Fraction::zero()));
        }
        // Those functions of a degree that G_i^d is built from and that the span does not make 0.
        let needed = |degree: i64| i.max(s - degree)..=(i + d - degree).min(s);
        let mut level = BTreeMap::new();
        let lowest = self.mode.functions.map_or(0, |most| most.min(d));
        for j in needed(lowest) {
            let pair = match self.mode.functions {
                None => (Fraction::one(), Fraction::zero()),
                Some(_) => (self.function(j, lowest, spot, false), self.function(j, lowest, spot, true)),
            };
            level.insert(j, pair);
        }
        for degree in lowest + 1..=d {
            let mut next = BTreeMap::new();
            for j in needed(degree) {
                let (mut value, mut slope) = (Fraction::zero(), Fraction::zero());
                for (index, rising) in [(j, true), (j + 1, false)] {
                    let Some((f, df)) = level.get(&index) else { continue };
                    // A summand with G = 0 is 0: its weight need not be known.
                    if f.is_zero() && (!derivative || df.is_zero()) {
                        continue;
                    }
                    let weight = self.weight(index, degree, spot)?;
                    let weight = if rising { weight.rise } else { weight.fall };
                    value = value.plus(&weight.times(f)?)?;
                    if derivative {
                        slope = slope.plus(&weight.times(df)?)?;
                        if !f.is_zero() {
                            let change = self.slope(index, degree, spot)?.times(f)?;
                            slope = if rising { slope.plus(&change)? } else { slope.minus(&change)? };
                        }
                    }
                }
                next.insert(j, (value, slope));
            }
            level = next;
        }
        level.remove(&i).ok_or(Reason::Zero)
    }

    fn function(&mut self, i: i64, d: i64, spot: &Spot<'_>, derivative: bool) -> Fraction {
        let at = [spot.u.clone(), spot.r.clone()];
        let key = Unknown::Function([i, d, spot.span], derivative, spot.window.name.clone(), at);
        self.unknown(key, Sign::Real).into()
    }

    /// d_i^q of Theorem 4.1 for degree k: d_i^{r+1} = w_i^{k−r} d_i^r + (1 − w_i^{k−r}) d_{i−1}^r.
    pub(crate) fn de_boor(&mut self, i: i64, q: i64, k: i64, spot: &Spot<'_>) -> Result<Fraction, Reason> {
        check_degree(k)?;
        if q < 0 || q > k {
            return Err(Reason::Negative("a level or what it leaves of the degree"));
        }
        let mut level = BTreeMap::new();
        for j in i - q..=i {
            let point = self.section.index("d", vec![j])?;
            level.insert(j, Fraction::from(Poly::variable(point)));
        }
        for r in 0..q {
            let mut next = BTreeMap::new();
            for j in i - q + r + 1..=i {
                let (Some(here), Some(before)) = (level.get(&j), level.get(&(j - 1))) else { continue };
                let weight = self.weight(j, k - r, spot)?;
                next.insert(j, weight.rise.times(here)?.plus(&weight.fall.times(before)?)?);
            }
            level = next;
        }
        level.remove(&i).ok_or(Reason::Zero)
    }

    /// The E with G_i^d = c·u^E + … for u → 0 and c > 0, by min for + and + for ·.
    pub(crate) fn order(&mut self, i: i64, d: i64, spot: &Spot<'_>, u: usize) -> Result<i64, Reason> {
        let s = spot.span;
        check_degree(d)?;
        let mut level = BTreeMap::from([(s, 0)]);
        for degree in 1..=d {
            let mut next = BTreeMap::new();
            for j in i.max(s - degree)..=(i + d - degree).min(s) {
                let mut least: Option<i64> = None;
                for (index, rising) in [(j, true), (j + 1, false)] {
                    let Some(order) = level.get(&index) else { continue };
                    let Weight { p, q, .. } = self.weight(index, degree, spot)?;
                    let whole = self.lowest(&p.clone().plus(&q), u)?;
                    let order = order + self.lowest(if rising { &p } else { &q }, u)? - whole;
                    least = Some(least.map_or(order, |least| least.min(order)));
                }
                if let Some(order) = least {
                    next.insert(j, order);
                }
            }
            level = next;
        }
        level.remove(&i).ok_or(Reason::Zero)
    }

    /// The lowest exponent of u, if its coefficient is positive.
    fn lowest(&self, poly: &Poly, u: usize) -> Result<i64, Reason> {
        match poly.by_powers(u).first_key_value() {
            Some((exponent, coefficient)) if coefficient.sign(&self.signs) == Sign::Positive => {
                Ok(i64::from(*exponent))
            }
            _ => Err(Reason::Lowest),
        }
    }
}
