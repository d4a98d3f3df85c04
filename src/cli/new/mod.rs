//! The command `new`: a folder for the claims of a paper, to start from.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;

use crate::language::Family;

use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::visible::visible_path;

/// Writes a folder for the claims of a paper, with four claims that work and comments that say how to go on.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The folder, which must not be there yet, or be empty.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// The title of the paper.
    #[arg(long, value_name = "TITLE", default_value = "My paper")]
    title: String,
    /// The family of weights: mobius, with an index α, or classical, for polynomial B-splines.
    #[arg(long, value_name = "NAME", default_value = "mobius")]
    family: String,
}

const EXAMPLE: &str = "\
Examples:
  knotproof new my-paper
  knotproof new splines --title \"On splines\" --family classical
Then `knotproof judge my-paper` judges it; one of the four claims is false as printed, on purpose.";

/// The files, by their names below the folder.
const FILES: [(&str, &str); 3] = [
    ("paper.toml", include_str!("paper.toml")),
    ("claims/01-basis.toml", include_str!("claims.toml")),
    ("instances.toml", include_str!("instances.toml")),
];

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Written {
    /// What this object is: `knotproof.new/1`.
    #[schemars(extend("const" = "knotproof.new/1"))]
    schema: &'static str,
    /// What was written.
    files: Vec<PathBuf>,
}

/// Writes the folder.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let family = Family::named(&args.family).ok_or_else(|| CliError::UnknownFamily {
        name: args.family.clone(),
        names: Family::ALL.map(|(name, _)| name).to_vec(),
    })?;
    refuse_to_overwrite(&args.folder)?;
    let alpha = match family {
        Family::Mobius => "-1 2 inf",
        Family::Classical => "inf",
    };
    // TOML takes the escapes of JSON, and wants one more.
    let title = serde_json::Value::from(args.title.as_str()).to_string().replace('\u{7f}', "\\u007f");
    let folder = Folder::beside("FOLDER", &args.folder)?;
    let mut files = Vec::new();
    for (name, text) in FILES {
        let text = text.replace("{family}", family.name()).replace("{alpha}", alpha);
        files.push(folder.write(name, text.replace("{title}", &title))?);
    }
    folder.put_in_place()?;
    output.result(&Written { schema: "knotproof.new/1", files })?;
    Ok(Exit::Holds)
}

/// A folder with anything in it is somebody's.
fn refuse_to_overwrite(folder: &Path) -> Result<(), CliError> {
    let failed =
        |error| CliError::File { argument: "FOLDER", action: "write", path: folder.to_owned(), error };
    match fs::read_dir(folder).map(|mut entries| entries.next().is_none()) {
        Ok(true) => Ok(()),
        Ok(false) => Err(failed(io::Error::new(
            io::ErrorKind::AlreadyExists,
            "it is there and not empty; name a folder that is not there yet",
        ))),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(failed(error)),
    }
}

/// The files, and what to do next.
impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for file in &self.files {
            writeln!(f, "Written: {}", visible_path(file))?;
        }
        let folder = self.files.first().and_then(|file| file.parent()).unwrap_or(Path::new("."));
        write!(f, "Next: knotproof judge {}", visible_path(folder))
    }
}
