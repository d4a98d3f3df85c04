//! Checks certificates: pairs of a statement and its proof.

use std::ffi::OsString;
use std::fs::read_to_string;
use std::io::Write;
use std::process::ExitCode;

use knotproof_checker::check;

const REJECTED: u8 = 1;
const UNREADABLE: u8 = 2;

/// Prints one line, or says why not with an exit code.
fn report(statement: &OsString, proof: &OsString) -> Result<(), (u8, String)> {
    let name = statement.to_string_lossy();
    let unreadable = |error: std::io::Error| (UNREADABLE, format!("{name}: {error}"));
    let (statement, proof) = (read_to_string(statement), read_to_string(proof));
    let checked = check(&statement.map_err(unreadable)?, &proof.map_err(unreadable)?);
    let checked = checked.map_err(|rejected| (REJECTED, format!("{name}: {rejected}")))?;
    writeln!(std::io::stdout(), "{checked}").map_err(unreadable)
}

fn main() -> ExitCode {
    let files: Vec<_> = std::env::args_os().skip(1).collect();
    let (pairs, rest) = files.as_chunks();
    let usage = (UNREADABLE, "usage: knotproof-checker NAME.statement NAME.proof …".to_owned());
    let mut worst = 0;
    let misused = files.is_empty() || !rest.is_empty();
    let failed = pairs.iter().filter_map(|[statement, proof]| report(statement, proof).err());
    for (code, message) in misused.then_some(usage).into_iter().chain(failed) {
        worst = worst.max(code);
        // Where nobody listens any more the exit code still tells.
        let _ = writeln!(std::io::stderr(), "{message}");
    }
    ExitCode::from(worst)
}
