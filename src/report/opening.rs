//! What matters, in a few lines: all from the data of the report.

use std::collections::BTreeSet;

use num_traits::One;

use crate::language::{Headline, Severity, Source};
use crate::scalar::BigRational;

use super::Report;
use super::corners::{Corner, Turn};
use super::record::{DegreeFinding, degrees};
use super::summary::UNASSIGNED;

/// The lines that a report opens with. What was not judged has none.
#[must_use]
pub fn opening(report: &Report<'_>) -> Vec<String> {
    let mut headlines = headlines(report).map(|(_, line)| line);
    let (first, corners) = (headlines.next(), corners(report));
    let before = report.dependence.sentence.clone().into_iter().chain(first).chain(corners);
    before.chain(headlines).chain(every_degree(report)).chain(errata(report)).collect()
}

/// How many statements are theorems about every degree; nothing if none is.
fn every_degree(report: &Report<'_>) -> Option<String> {
    let counts = &report.summary.paper;
    (counts.in_every_degree > 0).then(|| {
        format!(
            "{} of the paper's {} statements are true of every degree, as printed or as amended: Coq has checked a theorem for each.",
            counts.in_every_degree, counts.statements,
        )
    })
}

/// The lines of the paper's own that are so, each with its claim.
pub(super) fn headlines<'a>(report: &'a Report<'_>) -> impl Iterator<Item = (&'a str, String)> {
    report.of.about.headlines.iter().filter_map(|Headline { claim, refuted }| {
        let (from, known) = false_from(report, claim)?;
        Some((&**claim, refuted.replace("{k}", &from.to_string()).replace("{known}", &known)))
    })
}

/// The first degree from which on a claim is refuted, and all that is known degree by degree.
fn false_from(report: &Report<'_>, id: &str) -> Option<(usize, String)> {
    let record = report.claims.iter().find(|record| record.id == id)?;
    let of = |holds: fn(&DegreeFinding) -> bool| -> Vec<usize> {
        record.by_degree.iter().filter(|of| holds(of)).map(|of| of.degree).collect()
    };
    let refuted = of(|found| found.finding.is_refuted());
    let proved = of(|found| found.finding.is_proved());
    let known = match proved.is_empty() {
        true => format!("refuted for {}", degrees(&refuted)),
        false => format!("refuted for {}, proved for {}", degrees(&refuted), degrees(&proved)),
    };
    Some((*refuted.first()?, known))
}

/// The largest turn of the tangent, and the largest jump of the speed, where the classical curve has neither; nothing if there
/// is none.
fn corners(report: &Report<'_>) -> Option<String> {
    let smooth = || report.corners.iter().filter(|corner| corner.multiplicity < corner.degree);
    // Of equals the first is shown; the search keeps the last.
    let turns = || smooth().filter_map(|corner| Some((corner, corner.turn.as_ref()?))).rev();
    let (sharpest, turn) = turns().max_by(|(_, a), (_, b)| sharpness(a).cmp(&sharpness(b)))?;
    // Of a curve and its mirror image, the one that gets faster.
    let speed = |turn: &Turn| (jump(turn), turn.speed_ratio_squared.clone());
    let (fastest, jump) = turns().max_by(|(_, a), (_, b)| speed(a).cmp(&speed(b)))?;
    let corner = (!turn.cos2.is_one() || turn.turns_back)
        .then(|| format!("the tangent turns by up to {}° ({})", turn.angle_degrees, place(sharpest)));
    let jumps = (!jump.speed_ratio_squared.is_one())
        .then(|| format!("the speed jumps by a factor of up to {} ({})", jump.speed_ratio, place(fastest)));
    let told: Vec<String> = corner.iter().chain(&jumps).cloned().collect();
    let noun = if corner.is_some() { "corners" } else { "jumps of their speed" };
    (!told.is_empty()).then(|| {
        format!(
            "Curves of the paper have {noun} at knots where the classical curve is smooth: {}.",
            told.join(", and ")
        )
    })
}

/// Larger for a larger angle: the angle is acute or obtuse, and then its cosine decides.
fn sharpness(turn: &Turn) -> (bool, BigRational) {
    (turn.turns_back, if turn.turns_back { turn.cos2.clone() } else { -turn.cos2.clone() })
}

/// How much the square of the speed changes, up or down.
fn jump(turn: &Turn) -> BigRational {
    let ratio = &turn.speed_ratio_squared;
    ratio.clone().max(ratio.recip())
}

fn place(corner: &Corner) -> String {
    let Corner { instance, degree, alpha, knot, .. } = corner;
    format!("{instance}, k = {degree}, α = {alpha}, knot {knot}")
}

fn errata(report: &Report<'_>) -> Option<String> {
    let refuted = report.summary.paper.refuted;
    let causes = &report.summary.paper.refutations.by_cause;
    let of_paper = || report.claims.iter().filter(|record| record.source == Source::Paper);
    let serious: BTreeSet<_> = of_paper()
        .filter(|record| record.severity == Some(Severity::Serious))
        .map(|record| record.cause)
        .collect();
    let unnamed = causes.get(UNASSIGNED).copied().unwrap_or_default();
    let named = causes.len() - usize::from(unnamed > 0);
    let by = match named {
        1 => format!(", by 1 cause, {} of them serious", serious.len()),
        named => format!(", by {named} causes, {} of them serious", serious.len()),
    };
    let no_cause = if unnamed > 0 { format!("; of {unnamed} no cause is named") } else { String::new() };
    (refuted > 0).then(|| {
        format!(
            "{refuted} of the paper's {} statements fail as printed{}{no_cause}: the errata are ready to be sent.",
            report.summary.paper.statements,
            if named > 0 { by } else { String::new() },
        )
    })
}
