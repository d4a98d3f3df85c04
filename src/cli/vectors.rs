//! The command `vectors`: exact values for the tests of other spline libraries.

use std::fmt;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::simplest_member;
use crate::meaning::Weighting;
use crate::report::{VectorCase, vectors};
use crate::spline::Index;
use crate::typed::{ChosenFamily, TypedError, whole_number};

use super::atomic::write_atomically;
use super::error::CliError;
use super::exit::Exit;
use super::family::FamilyArgs;
use super::output::{Output, stamped_json};
use super::progress::Progress;
use super::visible::visible_path;

/// Writes exact values of basis functions for the tests of other spline libraries: at knots and between them, with one-sided
/// derivatives, on knots of every kind.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    family: FamilyArgs,
    /// The index α: less than 0, greater than 1, or inf.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    alpha: Option<Index>,
    /// The highest degree, at most 10.
    #[arg(long, value_name = "K", value_parser = whole_number, allow_hyphen_values = true, default_value = "4")]
    degree: usize,
    /// The highest derivative, at most 10.
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, default_value = "2")]
    derivatives: usize,
    /// The file for the values, JSON.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

const EXAMPLE: &str = "\
Without --family and --alpha these are the classical B-splines. Parameters that are not set are the simplest ones that are not all the same.

Examples:
  knotproof vectors --out vectors.json
  knotproof vectors --alpha -4 --degree 3 --out rational.json
  knotproof vectors --family knot-weights --derivatives 1 --out weights.json
`knotproof schema vectors` says what is in the file, docs/vectors.md how to use it.";

/// The highest degree, and the highest derivative.
const LIMIT: usize = 10;

/// The file: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Vectors {
    /// What this object is: `knotproof.vectors/1`.
    #[schemars(extend("const" = "knotproof.vectors/1"))]
    schema: &'static str,
    /// What is meant by a value where that is a matter of convention.
    conventions: Conventions,
    /// Degree by degree, on knots of every kind that the family is for.
    cases: Vec<VectorCase>,
}

/// What is a matter of convention.
#[derive(Debug, Serialize, JsonSchema)]
struct Conventions {
    /// Of the recursion, and of 0/0.
    recursion: &'static str,
    /// At knots.
    at_knots: &'static str,
    /// At t_m.
    at_the_last_knot: &'static str,
    /// Outside of [t_0, t_m].
    outside: &'static str,
    /// How numbers are written.
    numbers: &'static str,
}

const CONVENTIONS: Conventions = Conventions {
    recursion: "G_i^0 = 1 on [t_i, t_{i+1}), else 0; G_i^d = w_i^d G_i^{d-1} + (1 - w_{i+1}^d) G_{i+1}^{d-1}, where w_i^d is 0 if t_i = t_{i+d}. All n + 1 functions are there, also those that are 0 everywhere, and all of [t_0, t_m], not only [t_k, t_{n+1}].",
    at_knots: "Values are limits from the right; a function of degree k jumps at a knot of k + 1 copies, and may have a corner at one of k copies: `left` and `right` are the one-sided limits.",
    at_the_last_knot: "At t_m the value is the limit from the left.",
    outside: "Outside of [t_0, t_m] all functions are 0; so are the limits from the left at t_0.",
    numbers: "Exact fractions in lowest terms; derivatives are derivatives, not divided by factorials.",
};

/// What was written: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Written {
    /// What this object is: `knotproof.vectors.written/1`.
    #[schemars(extend("const" = "knotproof.vectors.written/1"))]
    schema: &'static str,
    /// The file.
    file: PathBuf,
    /// How many bases.
    cases: usize,
    /// How many points.
    points: usize,
    /// How many numbers.
    numbers: usize,
}

/// Computes, writes and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    for (argument, given) in [("--degree", args.degree), ("--derivatives", args.derivatives)] {
        if given > LIMIT {
            return Err(CliError::TooMany { argument, given, limit: LIMIT });
        }
    }
    let chosen = args.family.chosen(None)?;
    let wrong = |error| TypedError::Member { argument: "--family", error };
    // An index has no conditions on knots.
    let adjectives = chosen.as_ref().map_or(&[][..], |chosen| &chosen.family.knots);
    let member = |m: usize, k: usize| match &chosen {
        Some(ChosenFamily { family, given }) => Weighting::of(family, &simplest_member(family, given, m, k)),
        None => Ok(Weighting::Index(args.alpha.clone().unwrap_or_else(Index::infinity))),
    };
    let progress = Progress::new(args.degree + 1);
    let mut cases = Vec::new();
    for k in 0..=args.degree {
        progress.step(&format!("degree {k}"));
        cases.extend(vectors(adjectives, member, k, args.derivatives).map_err(wrong)?);
    }
    drop(progress);
    let points = cases.iter().map(|case| case.points.len()).sum();
    let sides = cases
        .iter()
        .flat_map(|case| &case.points)
        .flat_map(|point| [Some(&point.right), point.left.as_ref()]);
    let numbers = sides.flatten().flat_map(|side| &side.derivatives).map(Vec::len).sum();
    let written = Written {
        schema: "knotproof.vectors.written/1",
        file: args.out.clone(),
        cases: cases.len(),
        points,
        numbers,
    };
    let all = Vectors { schema: "knotproof.vectors/1", conventions: CONVENTIONS, cases };
    write_atomically("--out", &args.out, &(stamped_json(&all)? + "\n"))?;
    output.result(&written)?;
    Ok(Exit::Holds)
}

impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cases, points, numbers, .. } = self;
        write!(
            f,
            "Written: {}, {numbers} exact numbers at {points} points of {cases} bases",
            visible_path(&self.file)
        )
    }
}
