//! What `shape` says of all functions.

use knotproof::analysis::{Extremum, ExtremumKind, Location, Pieces, Shape, settled_apart, turns_back};
use knotproof::scalar::rational;
use knotproof::spline::{AnyWeights, Basis};
use knotproof::typed::{Asked, Case};
use serde_json::{Value, json};

use crate::{Answer, exact};

/// Settled digits of places and values, and 2 to this power the longest interval for one that is not known exactly: those of
/// `shape`.
const DIGITS: usize = 10;
const WIDTH: u32 = 20;

/// The fields of `shape`, without its slopes; of a function that is negative somewhere only that.
pub(crate) fn of(asked: &Asked) -> Answer {
    let Case { weights, basis, .. } = asked.case()?;
    let pieces = Pieces::of(&basis);
    // Of an index no function is negative.
    let may_be_negative = weights.index().is_none();
    let functions = (0..=basis.n()).map(|i| match may_be_negative && !pieces.is_nonnegative(i) {
        true => json!({ "index": i, "negative": true }),
        false => function(&basis, &pieces, i),
    });
    Ok(json!({ "functions": functions.collect::<Vec<_>>() }))
}

fn function(basis: &Basis<AnyWeights>, pieces: &Pieces, i: usize) -> Value {
    let mut shape = Shape::of(pieces, i);
    shape.refine_to(&rational(1, 1 << WIDTH));
    let mut places: Vec<_> = shape.extrema().iter().map(Extremum::x).collect();
    let mut heights: Vec<_> = shape.extrema().iter().map(Extremum::height).collect();
    let places = settled_apart(&mut places, DIGITS, |_| true);
    let heights = settled_apart(&mut heights, DIGITS, |at| turns_back(shape.extrema(), shape.jumps(), at));
    let extrema = shape.extrema().iter().zip(places.iter().zip(&heights)).map(|(extremum, (x, height))| {
        let ((from, to), (least, most)) = (extremum.place.interval(), &extremum.value);
        json!({
            "kind": match extremum.kind {
                ExtremumKind::Maximum => "maximum",
                ExtremumKind::Minimum => "minimum",
            },
            "interval": exact([from, to]),
            "x": x,
            "at_knot": extremum.at_knot,
            "plateau": matches!(extremum.place, Location::Plateau { .. }),
            "value": exact([least, most]),
            "height": height,
        })
    });
    let extrema: Vec<_> = extrema.collect();
    let jumps = shape.jumps().iter().map(|jump| {
        let [at, left, right] = [&jump.at, &jump.left, &jump.right].map(ToString::to_string);
        json!({ "at": at, "left": left, "right": right })
    });
    let (from, to) = basis.support(i);
    json!({
        "index": i,
        "support": exact([from, to]),
        "local_maxima": shape.local_maxima().count(),
        "local_minima": shape.local_minima().count(),
        "strong": shape.strong(),
        "weak": shape.weak(),
        "extrema": extrema,
        "jumps": jumps.collect::<Vec<_>>(),
    })
}
