//! The definition: weights, basis functions (D3.3) and de Boor's algorithm (Theorem 4.1) at a place.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::env::{Env, Window, binomial};
use crate::error::{Reason, Result};
use crate::family::{Family, Interval, Shares, choices};
use crate::fraction::Fraction;
use crate::poly::{Poly, Sign};
use crate::section::U;
use crate::terms::{Evaluator, Key};
use crate::token::Node;
use crate::work::{keep, spend};

/// Higher degrees are not computed; all recursion over them is bounded by this.
const DEGREE: i64 = 100;

/// A place with polynomials for its names: x = (V·t_s + U·t_{s+1}) / (U + V).
pub(crate) struct Spot<'t> {
    window: Rc<Window>,
    span: i64,
    /// U and V.
    u: (Poly, Poly),
    /// The parameters of the family that are one number.
    parameters: Vec<(&'t str, Fraction)>,
    /// Of the member that a reflection leads to: where the parameters were before, and the index of t_m there.
    dual: Option<(Rc<Window>, i64)>,
    family: Rc<Family<'t>>,
}

impl Spot<'_> {
    /// The point, measured from the first knot.
    pub(crate) fn x(&self, signs: &[Sign]) -> Result<Fraction> {
        Fraction::new(self.scaled()?, self.unit()?, signs)
    }

    /// U + V.
    fn whole(&self) -> Poly {
        self.u.0.clone().plus(&self.u.1)
    }

    /// What all lengths are multiplied with.
    fn unit(&self) -> Result<Poly> {
        self.whole().times(&self.window.scale)
    }

    /// x, measured from the first knot, in this unit.
    fn scaled(&self) -> Result<Poly> {
        let (left, right) = (self.window.knot(self.span)?, self.window.knot(self.span + 1)?);
        Ok(self.u.1.times(left)?.plus(&self.u.0.times(right)?))
    }

    /// A parameter of the family, if need be that of the member that a reflection leads to.
    fn parameter(&self, name: &str, indices: &[i64], signs: &[Sign]) -> Result<Fraction> {
        let known = |window: &Window, name: &str, indices: &[i64]| match self
            .parameters
            .iter()
            .find(|(known, _)| *known == name && indices.is_empty())
        {
            Some((_, value)) => Ok(value.clone()),
            None => window.parameter(name, indices),
        };
        if let Some((before, m)) = &self.dual {
            let of = |index: &str| {
                let parameter = self.family.parameter(name)?;
                let at = parameter.indices.iter().position(|known| *known == index)?;
                indices.get(at).copied()
            };
            let (i, d) = (of("i").unwrap_or(0), of("d").unwrap_or(0));
            let at = Interval { i, d, m: Some(*m), signs, ..Interval::default() };
            let after = self.family.dual(name, &at, &|name, indices| known(before, name, indices))?;
            if let Some(after) = after {
                return Ok(after);
            }
        }
        known(&self.window, name, indices)
    }

    /// The weight is a function of x: at a knot it is one from both sides.
    fn any(&self, what: &'static str, of: [i64; 2]) -> Result<Key> {
        let at = [self.scaled()?, self.unit()?];
        keep(at.iter().map(Poly::size).sum())?;
        Ok(Key::Any(what, of, self.window.name.clone(), at))
    }

    fn key(&self, what: &'static str, of: [i64; 3]) -> Result<Key> {
        let mut place = vec![self.u.clone()];
        for (_, value) in &self.parameters {
            place.push((value.num.clone(), value.denominator()?));
        }
        keep(place.iter().map(|(up, down)| up.size() + down.size()).sum())?;
        let dual = self.dual.as_ref().map(|(window, m)| (window.name.clone(), *m));
        Ok(Key::Function(what, of, (self.window.name.clone(), self.span), dual, place))
    }
}

fn check_degree(degree: i64) -> Result<()> {
    if (0..=DEGREE).contains(&degree) { Ok(()) } else { Err(Reason::Limits("a degree")) }
}

impl Evaluator {
    /// The place, if it is in a span that is not empty.
    pub(crate) fn spot<'t>(&self, node: &Node<'t>, env: &Env<'t>) -> Result<Spot<'t>> {
        let (kind, [window, span]) = node.headed("a place")? else { return node.wrong("a place") };
        let u = env.value("u", Vec::new())?;
        let (v, u) = (u.denominator()?, u.num);
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
        let family = env.family.clone();
        let single = family.parameters.iter().filter(|own| own.indices.is_empty());
        let single = single.map(|own| Ok((own.name, env.value(own.name, Vec::new())?)));
        let parameters = single.collect::<Result<_>>()?;
        let dual = env.dual.map(|(name, m)| Ok::<_, Reason>((env.window(&Node::name_of(name))?.clone(), m)));
        Ok(Spot { window, span, u, parameters, dual: dual.transpose()?, family })
    }

    /// The weight w_i^d on its interval, which has to contain the span by index.
    fn ends(&self, i: i64, d: i64, spot: &Spot) -> Result<Shares> {
        if i > spot.span || i + d <= spot.span {
            let what = format!("w_{i}^{d} on span {}", spot.span);
            return Err(Reason::NotDetermined(spot.window.name.clone(), what));
        }
        let whole = spot.whole();
        let [a, b] = [spot.window.knot(i)?.times(&whole)?, spot.window.knot(i + d)?.times(&whole)?];
        let (x, unit, signs) = (spot.scaled()?, spot.unit()?, &self.signs);
        let at = Interval { x, a, b, unit, i, d, m: None, signs };
        let shares = spot.family.shares(&at, &|name, indices| spot.parameter(name, indices, signs))?;
        // Positive wherever the span is: said again here, as everything else rests on it.
        let positive = shares.whole(0).sign(signs) == Sign::Positive;
        if positive { Ok(shares) } else { Err(Reason::Divisor) }
    }

    /// w_i^d and 1 − w_i^d.
    pub(crate) fn weight(&mut self, i: i64, d: i64, spot: &Spot) -> Result<[Fraction; 2]> {
        let shares = self.ends(i, d, spot)?;
        let (p, q) = (&Shares::of(&shares.rise, 0), &Shares::of(&shares.fall, 0));
        let one = Fraction::integer(1);
        if p.is_zero() {
            return Ok([Fraction::integer(0), one]);
        }
        if q.is_zero() {
            return Ok([one, Fraction::integer(0)]);
        }
        if spot.family.is_any() {
            // Of all families at once only the sign of a weight is known, and that it has a complement.
            let signs = [self.share(p, q), self.share(q, p)];
            let rise = self.unknown(spot.any("w", [i, d])?, signs[0])?;
            if self.mode.equation {
                return Ok([rise.clone(), one.minus(&rise)?]);
            }
            return Ok([rise, self.unknown(spot.any("v", [i, d])?, signs[1])?]);
        }
        if self.mode.weights.is_none_or(|least| d < least) {
            let over = |part: &Poly| Fraction::new(part.clone(), shares.whole(0), &self.signs);
            return Ok([over(p)?, over(q)?]);
        }
        if !self.mode.equation || p == q {
            return Ok([self.ratio(p, q)?, self.ratio(q, p)?]);
        }
        // One orientation for both: [q|p] is 1 − [p|q].
        let smaller = self.ratio(p.min(q), p.max(q))?;
        let other = one.minus(&smaller)?;
        Ok(if p < q { [smaller, other] } else { [other, smaller] })
    }

    /// The sign of p/(p + q): that of p, if q has one as well.
    fn share(&self, p: &Poly, q: &Poly) -> Sign {
        if q.sign(&self.signs) == Sign::Real { Sign::Real } else { p.sign(&self.signs) }
    }

    /// The unknown [p|q], which is p/(p + q).
    fn ratio(&mut self, p: &Poly, q: &Poly) -> Result<Fraction> {
        let sign = self.share(p, q);
        self.unknown(Key::Weight(p.clone(), q.clone()), sign)
    }

    /// The derivative of w_i^d of an order from 1 on: rise = w·(rise + fall), differentiated so often.
    pub(crate) fn slope(&mut self, i: i64, d: i64, spot: &Spot, order: usize) -> Result<Fraction> {
        let shares = self.ends(i, d, spot)?;
        if spot.family.is_any() {
            // They have a derivative; nothing is said of others.
            return match order {
                1 => self.unknown(spot.any("Dw", [i, d])?, Sign::Real),
                _ => Err(Reason::NotShown("a higher derivative of a weight that is not known")),
            };
        }
        let [p, q] = [&shares.rise, &shares.fall].map(|share| Shares::of(share, 0));
        if order == 1 {
            let num = shares.rising()?;
            if self.mode.weights.is_some_and(|least| d >= least) && !p.is_zero() && !q.is_zero() {
                return self.unknown(Key::Slope(p, q, num), Sign::Real);
            }
            let inverse = Fraction::new(Poly::constant(1), shares.whole(0), &self.signs)?;
            return Fraction::from(num).times(&inverse)?.times(&inverse);
        }
        let over = |part: Poly| Fraction::new(part, shares.whole(0), &self.signs);
        let mut found = vec![over(p)?];
        for order in 1..=order {
            let mut rest = over(Shares::of(&shares.rise, order))?;
            for (lower, value) in found.iter().enumerate() {
                let whole =
                    over(shares.whole(order - lower))?.times(&Fraction::integer(choices(order, lower)?))?;
                rest = rest.minus(&value.times(&whole)?)?;
            }
            found.push(rest);
        }
        found.pop().ok_or(Reason::Limits("the order of a derivative"))
    }

    /// G_i^d, or its derivative of an order.
    pub(crate) fn basis(&mut self, i: i64, d: i64, spot: &Spot, order: i64) -> Result<Fraction> {
        check_degree(d)?;
        if i > spot.span || i + d < spot.span {
            return Ok(Fraction::integer(0));
        }
        let key = spot.key("DG", [i, d, order])?;
        if self.mode.functions.is_some_and(|most| d <= most) {
            return self.unknown(key, Sign::Real);
        }
        if d == 0 {
            return Ok(Fraction::integer(i64::from(order == 0)));
        }
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        let mut sum = Fraction::integer(0);
        for (j, rising) in [(i, true), (i + 1, false)] {
            for lower in 0..=order {
                let value = self.basis(j, d - 1, spot, lower)?;
                // A summand with G = 0 is 0: its weight need not be known.
                if value.is_zero() {
                    continue;
                }
                let of_weight = usize::try_from(order - lower)
                    .map_err(|_| Reason::Limits("the order of a derivative"))?;
                let [rise, fall] = match of_weight {
                    0 => self.weight(j, d, spot)?,
                    of_weight => {
                        let slope = self.slope(j, d, spot, of_weight)?;
                        [slope.clone(), slope.negated()]
                    }
                };
                let times = value.times(if rising { &rise } else { &fall })?;
                sum = sum.plus(&times.times(&Fraction::integer(binomial(order, lower)?))?)?;
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
        if spot.family.is_any() {
            return Err(Reason::NotShown("the order of a weight that is not known"));
        }
        let mut level = BTreeMap::from([(spot.span, 0)]);
        for degree in 1..=d {
            let mut next = BTreeMap::new();
            // Of both degrees only those functions that G_i^d is built from.
            let last = i + d - degree;
            for (j, order) in level.range(i..=last + 1) {
                let shares = self.ends(*j, degree, spot)?;
                let whole = shares.whole(0);
                for (index, part) in [(*j, &shares.rise), (j - 1, &shares.fall)] {
                    if i <= index && index <= last {
                        let order = order + self.lowest(&Shares::of(part, 0))? - self.lowest(&whole)?;
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
