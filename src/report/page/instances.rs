//! The paper's instances, for the panel of the page.

use num_traits::ToPrimitive;
use serde_json::json;

use crate::language::Paper;
use crate::meaning::examples_of;

/// A JSON list that may stand in a `script` element: numbers of knots as they are written, points in `f64`.
pub(super) fn json(paper: &Paper) -> String {
    let list: Vec<_> = examples_of(&paper.examples, &paper.about.family)
        .iter()
        .map(|instance| {
            let knots: Vec<_> = instance.knots.knots().iter().map(ToString::to_string).collect();
            let indices: Vec<_> = instance.indices().map(ToString::to_string).collect();
            let points = instance.points.iter().flatten();
            let points: Vec<Vec<_>> =
                points.map(|point| point.iter().map(|c| c.to_f64()).collect()).collect();
            json!({
                "name": &*instance.name,
                "figure": instance.figure,
                "degree": instance.degree,
                "knots": knots.join(", "),
                "indices": indices,
                "points": points,
            })
        })
        .collect();
    // "</" would end the element.
    serde_json::Value::from(list).to_string().replace("</", "<\\/")
}
