//! What the panel of the page knows of the paper: its instances, and the sentences that it asks the judge about.

use serde_json::{Value, json};

use crate::language::{Claim, Definition, Form, Paper, Source, classical, source};
use crate::meaning::examples_of;

/// A JSON object that may stand in a `script` element; numbers as they are written.
pub(super) fn json(paper: &Paper) -> String {
    let properties = paper.with(classical().clone());
    // Those of `check`.
    let about_knots =
        |claim: &Claim<'_>| claim.source() == Source::Paper && claim.is_general() && claim.is_about_knots();
    let all = json!({
        "instances": instances(paper),
        "claims": Claim::of(paper).filter(about_knots).filter_map(sentence).collect::<Vec<_>>(),
        "classical": Claim::of(&properties)
            .take(classical().claims.len())
            .filter_map(sentence)
            .collect::<Vec<_>>(),
    });
    // "</" would end the element.
    all.to_string().replace("</", "<\\/")
}

fn instances(paper: &Paper) -> Vec<Value> {
    let written = |list: &[String], between: &str| list.join(between);
    examples_of(&paper.examples, &paper.about.family)
        .iter()
        .map(|instance| {
            let knots: Vec<_> = instance.knots.knots().iter().map(ToString::to_string).collect();
            let indices: Vec<_> = instance.indices().map(ToString::to_string).collect();
            let points = instance.points.iter().flatten();
            let points: Vec<Vec<_>> =
                points.map(|point| point.iter().map(ToString::to_string).collect()).collect();
            json!({
                "name": &*instance.name,
                "figure": instance.figure,
                "degree": instance.degree,
                "knots": written(&knots, " "),
                "indices": indices,
                "points": points,
            })
        })
        .collect()
}

/// The printed sentence in the claim language, with the definitions that it may name; none of those that name other claims.
fn sentence(claim: Claim<'_>) -> Option<Value> {
    let sentence = source(claim.sentence(Form::Printed)?);
    let definitions: Vec<_> = claim.definitions.iter().filter_map(definition).collect();
    (!sentence.contains("claim(")).then(|| {
        json!({ "id": claim.id(), "title": claim.stanza.title, "sentence": sentence, "definitions": definitions })
    })
}

/// Its head and its body.
fn definition(of: &Definition) -> Option<[String; 2]> {
    let text = source(of);
    let (head, body) = text.split_once(" = ")?;
    Some([head.to_owned(), body.to_owned()])
}
