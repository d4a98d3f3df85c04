//! The generated part of `proofs/theory/README.md`: which theorem answers for which claim, and which claims have none, and why.

use std::fmt::Write as _;

use crate::language::{Claim, Source};
use crate::settle::{Covers, Decides, Theorem, Theory};

/// The heading that the generated part begins with, and the one that it ends before.
const BEGIN: &str = "## Claim and theorem\n";
const END: &str = "\n## Where theorem and stanza differ\n";

const TABLE: &str = "\"any\" under weights: true of any numbers in the place of the weights. \"range, inside, left\": of every \
weight with 0 ≤ w ≤ 1, 0 < w < 1 inside of its interval, and 0 at\nits left end. \"of the interval\": of every weight that is a \
function of x and the ends of its interval. \"knot\": of the family of papers/knot-weights. A lemma is more general than its claim, or what it rests on, and answers for nothing \
alone.\nThe table is that of `theorems.toml`, the list after it that of `missing.toml`: `knotproof report --record` writes both.";

/// A cell of the table, as `check.sh table` prints it.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn row(theorem: &Theorem) -> String {
    let Theorem { claim, name, file, says, weights, degrees, .. } = theorem;
    let verdict = match theorem.verdict {
        Decides::Proved => "proved",
        Decides::Refuted => "refuted",
    };
    let covers = match (theorem.covers, &theorem.lacks) {
        (Covers::All, _) => "all".to_owned(),
        (Covers::Part, None) => "part".to_owned(),
        (Covers::Part, Some(lacks)) => format!("part: {}", cell(lacks)),
    };
    let form = theorem.form.name();
    format!(
        "| {claim} | {form} | {verdict} | [`{name}`]({file}) | {} | {degrees} | {weights} | {covers} |\n",
        cell(says)
    )
}

/// The claims of the paper that no theorem says all of: each with the reason, and those about examples by themselves.
fn missing(theory: &Theory, claims: &[Claim<'_>]) -> String {
    let lacks = |claim: &&Claim<'_>| claim.source() == Source::Paper && !theory.has_all_of(**claim);
    let (general, examples): (Vec<&Claim<'_>>, Vec<_>) =
        claims.iter().filter(lacks).partition(|claim| claim.is_general());
    let why = |id: &str| theory.missing_because(id).unwrap_or("no reason is given in missing.toml");
    let mut text = String::from("| claim | why |\n|---|---|\n");
    for id in general.iter().map(|claim| claim.id()) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {id} | {} |", cell(why(id)));
    }
    let examples: Vec<_> = examples.iter().map(|claim| claim.id()).collect();
    let count = examples.len();
    text + &format!(
        "\n{count} more are about the paper's own knots, in the degrees of its figures, and certificates settle them for every α: {}.\n",
        examples.join(", ")
    )
}

/// The part of `proofs/theory/README.md` from the table on.
#[must_use]
pub fn theory_tables(theory: &Theory, claims: &[Claim<'_>]) -> String {
    let head = "| claim | form | verdict | theorem | what it says | degrees | weights | covers |\n|---|---|---|---|---|---|---|---|\n";
    let rows: String = theory.theorems.iter().map(row).collect();
    format!("{BEGIN}\n{TABLE}\n\n{head}{rows}\n### Claims without a theorem\n\n{}", missing(theory, claims))
}

/// The page with that part in the place of its old one; `None` if it has no such place.
#[must_use]
pub fn with_theory_tables(page: &str, theory: &Theory, claims: &[Claim<'_>]) -> Option<String> {
    let (before, rest) = page.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{}{END}{after}", theory_tables(theory, claims)))
}
