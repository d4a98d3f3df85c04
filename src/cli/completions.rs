//! The command `completions`.

use std::fmt;

use clap::CommandFactory;
use clap_complete::{Shell, generate};
use schemars::JsonSchema;
use serde::Serialize;

use super::Program;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;

/// Prints a script by which a shell completes commands and options.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The shell.
    #[arg(value_name = "SHELL", value_enum)]
    shell: Shell,
}

const EXAMPLE: &str = "Examples, the first for one session, the second for good:
  source <(knotproof completions bash)
  knotproof completions fish > ~/.config/fish/completions/knotproof.fish";

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Completions {
    /// What this object is: `knotproof.completions/1`.
    #[schemars(extend("const" = "knotproof.completions/1"))]
    schema: &'static str,
    /// The shell.
    shell: String,
    /// What it has to read.
    script: String,
}

/// Writes the script.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let mut script = Vec::new();
    generate(args.shell, &mut Program::command(), "knotproof", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    output.result(&Completions {
        schema: "knotproof.completions/1",
        shell: args.shell.to_string(),
        script,
    })?;
    Ok(Exit::Holds)
}

impl fmt::Display for Completions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.script)
    }
}
