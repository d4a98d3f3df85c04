//! What matters, in a few lines: all from the data of the report.

use crate::scalar::BigRational;

use super::Report;
use super::corners::{Corner, Turn};
use super::record::{DegreeFinding, Record, degrees};

/// The lines that a report opens with. What was not judged has none.
#[must_use]
pub fn opening(report: &Report) -> Vec<String> {
    let lines = [
        report.dependence.sentence.clone(),
        conjecture(report),
        corners(report),
        variation(report),
        errata(report),
    ];
    lines.into_iter().flatten().collect()
}

/// The claim whose picture belongs to the opening.
pub(super) const CONJECTURE: &str = "Conj3.1.strong.continuous";
const VARIATION: &str = "X.variation";

/// The first degree from which on a claim is refuted, and all that is known degree by degree.
fn false_from(report: &Report, id: &str) -> Option<(usize, String)> {
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

fn conjecture(report: &Report) -> Option<String> {
    let (from, known) = false_from(report, CONJECTURE)?;
    Some(format!(
        "Conjecture 3.1, one maximum for each function, is false from k = {from} on, for continuous functions too: {known}."
    ))
}

fn variation(report: &Report) -> Option<String> {
    let (from, known) = false_from(report, VARIATION)?;
    Some(format!(
        "Curves do not diminish variation from k = {from} on: a line may meet the curve more often than its polygon ({known})."
    ))
}

/// The largest turn of the tangent, and the largest jump of the speed, where the classical curve has neither.
fn corners(report: &Report) -> Option<String> {
    let smooth = || report.corners.iter().filter(|corner| corner.multiplicity < corner.degree);
    // Of equals the first is shown; the search keeps the last.
    let turns = || smooth().filter_map(|corner| Some((corner, corner.turn.as_ref()?))).rev();
    let (sharpest, turn) = turns().max_by(|(_, a), (_, b)| sharpness(a).cmp(&sharpness(b)))?;
    // Of a curve and its mirror image, the one that gets faster.
    let speed = |turn: &Turn| (jump(turn), turn.speed_ratio_squared.clone());
    let (fastest, jump) = turns().max_by(|(_, a), (_, b)| speed(a).cmp(&speed(b)))?;
    Some(format!(
        "Curves of the paper have corners at knots where the classical curve is smooth: the tangent turns by up to {}° ({}), and the \
         speed jumps by a factor of up to {} ({}).",
        turn.angle_degrees,
        place(sharpest),
        jump.speed_ratio,
        place(fastest)
    ))
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

fn errata(report: &Report) -> Option<String> {
    let refuted = report.summary.paper.refuted;
    let causes = &report.summary.paper.refutations.by_cause;
    let serious = report.claims.iter().filter(|record| record.is_serious());
    let serious: std::collections::BTreeSet<_> = serious
        .filter(|record| record.source == crate::language::Source::Paper)
        .map(|record: &Record| record.cause)
        .collect();
    (refuted > 0).then(|| {
        format!(
            "{refuted} of the paper's {} statements fail as printed, by {} {}, {} of them serious: the errata are ready to be sent.",
            report.summary.paper.statements,
            causes.len(),
            if causes.len() == 1 { "cause" } else { "causes" },
            serious.len()
        )
    })
}
