//! Plane curves as sets of points.

use num_traits::Signed;

use crate::analysis::{Piece, always_positive, coefficient_rows, rank};
use crate::language::{Argument, Int, Name, Real};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, rational};
use crate::spline::Index;

use super::super::cell::Cell;
use super::super::family::Weighting;
use super::super::reading::Reading;
use super::super::truth::Stop;
use super::super::value::Value;
use super::OfMember;

/// Both coordinates on a span.
type Plane = [Piece; 2];

fn on_span(own: &mut Reading<'_>, curve: [OfMember<'_>; 2], j: usize) -> Result<Plane, Stop> {
    let (name, knots) = (Name::from("x"), own.knots()?);
    let cell = Cell::Open(Some(knots.t(j).clone()), Some(knots.t(j + 1).clone()));
    let [x, y] = curve.map(|(f, member)| {
        let argument = Argument { at: Real::Bound(name.clone()), side: None, member: member.cloned() };
        match own.within(&name, &cell, |own| own.apply(f, &argument))? {
            Value { plain, root: None } => Ok((*plain.piece()).clone()),
            Value { .. } => Err(Stop::Unknown("a coordinate with a square root".into())),
        }
    });
    Ok([x?, y?])
}

fn everywhere(own: &mut Reading<'_>, curve: [OfMember<'_>; 2]) -> Result<Vec<Plane>, Stop> {
    let spans: Vec<_> = own.knots()?.spans().map(|span| span.index()).collect();
    spans.into_iter().map(|j| on_span(own, curve, j)).collect()
}

/// Is some point of the curve farther than a distance ≥ 0 from all points of the curve for α = ∞?
///
/// No, if on every span G_α(u) = G_∞(r·u): then both have the same points. Yes, if one of the points that are tried is, in
/// the middle of each span and near its ends. Otherwise it stays open.
pub(super) fn strays(own: &mut Reading<'_>, curve: [OfMember<'_>; 2], distance: &Real) -> Result<bool, Stop> {
    let distance = own.real(distance)?;
    let distance = distance.number().filter(|distance| !distance.is_negative());
    let square = distance.map(|distance| distance * distance);
    let square = square.ok_or_else(|| Stop::Unknown("a distance is a rational number ≥ 0".into()))?;
    let own_points = everywhere(own, curve)?;
    let classical = own.with_weights(Weighting::Index(Index::infinity()), |own| everywhere(own, curve))?;
    let same = |(one, other): (&Plane, &Plane)| {
        let r = own.weights.index().map(Index::ratio);
        r.is_some_and(|r| (0..2).all(|c| one[c] == other[c].scaled_argument(r)))
    };
    if own_points.iter().zip(&classical).all(same) {
        return Ok(false);
    }
    let tried = [integer(1), rational(1, 7), integer(7)];
    let at = |u: &BigRational, [x, y]: &Plane| Some([x.evaluate(u)?, y.evaluate(u)?]);
    let mut points = own_points.iter().flat_map(|on| tried.iter().filter_map(move |u| at(u, on)));
    if points.any(|point| classical.iter().all(|on| is_beyond(on, &point, &square))) {
        return Ok(true);
    }
    Err(Stop::Unknown("no point that was tried is far enough".into()))
}

/// Are all points of a closed piece of a curve farther from a point than the root of a number?
fn is_beyond(on: &Plane, point: &[BigRational; 2], square: &BigRational) -> bool {
    let [x, y] = [0, 1].map(|c| on[c].minus(&on[c].embed(&point[c])));
    let excess = x.times(&x).plus(&y.times(&y)).minus(&x.embed(square));
    let ends = [excess.evaluate(&integer(0)), excess.at_infinity()];
    ends.iter().flatten().all(Signed::is_positive) && always_positive(&excess).holds()
}

/// The least e with a polynomial of degree e that is 0 on the curve on a span: its monomials are dependent.
pub(super) fn implicit_degree(
    own: &mut Reading<'_>,
    curve: [OfMember<'_>; 2],
    span: &Int,
) -> Result<usize, Stop> {
    let (j, knots) = (own.int(span)?, own.knots()?);
    let span = usize::try_from(j).ok().and_then(|j| knots.span(j));
    let span = span.ok_or_else(|| Stop::Undefined(format!("span {j} does not exist")))?;
    let [x, y] = on_span(own, curve, span.index())?;
    let dependent = |e: usize| {
        let exponents = (0..=e).flat_map(|sum| (0..=sum).map(move |b| (sum - b, b)));
        let monomials: Vec<_> = exponents.map(|(a, b)| x.power(a).times(&y.power(b))).collect();
        let count = monomials.len();
        rank(&coefficient_rows([monomials])) < count
    };
    // Coordinates of degree N over one denominator satisfy an equation of degree N.
    let mut degree = 1;
    while !dependent(degree) {
        degree += 1;
    }
    Ok(degree)
}

#[cfg(test)]
mod tests {
    use crate::language::{Known, sentence};
    use crate::meaning::{Decided, Instance, Names, decide};
    use crate::scalar::integer;
    use crate::spline::{Basis, KnotVector, Point};

    /// Knots, degree, control points.
    type Curve = (&'static [i64], usize, &'static [[i64; 2]]);

    const POINTS: &[[i64; 2]] = &[[0, 0], [3, 9], [6, 3], [9, 6]];
    const QUADRATIC: Curve = (&[0, 0, 0, 1, 2, 2, 2], 2, POINTS);
    const BEZIER: Curve = (&[0, 0, 0, 0, 1, 1, 1, 1], 3, POINTS);
    /// S3, of which the trace does not depend on α.
    const DOUBLE: Curve =
        (&[0, 0, 0, 0, 1, 1, 2, 2, 2, 2], 3, &[[4, 0], [0, 11], [8, 14], [8, 14], [16, 11], [12, 0]]);

    fn decided((knots, degree, points): Curve, alpha: &str, conclusion: &str) -> Decided {
        let known = Known::defining(&[("C[c](x)", "sum(i in 0..n: P[i,c]*G[i](x))")]).unwrap();
        let read = sentence("U in {C}", &[], &[conclusion], &known).unwrap();
        let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect()).unwrap();
        let points = points.iter().map(|point| point.map(integer).to_vec());
        let on = Instance::of(Basis::new(knots, degree, alpha.parse().unwrap()).unwrap());
        let on = on.named("C", Some(points.collect::<Vec<Point>>()));
        decide(&read, &on, Names { definitions: known.definitions(), ..Names::empty() })
    }

    #[test]
    fn curves_stray_where_their_trace_is_another_one() {
        for (curve, conclusion, found) in [
            (QUADRATIC, "strays(C[1], C[2], 0)", true),
            (BEZIER, "not strays(C[1], C[2], 0)", true),
            (DOUBLE, "not strays(C[1], C[2], 1/20)", true),
            (QUADRATIC, "strays(C[1], C[2], 1/20)", true),
            // Farther than any point: that is neither found nor refuted.
            (QUADRATIC, "strays(C[1], C[2], 100)", false),
            (QUADRATIC, "strays(C[1], C[2], -1)", false),
        ] {
            let decided = decided(curve, "-1/2", conclusion);
            assert_eq!((decided.facts == 1, decided.unknown.is_none()), (found, found), "{conclusion}");
        }
    }

    #[test]
    fn the_degree_of_the_trace_is_the_least_one() {
        for (alpha, conclusion) in [
            ("inf", "implicit_degree(G[0], G[2], 2) = 2"),
            ("-1", "implicit_degree(G[0], G[2], 2) > 2"),
            ("2", "implicit_degree(G[0], G[0], 2) = 1"),
        ] {
            assert_eq!(decided(QUADRATIC, alpha, conclusion).facts, 1, "{alpha}: {conclusion}");
        }
        let beyond = decided(QUADRATIC, "2", "implicit_degree(G[0], G[2], 0) = 2");
        assert!(beyond.failure.is_some_and(|failure| failure.undefined.is_some()), "an empty span");
    }
}
