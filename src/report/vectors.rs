//! Exact values for the tests of other programs: every function of a basis, at the knots and between them, with one-sided derivatives.

use num_rational::BigRational;
use num_traits::Pow;
use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::OfFamily;
use crate::language::Adjective;
use crate::meaning::{MemberError, Weighting, has};
use crate::scalar::{Jet, RationalAlgebra, integer, rational};
use crate::spline::{Active, Basis, KnotVector, Sampler, Side};

/// A basis with what its functions are at some points.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct VectorCase {
    /// What is special about the knots; one name is used once for each degree.
    pub name: &'static str,
    /// k.
    pub degree: usize,
    /// α, or nothing for a member of a family without an index.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha: Option<String>,
    /// The member of a family without an index.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub family: Option<OfFamily>,
    /// t_0, …, t_m, as fractions in lowest terms.
    pub knots: Vec<String>,
    /// n + 1 = m − k, the number of functions.
    pub functions: usize,
    /// Left of t_0, all stop knots, places between them, and right of t_m.
    pub points: Vec<VectorPoint>,
}

/// The functions at a point.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct VectorPoint {
    /// x.
    pub x: String,
    /// The values, and the limits of the derivatives from the right; at t_m the limits from the left.
    pub right: OneSided,
    /// The limits from the left, at knots: between them both sides are the same.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<OneSided>,
}

/// The functions that are not 0 on the span next to a point.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct OneSided {
    /// The index of the first of them.
    pub first: usize,
    /// Entry e is the list of their derivatives of order e; empty where all functions are 0.
    pub derivatives: Vec<Vec<String>>,
}

/// Knots for a degree k, with what is special about them.
///
/// Ends and inner knots of every multiplicity up to k + 2, gaps as small as 2⁻⁶⁰ and as large as 2⁶⁰, knots far from 0. All of them
/// are numbers that an `f64` has: who computes in floats is asked for the functions on just these knots.
fn knots(k: usize) -> Vec<(&'static str, Vec<BigRational>)> {
    let copies = |t: BigRational, count: usize| vec![t; count];
    let between = |first: usize, inner: Vec<Vec<BigRational>>, end: i64, last: usize| {
        [copies(integer(0), first), inner.concat(), copies(integer(end), last)].concat()
    };
    let clamped = |inner: &[BigRational], end: i64| between(k + 1, vec![inner.to_vec()], end, k + 1);
    let power = |exponent: i32| integer(2).pow(exponent);
    let mut all = vec![
        ("no inner knots", clamped(&[], 1)),
        ("equidistant inner knots", clamped(&[1, 2, 3].map(integer), 4)),
        ("uneven inner knots", clamped(&[rational(3, 8), integer(1), rational(5, 2)], 4)),
        ("not clamped", (0..2 * k + 5).map(|i| rational(i64::try_from(i).unwrap_or(0), 2)).collect()),
        (
            "not clamped, uneven",
            (0..2 * k + 5).map(|i| rational(i64::try_from(i * i + i).unwrap_or(0), 2)).collect(),
        ),
        ("a knot less at the ends", between(k.max(1), vec![[1, 2].map(integer).to_vec()], 3, k.max(1))),
        ("a knot more at the ends", between(k + 2, vec![[1, 2].map(integer).to_vec()], 3, k + 2)),
        ("knots side by side", between(k + 1, vec![copies(integer(1), k), copies(integer(2), k)], 3, k + 1)),
        ("a tiny gap", clamped(&[integer(1), integer(1) + power(-40)], 2)),
        ("a gap from one float to the next", clamped(&[integer(1), integer(1) + power(-52)], 2)),
        ("a huge gap", clamped(&[integer(1), power(60)], 1 << 61)),
        ("tiny and huge gaps", clamped(&[power(-60), integer(1)], 1 << 60)),
    ];
    for (name, count) in [
        ("a knot of k - 1 copies", k.saturating_sub(1)),
        ("a knot of k copies", k),
        ("a knot of k + 1 copies", k + 1),
        ("a knot of k + 2 copies", k + 2),
    ] {
        if count > 1 {
            all.push((name, between(k + 1, vec![copies(integer(1), count), vec![integer(2)]], 3, k + 1)));
        }
    }
    let far = clamped(&[1, 2].map(integer), 3).into_iter().map(|t| t + power(40)).collect();
    all.push(("far from 0", far));
    all.push(("below 0", clamped(&[1, 2].map(integer), 3).into_iter().map(|t| t - rational(7, 2)).collect()));
    all
}

/// The exact values of the functions of a member of a family, up to the derivatives of the given order, on knots of every kind for
/// degree k that are what the family asks of `knots`; `weights` gives the member for m and k.
///
/// # Errors
/// [`MemberError`], if a member has no weights on some knots.
pub fn vectors(
    adjectives: &[Adjective],
    weights: impl Fn(usize, usize) -> Result<Weighting, MemberError>,
    k: usize,
    order: usize,
) -> Result<Vec<VectorCase>, MemberError> {
    let mut cases = Vec::new();
    for (name, knots) in knots(k) {
        let Ok(knots) = KnotVector::new(knots) else { continue };
        if adjectives.iter().any(|adjective| !has(*adjective, &knots, k)) {
            continue;
        }
        let member = weights(knots.m(), k)?;
        let own = member.on_knots(&knots, k)?;
        let Ok(basis) = Basis::over(knots, k, own) else { continue };
        let mut sampler = Sampler::new(&basis);
        let mut side = |x: &BigRational, side: Side| OneSided::of(sampler.jets(x, side, order));
        let mut points = Vec::new();
        for (x, is_knot) in places(basis.knots()) {
            let left = is_knot.then(|| side(&x, Side::Left));
            points.push(VectorPoint { right: side(&x, Side::Right), left, x: x.to_string() });
        }
        cases.push(VectorCase {
            name,
            degree: k,
            alpha: member.index().map(ToString::to_string),
            family: OfFamily::of(&member),
            knots: basis.knots().knots().iter().map(ToString::to_string).collect(),
            functions: basis.n() + 1,
            points,
        });
    }
    Ok(cases)
}

/// Where to look, and whether it is a knot: at stop knots, at three places of each span, and outside. These, too, are numbers that
/// an `f64` has, the ones next to an eighth, a half and three quarters of the span, as far as there are any inside.
fn places(knots: &KnotVector) -> Vec<(BigRational, bool)> {
    let stops: Vec<_> = knots.stop_knots().map(|(t, _)| t.clone()).collect();
    let length = knots.last() - knots.first();
    let mut all = vec![(knots.first() - &length, false)];
    for pair in stops.windows(2) {
        all.push((pair[0].clone(), true));
        let length = &pair[1] - &pair[0];
        let between =
            [(1, 8), (1, 2), (3, 4)].map(|(p, q)| 0.0.embed(&(&pair[0] + &length * rational(p, q))));
        let between = between.into_iter().filter_map(BigRational::from_float);
        all.extend(between.filter(|x| pair[0] < *x && *x < pair[1]).map(|x| (x, false)));
    }
    all.push((knots.last().clone(), true));
    all.push((knots.last() + length, false));
    all
}

impl OneSided {
    fn of(functions: Option<Active<Jet<BigRational>>>) -> Self {
        let Some(functions) = functions else { return Self { first: 0, derivatives: Vec::new() } };
        let all: Vec<_> = functions.values().iter().map(Jet::derivatives).collect();
        let orders = all.first().map_or(0, Vec::len);
        let of_order = |e: usize| all.iter().map(|of| of[e].to_string()).collect();
        Self { first: functions.first(), derivatives: (0..orders).map(of_order).collect() }
    }
}
