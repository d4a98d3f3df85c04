//! The command `new`: a folder for the claims of a paper, to start from.

use std::ffi::OsString;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::simplest_member;
use crate::language::Family;

use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::family::find;
use super::file::read;
use super::offered::family_name;
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
    /// The family of weights: a name (`knotproof families` lists them), or a file, which is copied into the folder.
    #[arg(long, value_name = "NAME|FILE", default_value = "mobius", value_parser = family_name(), hide_possible_values = true)]
    family: OsString,
}

const EXAMPLE: &str = "\
Examples:
  knotproof new my-paper
  knotproof new splines --title \"On splines\" --family knot-weights
Then `knotproof judge my-paper` judges it; one of the four claims is false as printed, on purpose.";

/// The files, by their names below the folder.
const FILES: [(&str, &str); 3] = [
    ("paper.toml", include_str!("paper.toml")),
    ("claims/01-basis.toml", include_str!("claims.toml")),
    ("instances.toml", include_str!("instances.toml")),
];

/// The family of the folder's own.
const OWN: &str = "family.toml";

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
    let family = find(&args.family)?;
    refuse_to_overwrite(&args.folder)?;
    let own = Path::new(&args.family);
    let copied = own.is_file().then(|| read("--family", own)).transpose()?;
    let (knots, points) = match family.knots.is_empty() {
        true => ("0 0 0 1 2 2 2", "0,0 1,2 3,2 4,0"),
        false => ("0 0 0 1 1 1", "0,0 1,2 3,0"),
    };
    // TOML takes the escapes of JSON, and wants one more.
    let title = serde_json::Value::from(args.title.as_str()).to_string().replace('\u{7f}', "\\u007f");
    let folder = Folder::beside("FOLDER", &args.folder)?;
    let mut files = Vec::new();
    let named = if copied.is_some() { OWN } else { &family.name };
    let given = [
        ("{family}", named),
        ("{knots}", knots),
        ("{points}", points),
        ("{weights}", &weights(&family, knots)),
        ("{title}", &title),
    ];
    for (name, text) in FILES {
        let text = given.iter().fold(text.to_owned(), |text, (key, value)| text.replace(key, value));
        files.push(folder.write(name, text)?);
    }
    if let Some(text) = copied {
        files.push(folder.write(OWN, text)?);
    }
    folder.put_in_place()?;
    output.result(&Written { schema: "knotproof.new/1", files })?;
    Ok(Exit::Holds)
}

/// What the instance says of its weights.
fn weights(family: &Family, knots: &str) -> String {
    match family.moebius() {
        Some(Some(_)) => {
            "# The indices alpha that are shown, by spaces; inf is the classical one.\nalpha = \"-1 2 inf\""
                .to_owned()
        }
        Some(None) => "alpha = \"inf\"".to_owned(),
        None => {
            let set = simplest_member(family, &[], knots.split(' ').count() - 1, 2);
            let set: Vec<_> = set.iter().map(|(name, values)| format!("{name} = \"{values}\"")).collect();
            format!("# The parameters of the family, as behind --set.\nset = {{ {} }}", set.join(", "))
        }
    }
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
