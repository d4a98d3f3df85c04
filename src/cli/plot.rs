//! The command `plot`: a picture of one's own basis or curve.

use std::fmt;
use std::path::PathBuf;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::Serialize;

use crate::meaning::Example;
use crate::report::figures::{self, Plot, png};
use crate::spline::Point;

use super::atomic::write_atomically;
use super::error::CliError;
use super::exit::Exit;
use super::instance::{Case, InstanceArgs};
use super::on_knots::OnKnots;
use super::output::Output;
use super::progress::Progress;
use super::visible::visible_path;

/// Draws your own basis or curve as the paper's figures are drawn: a panel for each α.
///
/// Of a curve the control polygon, its convex hull, the knots on the curve and its corners are marked; of one coordinate it is the
/// graph over x, of three the first two are drawn. Of a basis all functions with the knots below.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// What to draw; by default the curve if there are control points, else the basis.
    #[arg(long, value_name = "WHAT", value_enum)]
    show: Option<Show>,
    /// What stands above the picture, in place of the name of the instance.
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// The file for the picture, FILE.svg or FILE.png; the SVG is printed if there is none.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

const EXAMPLE: &str = r#"Examples:
  knotproof plot --degree 2 --knots "0 0 0 1 2 2 2" --alpha -1 --alpha 2 --alpha inf \
    --out basis.svg
  knotproof plot --degree 2 --knots "0 0 0 1 2 2 2" --alpha 5 --points "0,0 1,2 2,2 3,0" \
    --out curve.png
  knotproof plot --instance C5 --show basis > basis.svg
The same program writes the same bytes every time."#;

/// A value of `--show`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Show {
    /// The basis functions.
    Basis,
    /// The curve.
    Curve,
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Plotted {
    /// What this object is: `knotproof.plot/1`.
    #[schemars(extend("const" = "knotproof.plot/1"))]
    schema: &'static str,
    #[serde(flatten)]
    on: OnKnots,
    /// α, of each panel; nothing for another family.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    alpha: Vec<String>,
    /// What is drawn.
    show: Show,
    /// The file that was written; `null` if there is none.
    file: Option<PathBuf>,
    /// The picture, where no file was asked for.
    svg: Option<String>,
}

/// Draws and writes.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let is_png = match &args.out {
        None => false,
        Some(path) => match path.extension().and_then(|ending| ending.to_str()) {
            Some("svg") => false,
            Some("png") => true,
            _ => return Err(CliError::PictureFile { path: path.clone() }),
        },
    };
    let cases = args.instance.resolve_any()?.cases()?;
    let Some(first) = cases.first() else { unreachable!("an instance has a case") };
    let (on, points) = (OnKnots::of(&first.basis, first.label.clone()), points(first));
    let on = match &first.curve {
        Some(curve) => on.with_points_of(curve),
        None => on,
    };
    let show = args.show.unwrap_or(if points.is_some() { Show::Curve } else { Show::Basis });
    if show == Show::Curve && points.is_none() {
        return Err(CliError::NoPoints { needed: first.basis.n() + 1 });
    }
    let named = || first.label.clone().unwrap_or_else(|| "Basis".to_owned());
    let title = match (&args.title, show, &first.label) {
        (Some(title), ..) => title.clone(),
        (None, Show::Curve, None) => "Curve".to_owned(),
        (None, ..) => named(),
    };
    let example = Example {
        name: String::new().into(),
        figure: String::new(),
        degree: first.basis.degree(),
        knots: first.basis.knots().clone(),
        weights: cases.iter().map(|case| case.weights.clone()).collect(),
        points,
    };
    let progress = Progress::new(1);
    progress.step("the picture");
    let what = match show {
        Show::Basis => Plot::Basis,
        Show::Curve => Plot::Curve,
    };
    let svg = figures::plot(&title, &example, what)?.ok_or(CliError::Unseen)?;
    drop(progress);
    let (file, svg) = match &args.out {
        None => (None, Some(svg)),
        Some(path) => {
            let bytes = if is_png { png(&svg)? } else { svg.into_bytes() };
            write_atomically("--out", path, bytes)?;
            (Some(path.clone()), None)
        }
    };
    let alpha = example.indices().map(ToString::to_string).collect();
    output.result(&Plotted { schema: "knotproof.plot/1", on, alpha, show, file, svg })?;
    Ok(Exit::Holds)
}

fn points(case: &Case) -> Option<Vec<Point>> {
    case.curve.as_ref().map(|curve| curve.points().to_vec())
}

impl fmt::Display for Plotted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.file, &self.svg) {
            (Some(file), _) => writeln!(f, "{}", visible_path(file)),
            (None, svg) => f.write_str(svg.as_deref().unwrap_or_default()),
        }
    }
}
