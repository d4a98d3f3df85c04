//! `formula --equals`: are the expressions in a file the basis functions?

use std::fmt;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::FormalBasis;
use crate::formula::{Counterexample, Script, ScriptError};
use crate::spline::Span;

use super::super::error::CliError;
use super::super::exact::Exact;
use super::super::exit::Exit;
use super::super::file::read_up_to;
use super::super::of_weights::OfWeights;
use super::super::on_knots::OnKnots;
use super::super::output::Output;

/// The longest file.
const LENGTH_LIMIT: u64 = 1 << 20;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in super::super) struct Comparison {
    /// What this object is: `knotproof.formula.equals/1`.
    #[schemars(extend("const" = "knotproof.formula.equals/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    #[serde(flatten)]
    weights: OfWeights,
    #[serde(skip)]
    every_index: bool,
    /// Are all that were compared?
    equal: bool,
    /// Every expression of the file that was asked for.
    functions: Vec<Compared>,
    /// The functions that were not compared: the file has none for them, or another one was asked for.
    not_compared: Vec<usize>,
}

/// One function.
#[derive(Debug, Serialize, JsonSchema)]
struct Compared {
    /// i of G_i^k.
    index: usize,
    /// The interval that was looked at, if not all x.
    #[serde(skip_serializing_if = "Option::is_none")]
    interval: Option<[Exact; 2]>,
    /// Is the expression the function, at every x of it?
    equal: bool,
    /// If not: a point where they differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    point: Option<Point>,
}

/// Where they differ.
#[derive(Debug, Serialize, JsonSchema)]
struct Point {
    /// x.
    x: Exact,
    /// α, where it is a letter.
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<Exact>,
    /// The value of the expression; `null` if it has none.
    expression: Option<Exact>,
    /// The value of the function.
    function: Exact,
}

/// Reads the file and compares.
pub(super) fn run(
    path: &Path,
    formal: &FormalBasis,
    weights: OfWeights,
    chosen: Option<usize>,
    span: Option<usize>,
    output: &Output,
) -> Result<Exit, CliError> {
    let text = read_up_to(LENGTH_LIMIT, "--equals", path)?;
    let wrong = |error: ScriptError| CliError::Expression { path: path.to_owned(), error };
    let script = Script::read(&text).map_err(wrong)?;
    let (basis, n) = (formal.basis(), formal.basis().n());
    let span = span.map(|j| span_of(formal, j)).transpose()?;
    let mut functions = Vec::new();
    for definition in script.definitions() {
        let index = match (definition.index, chosen) {
            (Some(index), None) | (None, Some(index)) => index,
            (Some(index), Some(chosen)) if index == chosen => index,
            (Some(_), Some(_)) => continue,
            (None, None) => {
                let purpose = "the file has one expression without a name: say which function it is to be";
                return Err(CliError::Needed { argument: "--index", purpose });
            }
        };
        let Some(function) = formal.functions().get(index) else {
            let message = format!("there is no function {index}: the basis has the functions 0 to {n}");
            return Err(wrong(script.error(definition, message)));
        };
        let found = script.counterexample(definition, formal, function, span).map_err(wrong)?;
        let ends = span.and_then(|span| basis.knots().ends(span).ok());
        functions.push(Compared {
            index,
            interval: ends.map(|(from, to)| [from, to].map(|x| Exact(x.clone()))),
            equal: found.is_none(),
            point: found.map(Point::from),
        });
    }
    if let (true, Some(chosen)) = (functions.is_empty(), chosen) {
        return Err(CliError::NoDefinition { path: path.to_owned(), index: chosen });
    }
    let equal = functions.iter().all(|function| function.equal);
    let compared = |i: &usize| functions.iter().any(|function| function.index == *i);
    output.result(&Comparison {
        schema: "knotproof.formula.equals/1",
        on: OnKnots::of(basis, None),
        weights,
        every_index: formal.is_symbolic(),
        equal,
        not_compared: (0..=n).filter(|i| !compared(i)).collect(),
        functions,
    })?;
    Ok(if equal { Exit::Holds } else { Exit::Refuted })
}

fn span_of(formal: &FormalBasis, j: usize) -> Result<Span, CliError> {
    let knots = formal.basis().knots();
    let span = knots.spans().find(|span| span.index() == j);
    let spans = || knots.spans().map(|span| span.index()).collect();
    span.ok_or_else(|| CliError::NoSpan { given: j, spans: spans() })
}

impl From<Counterexample> for Point {
    fn from(point: Counterexample) -> Self {
        Self {
            x: Exact(point.x),
            alpha: point.alpha.map(Exact),
            expression: point.found.map(Exact),
            function: Exact(point.expected),
        }
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let every_index = if self.every_index { " and every alpha < 0 and alpha > 1" } else { "" };
        for (at, Compared { index, interval, point, .. }) in self.functions.iter().enumerate() {
            if at > 0 {
                writeln!(f)?;
            }
            match point {
                None => {
                    write!(f, "G_{index}: equal for every x")?;
                    if let Some([from, to]) = interval {
                        write!(f, " between {from} and {to}")?;
                    }
                    write!(f, "{every_index}")?;
                }
                Some(Point { x, alpha, expression, function }) => {
                    write!(f, "G_{index}: not equal at x = {x}")?;
                    alpha.iter().try_for_each(|alpha| write!(f, ", alpha = {alpha}"))?;
                    match expression {
                        Some(value) => write!(f, ": the expression is {value}")?,
                        None => write!(f, ": the expression has no value")?,
                    }
                    write!(f, ", and G_{index} is {function}")?;
                }
            }
        }
        if !self.not_compared.is_empty() {
            let list: Vec<_> = self.not_compared.iter().map(|i| format!("G_{i}")).collect();
            write!(f, "\nNot compared: {}", list.join(", "))?;
        }
        Ok(())
    }
}
