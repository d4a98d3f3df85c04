//! The command `figures`: the paper's figures, and ours beside them, as SVG and PNG.

use std::fmt;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use crate::report::figures::{Figure, all, figure, png};

use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::progress::Progress;
use super::visible::visible_path;

/// Draws the paper's figures, and ours beside them, each as SVG and as PNG.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// Figures of the paper by number, 7 or fig7, and ours by name, such as two-maxima; all if there is none.
    #[arg(value_name = "NUMBER")]
    figures: Vec<String>,
    /// The folder for the pictures, which is made if it is not there.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLE: &str = "\
Examples:
  knotproof figures --out figures
  knotproof figures 12 29 two-maxima --out figures --format json
The same program writes the same bytes every time.";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Drawn {
    /// What this object is: `knotproof.figures/1`.
    #[schemars(extend("const" = "knotproof.figures/1"))]
    schema: &'static str,
    /// What was written.
    files: Vec<PathBuf>,
    /// What it shows.
    figures: Vec<Entry>,
}

/// A figure that was drawn.
#[derive(Debug, Serialize, JsonSchema)]
struct Entry {
    /// Its name: that of its files, without the ending.
    name: &'static str,
    /// Its title.
    title: &'static str,
    /// The claims that it belongs to.
    claims: &'static [&'static str],
}

/// Draws, writes and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let chosen = choose(&args.figures)?;
    Folder::try_out("--out", &args.out)?;
    let progress = Progress::new(chosen.len());
    let mut drawn = Vec::new();
    for figure in chosen {
        progress.step(figure.name);
        let svg = figure.svg()?;
        drawn.push((figure, png(&svg)?, svg));
    }
    drop(progress);
    let folder = Folder::beside("--out", &args.out)?;
    let (mut files, mut figures) = (Vec::new(), Vec::new());
    for (figure, png, svg) in drawn {
        files.push(folder.write(&format!("{}.svg", figure.name), svg)?);
        files.push(folder.write(&format!("{}.png", figure.name), png)?);
        figures.push(Entry { name: figure.name, title: figure.title, claims: figure.claims });
    }
    folder.put_in_place()?;
    output.result(&Drawn { schema: "knotproof.figures/1", files, figures })?;
    Ok(Exit::Holds)
}

/// The figures of these names, once each and in their order, or all if there are none.
fn choose(names: &[String]) -> Result<Vec<&'static Figure>, CliError> {
    let unknown = |name: &String| CliError::UnknownFigure {
        name: name.clone(),
        last: all().iter().filter_map(|figure| figure.number).max().unwrap_or_default(),
        ours: all().iter().filter(|figure| figure.number.is_none()).map(|figure| figure.name).collect(),
    };
    let named: Vec<&Figure> =
        names.iter().map(|name| figure(name).ok_or_else(|| unknown(name))).collect::<Result<_, _>>()?;
    let chosen = |figure: &&Figure| names.is_empty() || named.iter().any(|one| one.name == figure.name);
    Ok(all().iter().filter(chosen).collect())
}

impl fmt::Display for Drawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.files.iter().try_for_each(|file| writeln!(f, "{}", visible_path(file)))
    }
}
