//! The ways to compute the basis in `f64` that are compared.

use super::probe::Probe;
use crate::float::power::power;
use crate::float::{FAST_DEGREE, HIGHEST_DEGREE, Precision};

/// One way to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// The recursion of D3.3 with the weight as the paper prints it, α(x − a)/(x + (α − 1)b − αa), and 1 − w by
    /// subtraction.
    Paper,
    /// The same recursion with w = r(x − a)/(r(x − a) + (b − x)), r = α/(α − 1), and 1 − w by subtraction; for another
    /// family with w = rise/over.
    Ratio,
    /// The triangle of The NURBS Book (A2.2) with r: one quotient for each pair of products, no subtraction; for another
    /// family with rise, fall and over.
    Triangle,
    /// [`Precision::Fast`].
    Fast,
    /// [`Precision::Accurate`].
    Accurate,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Paper, Self::Ratio, Self::Triangle, Self::Fast, Self::Accurate];

    /// Those that any family has.
    pub const OF_MEMBERS: [Self; 2] = [Self::Ratio, Self::Triangle];

    /// Its name in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Ratio => "ratio",
            Self::Triangle => "triangle",
            Self::Fast => "fast",
            Self::Accurate => "accurate",
        }
    }

    /// G_{j−k}, …, G_j of the case. A member of another family has only [`Self::OF_MEMBERS`]: others give no number.
    #[must_use]
    pub fn values(self, case: &Probe) -> Vec<f64> {
        let (alpha, x) = (case.basis.alpha(), case.x);
        let (ends, terms) = (ends(case), terms(case));
        let mut values = match self {
            Self::Paper | Self::Fast | Self::Accurate if case.member.is_some() => {
                vec![f64::NAN; case.basis.degree() + 1]
            }
            Self::Paper if alpha.is_infinite() => recursion(case, |d, c| {
                let (a, b) = ends(d, c);
                (x - a) / (b - a)
            }),
            Self::Paper => recursion(case, |d, c| {
                let (a, b) = ends(d, c);
                alpha * (x - a) / (x + (alpha - 1.0) * b - alpha * a)
            }),
            Self::Ratio => recursion(case, |d, c| {
                let [rise, _, over] = terms(d, c);
                rise / over
            }),
            Self::Triangle => triangle(case, terms),
            Self::Fast => {
                let mut values = vec![0.0; case.basis.degree() + 1];
                match case.basis.values_on(case.span, &[x], Precision::Fast, &mut values) {
                    Ok(()) => values,
                    Err(error) => unreachable!("a case is a point of its span: {error}"),
                }
            }
            Self::Accurate => {
                let mut values = vec![0.0; case.basis.degree() + 1];
                case.basis.at_point(case.span, x, &mut values);
                values
            }
        };
        case.basis.blank(Some(case.span), &mut values);
        values
    }

    /// The proved bound on its error in units in the last place, where there is one: for exact values from 2⁻⁹⁰⁰ up, in every
    /// case that it [applies to](Self::bound_applies). But for the half unit of the last rounding, a relative error of
    /// c·2⁻⁵³ is at most c units.
    #[must_use]
    pub fn bound(self, degree: usize) -> Option<f64> {
        let k = u32::try_from(degree).map_or(f64::INFINITY, f64::from);
        match self {
            Self::Paper | Self::Ratio => None,
            Self::Triangle => Some(9.0 * k),
            Self::Fast if degree <= FAST_DEGREE => Some(k * k + 7.0 * k),
            Self::Fast | Self::Accurate => Some(0.5 + k / f64::from(1 << 22) / f64::from(1 << 22)),
        }
    }

    /// Is the case in the range in which the bound is proved? For the formulas of this library every case is. The
    /// triangle needs all its sums r(x − a) + (b − x) between 2⁻¹⁰⁰ and 2¹⁰⁰: then nothing overflows, and no underflow
    /// matters.
    #[must_use]
    pub fn bound_applies(self, case: &Probe) -> bool {
        match self {
            _ if case.member.is_some() => false,
            Self::Paper | Self::Ratio => false,
            Self::Fast | Self::Accurate => true,
            Self::Triangle => {
                // The sums as they are rounded: one in the narrower range is in the wider one.
                let (range, terms) = (power(-99)..power(99), terms(case));
                let level = |d: usize| (0..d).map(move |c| (d, c));
                let mut levels = (1..=case.basis.degree()).flat_map(level);
                levels.all(|(d, c)| range.contains(&terms(d, c)[2]))
            }
        }
    }

    /// Is it proved that a value is 0 if and only if the exact one is?
    #[must_use]
    pub fn keeps_signs(self) -> bool {
        matches!(self, Self::Fast | Self::Accurate)
    }
}

/// r = α/(α − 1), rounded.
fn ratio(case: &Probe) -> f64 {
    let alpha = case.basis.alpha();
    if alpha.is_infinite() { 1.0 } else { alpha / (alpha - 1.0) }
}

/// (t_i, t_{i+d}) by d and c, i = j − d + 1 + c.
fn ends(case: &Probe) -> impl Fn(usize, usize) -> (f64, f64) {
    let (degree, knots) = (case.basis.degree(), case.basis.local(case.span));
    move |d, c| (knots[degree - d + c], knots[degree + c])
}

/// rise, fall and over of w_i^d, likewise.
fn terms(case: &Probe) -> impl Fn(usize, usize) -> [f64; 3] {
    let (ends, r) = (ends(case), ratio(case));
    move |d, c| {
        if let Some(member) = &case.member {
            return member.terms(case.span, case.x, d, c);
        }
        let (a, b) = ends(d, c);
        let (rise, fall) = (r * (case.x - a), b - case.x);
        [rise, fall, rise + fall]
    }
}

/// G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1} on the span, for w_i^d = `weight`(d, c).
fn recursion(case: &Probe, weight: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let degree = case.basis.degree();
    let mut values = vec![1.0];
    for d in 1..=degree {
        // The weight of entry c of the lower degree.
        let w = |c: usize| weight(d, c);
        let upper = (0..=d).map(|c| {
            let own = c.checked_sub(1).map(|below| w(below) * values[below]);
            let next = values.get(c).map(|value| (1.0 - w(c)) * value);
            match (own, next) {
                (Some(own), Some(next)) => own + next,
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => 0.0,
            }
        });
        values = upper.collect();
    }
    values
}

fn triangle(case: &Probe, terms: impl Fn(usize, usize) -> [f64; 3]) -> Vec<f64> {
    let degree = case.basis.degree();
    let mut values = [1.0; HIGHEST_DEGREE + 1];
    for d in 1..=degree {
        let mut own = 0.0;
        for (c, value) in values.iter_mut().enumerate().take(d) {
            let [left, right, over] = terms(d, c);
            let share = *value / over;
            *value = own + right * share;
            own = left * share;
        }
        values[d] = own;
    }
    values[..=degree].to_vec()
}
