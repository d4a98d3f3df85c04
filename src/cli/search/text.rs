//! What `search` and `merge` print for people.

use std::fmt;

use anstyle::Style;

use crate::scalar::{parse_rational, settled_digits};
use crate::search::{FindingRecord, Goal, Portion, Space};

use super::super::table::plain;

const HEADING: Style = Style::new().bold();

/// The result of a search, as text.
pub(in super::super) struct Summary<'a>(pub(in super::super) &'a Portion);

impl fmt::Display for Summary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(part) = self;
        let (search, tally, findings) = (part.search(), part.decided(), part.findings());
        writeln!(f, "Degree {}, {}", search.degree, space(&search.space))?;
        if !part.shard().is_whole() {
            writeln!(f, "Shard {} of these", part.shard())?;
        }
        writeln!(
            f,
            "{} cases, each decided: {} by intervals, {} exactly; {} {} more than one local maximum",
            tally.cases(),
            tally.by_intervals,
            tally.exactly,
            tally.several,
            if tally.several == 1 { "has" } else { "have" }
        )?;
        let what = match search.find {
            Goal::Several => "more than one local maximum".to_owned(),
            Goal::Most if findings.is_empty() => "more than one local maximum".to_owned(),
            Goal::Most => format!("{} local maxima, the most of all", findings.most_maxima()),
            Goal::Equal => "two equal largest maxima for some α".to_owned(),
            Goal::Deepest if findings.is_empty() => "more than one local maximum".to_owned(),
            Goal::Deepest => "the deepest dips between two maxima".to_owned(),
        };
        if findings.is_empty() {
            return write!(f, "\nNone has {what}.");
        }
        writeln!(
            f,
            "\n{HEADING}Functions with {what}: {}{HEADING:#}, {}",
            findings.len(),
            if search.find == Goal::Deepest { "deepest first" } else { "shrunk, smallest first" }
        )?;
        let mut table = plain(["gaps", "α", "maxima", "dip ≈", "cases"].map(str::to_owned).to_vec());
        for record in findings.records() {
            table.add_row([
                record.gaps.join(" "),
                alpha(record),
                record.witness.local_maxima.to_string(),
                dip(record),
                record.cases.to_string(),
            ]);
        }
        writeln!(f, "{}", table.trim_fmt())?;
        writeln!(f, "\n{HEADING}To see them{HEADING:#}")?;
        findings.records().try_for_each(|record| writeln!(f, "{}", record.reproduce))
    }
}

/// The dip to as many digits as its bounds settle, up to five.
fn dip(record: &FindingRecord) -> String {
    let [lo, hi] = record.witness.dip.each_ref().map(|bound| parse_rational(bound));
    let both = lo.ok().zip(hi.ok());
    both.and_then(|(lo, hi)| settled_digits(&lo, &hi, 5)).unwrap_or_else(|| record.witness.dip.join(" to "))
}

fn alpha(record: &FindingRecord) -> String {
    match &record.witness.equal {
        None => record.alpha.clone(),
        Some(equal) => format!("{} to {}", equal.alpha[0], equal.alpha[1]),
    }
}

fn space(space: &Space) -> String {
    match space {
        Space::Exhaustive(limits) => {
            let mut text = format!("all functions up to size {}", limits.size);
            for (limit, name) in [(limits.gap, "gaps"), (limits.height, "heights of α")] {
                if let Some(limit) = limit {
                    text += &format!(", {name} up to {limit}");
                }
            }
            text
        }
        Space::Indices(sample) => format!(
            "{} random functions with α = {}, seed {}, gaps spread over factors up to 2^{}",
            sample.count,
            sample.alpha.join(" or "),
            sample.seed,
            sample.spread
        ),
        Space::Random(sample) => format!(
            "{} random functions, seed {}, gaps and ratios spread over factors up to 2^{}",
            sample.count, sample.seed, sample.spread
        ),
    }
}
