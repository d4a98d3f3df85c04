//! NURBS curves for NURBS-Python (geomdl).

use serde_json::{Value, json};

use super::Rounded;

/// One object `shape` with all curves.
pub(super) fn file(curves: &[Rounded]) -> String {
    let data: Vec<_> = curves.iter().map(spline).collect();
    let shape = json!({ "shape": { "type": "curve", "count": data.len(), "data": data } });
    format!("{shape:#}\n")
}

fn spline(curve: &Rounded) -> Value {
    let dimension = curve.dimension().max(2);
    json!({
        "type": "spline",
        "rational": true,
        "dimension": dimension,
        "degree": curve.degree,
        "knotvector": curve.knots,
        "control_points": { "points": curve.points_in(dimension), "weights": curve.weights },
    })
}
