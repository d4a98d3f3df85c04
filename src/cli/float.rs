//! The command `float`: ways to compute in `f64` against exact arithmetic on the same floats.

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use schemars::JsonSchema;
use serde::Serialize;

use crate::float::{FloatBasis, FloatError, hexadecimal};
use crate::judge::OfFamily;
use crate::meaning::Weighting;
use crate::report::heat_map;
use crate::scalar::{RationalAlgebra, decimal, exact_value, integer, parse_rational};
use crate::spline::{Basis, KnotVector, Side};
use crate::study::{
    Effort, FloatMember, FloatMemberError, Method, MethodRecord, Population, Probe, RangeRecord, study,
};

use super::atomic::Folder;
use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::{InstanceArgs, MemberSubject, Resolved};
use super::output::Output;
use super::table::{plain, right_aligned};
use super::visible::visible_path;
use crate::typed::whole_number;
use crate::typed::{Provenance, TypedError};

/// How wrong ways to compute in f64 are: the paper's formula, usual ones, and those of this library.
///
/// Each is measured against exact arithmetic on the same floats: in units in the last place (ULP), fractions included;
/// absolutely; by the sum of all functions; and by the signs. Without knots, random cases of a degree are measured: gaps and
/// |α| or α − 1 differ from 1 by factors up to 2^10, spread evenly over the scales; with knots, random points of these. Then a
/// search climbs towards worse cases. Each worst case is printed with a command that shows it again.
///
/// "Largest found" is what the search found, and not the largest there is; "proved to be at most" is proved, in `docs/float.md`,
/// and is compared with it. A result that is no number, written `inf`, is worse than any bound. Exact values below 2^-900,
/// next to underflow, are left out of the columns in ULP: they are counted, and have their part in the absolute errors
/// and the signs. Numbers that f64 does not have are rounded, and the output says which.
/// Up to degree 31: the functions in f64 compute in memory of a fixed size.
///
/// For a family that is not that of an index, on given knots, the formulas `ratio` and `triangle` are measured, with the weights of
/// the family; the others are about α, and nothing is proved.
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
  knotproof float --degree 2 \
    --knots "100000000 100000001 100000002 100000003 100000004 100000005" --alpha -1
  knotproof float --degree 1 --knots "0 1 2" --alpha -0x1.8p-3 --x 0x1.8p-1 --format json
  knotproof float --degree 3 --knots "0 0 0 0 1 2 3 3 3 3" --family lupas --set q=1/3
Exit code 1: an error is larger than its proved bound, or a result is no number: with given knots one of any formula,
with random ones one of a formula that has a bound."#;

/// The most random cases, and steps of the search.
const COUNT_LIMIT: usize = 1_000_000;
const STEPS_LIMIT: usize = 10_000_000;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Comparison {
    /// What this object is: `knotproof.float/1`.
    #[schemars(extend("const" = "knotproof.float/1"))]
    schema: &'static str,
    /// k.
    degree: usize,
    /// The seed of all that is random.
    seed: usize,
    /// How many random cases were measured.
    count: usize,
    /// How many steps the search for the worst case took.
    steps: usize,
    /// What was given and is no `f64`.
    rounded: Vec<Rounded>,
    /// The member of another family than that of an index, as it was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    family: Option<OfFamily>,
    /// The positions of neighbouring knots that are different, and the same in `f64`.
    merged: Vec<[usize; 2]>,
    /// One for each way to compute a basis function in `f64`.
    formulas: Vec<MethodRecord>,
    #[serde(skip)]
    weights: Option<String>,
    #[serde(skip)]
    written: Vec<PathBuf>,
}

/// A number that was rounded.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
struct Rounded {
    /// `x`, `alpha`, `t_i` or a parameter of a family.
    what: String,
    /// What was given.
    exact: Exact,
    /// What it became.
    float: String,
    /// |float − exact|, unless that is infinite.
    #[serde(skip)]
    off: Option<BigRational>,
}

/// What is to be measured, and what of it was rounded.
struct Subjects {
    degree: usize,
    field: Population,
    /// The member of another family than that of an index.
    member: Option<Weighting>,
    rounded: Vec<Rounded>,
    merged: Vec<[usize; 2]>,
}

/// Measures, searches and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let limits = [("--count", args.count, 1, COUNT_LIMIT), ("--steps", args.steps, 0, STEPS_LIMIT)];
    for (argument, given, least, most) in limits {
        if given < least || given > most {
            return Err(CliError::Limits { argument, given, least, most });
        }
    }
    let Subjects { degree, field, member, rounded, merged } = args.subject()?;
    let [seed, count, steps] =
        [args.seed, args.count, args.steps].map(|n| u64::try_from(n).unwrap_or(u64::MAX));
    let written = match &args.out {
        Some(folder) => maps(folder, &field)?,
        None => Vec::new(),
    };
    let methods = if member.is_some() { &Method::OF_MEMBERS[..] } else { &Method::ALL };
    let figures = study(&field, methods, Effort { seed, count, steps });
    // On random knots the search looks for what breaks a formula, and one without a bound may break.
    let given = !matches!(field, Population::Degree(_));
    let kept = figures.iter().all(|of| of.keeps_bound() && !(given && of.not_finite > 0));
    let formulas = figures.iter().map(MethodRecord::from).collect();
    let Args { seed, count, steps, .. } = *args;
    output.result(&Comparison {
        schema: "knotproof.float/1",
        degree,
        seed,
        count,
        steps,
        rounded,
        family: member.as_ref().and_then(OfFamily::of),
        merged,
        formulas,
        weights: member.as_ref().map(ToString::to_string),
        written,
    })?;
    Ok(if kept { Exit::Holds } else { Exit::Refuted })
}

impl Args {
    fn subject(&self) -> Result<Subjects, CliError> {
        if let Some(degree) = self.instance.degree_alone() {
            let degree = degree?;
            if let Some(chosen) = self.instance.family(None)? {
                // What is wrong with its parameters is told first.
                chosen.member()?;
                let purpose = "random cases are those of an index; give the knots of the family, such as --knots \"0 0 0 1 2 2 2\"";
                return Err(CliError::Needed { argument: "--knots", purpose });
            }
            if self.instance.indices()?.is_some() {
                let purpose = "random cases have random indices; to measure one, give knots, such as --knots \"0 0 0 1 2 2 2\"";
                return Err(CliError::Needed { argument: "--knots", purpose });
            }
            // The floats have a highest degree; its error names it.
            let knots = (0..2 * degree.min(1000) + 2).map(|_| 0.0).chain([1.0]).collect();
            let refused = FloatBasis::new(knots, degree, f64::INFINITY).err();
            return match (refused, &self.x) {
                (Some(error), _) => {
                    Err(CliError::Float { place: Provenance::option("--degree"), error: error.into() })
                }
                (None, Some(_)) => {
                    let purpose =
                        "a point is a point of some knots; give them, such as --knots \"0 0 1 2 2\"";
                    Err(CliError::Needed { argument: "--knots", purpose })
                }
                (None, None) => {
                    let field = Population::Degree(degree);
                    Ok(Subjects { degree, field, member: None, rounded: Vec::new(), merged: Vec::new() })
                }
            };
        }
        let cases = match self.instance.resolve_any()? {
            Resolved::Indices(subjects) => subjects.cases,
            Resolved::Member(subject) => return self.member(&subject),
        };
        let bases = cases.iter().map(|case| float(&case.basis)).collect::<Result<Vec<_>, _>>()?;
        let degree = cases.first().map_or(0, |case| case.basis.degree());
        let (mut rounded, mut merged) = (Vec::new(), Vec::new());
        if let (Some(case), Some(float)) = (cases.first(), bases.first()) {
            (rounded, merged) = rounding(case.basis.knots(), float);
        }
        for (case, float) in cases.iter().zip(&bases) {
            let alpha = case.basis.index().alpha();
            rounded.extend(alpha.and_then(|alpha| Rounded::of("alpha".to_owned(), &alpha, float.alpha())));
        }
        let Some(x) = self.point(&mut rounded)? else {
            let field = Population::Bases(bases);
            return Ok(Subjects { degree, field, member: None, rounded, merged });
        };
        let cases = bases.into_iter().filter_map(|basis| Probe::at(basis, x, Side::Right));
        let field = Population::Cases(cases.collect());
        Ok(Subjects { degree, field, member: None, rounded, merged })
    }

    /// The same for a member of another family.
    fn member(&self, subject: &MemberSubject) -> Result<Subjects, CliError> {
        if self.out.is_some() {
            return Err(CliError::OnlyIndices { option: "--out", family: subject.family() });
        }
        let basis = &subject.basis;
        // Where the member gives no weights on the knots, that is not due to a rounding.
        let exact = basis.weights().on_knots(basis.knots(), basis.degree());
        exact.map_err(|error| TypedError::Member { argument: "--family", error })?;
        let float = FloatMember::nearest(basis).map_err(|error| match error {
            FloatMemberError::Parameter(_) | FloatMemberError::Weights(_) => {
                CliError::Float { place: Provenance::option("--set"), error }
            }
            FloatMemberError::Knots(_) => CliError::Float { place: Provenance::option("--knots"), error },
        })?;
        let (mut rounded, merged) = rounding(basis.knots(), float.knots());
        let named = |weights: &Weighting| -> Vec<(String, BigRational)> {
            let all = weights.member().into_iter().flat_map(|member| member.named());
            all.flat_map(|(name, values)| values.all().map(|value| (name.to_string(), value.clone())))
                .collect()
        };
        let pairs = named(basis.weights()).into_iter().zip(named(float.weights()));
        rounded.extend(
            pairs.filter_map(|((name, exact), (_, float))| Rounded::of(name, &exact, 0.0_f64.embed(&float))),
        );
        let degree = basis.degree();
        let member = Some(basis.weights().clone());
        let (x, float) = (self.point(&mut rounded)?, Arc::new(float));
        let field = match x {
            Some(x) => Population::Cases(Probe::of_member(&float, x, Side::Right).into_iter().collect()),
            None => Population::Member(float),
        };
        Ok(Subjects { degree, field, member, rounded, merged })
    }

    /// The point that is given, as a float.
    fn point(&self, rounded: &mut Vec<Rounded>) -> Result<Option<f64>, CliError> {
        let Some(exact) = &self.x else { return Ok(None) };
        let x = 0.0_f64.embed(exact);
        if !x.is_finite() {
            return Err(CliError::Float {
                place: Provenance::option("--x"),
                error: FloatError::Point(x).into(),
            });
        }
        rounded.extend(Rounded::of("x".to_owned(), exact, x));
        Ok(Some(x))
    }
}

/// The knots that are no floats, and the neighbours that became one.
fn rounding(knots: &KnotVector, float: &FloatBasis<f64>) -> (Vec<Rounded>, Vec<[usize; 2]>) {
    let (exact, float) = (knots.knots(), float.knots());
    let pairs = exact.iter().zip(float).enumerate();
    let rounded = pairs.filter_map(|(i, (exact, &float))| Rounded::of(format!("t_{i}"), exact, float));
    let pairs = exact.windows(2).zip(float.windows(2)).enumerate();
    let same = pairs.filter(|(_, (exact, float))| exact[0] < exact[1] && float[0] >= float[1]);
    (rounded.collect(), same.map(|(i, _)| [i, i + 1]).collect())
}

impl Rounded {
    /// `None` if the float is the number.
    fn of(what: String, exact: &BigRational, float: f64) -> Option<Self> {
        let off = exact_value(float).map(|float| (float - exact).abs());
        if off.as_ref().is_some_and(Zero::is_zero) {
            return None;
        }
        Some(Self { what, exact: Exact(exact.clone()), float: hexadecimal(float), off })
    }
}

/// `t_2 became 0x1p0, which is 1.00000e-20 away`.
impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, exact, float, off } = self;
        match off {
            Some(off) => write!(f, "{what} became {float}, which is {} away", decimal(off, DIGITS)),
            None => write!(f, "{what} = {} became {float}", decimal(&exact.0, DIGITS)),
        }
    }
}

/// Writes a map for each formula, and returns the files.
fn maps(folder: &Path, field: &Population) -> Result<Vec<PathBuf>, CliError> {
    let (knots, degree) = match field {
        Population::Degree(degree) => {
            ((0..2 * degree + 2).map(|i| 0.0_f64.embed(&integer(i))).collect(), *degree)
        }
        Population::Bases(bases) => match bases.first() {
            Some(basis) => (basis.knots().to_vec(), basis.degree()),
            None => return Ok(Vec::new()),
        },
        Population::Cases(_) | Population::Member(_) => return Ok(Vec::new()),
    };
    let folder = Folder::beside("--out", folder)?;
    let write = |formula: Method| {
        folder.write(&format!("error-{}.svg", formula.name()), heat_map(formula, &knots, degree)?)
    };
    let files = Method::ALL.into_iter().map(write).collect::<Result<_, _>>()?;
    folder.put_in_place()?;
    Ok(files)
}

/// The basis in floats.
fn float(basis: &Basis) -> Result<FloatBasis<f64>, CliError> {
    FloatBasis::nearest(basis).map_err(|error| {
        let option = if matches!(error, FloatError::Index(_)) { "--alpha" } else { "--knots" };
        CliError::Float { place: Provenance::option(option), error: error.into() }
    })
}

/// The digits of a number that is shown rounded, and how many of the rounded ones are shown.
const DIGITS: usize = 6;
const SHOWN: usize = 8;

impl Comparison {
    /// What was changed before anything was measured.
    fn fmt_rounding(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rounded, merged, .. } = self;
        if rounded.is_empty() {
            return Ok(());
        }
        writeln!(
            f,
            "The input was rounded to f64, and all errors are those against the exact values of the floats:"
        )?;
        rounded.iter().take(SHOWN).try_for_each(|number| writeln!(f, "  {number}"))?;
        if rounded.len() > SHOWN {
            writeln!(f, "  and {} more, all of them with --format json", rounded.len() - SHOWN)?;
        }
        let spans = merged.iter().take(SHOWN);
        spans
            .into_iter()
            .try_for_each(|[i, j]| writeln!(f, "  t_{i} and t_{j} were different, and are the same now"))?;
        if merged.len() > SHOWN {
            writeln!(f, "  and so are {} more pairs", merged.len() - SHOWN)?;
        }
        writeln!(f)
    }
}

/// A table of the figures, and the worst cases.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let headings = [
            "formula",
            "largest found",
            "99 %",
            "median",
            "absolute",
            "of the sum",
            "signs",
            "not finite",
            "left out",
            "proved to be at most",
        ];
        let mut table = plain(headings);
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
                of.left_out.to_string(),
                of.proved(),
            ]);
        }
        (1..headings.len()).for_each(|column| right_aligned(&mut table, column));
        self.fmt_rounding(f)?;
        let Some(first) = self.formulas.first() else {
            return write!(
                f,
                "x is outside of [t_0, t_m], where every function is 0: there is nothing to measure."
            );
        };
        let tried = first.tried;
        let of = self.weights.as_ref().map(|of| format!(", family {of}")).unwrap_or_default();
        writeln!(f, "Errors in f64, degree {}{of}: largest found (of {tried} tried), in ULP", self.degree)?;
        writeln!(f, "{}\n", table.trim_fmt())?;
        if self.weights.is_some() {
            writeln!(
                f,
                "No bound is proved for this family: these errors are measured, and there may be larger ones."
            )?;
        }
        if self.formulas.iter().any(|of| of.not_finite > 0) {
            writeln!(f, "inf: a result is no number, which is worse than any bound.")?;
        }
        if self.formulas.iter().any(|of| of.left_out > 0) {
            let note = "they are in the columns absolute, of the sum and signs, and in none of those in ULP";
            writeln!(f, "Left out are exact values below 2^-900, next to underflow: {note}.")?;
        }
        for of in &self.formulas {
            if let Some(RangeRecord { holds_where, outside, measured, .. }) = &of.bound_range {
                let name = of.name;
                writeln!(
                    f,
                    "{name}: its bound is proved where {holds_where}; not so in {outside} of {measured} cases."
                )?;
            }
        }
        writeln!(f, "Worst cases")?;
        for of in &self.formulas {
            if let Some(worst) = &of.worst {
                writeln!(f, "  {}, G_{}: {}", of.name, worst.index, worst.reproduce)?;
            }
        }
        write!(f, "The exact values: the same with `knotproof eval`.")?;
        self.written.iter().try_for_each(|path| write!(f, "\nWritten: {}", visible_path(path)))
    }
}
