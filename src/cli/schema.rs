//! The command `schema`.

use schemars::schema_for;

use super::error::CliError;
use super::exit::Exit;
use super::file::InstanceFile;
use super::output::Output;

/// Prints the JSON Schema of instance files (for --instance FILE).
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {}

const EXAMPLE: &str = r#"Example:
  knotproof schema > instance.schema.json
An instance file:
  {"degree": 2, "knots": ["0", 0, 0, "1/2", 1, 1, 1], "alpha": "-1", "points": [["0", "2"], [1, 3], [2, 3], [3, 0]]}"#;

/// Prints the schema; it is JSON in either format.
pub(super) fn run(_: &Args, output: &Output) -> Result<Exit, CliError> {
    output.json(&schema_for!(InstanceFile))?;
    Ok(Exit::Holds)
}
