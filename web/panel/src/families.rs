//! Families and their members.

use knotproof::judge::simplest_member;
use knotproof::language::families;
use knotproof::scalar::parse_rational;
use knotproof::spline::Index;
use knotproof::typed::{Asked, Provenance, TypedError, family_named, numbers, whole_number};
use serde_json::{Value, json};

use crate::Answer;

/// The families that come with the program, but for those whose members are chosen by an index: that is α.
pub(crate) fn all() -> Value {
    let others = families().iter().filter(|family| family.moebius().is_none());
    let shown = others.map(|family| {
        let parameters =
            family.parameters.iter().map(|own| json!({ "parameter": own.head(), "bound": own.says }));
        json!({
            "name": family.name,
            "title": family.title,
            "weight": family.ratio(true),
            "parameters": parameters.collect::<Vec<_>>(),
        })
    });
    json!({ "families": shown.collect::<Vec<_>>() })
}

/// The simplest settings of a family on the knots that are typed.
pub(crate) fn member(asked: &Asked) -> Answer {
    let family = family_named(asked.family.trim())?;
    let m = numbers(&asked.knots, &Provenance::option("--knots"))?.len().saturating_sub(1);
    let k = whole_number(&asked.degree).unwrap_or(0);
    let settings = simplest_member(&family, &[], m, k);
    let set: Vec<_> = settings.iter().map(|(name, values)| format!("{name}={values}")).collect();
    Ok(json!({ "set": set }))
}

/// α of a slope ratio.
pub(crate) fn index(ratio: &str) -> Answer {
    let wrong = |why: String| TypedError::Value { field: "--alpha <A>", text: ratio.to_owned(), why };
    let exact = parse_rational(ratio).map_err(|error| wrong(error.to_string()))?;
    let index = Index::from_ratio(exact).map_err(|error| wrong(error.to_string()))?;
    Ok(json!({ "alpha": index.to_string() }))
}
