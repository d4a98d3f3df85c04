//! The program `knotproof`; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    knotproof::cli::main()
}
