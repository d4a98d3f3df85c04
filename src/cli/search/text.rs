//! What `search` and `merge` print for people.

use std::fmt;

use crate::scalar::{parse_rational, settled_digits};
use crate::search::{FindingRecord, Goal, MemberSpace, Portion, Space, UndecidedRecord};

use super::super::table::{HEADING, plain};

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
        let open = match tally.undecided {
            0 => [", each decided", ""].map(str::to_owned),
            undecided => [String::new(), format!(", {undecided} not decided")],
        };
        writeln!(
            f,
            "{} cases{}: {} by intervals, {} exactly{}; {} {} more than one local maximum",
            tally.cases(),
            open[0],
            tally.by_intervals,
            tally.exactly,
            open[1],
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
        for open in part.undecided() {
            let UndecidedRecord { at, gaps, family, why } = open;
            writeln!(f, "Not decided at position {at}: gaps {}, {family}: {why}", gaps.join(" "))?;
        }
        if findings.is_empty() {
            let known = if tally.undecided == 0 { "None" } else { "None that is decided" };
            return write!(f, "\n{known} has {what}.");
        }
        writeln!(
            f,
            "\n{HEADING}Functions with {what}: {}{HEADING:#}, {}",
            findings.len(),
            if search.find == Goal::Deepest { "deepest first" } else { "shrunk, smallest first" }
        )?;
        let weights = if matches!(search.space, Space::Family(_)) { "parameters" } else { "α" };
        let mut table = plain(["gaps", weights, "maxima", "dip ≈", "cases"]);
        for record in findings.records() {
            table.add_row([
                record.gaps.join(" "),
                weights_of(record),
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

/// α, or between which ones, or the parameters of the family.
fn weights_of(record: &FindingRecord) -> String {
    let set = |(name, values): (&String, &String)| format!("{name} = {values}");
    match (&record.witness.equal, &record.alpha, &record.family) {
        (Some(equal), ..) => format!("{} to {}", equal.alpha[0], equal.alpha[1]),
        (None, Some(alpha), _) => alpha.clone(),
        (None, None, Some(family)) => family.parameters.iter().map(set).collect::<Vec<_>>().join(", "),
        (None, None, None) => String::new(),
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
        Space::Family(family) => {
            let cases = match &family.cases {
                MemberSpace::Exhaustive(limits) => {
                    let mut text = format!("all functions up to size {}", limits.size);
                    for (limit, name) in [(limits.gap, "gaps"), (limits.height, "heights of parameters")] {
                        if let Some(limit) = limit {
                            text += &format!(", {name} up to {limit}");
                        }
                    }
                    text
                }
                MemberSpace::Random(sample) => format!(
                    "{} random functions, seed {}, gaps and parameters spread over factors up to 2^{}",
                    sample.count, sample.seed, sample.spread
                ),
            };
            let set: Vec<_> =
                family.set.iter().map(|(name, values)| format!(", {name} = {values}")).collect();
            format!("family {}{}: {cases}", family.name, set.concat())
        }
        Space::Random(sample) => format!(
            "{} random functions, seed {}, gaps and ratios spread over factors up to 2^{}",
            sample.count, sample.seed, sample.spread
        ),
    }
}
