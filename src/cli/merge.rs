//! The command `merge`: the shards of a search, put together.

use std::fmt;
use std::path::PathBuf;

use serde::Serialize;

use crate::search::{FindingRecord, Part, SummaryRecord, merge};

use super::atomic::write_atomically;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::search::{Summary, read_part};

/// Puts the shards of a search together, and proves that they cover it: every position once, and as many cases as there are.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The results of all shards, in any order: their checkpoints, or what they wrote with `--format json`.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Writes the result into this file, as the search as a whole would have.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

const EXAMPLE: &str = "\
Example:
  knotproof search --degree 3 --shard 0/2 --checkpoint shard-0.jsonl
  knotproof search --degree 3 --shard 1/2 --checkpoint shard-1.jsonl
  knotproof merge shard-0.jsonl shard-1.jsonl --out all.jsonl
Exit code 1: something was found; 0: nothing; 2: a shard is missing, given twice, unfinished, damaged or of another search.";

/// The result: its fields are the JSON.
#[derive(Serialize)]
struct Merged<'a> {
    schema: &'static str,
    /// Every position of the space is in exactly one of the files, and every case was decided. What is not so is an error.
    covered: bool,
    searched: SummaryRecord,
    findings: Vec<&'a FindingRecord>,
    #[serde(skip)]
    part: &'a Part,
    #[serde(skip)]
    files: usize,
}

/// Reads, checks, and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let read = |path: &PathBuf| Ok((path.display().to_string(), read_part("FILE", path)?));
    let parts = args.files.iter().map(read).collect::<Result<Vec<_>, CliError>>()?;
    let part = merge(parts).map_err(CliError::Merge)?;
    if let Some(path) = &args.out {
        if path.exists() {
            // The same result may be written again; nothing else is lost.
            let old = read_part("--out", path)?;
            if old.search() != part.search() || !old.shard().is_whole() {
                return Err(CliError::OtherSearch {
                    argument: "--out",
                    path: path.clone(),
                    what: "what is in it",
                });
            }
        }
        write_atomically("--out", path, &part.to_text().map_err(std::io::Error::from)?)?;
    }
    output.result(&Merged {
        schema: "knotproof.merge/1",
        covered: true,
        searched: part.summary(),
        findings: part.findings().records().collect(),
        part: &part,
        files: args.files.len(),
    })?;
    Ok(if part.findings().is_empty() { Exit::Holds } else { Exit::Refuted })
}

impl fmt::Display for Merged<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} shards cover the search: every case once", self.files)?;
        write!(f, "{}", Summary(self.part))
    }
}
