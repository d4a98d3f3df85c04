//! The ways to compute the basis in `f64` that are compared.

use super::super::batch::Precision;
use super::super::error::HIGHEST_DEGREE;
use super::super::power::power;
use super::probe::Probe;

/// One way to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// The recursion of D3.3 with the weight as the paper prints it, α(x − a)/(x + (α − 1)b − αa), and 1 − w by
    /// subtraction.
    Paper,
    /// The same recursion with w = r(x − a)/(r(x − a) + (b − x)), r = α/(α − 1), and 1 − w by subtraction.
    Ratio,
    /// The triangle of The NURBS Book (A2.2) with r: one quotient for each pair of products, no subtraction.
    Triangle,
    /// [`Precision::Fast`].
    Fast,
    /// [`Precision::Accurate`].
    Accurate,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Paper, Self::Ratio, Self::Triangle, Self::Fast, Self::Accurate];

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

    /// G_{j−k}, …, G_j of the case.
    #[must_use]
    pub fn values(self, case: &Probe) -> Vec<f64> {
        let (alpha, x) = (case.basis.alpha(), case.x);
        let r = ratio(case);
        let mut values = match self {
            Self::Paper if alpha.is_infinite() => recursion(case, |a, b| (x - a) / (b - a)),
            Self::Paper => recursion(case, |a, b| alpha * (x - a) / (x + (alpha - 1.0) * b - alpha * a)),
            Self::Ratio => recursion(case, |a, b| r * (x - a) / (r * (x - a) + (b - x))),
            Self::Triangle => triangle(case, r),
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
            Self::Fast if degree <= super::super::fast::FAST_DEGREE => Some(k * k + 7.0 * k),
            Self::Fast | Self::Accurate => Some(0.5 + k / f64::from(1 << 22) / f64::from(1 << 22)),
        }
    }

    /// Is the case in the range in which the bound is proved? For the formulas of this library every case is. The
    /// triangle needs all its sums r(x − a) + (b − x) between 2⁻¹⁰⁰ and 2¹⁰⁰: then nothing overflows, and no underflow
    /// matters.
    #[must_use]
    pub fn bound_applies(self, case: &Probe) -> bool {
        match self {
            Self::Paper | Self::Ratio => false,
            Self::Fast | Self::Accurate => true,
            Self::Triangle => {
                let (degree, knots, r) = (case.basis.degree(), case.basis.local(case.span), ratio(case));
                // The sums as they are rounded: one in the narrower range is in the wider one.
                let range = power(-99)..power(99);
                let sum = |a: f64, b: f64| r * (case.x - a) + (b - case.x);
                let level = |d: usize| (0..d).map(move |c| (degree - d + c, degree + c));
                (1..=degree).flat_map(level).all(|(a, b)| range.contains(&sum(knots[a], knots[b])))
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

/// G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1} on the span, for w_i^d = `weight`(t_i, t_{i+d}).
fn recursion(case: &Probe, weight: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let (degree, knots) = (case.basis.degree(), case.basis.local(case.span));
    let mut values = vec![1.0];
    for d in 1..=degree {
        // The weight of entry c of the lower degree.
        let w = |c: usize| weight(knots[degree - d + c], knots[degree + c]);
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

fn triangle(case: &Probe, r: f64) -> Vec<f64> {
    let (degree, knots) = (case.basis.degree(), case.basis.local(case.span));
    let mut values = [1.0; HIGHEST_DEGREE + 1];
    for d in 1..=degree {
        let mut own = 0.0;
        for c in 0..d {
            let (left, right) = (r * (case.x - knots[degree - d + c]), knots[degree + c] - case.x);
            let share = values[c] / (left + right);
            values[c] = own + right * share;
            own = left * share;
        }
        values[d] = own;
    }
    values[..=degree].to_vec()
}
