//! What a search has found: shrunk, each once, with a witness and the command that shows it.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::analysis::{Crossing, ExtremumKind, Flank};
use crate::judge::OfFamily;
use crate::scalar::{BigRational, parse_rational};
use crate::spline::Index;

use super::candidate::Candidate;
use super::decide::local_maxima;
use super::dip::Dip;
use super::members::{MemberFunction, Members};
use super::mismatch::Mismatch;
use super::shrink::smaller_gaps;
use super::space::Goal;
use super::subject::Subject;

/// The schema of every line of a result, and what a line of it is.
pub(super) const SCHEMA: &str = "knotproof.search/1";
const FINDING: &str = "finding";

/// A function that was looked for; of an index in normal form.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    subject: Subject,
    maxima: usize,
    crossing: Option<Crossing>,
    /// Where findings are in the order of their dips, that.
    dip: Option<Dip>,
}

/// The order of findings, and what they are known by.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    /// The deepest dip comes first.
    depth: Reverse<Option<BigRational>>,
    subject: Subject,
}

/// What a case has to reach to be of interest beside the findings that are there.
#[derive(Debug, Clone, Default)]
pub(super) struct Bar {
    maxima: usize,
    depth: Option<BigRational>,
}

/// How many of the deepest functions are kept.
pub const DEEPEST_KEPT: usize = 10;

/// Findings, each once, in the order of candidates, or of their dips if these are looked for. How it was put together does not matter: each operation is
/// commutative and associative.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Findings {
    entries: BTreeMap<Key, Entry>,
}

/// A finding with its record, which takes longer to compute than everything else.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    finding: Finding,
    record: FindingRecord,
}

/// A finding as the line of a file; rational numbers are strings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FindingRecord {
    /// `knotproof.search/1`.
    #[schemars(extend("const" = "knotproof.search/1"))]
    pub schema: String,
    /// `finding`.
    #[schemars(extend("const" = "finding"))]
    pub record: String,
    /// k.
    pub degree: usize,
    /// The gaps between the knots of the function.
    pub gaps: Vec<String>,
    /// A full knot vector with the function on it.
    pub knots: Vec<String>,
    /// α; for equal maxima the lower end of the interval of indices; nothing for another family.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alpha: Option<String>,
    /// The member of another family, with its parameters on these knots.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub family: Option<OfFamily>,
    /// i.
    pub index: usize,
    /// What shows it.
    pub witness: Evidence,
    /// The command that computes it again.
    pub reproduce: String,
    /// The position of the first case that led to it.
    pub found_at: u64,
    /// The number of cases that led to it.
    pub cases: u64,
}

/// The extrema of a finding, on its full knot vector.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Evidence {
    /// How many local maxima there are at α.
    pub local_maxima: usize,
    /// From left to right.
    pub extrema: Vec<ExtremumRecord>,
    /// Bounds of its dip, the deepest fall between two maxima as a share of the largest value: decimals of ten digits, equal if it is known exactly.
    pub dip: [String; 2],
    /// For equal maxima: the proof that they exist at some index of an interval.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equal: Option<EqualRecord>,
}

/// A local maximum or minimum.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExtremumRecord {
    /// `maximum` or `minimum`.
    #[schemars(extend("enum" = ["maximum", "minimum"]))]
    pub kind: String,
    /// Bounds of x, equal if it is known exactly.
    pub interval: [String; 2],
    /// Is it at a knot?
    pub at_knot: bool,
}

/// Two largest maxima that are equal for some index of an interval.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EqualRecord {
    /// Between these indices the two largest maxima are equal at least once.
    pub alpha: [String; 2],
    /// A point between them, for all indices of the interval lower than…
    pub valley: String,
    /// …this one.
    pub above_valley: String,
    /// The side of the valley that is higher at the first index, and at the second.
    pub higher: [String; 2],
    /// At either index, a value between the largest ones of the two sides.
    pub separated_by: [String; 2],
}

/// Why a line is no finding of the search.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FindingError {
    /// The numbers cannot be read, or are no candidate.
    #[error("its gaps and its α, or parameters, are no function of the search in normal form")]
    Candidate,
    /// Computed again, it is not what the search looks for.
    #[error("computed again, the function does not have what was found")]
    Refuted,
    /// The first case that led to it is none.
    #[error("`found_at` is no position that is done and that leads to what was found")]
    Place,
    /// Not as many cases as can be.
    #[error("`cases` is not from 1 to `several`")]
    Cases,
    /// Of the largest number of local maxima, and there are two numbers.
    #[error("it has another number of local maxima than the findings before it, so not all have the most")]
    NotMost,
    /// Computed again, it comes out differently.
    #[error("computed again, its record is another one")]
    Different,
}

impl Finding {
    /// What a case leads to, if it has what is looked for, and reaches the bar: shrunk as far as it goes, but for the
    /// deepest dips, where it is the case itself. It depends on the goal and the case only.
    #[must_use]
    pub(super) fn from_case(goal: Goal, subject: &Subject, maxima: usize, bar: &Bar) -> Option<Self> {
        if maxima < bar.maxima.max(2) {
            return None;
        }
        match goal {
            Goal::Several => Some(Self::of(subject.clone().shrunk(|maxima| maxima > 1))),
            Goal::Most => Some(Self::of(subject.clone().shrunk(|near| near == maxima))),
            Goal::Equal => {
                let candidate = subject.candidate()?;
                let near = Crossing::near(candidate.gaps(), candidate.ratio())?;
                Self::of_crossing(shrunk_crossing(near))
            }
            Goal::Deepest => {
                let dip = Dip::at_least(subject.extrema(), bar.depth.as_ref())?;
                Some(Self { subject: subject.clone(), maxima, crossing: None, dip: Some(dip) })
            }
        }
    }

    fn of(subject: Subject) -> Self {
        let maxima = subject.maxima().unwrap_or(0);
        Self { subject, maxima, crossing: None, dip: None }
    }

    fn of_crossing(crossing: Crossing) -> Option<Self> {
        let candidate = Candidate::new(crossing.gaps().to_vec(), crossing.ends()[1]).ok()?;
        Some(Self { crossing: Some(crossing), ..Self::of(Subject::Index(candidate)) })
    }

    /// The function; for equal maxima at the lower end of the interval of indices.
    #[must_use]
    pub fn subject(&self) -> &Subject {
        &self.subject
    }

    /// How many local maxima it has there.
    #[must_use]
    pub fn maxima(&self) -> usize {
        self.maxima
    }

    /// Equal maxima are the same finding if the gaps are: any α leads to the same place. Dips with the same ten digits
    /// count as equally deep.
    fn key(&self) -> Key {
        let subject = match &self.crossing {
            None => self.subject.clone(),
            Some(_) => Subject::Index(Candidate::assumed(self.subject.gaps().to_vec(), (1, 1))),
        };
        Key { depth: Reverse(self.dip.as_ref().map(|dip| dip.lo.clone())), subject }
    }

    fn record(&self, found_at: u64, cases: u64) -> FindingRecord {
        let (subject, full) = (&self.subject, self.subject.full_knots());
        let knots: Vec<_> = full.knots.iter().map(ToString::to_string).collect();
        let turns = subject.extrema();
        let extrema = turns.iter().map(|turn| ExtremumRecord {
            kind: match turn.kind {
                ExtremumKind::Maximum => "maximum".to_owned(),
                ExtremumKind::Minimum => "minimum".to_owned(),
            },
            interval: <[_; 2]>::from(turn.place.interval()).map(ToString::to_string),
            at_knot: turn.at_knot,
        });
        let extrema = extrema.collect();
        let dip = self.dip.clone().or_else(|| Dip::of_turns(turns));
        let Some(Dip { lo, hi }) = dip else { unreachable!("between two maxima is a minimum") };
        let dip = [lo, hi].map(|bound| bound.to_string());
        let equal = self.crossing.as_ref().map(EqualRecord::of);
        let weights = match (&equal, subject) {
            (Some(equal), _) => format!("--alpha {} --alpha {}", equal.alpha[0], equal.alpha[1]),
            (None, Subject::Index(candidate)) => format!("--alpha {}", candidate.index()),
            (None, Subject::Member(function)) => function.of_family().to_string(),
        };
        let degree = subject.gaps().len().saturating_sub(1);
        FindingRecord {
            schema: SCHEMA.to_owned(),
            record: FINDING.to_owned(),
            degree,
            gaps: subject.gaps().iter().map(ToString::to_string).collect(),
            reproduce: format!(
                "knotproof shape --degree {degree} --knots \"{}\" {weights} --index {}",
                knots.join(" "),
                full.index
            ),
            knots,
            alpha: subject.candidate().map(|candidate| candidate.index().to_string()),
            family: subject.member().map(MemberFunction::of_family),
            index: full.index,
            witness: Evidence { local_maxima: self.maxima, extrema, dip, equal },
            found_at,
            cases,
        }
    }
}

/// A crossing on the smallest gaps near, each time looked for from the middle of the last one.
fn shrunk_crossing(mut crossing: Crossing) -> Crossing {
    let next = |crossing: &Crossing| {
        let gaps = crossing.gaps();
        let mut smaller: Vec<_> = smaller_gaps(gaps)
            .into_iter()
            .filter_map(|gaps| Candidate::new(gaps, crossing.middle()).ok())
            .map(|candidate| candidate.normal_form())
            .collect();
        smaller.sort();
        smaller.dedup();
        let several = |candidate: &Candidate| local_maxima(candidate).maxima > 1;
        let smaller =
            smaller.iter().filter(|candidate| candidate.gaps().iter().sum::<u64>() < gaps.iter().sum());
        smaller
            .filter(|candidate| several(candidate))
            .find_map(|candidate| Crossing::near(candidate.gaps(), candidate.ratio()))
    };
    while let Some(smaller) = next(&crossing) {
        crossing = smaller;
    }
    crossing
}

impl FindingRecord {
    /// The function of an index that it is about.
    pub(super) fn candidate(&self) -> Option<Candidate> {
        let index: Index = self.alpha.as_ref()?.parse().ok()?;
        let (p, q) = (index.ratio().numer().try_into().ok()?, index.ratio().denom().try_into().ok()?);
        Candidate::new(self.whole_gaps()?, (p, q)).ok().filter(Candidate::is_normal)
    }

    /// The function of a member of another family that it is about.
    pub(super) fn member(&self, members: &Arc<Members>) -> Option<MemberFunction> {
        members.read(self.whole_gaps()?, self.family.as_ref()?)
    }

    fn whole_gaps(&self) -> Option<Vec<u64>> {
        self.gaps.iter().map(|gap| gap.parse().ok()).collect()
    }
}

impl EqualRecord {
    fn of(crossing: &Crossing) -> Self {
        let [lower, upper] = crossing.at_ends();
        let side = |side| match side {
            Flank::Left => "left".to_owned(),
            Flank::Right => "right".to_owned(),
        };
        let [valley, above_valley] = crossing.points().clone().map(|x| x.to_string());
        Self {
            alpha: crossing.indices().map(|alpha| alpha.to_string()),
            valley,
            above_valley,
            higher: [side(lower.0), side(upper.0)],
            separated_by: [lower.1.to_string(), upper.1.to_string()],
        }
    }
}

impl Findings {
    /// Adds what the case at a position has led to.
    pub(super) fn add(&mut self, finding: &Finding, position: u64) {
        self.add_counted(finding, position, 1);
    }

    fn add_counted(&mut self, finding: &Finding, position: u64, cases: u64) {
        match self.entries.get_mut(&finding.key()) {
            None => {
                let record = finding.record(position, cases);
                self.entries.insert(finding.key(), Entry { finding: finding.clone(), record });
            }
            Some(entry) => {
                let (position, cases) = (entry.record.found_at.min(position), entry.record.cases + cases);
                if finding.rank() < entry.finding.rank() {
                    *entry = Entry { finding: finding.clone(), record: finding.record(position, cases) };
                } else {
                    (entry.record.found_at, entry.record.cases) = (position, cases);
                }
            }
        }
    }

    /// Adds the findings of another part of the same search.
    pub(super) fn merge(&mut self, other: Self) {
        for Entry { finding, record } in other.entries.into_values() {
            self.add_counted(&finding, record.found_at, record.cases);
        }
    }

    /// Keeps those that count: with the largest number of local maxima, or the deepest. What goes now would go later
    /// as well, so it does not matter when that is done.
    pub(super) fn keep(&mut self, goal: Goal) {
        match goal {
            Goal::Most => {
                let most = self.most_maxima();
                self.entries.retain(|_, entry| entry.finding.maxima == most);
            }
            Goal::Deepest => while self.entries.len() > DEEPEST_KEPT && self.entries.pop_last().is_some() {},
            Goal::Several | Goal::Equal => {}
        }
    }

    /// What a case has to reach, or [`keep`](Self::keep) would drop it.
    pub(super) fn bar(&self, goal: Goal) -> Bar {
        let last = self.entries.last_key_value().filter(|_| self.entries.len() >= DEEPEST_KEPT);
        match goal {
            Goal::Most => Bar { maxima: self.most_maxima(), depth: None },
            Goal::Deepest => Bar { maxima: 0, depth: last.and_then(|(key, _)| key.depth.0.clone()) },
            Goal::Several | Goal::Equal => Bar::default(),
        }
    }

    /// The largest number of local maxima of a finding; 0 if there is none.
    #[must_use]
    pub fn most_maxima(&self) -> usize {
        self.entries.values().map(|entry| entry.finding.maxima).max().unwrap_or(0)
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Is there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The findings, smallest first, or deepest first.
    pub fn iter(&self) -> impl Iterator<Item = &Finding> {
        self.entries.values().map(|entry| &entry.finding)
    }

    /// Their records, in the same order.
    pub fn records(&self) -> impl Iterator<Item = &FindingRecord> {
        self.entries.values().map(|entry| &entry.record)
    }

    /// What is wrong with these findings, if those of the cases at some positions are `again`.
    pub(super) fn faults(&self, again: &Self, goal: Goal, positions: &Range<u64>) -> Vec<Mismatch> {
        // Whatever counts among all has to be here already.
        let mut joined = self.clone();
        joined.merge(again.clone());
        joined.keep(goal);
        let counts = again.entries.iter().filter(|(key, _)| joined.entries.contains_key(key));
        let missing = counts.filter_map(|(key, found)| match self.entries.get(key) {
            None => Some(Mismatch::Missing { function: found.finding.subject.to_string() }),
            Some(own) => {
                let earlier = found.record.found_at < own.record.found_at;
                let more = found.record.cases > own.record.cases;
                (earlier || more || found.finding.rank() < own.finding.rank())
                    .then(|| Mismatch::Altered { function: own.finding.subject.to_string() })
            }
        });
        let said = self.entries.iter().filter(|(_, own)| positions.contains(&own.record.found_at));
        let invented = said.filter_map(|(key, own)| {
            let at = own.record.found_at;
            let found = again.entries.get(key).is_some_and(|found| found.record.found_at == at);
            (!found).then(|| Mismatch::Invented { function: own.finding.subject.to_string(), at })
        });
        missing.chain(invented).collect()
    }

    /// The records that are not the same in `all`, which has the same findings.
    pub(super) fn altered<'a>(&'a self, all: &'a Self) -> impl Iterator<Item = Mismatch> + 'a {
        let differs = |(key, own): &(&Key, &Entry)| all.entries.get(key).is_none_or(|found| found != *own);
        let altered = |own: &Entry| Mismatch::Altered { function: own.finding.subject.to_string() };
        self.entries.iter().filter(differs).map(move |(_, own)| altered(own))
    }

    /// Adds a finding about a function from a file, after computing all of it again.
    pub(super) fn add_record(
        &mut self,
        goal: Goal,
        subject: Subject,
        record: &FindingRecord,
    ) -> Result<(), FindingError> {
        let finding = Finding::from_record(goal, subject, record)?;
        let entry = Entry { record: finding.record(record.found_at, record.cases), finding };
        if entry.record != *record || self.entries.contains_key(&entry.finding.key()) {
            return Err(FindingError::Different);
        }
        let first = self.entries.values().next().map_or(entry.finding.maxima, |first| first.finding.maxima);
        if goal == Goal::Most && first != entry.finding.maxima {
            return Err(FindingError::NotMost);
        }
        self.entries.insert(entry.finding.key(), entry);
        Ok(())
    }
}

impl Finding {
    fn from_record(goal: Goal, subject: Subject, record: &FindingRecord) -> Result<Self, FindingError> {
        let finding = match (goal, &record.witness.equal) {
            (Goal::Equal, Some(equal)) => {
                let points = [&equal.valley, &equal.above_valley].map(|x| parse_rational(x).ok());
                let ratio = |alpha: &String| Crossing::ratio(&parse_rational(alpha).ok()?);
                match (points, [ratio(&equal.alpha[1]), ratio(&equal.alpha[0])]) {
                    ([Some(c), Some(d)], [Some(low), Some(high)]) => {
                        Crossing::new(subject.gaps(), [low, high], [c, d]).and_then(Self::of_crossing)
                    }
                    _ => None,
                }
            }
            (Goal::Equal, None) => None,
            (Goal::Several | Goal::Most, _) => Some(Self::of(subject)),
            (Goal::Deepest, _) => subject.dip().map(|dip| Self { dip: Some(dip), ..Self::of(subject) }),
        };
        finding.filter(|finding| finding.maxima > 1).ok_or(FindingError::Refuted)
    }

    /// Which of two findings about the same function is kept.
    fn rank(&self) -> (&Subject, Option<[BigRational; 2]>) {
        (&self.subject, self.crossing.as_ref().map(Crossing::indices))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::shrink;

    /// As after a change of the goal: two findings of degree 5 that do not have the same number of maxima.
    #[test]
    fn findings_of_the_most_maxima_have_the_same_number() {
        let gaps = vec![798_629, 50_969, 15_552_000, 72_327, 2_424_870, 9_185_290];
        let three = Candidate::new(gaps, (183_588, 1_000_000)).unwrap().normal_form();
        let two = shrink(three.clone(), |candidate| local_maxima(candidate).maxima == 2);
        let subjects = [two, three].map(Subject::Index);
        let records = subjects.clone().map(|subject| Finding::of(subject).record(0, 1));
        assert_eq!(records.each_ref().map(|record| record.witness.local_maxima), [2, 3]);
        for order in [[0, 1], [1, 0]] {
            let mut findings = Findings::default();
            let mut add = |goal, at: usize| findings.add_record(goal, subjects[at].clone(), &records[at]);
            add(Goal::Most, order[0]).unwrap();
            assert_eq!(add(Goal::Most, order[1]), Err(FindingError::NotMost));
            add(Goal::Several, order[1]).unwrap();
        }
    }

    #[test]
    fn equal_maxima_need_their_proof() {
        let subject = Subject::Index(Candidate::new(vec![2, 1, 1, 0], (3, 5)).unwrap());
        let record = Finding::of(subject.clone()).record(0, 1);
        let add = |goal| Findings::default().add_record(goal, subject.clone(), &record);
        assert_eq!((add(Goal::Several), add(Goal::Equal)), (Ok(()), Err(FindingError::Refuted)));
    }
}
