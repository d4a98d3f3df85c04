//! Checks certificates: pairs of a statement and its proof.

use std::io::Write;
use std::process::ExitCode;

use knotproof_checker::check;

const REJECTED: u8 = 1;
const UNREADABLE: u8 = 2;

fn main() -> ExitCode {
    let files: Vec<_> = std::env::args_os().skip(1).collect();
    let mut worst = 0;
    let mut complain = |code: u8, message: String| {
        worst = worst.max(code);
        // Where nobody listens any more the exit code still tells.
        let _ = writeln!(std::io::stderr(), "{message}");
    };
    if files.is_empty() || files.len() % 2 == 1 {
        complain(UNREADABLE, "usage: knotproof-checker NAME.statement NAME.proof …".to_owned());
        return ExitCode::from(worst);
    }
    for pair in files.chunks_exact(2) {
        let [statement, proof] = pair else { continue };
        let name = statement.to_string_lossy();
        let read = |file| std::fs::read_to_string(file).map_err(|error| format!("{}: {error}", name));
        match (read(statement), std::fs::read_to_string(proof)) {
            (Ok(statement), Ok(proof)) => match check(&statement, &proof) {
                Ok(checked) => {
                    if writeln!(std::io::stdout(), "{checked}").is_err() {
                        complain(UNREADABLE, "the result could not be printed".to_owned());
                    }
                }
                Err(rejected) => complain(REJECTED, format!("{name}: {rejected}")),
            },
            (Err(message), _) => complain(UNREADABLE, message),
            (_, Err(error)) => complain(UNREADABLE, format!("{}: {error}", proof.to_string_lossy())),
        }
    }
    ExitCode::from(worst)
}
