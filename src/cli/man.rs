//! The command `man`.

use std::fmt;
use std::path::PathBuf;

use clap::CommandFactory;
use clap_mangen::Man;
use schemars::JsonSchema;
use serde::Serialize;

use super::Program;
use super::atomic::Folder;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::visible::visible_path;

/// Writes manual pages: knotproof.1, and one for each command.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The folder to write them to; it is made if it is not there.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLE: &str = "Example, after which `man knotproof-eval` shows a page:
  knotproof man --out ~/.local/share/man/man1";

/// A command that is broken at a hyphen is no command any more.
const NO_HYPHENS: &[u8] = b".nh\n";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Pages {
    /// What this object is: `knotproof.man/1`.
    #[schemars(extend("const" = "knotproof.man/1"))]
    schema: &'static str,
    /// What was written.
    files: Vec<PathBuf>,
}

/// Writes the pages and names them.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let mut program = Program::command();
    program.build();
    let folder = Folder::beside("--out", &args.out)?;
    let mut files = Vec::new();
    for command in std::iter::once(&program).chain(program.get_subcommands()) {
        let page = Man::new(command.clone());
        let mut text = NO_HYPHENS.to_vec();
        page.render(&mut text)?;
        files.push(folder.write(&page.get_filename(), &text)?);
    }
    folder.put_in_place()?;
    output.result(&Pages { schema: "knotproof.man/1", files })?;
    Ok(Exit::Holds)
}

/// One file a line.
impl fmt::Display for Pages {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.files.iter().try_for_each(|file| writeln!(f, "{}", visible_path(file)))
    }
}
