//! Many points: results in the order of the points, each written before the next is read.

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::Serialize;

use super::super::error::CliError;
use super::super::notation::Notation;
use super::super::of_weights::OfWeights;
use super::super::on_knots::OnKnots;
use super::super::output::{Format, Output, Stamped};
use super::super::progress::Progress;
use super::input::PointFile;
use super::point::{PointValues, Prepared, Request};
use super::{OneSide, SCHEMA};

/// The time between two steps of the progress bar.
const PAUSE: Duration = Duration::from_millis(100);

/// What is the same at all points: the first line of the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in super::super) struct Head {
    /// What this object is: `knotproof.eval/1`.
    #[schemars(extend("const" = "knotproof.eval/1"))]
    schema: &'static str,
    #[serde(flatten)]
    pub(super) on: OnKnots,
    #[serde(flatten)]
    pub(super) weights: OfWeights,
    /// i, where one function only was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) index: Option<usize>,
}

impl Head {
    pub(super) fn of(request: &Request<'_>, label: Option<String>) -> Self {
        let on = OnKnots::of(request.basis, label);
        Self {
            schema: SCHEMA,
            on: match request.curve {
                Some(curve) => on.with_points_of(curve),
                None => on,
            },
            weights: OfWeights::of(request.weights),
            index: request.index,
        }
    }
}

/// Evaluates at all points of the file; `side` is for those that do not name one. What was done before an error is
/// written, and a reader who leaves ends the work.
///
/// # Errors
/// [`CliError`] for the first line that is no point, and where nothing can be read or written.
pub(super) fn evaluate_file(
    path: &Path,
    request: &Request<'_>,
    prepared: &mut Prepared<'_>,
    side: OneSide,
    notation: Notation,
    output: &Output,
) -> Result<(), CliError> {
    let mut file = PointFile::open(path)?;
    // On one terminal the bar and the results would be in each other's way.
    let progress = (!io::stdout().is_terminal()).then(|| Progress::of_bytes(file.length()));
    let mut shown = Instant::now();
    let write = |to: &mut dyn Write| {
        while let Some(point) = file.next()? {
            let values = request.at(prepared, point.x, point.side.unwrap_or(side));
            // Not before: an error in the first line leaves nothing on standard output.
            let first = file.points() == 1;
            match output.format() {
                Format::Json => write_json(to, request, &values, first)?,
                Format::Text => write_csv(to, request, &values, first)?,
            }
            if file.may_block() {
                to.flush()?;
            }
            if let Some(progress) = progress.as_ref().filter(|_| shown.elapsed() >= PAUSE) {
                progress.reach(file.read(), &format!("{} points", file.points()));
                shown = Instant::now();
            }
        }
        Ok(())
    };
    notation.during(|| output.stream(write))
}

fn write_json(
    to: &mut dyn Write,
    request: &Request<'_>,
    values: &PointValues,
    first: bool,
) -> io::Result<()> {
    if first {
        write_line(to, &Stamped::new(Head::of(request, None)))?;
    }
    write_line(to, values)
}

fn write_line(to: &mut dyn Write, line: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *to, line)?;
    to.write_all(b"\n")
}

/// No quotation marks are needed: neither a number nor a name has a comma in it.
fn write_csv(to: &mut dyn Write, request: &Request<'_>, values: &PointValues, first: bool) -> io::Result<()> {
    if first {
        writeln!(to, "{}", columns(request).join(","))?;
    }
    let side = values.side;
    let notation = Notation::in_force();
    write!(to, "{},{side}", notation.number(&values.x.0))?;
    let curve = values.curve.iter().chain(&values.curve_derivatives);
    for value in std::iter::once(&values.values).chain(&values.derivatives).chain(curve).flatten() {
        write!(to, ",{}", notation.number(&value.0))?;
    }
    to.write_all(b"\n")
}

/// x, side, G_0, …, G_n, then the derivatives `G_0^(1)`, …, then the coordinates of the curve and its derivatives.
fn columns(request: &Request<'_>) -> Vec<String> {
    let functions = request.functions().map(|i| format!("G_{i}")).collect();
    let dimension = request.curve.map_or(0, crate::spline::Curve::dimension);
    let coordinates = (0..dimension).map(|c| format!("curve_{c}")).collect();
    let mut columns = vec!["x".to_owned(), "side".to_owned()];
    for names in [functions, coordinates] as [Vec<String>; 2] {
        columns.extend(names.iter().cloned());
        for order in 1..=request.order {
            columns.extend(names.iter().map(|name| format!("{name}^({order})")));
        }
    }
    columns
}
