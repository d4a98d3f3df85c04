//! The command `search`: counterexamples to Conjecture 3.1.

mod text;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, io};

use clap::ValueEnum;

use crate::search::{
    DEFAULT_SIZE, DEFAULT_SIZE_OF_FAMILY, DEFAULT_SPREAD, FamilySpace, Goal, IndexSample, Limits,
    MemberSpace, Portion, PortionError, Sample, Search, Shard, Space, SpaceError,
};
use crate::spline::Index;
use crate::typed::{WholeNumberError, whole_number};

use super::atomic::write_atomically;
use super::error::CliError;
use super::exit::Exit;
use super::family::FamilyArgs;
use super::file::read_up_to;
use super::output::{Format, Output};
use super::progress::Progress;

pub(super) use text::Summary;

/// Searches for basis functions with more than one maximum (Conjecture 3.1): all of them in order of size, or a random sample.
///
/// A function is given by the gaps between its own k + 2 knots and by α; scaling the gaps, and reversing them together with the
/// conjugate index 1 − α, changes nothing of its shape, so only one of each such family is searched: coprime whole gaps,
/// and α < 0 or ∞. Its size is the sum of the gaps plus the height of α (the larger of numerator and denominator).
/// Functions that jump are left out. Every case is decided exactly.
///
/// Findings are shrunk as far as they go, and each is listed once, with the command that shows it again. The result depends on what is
/// searched only, not on threads, shards or interruptions.
///
/// Each finding has its dip. At a local minimum m, with L and R the largest values to its left and to its right, the function falls by
/// min(L, R) − m; the dip is the largest of these falls as a share of the largest value of all. `--find deepest` keeps the ten functions
/// with the deepest dips, deepest first, as they are, unshrunk; of equal ones, to ten digits, the smaller functions.
///
/// With --family the functions are those of another family: by the gaps, and by the numbers of its parameters on the own knots of the
/// function, as far as --set does not fix them. The size is the sum of the gaps and, over all these numbers p/q, of max(|p|, q) − 1; no
/// symmetry is used. Random numbers are log-spread within the bounds of the parameter. A case without weights, or whose function is
/// negative somewhere or jumps, is counted as not decided, with the reason.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE, verbatim_doc_comment)]
pub(super) struct Args {
    /// The degree k, from 1 to 16.
    #[arg(long, value_name = "K", value_parser = whole_number, allow_hyphen_values = true)]
    degree: Option<usize>,
    /// What to look for; `several` if not given.
    #[arg(long, value_enum)]
    find: Option<Find>,
    /// All cases up to this size, smallest first; 8 if nothing else is asked for, and 5 with --family.
    #[arg(long, value_name = "SIZE", value_parser = number, allow_hyphen_values = true, conflicts_with = "count")]
    limit: Option<u64>,
    /// Of those only the ones with no larger gap.
    #[arg(long, value_name = "GAP", value_parser = number, allow_hyphen_values = true, conflicts_with = "count")]
    limit_gap: Option<u64>,
    /// Of those only the ones with α, or numbers of a family, of no larger height.
    #[arg(long, value_name = "HEIGHT", value_parser = number, allow_hyphen_values = true, conflicts_with = "count")]
    limit_height: Option<u64>,
    /// So many random cases, instead of all up to a size.
    #[arg(long, value_name = "N", value_parser = number, allow_hyphen_values = true)]
    count: Option<u64>,
    /// The seed of random cases; 0 if not given. Case c of a seed is always the same.
    #[arg(long, value_name = "S", value_parser = number, allow_hyphen_values = true)]
    seed: Option<u64>,
    /// Random gaps differ by factors up to 2^B, spread evenly over the logarithms, and so does the slope ratio; 9 if not given.
    #[arg(long, value_name = "B", value_parser = number, allow_hyphen_values = true)]
    spread: Option<u64>,
    /// Random cases have this α; may be repeated, and each case has one of them. α and its conjugate 1 − α stand for each other.
    #[arg(long, value_name = "A", allow_hyphen_values = true, requires = "count")]
    alpha: Vec<Index>,
    #[command(flatten)]
    family: FamilyArgs,
    /// Only part I of N, I from 0. `knotproof merge` puts the parts together.
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    shard: Option<String>,
    /// Keeps the state of the search in this file, and goes on from it if it is there already. Once the search is finished, the
    /// file is its result, as with `--format json`.
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Goes on from this checkpoint, and keeps the state there; what is searched stands in the file.
    #[arg(long, value_name = "FILE", conflicts_with = "checkpoint")]
    resume: Option<PathBuf>,
    /// The number of threads; all cores if not given.
    #[arg(long, value_name = "N", value_parser = whole_number, allow_hyphen_values = true)]
    threads: Option<usize>,
}

const EXAMPLE: &str = "\
Examples:
  knotproof search --degree 3  # exit code 1
  knotproof search --degree 4 --limit 14 --limit-height 3 --format json  # exit code 1
  knotproof search --degree 5 --find most --count 100000 --seed 1  # exit code 1
  knotproof search --degree 3 --find deepest --count 20000 --alpha -4 --alpha -1/2 \\
    --alpha -1/7  # exit code 1
  knotproof search --degree 3 --family knot-weights --limit 6
  knotproof search --degree 3 --family lupas --set q=1/3 --count 2000  # exit code 1
  knotproof search --degree 3 --find equal --limit 12 --shard 0/4 \\
    --checkpoint equal-0.jsonl  # exit code 1
  knotproof search --resume equal-0.jsonl  # exit code 1
With --format json each finding is one line: `witness.dip` has bounds of its dip, decimals of ten digits. The last line says what was
searched: `decides` is a digest of the sources that decide, and `blocks` says for each block of positions how many cases there were,
with a digest of all of them, so that `knotproof merge --audit` can compare them with a second run.
Exit code 1: something was found; 0: nothing; 3: nothing, but some case is not decided.";

/// What to look for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Find {
    /// Functions with more than one local maximum.
    Several,
    /// Those with the largest number of local maxima.
    Most,
    /// Functions whose two largest maxima are equal for some α of an interval.
    Equal,
    /// The ten functions that fall deepest between two maxima.
    Deepest,
}

impl From<Find> for Goal {
    fn from(find: Find) -> Self {
        match find {
            Find::Several => Self::Several,
            Find::Most => Self::Most,
            Find::Equal => Self::Equal,
            Find::Deepest => Self::Deepest,
        }
    }
}

/// The longest file that is read: a million findings.
const LONGEST: u64 = 1 << 30;
/// More threads than that help no machine, and could be more than it can start.
const MOST_THREADS: usize = 1024;

/// From one checkpoint to the next after so long: what an interruption costs is a sixtieth of what has been done, and ten thousand shards
/// on one file system do not write all the time.
fn pause(after: Duration) -> Duration {
    (after / 60).max(Duration::from_secs(2))
}

/// Searches, and prints what was found.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    if args.threads == Some(0) {
        return Err(CliError::Threads { reason: "a search needs 1 thread at least".to_owned() });
    }
    if let Some(threads) = args.threads.filter(|&threads| threads > MOST_THREADS) {
        return Err(CliError::Threads { reason: format!("{threads} is too many: at most {MOST_THREADS}") });
    }
    let (mut part, file) = args.part()?;
    if let Some(file) = &file {
        file.save(&part)?;
    }
    // For rayon 0 threads are all that there are.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.threads.unwrap_or(0)).build();
    let pool = pool.map_err(|error| CliError::Threads { reason: error.to_string() })?;
    let total = part.range().end - part.range().start;
    let progress = Progress::new(usize::try_from(total).unwrap_or(usize::MAX));
    progress.reach(part.done(), &format!("{} found", part.findings().len()));
    let begun = Instant::now();
    let mut saved = begun;
    pool.install(|| {
        part.run(|part| {
            progress.reach(part.done(), &format!("{} found", part.findings().len()));
            match &file {
                Some(file) if part.is_complete() || saved.elapsed() >= pause(begun.elapsed()) => {
                    saved = Instant::now();
                    file.save(part)
                }
                _ => Ok(()),
            }
        })
    })?;
    drop(progress);
    match output.format() {
        Format::Json => output.text(&part.to_text().map_err(io::Error::from)?)?,
        Format::Text => output.text(&Summary(&part).to_string())?,
    }
    Ok(exit(&part))
}

/// What a search has come to.
pub(super) fn exit(part: &Portion) -> Exit {
    match (part.findings().is_empty(), part.decided().undecided) {
        (false, _) => Exit::Refuted,
        (true, 0) => Exit::Holds,
        (true, _) => Exit::Undecided,
    }
}

/// Where the state of a search is kept.
struct StateFile {
    option: &'static str,
    path: PathBuf,
}

impl StateFile {
    fn save(&self, part: &Portion) -> Result<(), CliError> {
        write_atomically(self.option, &self.path, &part.to_text().map_err(io::Error::from)?)
    }
}

/// The part of a search in a file, as [`Portion::to_text`] has written it.
pub(super) fn read_portion(option: &'static str, path: &Path) -> Result<Portion, CliError> {
    let failed = |error| CliError::File { argument: option, action: "read", path: path.to_owned(), error };
    // Reading a pipe could wait for ever.
    if !fs::metadata(path).map_err(failed)?.is_file() {
        let message = "it is no regular file, so no state of a search can be kept there";
        return Err(failed(io::Error::new(io::ErrorKind::InvalidInput, message)));
    }
    let text = read_up_to(LONGEST, option, path)?;
    Portion::parse(&text).map_err(|error| CliError::SearchFile {
        argument: option,
        path: path.to_owned(),
        error: Box::new(error),
    })
}

impl Args {
    /// What to do, and the file to keep it in.
    fn part(&self) -> Result<(Portion, Option<StateFile>), CliError> {
        let shard = match &self.shard {
            None => None,
            Some(text) => Some(text.parse::<Shard>().map_err(|error| blame(error.into()))?),
        };
        let (option, path) = match (&self.resume, &self.checkpoint) {
            (Some(path), _) => ("--resume", path),
            (None, Some(path)) => ("--checkpoint", path),
            (None, None) => return Ok((self.new_part(shard)?, None)),
        };
        if self.resume.is_none() && !path.exists() {
            return Ok((self.new_part(shard)?, Some(StateFile { option, path: path.clone() })));
        }
        let found = read_portion(option, path)?;
        let mut differs = self.differs(&found, shard)?;
        if self.resume.is_none() {
            // What is not given counts as well, by its default.
            let new = self.new_part(shard)?;
            let same = found.search() == new.search() && found.shard() == new.shard();
            differs = differs.or((!same).then_some("an option that is not given"));
        }
        match differs {
            None => Ok((found, Some(StateFile { option, path: path.clone() }))),
            Some(what) => Err(CliError::OtherSearch { argument: option, path: path.clone(), what }),
        }
    }

    fn new_part(&self, shard: Option<Shard>) -> Result<Portion, CliError> {
        Portion::new(self.search()?, shard.unwrap_or(Shard::WHOLE)).map_err(blame)
    }

    /// What is asked for, with what is not given filled in.
    fn search(&self) -> Result<Search, CliError> {
        let purpose = "give the degree of the functions, such as --degree 3";
        let degree = self.degree.ok_or(CliError::Needed { argument: "--degree", purpose })?;
        let family = self.family_space()?;
        let space = match self.count {
            Some(count) => {
                let (seed, spread) = (self.seed.unwrap_or(0), self.spread.unwrap_or(DEFAULT_SPREAD));
                match self.alpha.as_slice() {
                    [] => Space::Random(Sample { count, seed, spread }),
                    given => {
                        Space::Indices(IndexSample { alpha: IndexSample::names(given), count, seed, spread })
                    }
                }
            }
            None if self.seed.is_some() || self.spread.is_some() => {
                let purpose = "a seed and a spread are for random cases; say how many, such as --count 10000";
                return Err(CliError::Needed { argument: "--count", purpose });
            }
            None => Space::Exhaustive(Limits {
                size: self.limit.unwrap_or(match &family {
                    None => DEFAULT_SIZE,
                    Some(_) => DEFAULT_SIZE_OF_FAMILY,
                }),
                gap: self.limit_gap,
                height: self.limit_height,
            }),
        };
        let space = match family {
            None => space,
            Some(family) => family.with(space),
        };
        Ok(Search { degree, find: self.find.map_or(Goal::Several, Goal::from), space })
    }

    /// The family that is asked for, if it is not that of an index.
    fn family_space(&self) -> Result<Option<FamilyOfSearch>, CliError> {
        let Some(chosen) = self.family.chosen(None)? else { return Ok(None) };
        // All members of it are those of the search by index.
        if matches!(chosen.family.moebius(), Some(Some(_))) && chosen.given.is_empty() {
            return Ok(None);
        }
        let set = chosen.given.iter().map(|(name, values)| (name.clone(), values.to_string())).collect();
        let (name, text) = (chosen.family.given.clone(), chosen.family.text.clone());
        Ok(Some(FamilyOfSearch { name, text, set }))
    }

    /// The first option that asks for something else than what a file has.
    fn differs(&self, found: &Portion, shard: Option<Shard>) -> Result<Option<&'static str>, CliError> {
        let search = found.search();
        let random = |sample: &Sample| (sample.count, sample.seed, sample.spread);
        let (limits, sample, alpha) = match &search.space {
            Space::Exhaustive(limits) => (Some(limits), None, &[][..]),
            Space::Random(sample) => (None, Some(random(sample)), &[][..]),
            Space::Indices(sample) => {
                (None, Some((sample.count, sample.seed, sample.spread)), sample.alpha.as_slice())
            }
            Space::Family(family) => match &family.cases {
                MemberSpace::Exhaustive(limits) => (Some(limits), None, &[][..]),
                MemberSpace::Random(sample) => (None, Some(random(sample)), &[][..]),
            },
        };
        let of = match &search.space {
            Space::Family(family) => Some(family),
            _ => None,
        };
        let family = self.family_space()?;
        let same_family = || {
            let file = of.map(|family| (&family.name, &family.text));
            self.family.is_absent() || family.as_ref().map(|family| (&family.name, &family.text)) == file
        };
        let same_set = || family.as_ref().map(|family| &family.set) == of.map(|family| &family.set);
        let differ = |given: Option<u64>, found: Option<u64>| given.is_some() && given != found;
        let options = [
            ("--degree", self.degree.is_some_and(|degree| degree != search.degree)),
            ("--find", self.find.is_some_and(|find| Goal::from(find) != search.find)),
            ("--limit", differ(self.limit, limits.map(|limits| limits.size))),
            ("--limit-gap", differ(self.limit_gap, limits.and_then(|limits| limits.gap))),
            ("--limit-height", differ(self.limit_height, limits.and_then(|limits| limits.height))),
            ("--count", differ(self.count, sample.map(|(count, _, _)| count))),
            ("--seed", differ(self.seed, sample.map(|(_, seed, _)| seed))),
            ("--spread", differ(self.spread, sample.map(|(_, _, spread)| spread))),
            ("--alpha", !self.alpha.is_empty() && IndexSample::names(&self.alpha) != alpha),
            ("--family", !same_family()),
            ("--set", !self.family.is_absent() && !same_set()),
            ("--shard", shard.is_some_and(|shard| shard != found.shard())),
        ];
        Ok(options.into_iter().find(|(_, differs)| *differs).map(|(option, _)| option))
    }
}

/// A family, and what is set of it.
struct FamilyOfSearch {
    name: String,
    text: String,
    set: BTreeMap<String, String>,
}

impl FamilyOfSearch {
    /// Its functions within the same limits, or a sample of the same size.
    fn with(self, space: Space) -> Space {
        let Self { name, text, set } = self;
        let cases = match space {
            Space::Exhaustive(limits) => MemberSpace::Exhaustive(limits),
            Space::Random(sample) => MemberSpace::Random(sample),
            // An index can't be given beside a family.
            other @ (Space::Indices(_) | Space::Family(_)) => return other,
        };
        Space::Family(FamilySpace { name, text, set, cases })
    }
}

/// What is wrong with a search, with the option that has to change.
pub fn blame(error: PortionError) -> CliError {
    let argument = match &error {
        PortionError::Shard(_) => "--shard",
        PortionError::Space(SpaceError::Degree(_)) => "--degree",
        PortionError::Space(
            SpaceError::Empty(_) | SpaceError::NoMember(_) | SpaceError::TooLarge(_) | SpaceError::TooMany(_),
        ) => "--limit",
        PortionError::Space(
            SpaceError::Family(_)
            | SpaceError::OfIndex(_)
            | SpaceError::SpecialKnots { .. }
            | SpaceError::NoNumber { .. },
        ) => "--family",
        PortionError::Space(
            SpaceError::Setting { .. } | SpaceError::Numbers { .. } | SpaceError::Member(_),
        ) => "--set",
        PortionError::Space(SpaceError::EqualOfFamily) => "--find",
        PortionError::Space(SpaceError::NoGap) => "--limit-gap",
        PortionError::Space(SpaceError::NoHeight) => "--limit-height",
        PortionError::Space(SpaceError::NoCase) => "--count",
        PortionError::Space(SpaceError::Spread(_)) => "--spread",
        PortionError::Space(SpaceError::Index) => "--alpha",
    };
    CliError::Search { argument, error }
}

/// A whole number ≥ 0, also on machines that count to less.
pub(super) fn number(text: &str) -> Result<u64, WholeNumberError> {
    let number = whole_number(text)?;
    u64::try_from(number).map_err(|_| WholeNumberError::TooLarge)
}
