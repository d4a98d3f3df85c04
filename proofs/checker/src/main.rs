//! Checks certificates: pairs of a statement and its proof.

use std::io::{Error, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;

use knotproof_checker::{Checked, check, read};

const REJECTED: u8 = 1;
const UNREADABLE: u8 = 2;

/// The name of a file, on one line and without anything that a terminal obeys.
fn shown(file: &Path) -> String {
    let visible = |c: char| match c {
        '\'' | '"' | '\\' => c.to_string(),
        _ => c.escape_debug().to_string(),
    };
    file.to_string_lossy().chars().map(visible).collect()
}

/// Checks one certificate on a thread of its own: if the checker has a fault, it stops there, and the next one is read.
fn checked(statement: &str, proof: &str) -> Result<Checked, String> {
    let run = || check(statement, proof).map_err(|rejected| rejected.to_string());
    let ended = thread::scope(|scope| scope.spawn(run).join());
    ended.unwrap_or_else(|_| Err("not checked: the checker has a fault".to_owned()))
}

/// Prints one line, or says why not with an exit code.
fn report(statement: &Path, proof: &Path) -> Result<(), (u8, String)> {
    let unreadable = |file, error: Error| (UNREADABLE, format!("{}: {error}", shown(file)));
    let text = |file| read(file).map_err(|error| unreadable(file, error));
    let checked = checked(&text(statement)?, &text(proof)?);
    let checked = checked.map_err(|reason| (REJECTED, format!("{}: {reason}", shown(statement))))?;
    writeln!(std::io::stdout(), "{checked}").map_err(|error| unreadable(statement, error))
}

fn main() -> ExitCode {
    let files: Vec<_> = std::env::args_os().skip(1).map(PathBuf::from).collect();
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
