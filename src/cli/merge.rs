//! The command `merge`: the shards of a search, put together, and parts of them computed again.

use std::collections::hash_map::RandomState;
use std::fmt;
use std::hash::{BuildHasher, Hasher};
use std::ops::Range;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;

use crate::language::paper;
use crate::search::{Audit, AuditError, Draw, FindingRecord, Portion, SummaryRecord, audit, merge};
use crate::typed::WholeNumberError;

use super::atomic::write_atomically;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::progress::Progress;
use super::search::{Summary, exit, number, read_portion};

/// Puts the shards of a search together, and proves that they cover it: every position once, and as many cases as there are.
///
/// That the shards say what comes out of their cases is believed, unless it is audited: `--audit N` computes N blocks of positions again,
/// drawn from a seed that nobody knew when the shards were written, and compares all that is recorded of them.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The results of all shards, in any order: their checkpoints, or what they wrote with `--format json`.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Writes the result into this file, as the search as a whole would have.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Computes N blocks again, or `all`: the search as a whole, once more.
    #[arg(long, value_name = "N|all", value_parser = amount, allow_hyphen_values = true)]
    audit: Option<Amount>,
    /// The seed from which blocks are drawn; one that cannot be foreseen if not given. It is printed, to draw the same ones again.
    #[arg(long, value_name = "S", value_parser = number, allow_hyphen_values = true, requires = "audit")]
    seed: Option<u64>,
}

const EXAMPLE: &str = "\
Example:
  knotproof search --degree 3 --shard 0/2 --checkpoint shard-0.jsonl  # exit code 1
  knotproof search --degree 3 --shard 1/2 --checkpoint shard-1.jsonl
  knotproof merge shard-0.jsonl shard-1.jsonl --audit 3 --out all.jsonl  # exit code 1
Exit code 1: something was found, or an audit found something else than the shards say: then nothing is written; 0: nothing; 3: nothing, but
some case is not decided; 2: a shard is missing, given twice, unfinished, damaged, of another search or written by a program that may decide otherwise.";

/// How many blocks.
#[derive(Debug, Clone, Copy)]
enum Amount {
    All,
    Blocks(u64),
}

/// `all`, or a whole number.
fn amount(text: &str) -> Result<Amount, WholeNumberError> {
    if text == "all" { Ok(Amount::All) } else { number(text).map(Amount::Blocks) }
}

/// The result: its fields are the JSON.
#[derive(Serialize, JsonSchema)]
pub(super) struct Merged<'a> {
    /// What this object is: `knotproof.merge/1`.
    #[schemars(extend("const" = "knotproof.merge/1"))]
    schema: &'static str,
    /// Every position of the space is in exactly one of the files, and no audit has found that one says what is not so.
    covered: bool,
    /// What was searched, and how it came out.
    searched: SummaryRecord,
    /// What was found.
    findings: Vec<&'a FindingRecord>,
    /// What was computed again; `null` if nothing was computed again.
    audited: Option<Audited>,
    #[serde(skip)]
    part: &'a Portion,
    #[serde(skip)]
    files: usize,
}

/// What was computed again, and what came of it.
#[derive(Serialize, JsonSchema)]
struct Audited {
    /// The seed from which they were drawn; `null` if all blocks were.
    seed: Option<u64>,
    /// The number of blocks of the search.
    blocks: u64,
    /// The positions of those that were computed again.
    recomputed: Vec<[u64; 2]>,
    /// The number of those that were not.
    not_recomputed: u64,
    /// What came out differently.
    differences: Vec<Difference>,
}

/// Something that came out differently.
#[derive(Serialize, JsonSchema)]
struct Difference {
    /// The first position of the block.
    from: u64,
    /// The position after its last one.
    to: u64,
    /// The shards that have these positions.
    files: Vec<String>,
    /// What is different.
    what: String,
}

/// Reads, checks, and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    if matches!(args.audit, Some(Amount::Blocks(0))) {
        return Err(CliError::Audit(AuditError::NoBlock));
    }
    let read = |path: &PathBuf| Ok((path.display().to_string(), read_portion("FILE", path)?));
    let parts = args.files.iter().map(read).collect::<Result<Vec<_>, CliError>>()?;
    let shards: Vec<_> = parts.iter().map(|(name, part)| (name.clone(), part.range())).collect();
    let part = merge(parts).map_err(CliError::Merge)?;
    if let Some(path) = &args.out {
        may_be_replaced(path, &part)?;
    }
    let audited = args.audit.map(|amount| audited(&part, amount, args.seed, &shards)).transpose()?;
    let holds = audited.as_ref().is_none_or(|audited| audited.differences.is_empty());
    if let Some(path) = args.out.as_ref().filter(|_| holds) {
        write_atomically("--out", path, &part.to_text().map_err(std::io::Error::from)?)?;
    }
    output.result_of(
        paper(),
        &Merged {
            schema: "knotproof.merge/1",
            covered: holds,
            searched: part.summary(),
            findings: part.findings().records().collect(),
            audited,
            part: &part,
            files: args.files.len(),
        },
    )?;
    Ok(if holds { exit(&part) } else { Exit::Refuted })
}

/// The same result may be written again; nothing else is lost.
fn may_be_replaced(path: &Path, part: &Portion) -> Result<(), CliError> {
    if path.exists() {
        let old = read_portion("--out", path)?;
        if old.search() != part.search() || !old.shard().is_whole() {
            let (path, what) = (path.to_owned(), "what is in it");
            return Err(CliError::OtherSearch { argument: "--out", path, what });
        }
    }
    Ok(())
}

fn audited(
    part: &Portion,
    amount: Amount,
    seed: Option<u64>,
    shards: &[(String, Range<u64>)],
) -> Result<Audited, CliError> {
    // The keys of this are drawn by the system.
    let seed = seed.unwrap_or_else(|| RandomState::new().build_hasher().finish());
    let draw = match amount {
        Amount::All => Draw::All,
        Amount::Blocks(count) => Draw::Blocks { count, seed },
    };
    let positions = usize::try_from(part.range().end).unwrap_or(usize::MAX);
    let progress = Progress::new(positions);
    let audit: Result<Audit, AuditError> = audit(part, draw, |done| {
        progress.reach(done, "computed again");
        Ok(())
    });
    drop(progress);
    let Audit { blocks, again, differences } = audit.map_err(CliError::Audit)?;
    let meets = |range: &Range<u64>, positions: &Range<u64>| {
        range.start < positions.end && positions.start < range.end
    };
    let difference = |difference: crate::search::Discrepancy| {
        let positions = difference.positions;
        let files = shards.iter().filter(|(_, range)| meets(range, &positions));
        Difference {
            from: positions.start,
            to: positions.end,
            files: files.map(|(name, _)| name.clone()).collect(),
            what: difference.fault.to_string(),
        }
    };
    Ok(Audited {
        seed: matches!(draw, Draw::Blocks { .. }).then_some(seed),
        blocks,
        recomputed: again.iter().map(|range| [range.start, range.end]).collect(),
        not_recomputed: blocks - again.len() as u64,
        differences: differences.into_iter().map(difference).collect(),
    })
}

impl fmt::Display for Merged<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} shards cover the search: every position once, and as many cases as there are",
            self.files
        )?;
        match &self.audited {
            None => {
                writeln!(
                    f,
                    "Nothing was computed again (`--audit N` does): what each case came to is as the shards say"
                )?;
            }
            Some(audited) => write!(f, "{audited}")?,
        }
        if !self.covered {
            return write!(f, "\nThe shards are not what comes out of the search. Nothing was written.");
        }
        write!(f, "{}", Summary(self.part))
    }
}

impl fmt::Display for Audited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { blocks, recomputed, not_recomputed, .. } = self;
        match self.seed {
            Some(seed) => {
                write!(f, "Computed again: {} of {blocks} blocks, drawn with seed {seed}", recomputed.len())?
            }
            None => write!(f, "Computed again: all {blocks} blocks")?,
        }
        let places: Vec<_> =
            recomputed.iter().take(SHOWN).map(|[from, to]| format!("{from} to {to}")).collect();
        let more = if recomputed.len() > SHOWN { ", …" } else { "" };
        writeln!(f, " (positions {}{more})", places.join(", "))?;
        match not_recomputed {
            0 => writeln!(f, "Every case was computed again")?,
            rest => writeln!(f, "Not computed again: {rest} blocks, which are as the shards say")?,
        }
        for Difference { from, to, files, what } in &self.differences {
            writeln!(f, "Positions {from} to {to}, in {}: {what}", files.join(" and "))?;
        }
        if self.differences.is_empty() {
            writeln!(f, "All that is recorded of these blocks has come out again")?;
        }
        Ok(())
    }
}

/// Blocks whose positions are named in text.
const SHOWN: usize = 8;
