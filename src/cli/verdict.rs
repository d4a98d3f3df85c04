//! Verdicts on a terminal, and as exit codes.

use std::fmt;

use anstyle::{AnsiColor, Style};

use crate::report::{Finding, Record};

use super::exit::Exit;

/// The status in its colour, with the reach of a proof.
pub(super) fn styled(finding: &Finding) -> String {
    let colour = match finding.status.as_str() {
        "proved" => Some(AnsiColor::Green),
        "refuted" => Some(AnsiColor::Red),
        "undecided" => Some(AnsiColor::Yellow),
        _ => None,
    };
    coloured(&finding.words(), colour)
}

/// The verdict on a claim as printed: a refutation comes with its severity, in red only if the idea fails.
pub(super) fn styled_as_printed(record: &Record) -> String {
    match (record.as_printed.finding.is_refuted(), record.is_serious()) {
        (true, true) => coloured(&record.words(), Some(AnsiColor::Red)),
        (true, false) => coloured(&record.words(), Some(AnsiColor::Yellow)),
        (false, _) => styled(&record.as_printed.finding),
    }
}

fn coloured(text: &str, colour: Option<AnsiColor>) -> String {
    let style = Style::new().fg_color(colour.map(Into::into));
    format!("{style}{text}{style:#}")
}

/// How many findings have each status.
#[derive(Debug, Default)]
pub(super) struct Tally {
    counts: Vec<(String, usize)>,
}

impl<'a> FromIterator<&'a Finding> for Tally {
    fn from_iter<I: IntoIterator<Item = &'a Finding>>(findings: I) -> Self {
        let mut tally = Self::default();
        for finding in findings {
            match tally.counts.iter_mut().find(|(status, _)| *status == finding.status) {
                Some((_, count)) => *count += 1,
                None => tally.counts.push((finding.status.clone(), 1)),
            }
        }
        tally
    }
}

impl Tally {
    fn has(&self, status: &str) -> bool {
        self.counts.iter().any(|(other, _)| other == status)
    }

    /// 1 if something is refuted, otherwise 3 if something is undecided, otherwise 0.
    pub(super) fn exit(&self) -> Exit {
        if self.has("refuted") {
            Exit::Refuted
        } else if self.has("undecided") {
            Exit::Undecided
        } else {
            Exit::Holds
        }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts: Vec<_> = self.counts.iter().map(|(status, count)| format!("{count} {status}")).collect();
        f.write_str(&counts.join(", "))
    }
}
