//! `shape` with a parameter: the slope ratio, or one knot.

use std::fmt;

use anstyle::Style;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Partition, PartitionEnd, PartitionEvent, RatioCell};
use crate::scalar::parse_rational;
use crate::spline::Basis;

use super::super::error::CliError;
use super::super::exact::{Exact, as_given};
use super::super::exit::Exit;
use super::super::instance::Subjects;
use super::super::notation::{Decimal, Notation};
use super::super::on_knots::OnKnots;
use super::super::output::Output;
use super::super::progress::Progress;
use super::Args;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in super::super) struct Partitions {
    /// What this object is: `knotproof.shape/1`.
    #[schemars(extend("const" = "knotproof.shape/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    /// J, where the knot t_J moves between its neighbours; otherwise α does.
    #[serde(skip_serializing_if = "Option::is_none")]
    free_knot: Option<usize>,
    /// One for each index i that was asked for.
    functions: Vec<FunctionPartition>,
}

/// One function, for every value of the parameter.
#[derive(Debug, Serialize, JsonSchema)]
struct FunctionPartition {
    /// i of G_i^k.
    index: usize,
    /// α, where a knot moves.
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<String>,
    /// Is there one local maximum only, whatever the parameter is? `null` if neither is known.
    strong: Option<bool>,
    /// The open intervals of the parameter between two ends, from left to right.
    cells: Vec<Cell>,
    /// The places between them, where the number of local maxima may change.
    ends: Vec<End>,
}

/// The bounds of a cell by the parameter's name.
#[derive(Debug, Serialize, JsonSchema)]
struct Cell {
    #[serde(flatten)]
    bounds: Bounds,
    /// How many local maxima there are everywhere in it; `null` if that is not known.
    local_maxima: Option<usize>,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Bounds {
    /// Bounds of the slope ratio r = (α − 1)/α, exactly; `null` for ∞.
    Ratio(
        #[serde(serialize_with = "as_given")]
        #[schemars(with = "[Option<String>; 2]")]
        [Option<Exact>; 2],
    ),
    /// Bounds of the knot that moves, exactly; `null` for ∞.
    Knot(
        #[serde(serialize_with = "as_given")]
        #[schemars(with = "[Option<String>; 2]")]
        [Option<Exact>; 2],
    ),
}

#[derive(Debug, Serialize, JsonSchema)]
struct End {
    /// Exact bounds of the parameter, equal if it is known exactly.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "[String; 2]")]
    interval: [Exact; 2],
    /// How many local maxima there are just there.
    local_maxima: usize,
    /// `knot` for critical points that pass one, `fold` for two that meet.
    #[schemars(extend("enum" = ["knot", "fold"]))]
    kind: &'static str,
    /// What happens there, in which spans.
    events: Vec<Event>,
    /// For a critical point at a knot: the integer polynomial in the parameter of which the end is a root, lowest
    /// coefficient first.
    #[serde(skip_serializing_if = "Option::is_none")]
    polynomial: Option<Vec<String>>,
    /// For two that meet: N as a list of such polynomials, the coefficients of u⁰, u¹, …; there N = ∂N/∂u = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    double_root_of: Option<Vec<Vec<String>>>,
    /// Its settled digits.
    at: Decimal,
}

/// Where on a span [t_span, t_{span+1}) a critical point is.
#[derive(Debug, Serialize, JsonSchema)]
struct Event {
    /// j of the span [t_j, t_{j+1}).
    span: usize,
    /// Where in it.
    at: &'static str,
}

/// Every slope ratio.
pub(super) fn by_ratio(
    args: &Args,
    subject: Subjects,
    notation: Notation,
    output: &Output,
) -> Result<Exit, CliError> {
    print(args, subject, (None, notation), output, |basis, i| Ok(Partition::by_ratio(basis, i, &args.width)))
}

/// Every place of one knot.
pub(super) fn by_knot(
    args: &Args,
    subject: Subjects,
    knot: usize,
    notation: Notation,
    output: &Output,
) -> Result<Exit, CliError> {
    print(args, subject, (Some(knot), notation), output, |basis, i| {
        Ok(Partition::by_knot(basis, i, knot, &args.width)?)
    })
}

fn print(
    args: &Args,
    subject: Subjects,
    (free_knot, notation): (Option<usize>, Notation),
    output: &Output,
    partition: impl Fn(&Basis, usize) -> Result<Partition, CliError>,
) -> Result<Exit, CliError> {
    let mut functions = Vec::new();
    for case in &subject.cases {
        let basis = &case.basis;
        let chosen = args.function.range(basis)?;
        let progress = Progress::new(chosen.clone().count());
        for i in chosen {
            progress.step(&format!("G_{i}"));
            functions.push(FunctionPartition::new(basis, i, (free_knot, notation), &partition(basis, i)?));
        }
    }
    let Some(first) = subject.cases.first() else { unreachable!("an instance has an index") };
    let verdicts = || functions.iter().map(|function| function.strong);
    let exit = if verdicts().any(|strong| strong == Some(false)) {
        Exit::Refuted
    } else if verdicts().any(|strong| strong.is_none()) {
        Exit::Undecided
    } else {
        Exit::Holds
    };
    output.result(&Partitions {
        schema: "knotproof.shape/1",
        on: OnKnots::of(&first.basis, subject.label),
        free_knot,
        functions,
    })?;
    Ok(exit)
}

impl FunctionPartition {
    fn new(
        basis: &Basis,
        index: usize,
        (free_knot, notation): (Option<usize>, Notation),
        partition: &Partition,
    ) -> Self {
        let bounds = |range| if free_knot.is_some() { Bounds::Knot(range) } else { Bounds::Ratio(range) };
        let cell = |cell: &RatioCell| Cell {
            bounds: bounds([Some(Exact(cell.from.clone())), cell.to.clone().map(Exact)]),
            local_maxima: cell.local_maxima,
        };
        let counts = || partition.cells().iter().map(|cell| cell.local_maxima);
        let several = counts().flatten().any(|maxima| maxima != 1);
        Self {
            index,
            alpha: free_knot.map(|_| basis.index().to_string()),
            strong: if several { Some(false) } else { partition.is_decided().then_some(true) },
            cells: partition.cells().iter().map(cell).collect(),
            ends: partition.ends().iter().map(|end| End::new(end, notation)).collect(),
        }
    }
}

impl End {
    fn new(end: &PartitionEnd, notation: Notation) -> Self {
        let (lo, hi) = &end.interval;
        let mut polynomials: Vec<Vec<String>> =
            end.polynomials.iter().map(|p| p.iter().map(ToString::to_string).collect()).collect();
        let event = |&(span, event): &(usize, PartitionEvent)| {
            let at = match event {
                PartitionEvent::Start => "start",
                PartitionEvent::End => "end",
                PartitionEvent::Fold => "inside",
            };
            Event { span, at }
        };
        let fold = end.events.iter().any(|(_, event)| *event == PartitionEvent::Fold);
        Self {
            interval: [lo, hi].map(|x| Exact(x.clone())),
            local_maxima: end.local_maxima,
            kind: if fold { "fold" } else { "knot" },
            events: end.events.iter().map(event).collect(),
            polynomial: if fold { None } else { polynomials.pop() },
            double_root_of: fold.then_some(polynomials),
            at: notation.settled(&mut end.number()),
        }
    }
}

const HEADING: Style = Style::new().bold();

impl fmt::Display for Partitions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on)?;
        for function in &self.functions {
            write!(f, "\n{HEADING}G_{}", function.index)?;
            match (&function.alpha, self.free_knot) {
                (Some(alpha), Some(knot)) => {
                    writeln!(f, ", α = {alpha}, for every t_{knot} between its neighbours{HEADING:#}")?;
                }
                _ => writeln!(f, " for every r = α/(α − 1) > 0{HEADING:#}")?,
            }
            function.fmt(f)?;
        }
        Ok(())
    }
}

/// The cells from left to right, each followed by its end.
impl fmt::Display for FunctionPartition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for cell in &self.cells {
            let (Bounds::Ratio([from, to]) | Bounds::Knot([from, to])) = &cell.bounds;
            match cell.local_maxima {
                Some(1) => write!(f, "1 local maximum ")?,
                Some(maxima) => write!(f, "{maxima} local maxima ")?,
                None => write!(f, "undecided ")?,
            }
            let before = self.ends.iter().find(|end| Some(&end.interval[1]) == from.as_ref());
            let after = self.ends.iter().find(|end| Some(&end.interval[0]) == to.as_ref());
            writeln!(f, "between {} and {}", near(from, before), near(to, after))?;
            if let Some(end) = after {
                let [lo, hi] = &end.interval;
                if lo == hi {
                    write!(f, "  at {lo}: ")?;
                } else {
                    write!(f, "  at a number in [{lo}, {hi}]: ")?;
                }
                let events: Vec<_> = end
                    .events
                    .iter()
                    .map(|event| match event.at {
                        "inside" => format!("two critical points meet on span {}", event.span),
                        at => format!("a critical point at the {at} of span {}", event.span),
                    })
                    .collect();
                writeln!(f, "{}; {}", end.local_maxima, events.join(" and "))?;
            }
        }
        Ok(())
    }
}

/// A bound of a cell: the end of the partition that is there, or a rational number, or ∞.
fn near(bound: &Option<Exact>, end: Option<&End>) -> String {
    match (bound, end) {
        (_, Some(end)) if end.interval[0] != end.interval[1] => format!("≈ {}", end.at.0),
        (None, _) => "∞".to_owned(),
        (Some(Exact(x)), _) => {
            let text = Notation::in_force().approximation(x);
            if parse_rational(&text).as_ref() == Ok(x) { text } else { format!("≈ {text}") }
        }
    }
}
