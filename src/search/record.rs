//! Results as text: one line of JSON for each finding, and a last one that says what was searched.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::json::{self, JsonError};
use crate::language::PaperNumber;

use super::block::{BlockRecord, is_zero};
use super::decide::Decided;
use super::finding::{DEEPEST_KEPT, FindingError, FindingRecord, SCHEMA};
use super::portion::{Portion, PortionError};
use super::shard::{Shard, ShardError};
use super::space::{Goal, Search};
use super::subject::Subject;
use super::undecided::UndecidedRecord;

/// The version that results carry: another one may draw or order cases differently.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// A digest of the sources of everything that decides a case: of two programs with the same one the same comes out.
const DECIDES: &str = env!("KNOTPROOF_DECIDES");
const SUMMARY: &str = "summary";

/// The last line: what was searched, how far, and a checksum of it all.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SummaryRecord {
    /// `knotproof.search/1`.
    #[schemars(extend("const" = "knotproof.search/1"))]
    pub schema: String,
    /// `summary`.
    #[schemars(extend("const" = "summary"))]
    pub record: String,
    /// The version of the program.
    pub version: String,
    /// The paper whose Conjecture 3.1 it is about.
    pub paper: PaperNumber,
    /// A digest of the sources that decide, of the program that wrote this.
    pub decides: String,
    /// What is looked for, and where.
    pub search: Search,
    /// The number of positions of the whole space.
    pub positions: u64,
    /// The number of cases of the whole space.
    pub count: u64,
    /// Which shard this is, if it is not the whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<String>,
    /// The first position of this part.
    pub from: u64,
    /// The position after its last one.
    pub to: u64,
    /// The position after the last one that is done.
    pub done: u64,
    /// The number of cases that were looked at.
    pub cases: u64,
    /// How.
    pub decided: DecidedRecord,
    /// How many of them have more than one local maximum.
    pub several: u64,
    /// The number of findings.
    pub findings: usize,
    /// The first cases that are not decided, by position; left out, if all are decided.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub undecided: Vec<UndecidedRecord>,
    /// What came of each block of positions; only in a text.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub blocks: Vec<BlockRecord>,
    /// CRC-32 of the text with nothing between the quotes of the checksum, in 8 hexadecimal digits; only in a text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub checksum: Option<String>,
}

/// Cases by what decided them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DecidedRecord {
    /// By intervals with outward rounding.
    pub by_intervals: u64,
    /// In exact arithmetic.
    pub exactly: u64,
    /// Not at all; left out, if all are decided.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub undecided: u64,
}

/// Why a text is not the result of a search.
#[derive(Debug, Error)]
pub enum RecordError {
    /// The last line is no summary.
    #[error("the last line is no summary of a search ({0}): the file is cut off, or something else")]
    NoSummary(String),
    /// A text that has to be read in another way.
    #[error(
        "it is of another format, `{0}`, and this version reads `{SCHEMA}`: use the version that wrote it"
    )]
    Format(String),
    /// Another version of the program.
    #[error(
        "it was written by version {0}, and this is version {VERSION}: search again, or use that version"
    )]
    Version(String),
    /// The same version, built from other sources.
    #[error(
        "it was written by a program whose deciding sources are others ({0}, and here {DECIDES}): search again, or use \
         that program"
    )]
    Decides(String),
    /// A line is no finding.
    #[error("line {line}: {error}: the file is damaged")]
    Line {
        /// From 1.
        line: usize,
        /// What is wrong.
        error: JsonError,
    },
    /// A finding does not stand.
    #[error("line {line}: {error}: the file is damaged")]
    Finding {
        /// From 1.
        line: usize,
        /// What is wrong.
        error: FindingError,
    },
    /// What it says of the space is not so.
    #[error("{0}: the file is damaged")]
    Space(#[from] PortionError),
    /// Numbers that do not add up, or a wrong checksum.
    #[error("{0}: the file is damaged")]
    Damaged(&'static str),
}

/// Enough of a summary to tell who wrote it.
#[derive(Deserialize)]
struct Origin {
    schema: String,
    version: Option<String>,
    decides: Option<String>,
}

impl Portion {
    /// The lines, each with its line break: a complete part is what `merge` reads, any other one what a search is
    /// resumed from. [`parse`](Self::parse) reads it back.
    ///
    /// # Errors
    /// If the serializer fails, which it does not for these types.
    pub fn to_text(&self) -> Result<String, serde_json::Error> {
        let mut text = String::new();
        for record in self.findings.records() {
            text.push_str(&serde_json::to_string(record)?);
            text.push('\n');
        }
        let mut summary = self.summary();
        summary.blocks = self.blocks.records(&(self.range.start..self.done));
        summary.checksum = Some(String::new());
        let line = serde_json::to_string(&summary)?;
        summary.checksum = Some(format!("{:08x}", crc32fast::hash((text.clone() + &line).as_bytes())));
        text.push_str(&serde_json::to_string(&summary)?);
        text.push('\n');
        Ok(text)
    }

    /// The last line, without its blocks and its checksum.
    #[must_use]
    pub fn summary(&self) -> SummaryRecord {
        let Decided { by_intervals, exactly, several, undecided } = self.decided;
        SummaryRecord {
            schema: SCHEMA.to_owned(),
            record: SUMMARY.to_owned(),
            version: VERSION.to_owned(),
            paper: PaperNumber::default(),
            decides: DECIDES.to_owned(),
            search: self.search.clone(),
            positions: self.cases.positions(),
            count: self.cases.count(),
            shard: (!self.shard.is_whole()).then(|| self.shard.to_string()),
            from: self.range.start,
            to: self.range.end,
            done: self.done,
            cases: self.decided.cases(),
            decided: DecidedRecord { by_intervals, exactly, undecided },
            several,
            findings: self.findings.len(),
            undecided: self.undecided.records().cloned().collect(),
            blocks: Vec::new(),
            checksum: None,
        }
    }

    /// Reads what [`to_text`](Self::to_text) has written, and accepts nothing else: every finding is computed again, all
    /// numbers have to fit, and the text has to be the same, byte by byte, when it is written again.
    ///
    /// # Errors
    /// [`RecordError`], for the first thing that is wrong.
    pub fn parse(text: &str) -> Result<Self, RecordError> {
        let mut lines: Vec<&str> = text.lines().collect();
        let last = lines.pop().ok_or_else(|| RecordError::NoSummary("there is no line".to_owned()))?;
        let no_summary = |error: JsonError| RecordError::NoSummary(error.to_string());
        let origin: Origin = json::read(last).map_err(no_summary)?;
        if origin.schema != SCHEMA {
            return Err(RecordError::Format(origin.schema));
        }
        if let Some(version) = origin.version.filter(|version| version != VERSION) {
            return Err(RecordError::Version(version));
        }
        if let Some(decides) = origin.decides.filter(|decides| decides != DECIDES) {
            return Err(RecordError::Decides(decides));
        }
        let summary: SummaryRecord = json::read(last).map_err(no_summary)?;
        let shard = match &summary.shard {
            None => Ok(Shard::WHOLE),
            Some(shard) => shard.parse().map_err(|error: ShardError| RecordError::Space(error.into())),
        };
        let mut part = Self::new(summary.search.clone(), shard?)?;
        if !(part.range.start..=part.range.end).contains(&summary.done) {
            return Err(RecordError::Damaged("the position that is done lies outside of the part"));
        }
        part.done = summary.done;
        let DecidedRecord { by_intervals, exactly, undecided } = summary.decided;
        part.decided = Decided { by_intervals, exactly, several: summary.several, undecided };
        part.check_tally().map_err(RecordError::Damaged)?;
        let done = part.range.start..part.done;
        part.blocks.read(&summary.blocks, &done, part.decided).map_err(RecordError::Damaged)?;
        for (line, text) in (1..).zip(lines) {
            let record: FindingRecord =
                json::read(text).map_err(|error| RecordError::Line { line, error })?;
            part.add_record(&record).map_err(|error| RecordError::Finding { line, error })?;
        }
        part.check_findings().map_err(RecordError::Damaged)?;
        part.add_undecided(summary.undecided).map_err(RecordError::Damaged)?;
        match part.to_text() {
            Ok(again) if again == text => Ok(part),
            _ if text.contains('\r') => Err(RecordError::Damaged(
                "its line endings are CRLF, and were LF: copy it again without a change of line endings",
            )),
            _ => Err(RecordError::Damaged("its content and its checksum do not fit together")),
        }
    }

    /// Can there be such numbers of cases? No sum of them overflows then, in this part nor in a whole search.
    fn check_tally(&self) -> Result<(), &'static str> {
        let (decided, several) = (self.decided, self.decided.several);
        let (positions, count) = (self.cases.positions(), self.cases.count());
        let most = self.done().min(count);
        let cases = decided.checked_cases().filter(|&cases| cases <= most);
        let cases = cases.ok_or("there are more cases than the positions that are done can have")?;
        // At most one case stands at each of the other positions.
        if cases < count.saturating_sub(positions - self.done()) {
            return Err("there are fewer cases than the positions that are done must have");
        }
        if several > cases {
            return Err("`several` is larger than the number of cases");
        }
        Ok(())
    }

    /// Adds a finding that a case of this part may have led to.
    fn add_record(&mut self, record: &FindingRecord) -> Result<(), FindingError> {
        if !(1..=self.decided.several).contains(&record.cases) {
            return Err(FindingError::Cases);
        }
        let at = record.found_at;
        let case = (self.range.start..self.done).contains(&at);
        let case = case.then(|| self.cases.subjects(at..at.saturating_add(1)).next()).flatten();
        let Some((_, case)) = case else { return Err(FindingError::Place) };
        let maxima = case.maxima().unwrap_or(0);
        let subject = match self.cases.members() {
            None => record.candidate().map(Subject::Index),
            Some(members) => record.member(members).map(Subject::Member),
        };
        let subject = subject.filter(|subject| subject.gaps().len() == self.search.degree + 1);
        let subject = subject.ok_or(FindingError::Candidate)?;
        let leads = match self.search.find {
            Goal::Several | Goal::Equal => maxima > 1,
            Goal::Most => maxima == record.witness.local_maxima,
            Goal::Deepest => case == subject,
        };
        if !leads {
            return Err(FindingError::Place);
        }
        self.findings.add_record(self.search.find, subject, record)
    }

    /// Adds the first cases that are not decided, after looking at them again.
    fn add_undecided(&mut self, records: Vec<UndecidedRecord>) -> Result<(), &'static str> {
        for record in records {
            let at = record.at;
            let case = (self.range.start..self.done).contains(&at);
            let case = case.then(|| self.cases.subjects(at..at.saturating_add(1)).next()).flatten();
            let again = match &case {
                Some((_, Subject::Member(function))) => {
                    function.local_maxima().err().map(|why| UndecidedRecord::new(at, function, why))
                }
                _ => None,
            };
            if again.as_ref() != Some(&record) {
                return Err("a case that is said not to be decided is, or for another reason");
            }
            self.undecided.add(record);
        }
        if self.undecided.are_first_of(self.decided.undecided) {
            Ok(())
        } else {
            Err("the cases that are not decided are not as many as it says")
        }
    }

    /// Can the cases with several maxima have led to the findings?
    fn check_findings(&self) -> Result<(), &'static str> {
        let several = u128::from(self.decided.several);
        let led: u128 = self.findings.records().map(|record| u128::from(record.cases)).sum();
        match self.search.find {
            Goal::Several if led != several => Err("the cases of the findings do not add up to `several`"),
            _ if led > several => Err("the cases of the findings add up to more than `several`"),
            Goal::Most | Goal::Deepest if led == 0 && several > 0 => Err(
                "`several` is not 0, and there is no finding with the most local maxima or the deepest dip",
            ),
            Goal::Deepest if self.findings.len() > DEEPEST_KEPT => {
                Err("there are more findings than are kept")
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{Goal, Limits, Space};

    fn part(find: Goal, size: u64) -> Portion {
        let space = Space::Exhaustive(Limits { size, gap: None, height: None });
        let mut part = Portion::new(Search { degree: 3, find, space }, Shard::WHOLE).unwrap();
        part.run(|_| Ok::<(), ()>(())).unwrap();
        part
    }

    #[test]
    fn what_is_written_is_read_back() {
        for find in [Goal::Several, Goal::Most, Goal::Equal, Goal::Deepest] {
            let part = part(find, 8);
            let text = part.to_text().unwrap();
            assert_eq!(text.lines().count(), part.findings().len() + 1);
            assert_eq!(Portion::parse(&text).unwrap().to_text().unwrap(), text);
        }
        assert!(!part(Goal::Several, 8).findings().is_empty());
    }

    /// Whatever byte is changed or missing at the end.
    #[test]
    fn damage_is_noticed() {
        let text = part(Goal::Several, 8).to_text().unwrap();
        for place in 0..text.len() {
            let mut bytes = text.clone().into_bytes();
            bytes[place] ^= 1;
            if let Ok(text) = String::from_utf8(bytes) {
                assert!(Portion::parse(&text).is_err(), "byte {place}");
            }
            if text.is_char_boundary(place) {
                assert!(Portion::parse(&text[..place]).is_err(), "cut at {place}");
            }
        }
        assert!(Portion::parse(&(text.clone() + "\n")).is_err());
        assert!(Portion::parse(&(text.clone() + &text)).is_err());
    }

    /// The text with a valid checksum, after some changes of it.
    fn forged(text: &str, changes: &[(&str, &str)]) -> String {
        let mut text = text.to_owned();
        for (from, to) in changes {
            assert!(text.contains(from), "{from} in {text}");
            text = text.replace(from, to);
        }
        let (content, _) = text.rsplit_once("\"checksum\":").unwrap();
        let sum = crc32fast::hash(format!("{content}\"checksum\":\"\"}}").as_bytes());
        format!("{content}\"checksum\":\"{sum:08x}\"}}\n")
    }

    /// Whoever writes a valid checksum as well: numbers that cannot be are an error, and no overflow.
    #[test]
    fn impossible_numbers_are_refused() {
        let part = part(Goal::Several, 8);
        let (text, summary) = (part.to_text().unwrap(), part.summary());
        assert!(Portion::parse(&forged(&text, &[])).is_ok());
        let last = text.lines().last().unwrap();
        let decided = &last[last.find("\"decided\"").unwrap()..last.find(",\"several\"").unwrap()];
        let cases = format!("\"cases\":{},", summary.cases);
        for (exactly, sum, rule) in [
            (summary.cases, summary.cases + 1, "more cases than"),
            (u64::MAX, 0, "more cases than"),
            (summary.cases - 2, summary.cases - 1, "fewer cases than"),
        ] {
            let numbers = format!("\"decided\":{{\"by_intervals\":1,\"exactly\":{exactly}}}");
            let changes = [(decided, &*numbers), (&cases, &*format!("\"cases\":{sum},"))];
            let error = Portion::parse(&forged(&text, &changes)).unwrap_err().to_string();
            assert!(error.contains(rule), "{exactly}: {error}");
        }
        let max = u64::MAX;
        let at = text.split("\"found_at\":").nth(1).unwrap().split(',').next().unwrap();
        let place = |at: &str| format!("\"found_at\":{at},");
        let one = "\"cases\":1}";
        for (from, to, rule) in [
            ("\"several\":1,", &*format!("\"several\":{max},"), "`several` is larger"),
            ("\"several\":1,", "\"several\":2,", "do not add up"),
            (one, &*format!("\"cases\":{max}}}"), "`cases` is not from 1"),
            (one, "\"cases\":0}", "`cases` is not from 1"),
            (&*place(at), &*place(&max.to_string()), "`found_at`"),
            (&*place(at), &*place("0"), "`found_at`"),
            (&*place(at), &*place(&summary.to.to_string()), "`found_at`"),
        ] {
            let error = Portion::parse(&forged(&text, &[(from, to)])).unwrap_err().to_string();
            assert!(error.contains(rule), "{to}: {error}");
        }
        // Another goal: the crossing has no proof, or there is no finding.
        let goal = |goal: &'static str| ("\"find\":\"several\"", goal);
        let equal = forged(&text, &[goal("\"find\":\"equal\"")]);
        assert!(matches!(
            Portion::parse(&equal),
            Err(RecordError::Finding { error: FindingError::Refuted, .. })
        ));
        let last = forged(last, &[goal("\"find\":\"most\""), ("\"findings\":1,", "\"findings\":0,")]);
        assert!(Portion::parse(&last).unwrap_err().to_string().contains("no finding"));
    }

    #[test]
    fn converted_line_endings_are_named() {
        let text = part(Goal::Several, 8).to_text().unwrap().replace('\n', "\r\n");
        assert!(Portion::parse(&text).unwrap_err().to_string().contains("line endings"));
    }

    #[test]
    fn another_format_is_named() {
        let text = part(Goal::Several, 7).to_text().unwrap().replace(SCHEMA, "knotproof.search/2");
        for text in [&*text, "{\"schema\":\"knotproof.search/2\"}"] {
            let error = Portion::parse(text).unwrap_err();
            assert!(matches!(&error, RecordError::Format(schema) if schema == "knotproof.search/2"));
            assert!(!error.to_string().contains("damaged"));
        }
    }

    #[test]
    fn another_version_is_named() {
        let text = part(Goal::Several, 7).to_text().unwrap();
        let other = text.replace(&format!("\"version\":\"{VERSION}\""), "\"version\":\"0.0.9\"");
        assert!(matches!(Portion::parse(&other), Err(RecordError::Version(version)) if version == "0.0.9"));
    }
}
