//! Functions and the curve in floats, by the program's own recursion, for a drawing only.

use knotproof::scalar::RationalAlgebra;
use knotproof::spline::{Active, AnyWeights, Curve};
use knotproof::typed::{Asked, Case};
use serde_json::{Value, json};

use crate::Answer;

/// Points on each span, both ends among them.
const POINTS: u32 = 65;

/// The knots, and of each span the functions that live there, from `first` on, and the curve, at evenly spaced points.
pub(crate) fn of(asked: &Asked) -> Answer {
    let Case { basis, curve, .. } = asked.case()?;
    let (knots, k, n) = (basis.knots(), basis.degree(), basis.n());
    let rounded = |t| 0.0_f64.embed(t);
    let spans = knots.spans().filter_map(|span| {
        let (j, (from, to)) =
            (span.index(), (rounded(knots.t(span.index())), rounded(knots.t(span.index() + 1))));
        let at = |s: u32| {
            if s + 1 == POINTS { to } else { from + (to - from) * f64::from(s) / f64::from(POINTS - 1) }
        };
        // Knots that floats can't tell apart leave no points between them.
        let rows: Vec<(f64, Active<f64>)> =
            (0..POINTS).map(at).filter_map(|x| Some((x, basis.active(span, &x).ok()?))).collect();
        let (_, start) = rows.first()?;
        // Outside of [t_k, t_{n+1}] the functions don't add up to 1, and there is no curve.
        let traced = curve.as_ref().filter(|_| (k..=n).contains(&j));
        Some(json!({
            "x": rows.iter().map(|(x, _)| x).collect::<Vec<_>>(),
            "first": start.first(),
            "functions": rows.iter().map(|(_, row)| row.values().to_vec()).collect::<Vec<_>>(),
            "curve": traced.map(|curve| trace(curve, &rows)),
        }))
    });
    let spans: Vec<Value> = spans.collect();
    let stops = knots
        .stop_knots()
        .map(|(t, times)| json!({ "at": rounded(t), "exact": t.to_string(), "times": times }));
    Ok(json!({
        "knots": stops.collect::<Vec<_>>(),
        "count": n + 1,
        "points": curve.as_ref().map(|curve| curve.points().iter().map(|point| point.iter().map(rounded).collect()).collect::<Vec<Vec<f64>>>()),
        "spans": spans,
    }))
}

fn trace(curve: &Curve<AnyWeights>, rows: &[(f64, Active<f64>)]) -> Vec<Vec<f64>> {
    rows.iter().filter_map(|(_, row)| curve.combine(row).ok()).collect()
}
