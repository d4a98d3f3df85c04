//! The command `float`: ways to compute in `f64` against exact arithmetic on the same floats.

use std::fmt;
use std::path::{Path, PathBuf};

use num_rational::BigRational;
use serde::Serialize;

use crate::float::{Case, Effort, Field, Figures, FloatBasis, FloatError, Formula, FormulaRecord, study};
use crate::report::heat_map;
use crate::scalar::{RationalAlgebra, integer, parse_rational};
use crate::spline::{Basis, Side};

use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::instance::{InstanceArgs, whole_number};
use super::output::Output;
use super::place::Place;
use super::table::{plain, right_aligned};

/// How wrong ways to compute in f64 are: the paper's formula, usual ones, and those of this library.
///
/// Each is measured against exact arithmetic on the same floats: in units in the last place (ULP), fractions included;
/// absolutely; by the sum of all functions; and by the signs. Without knots, random cases of a degree are measured: gaps and
/// |α| or α − 1 differ from 1 by factors up to 2^10, spread evenly over the scales; with knots, random points of these. Then a
/// search climbs towards worse cases. Each worst case is printed with a command that shows it again.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// Only this point, and no search.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true)]
    x: Option<BigRational>,
    /// The seed of all that is random.
    #[arg(long, value_name = "S", value_parser = whole_number, allow_hyphen_values = true, default_value = "0")]
    seed: usize,
    /// How many random cases are measured, at most 1000000.
    #[arg(long, value_name = "N", value_parser = whole_number, allow_hyphen_values = true, default_value = "1000")]
    count: usize,
    /// How many steps the search takes, at most 10000000; 0 for none.
    #[arg(long, value_name = "N", value_parser = whole_number, allow_hyphen_values = true, default_value = "20000")]
    steps: usize,
    /// Writes maps of the error over (x, α) as SVG into this folder, which is made if it is not there: one for each formula, on
    /// these knots, or on 0, 1, …, 2k + 1.
    #[arg(long, value_name = "DIR", conflicts_with = "x")]
    out: Option<PathBuf>,
}

const EXAMPLE: &str = r#"Examples:
  knotproof float --degree 3 --seed 1
  knotproof float --instance U4 --out pictures
  knotproof float --degree 2 --knots "100000000 100000001 100000002 100000003 100000004 100000005" --alpha -1
  knotproof float --degree 1 --knots "0 1 2" --alpha -0x1.8p-3 --x 0x1.8p-1 --format json
Exit code 1: an error is larger than its proved bound."#;

/// The most random cases, and steps of the search.
const COUNT_LIMIT: usize = 1_000_000;
const STEPS_LIMIT: usize = 10_000_000;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize)]
struct Comparison {
    schema: &'static str,
    degree: usize,
    seed: usize,
    count: usize,
    steps: usize,
    formulas: Vec<FormulaRecord>,
    #[serde(skip)]
    written: Vec<PathBuf>,
}

/// Measures, searches and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let limits = [("--count", args.count, 1, COUNT_LIMIT), ("--steps", args.steps, 0, STEPS_LIMIT)];
    for (argument, given, least, most) in limits {
        if given < least || given > most {
            return Err(CliError::Limits { argument, given, least, most });
        }
    }
    let (degree, field) = args.field()?;
    let [seed, count, steps] =
        [args.seed, args.count, args.steps].map(|n| u64::try_from(n).unwrap_or(u64::MAX));
    let written = match &args.out {
        Some(folder) => maps(folder, &field)?,
        None => Vec::new(),
    };
    let figures = study(&field, &Formula::ALL, Effort { seed, count, steps });
    let kept = figures.iter().all(Figures::keeps_bound);
    let formulas = figures.iter().map(FormulaRecord::from).collect();
    let Args { seed, count, steps, .. } = *args;
    output.result(&Comparison {
        schema: "knotproof.float/1",
        degree,
        seed,
        count,
        steps,
        formulas,
        written,
    })?;
    Ok(if kept { Exit::Holds } else { Exit::Refuted })
}

impl Args {
    /// k, and what is to be measured.
    fn field(&self) -> Result<(usize, Field), CliError> {
        if let Some(degree) = self.instance.degree_alone() {
            let degree = degree?;
            // The floats have a highest degree; its error names it.
            let knots = (0..2 * degree.min(1000) + 2).map(|_| 0.0).chain([1.0]).collect();
            let refused = FloatBasis::new(knots, degree, f64::INFINITY).err();
            return match (refused, &self.x) {
                (Some(error), _) => Err(CliError::Float { place: Place::option("--degree"), error }),
                (None, Some(_)) => {
                    let purpose =
                        "a point is a point of some knots; give them, such as --knots \"0 0 1 2 2\"";
                    Err(CliError::Needed { argument: "--knots", purpose })
                }
                (None, None) => Ok((degree, Field::Degree(degree))),
            };
        }
        let cases = self.instance.resolve()?.cases;
        let bases = cases.iter().map(|case| float(&case.basis)).collect::<Result<Vec<_>, _>>()?;
        let degree = cases.first().map_or(0, |case| case.basis.degree());
        let Some(x) = &self.x else { return Ok((degree, Field::Bases(bases))) };
        let place = || Place::option("--x");
        let x = 0.0_f64.embed(x);
        let at = |basis: FloatBasis<f64>| {
            basis.span_at(x, Side::Right).map_err(|error| CliError::Float { place: place(), error })?;
            Ok(Case::at(basis, x, Side::Right))
        };
        let cases = bases.into_iter().map(at).collect::<Result<Vec<_>, CliError>>()?;
        Ok((degree, Field::Cases(cases.into_iter().flatten().collect())))
    }
}

/// Writes a map for each formula, and returns the files.
fn maps(folder: &Path, field: &Field) -> Result<Vec<PathBuf>, CliError> {
    let (knots, degree) = match field {
        Field::Degree(degree) => ((0..2 * degree + 2).map(|i| 0.0_f64.embed(&integer(i))).collect(), *degree),
        Field::Bases(bases) => match bases.first() {
            Some(basis) => (basis.knots().to_vec(), basis.degree()),
            None => return Ok(Vec::new()),
        },
        Field::Cases(_) => return Ok(Vec::new()),
    };
    let folder = Folder::beside("--out", folder)?;
    let write = |formula: Formula| {
        folder.write(&format!("error-{}.svg", formula.name()), heat_map(formula, &knots, degree)?)
    };
    let files = Formula::ALL.into_iter().map(write).collect::<Result<_, _>>()?;
    folder.put_in_place()?;
    Ok(files)
}

/// The basis in floats.
fn float(basis: &Basis) -> Result<FloatBasis<f64>, CliError> {
    FloatBasis::nearest(basis).map_err(|error| {
        let option = if matches!(error, FloatError::Index(_)) { "--alpha" } else { "--knots" };
        CliError::Float { place: Place::option(option), error }
    })
}

/// A table of the figures, and the worst cases.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let headings = [
            "formula",
            "largest ULP",
            "99 %",
            "median",
            "absolute",
            "of the sum",
            "signs",
            "not finite",
            "proved",
        ];
        let mut table = plain(headings.map(str::to_owned).to_vec());
        for of in &self.formulas {
            table.add_row([
                of.name.to_owned(),
                of.max_ulp.clone().unwrap_or_default(),
                of.p99_ulp.clone(),
                of.median_ulp.clone(),
                of.max_absolute.clone(),
                of.max_sum.clone(),
                of.sign_errors.to_string(),
                of.not_finite.to_string(),
                of.bound_ulp.map_or_else(String::new, |bound| format!("{bound:.4}")),
            ]);
        }
        (1..headings.len()).for_each(|column| right_aligned(&mut table, column));
        writeln!(f, "Errors in f64, degree {}\n{}\n\nWorst cases", self.degree, table.trim_fmt())?;
        for of in &self.formulas {
            if let Some(worst) = &of.worst {
                writeln!(f, "  {}, G_{}: {}", of.name, worst.index, worst.reproduce)?;
            }
        }
        write!(f, "The exact values: the same with `knotproof eval`.")?;
        self.written.iter().try_for_each(|path| write!(f, "\nWritten: {}", path.display()))
    }
}
