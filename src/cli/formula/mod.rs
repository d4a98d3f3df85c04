//! The command `formula`: the basis functions as formulas, piece by piece.

mod equals;

use std::fmt;
use std::path::PathBuf;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{FormalBasis, FormalFunction, FormalPiece};
use crate::formula::{Form, Language, expression, formula};
use crate::spline::AnyWeights;
use crate::typed::whole_number;

use super::error::CliError;
use super::exact::Exact;
use super::exit::Exit;
use super::instance::{Case, FunctionArgs};
use super::of_weights::OfWeights;
use super::on_knots::OnKnots;
use super::output::Output;

pub(super) use equals::Comparison;

/// The basis functions as formulas in x, one for each interval between knots.
///
/// Numerators and denominators have integer coefficients and no common factor; the denominators are products of
/// factors that are linear in x, or for another family of what divides the denominators of its weights. With --alpha symbolic
/// they hold for every α < 0 and every α > 1, and `alpha` is a letter in them; α = ∞ is no value of it, but --alpha inf gives
/// those formulas. The parameters of a family are numbers. Up to degree 8.
///
/// With --equals they are not printed but compared with those in a file, exactly and for every x: quotients of polynomials in x, with
/// `alpha` and `r` = alpha/(alpha − 1) too, in the syntax of Maxima. The file has definitions such as --as maxima prints, each of
/// which is compared with its function, or with --index one expression: `if … then … elseif … else …` over all x, or with
/// --span the formula on one interval. What cancels is cancelled, as Maxima does: (x − 1)/(x − 1) is 1. Where it is not
/// equal, a point is printed with both values. Exponents are whole numbers up to 100, degrees at most 60.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    function: FunctionArgs,
    /// Who reads the formulas.
    #[arg(long = "as", value_name = "LANGUAGE", value_enum, default_value_t = Reader::Text)]
    reader: Reader,
    /// Polynomials as products, which is the default: all powers of x − t that divide a numerator are split off.
    #[arg(long)]
    factored: bool,
    /// Polynomials as sums of terms.
    #[arg(long, conflicts_with = "factored")]
    expanded: bool,
    /// Prints no formulas, but whether those in this file are the functions.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["reader", "factored", "expanded"])]
    equals: Option<PathBuf>,
    /// Only on the interval [t_J, t_{J+1}), for an expression that is meant for it alone.
    #[arg(long, value_name = "J", value_parser = whole_number, allow_hyphen_values = true)]
    #[arg(requires = "equals", requires = "index")]
    span: Option<usize>,
}

const EXAMPLE: &str = r#"Examples:
  knotproof formula --instance U4 --alpha -1
  knotproof formula --degree 1 --knots "0 1 3" --alpha symbolic --as latex
  knotproof formula --instance U4 --alpha 5 --index 1 --expanded --as maxima
  knotproof formula --instance U9 --alpha -1 --as sympy
  knotproof formula --instance U4 --alpha symbolic --as maxima > u4.mac
  knotproof formula --instance U4 --alpha symbolic --equals u4.mac
  knotproof formula --degree 2 --knots "0 0 0 1 2 2 2" --family lupas --set q=1/2 --as latex
Exit code with --equals: 0 if all is equal, 1 if not."#;

/// The highest degree k that is written out. A numerator has up to ⌊(k + 2)²/4⌋ − 1 powers of x, and with a symbol as many
/// of α for each: this is more than anybody reads.
const DEGREE_LIMIT: usize = 8;

/// A value of `--as`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Reader {
    /// People.
    Text,
    /// LaTeX with amsmath.
    Latex,
    /// Maxima: definitions to load.
    Maxima,
    /// Python with SymPy: a program.
    Sympy,
}

impl Reader {
    fn language(self) -> Language {
        match self {
            Self::Text => Language::Text,
            Self::Latex => Language::Latex,
            Self::Maxima => Language::Maxima,
            Self::Sympy => Language::Sympy,
        }
    }
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Formulas {
    /// What this object is: `knotproof.formula/1`.
    #[schemars(extend("const" = "knotproof.formula/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    #[serde(flatten)]
    weights: OfWeights,
    /// Who reads the formulas.
    #[serde(rename = "as")]
    reader: Reader,
    /// Polynomials as products, or as sums of terms.
    #[schemars(extend("enum" = ["factored", "expanded"]))]
    form: &'static str,
    /// By function, then from left to right. Elsewhere a function is 0.
    pieces: Vec<Piece>,
    /// The whole text, as it is without --format json.
    source: String,
}

/// G_index = numerator/denominator on [from, to), or on [from, to] if it is closed.
#[derive(Debug, Serialize, JsonSchema)]
struct Piece {
    /// i of G_i^k.
    index: usize,
    /// The left end of its interval, which belongs to it.
    from: Exact,
    /// The right end.
    to: Exact,
    /// Does the right end belong to it?
    closed: bool,
    /// The numerator as a formula.
    numerator: String,
    /// The denominator as a formula.
    denominator: String,
}

/// Finds the formulas and prints them.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let every_index = args.function.instance.symbolic_index();
    let Case { weights, basis, .. } =
        every_index.as_ref().unwrap_or(&args.function.instance).resolve_any()?.only_case()?;
    let index = args.function.chosen(&basis)?;
    let reason = "a numerator has up to (k + 2)²/4 powers of x; eval gives values of every degree";
    let too_high = CliError::TooHigh { degree: basis.degree(), limit: DEGREE_LIMIT, reason };
    if basis.degree() > DEGREE_LIMIT {
        return Err(too_high);
    }
    CliError::if_quotients_exceed(FormalBasis::QUOTIENT_LIMIT, &basis)?;
    let formal = match basis.weights() {
        _ if every_index.is_some() => FormalBasis::for_every_index(&basis),
        AnyWeights::Index(index) => FormalBasis::of(&basis.with(index.clone())),
        AnyWeights::Forms(table) => FormalBasis::of_forms(&basis.with(table.clone()), weights.to_string()),
    };
    let formal = formal.ok_or(too_high)?;
    let of = if every_index.is_some() { OfWeights::symbolic() } else { OfWeights::of(&weights) };
    if let Some(path) = &args.equals {
        return equals::run(path, &formal, of, index, args.span, output);
    }
    let (language, form) =
        (args.reader.language(), if args.expanded { Form::Expanded } else { Form::Factored });
    let chosen = |function: &&FormalFunction| index.is_none_or(|i| i == function.index);
    let pieces = formal.functions().iter().filter(chosen).flat_map(|function| {
        function.pieces.iter().map(|piece| Piece::new(function.index, piece, language, form))
    });
    output.result(&Formulas {
        schema: "knotproof.formula/1",
        on: OnKnots::of(&basis, None),
        weights: of,
        reader: args.reader,
        form: if args.expanded { "expanded" } else { "factored" },
        pieces: pieces.collect(),
        source: formula(&formal, index, language, form),
    })?;
    Ok(Exit::Holds)
}

impl Piece {
    fn new(index: usize, piece: &FormalPiece, language: Language, form: Form) -> Self {
        Self {
            index,
            from: Exact(piece.from.clone()),
            to: Exact(piece.to.clone()),
            closed: piece.closed,
            numerator: expression(&piece.numerator, language, form),
            denominator: expression(&piece.denominator, language, form),
        }
    }
}

impl fmt::Display for Formulas {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.source)
    }
}
