//! Exit codes.

use std::process::ExitCode;

/// What the program's exit code says; scripts rely on the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// Everything asked holds, or was done.
    Holds = 0,
    /// Something is refuted, or differs from the baseline.
    Refuted = 1,
    /// The request is wrong: bad usage or bad input.
    Usage = 2,
    /// Undecided within the limits.
    Undecided = 3,
    /// The program failed: a bug, or results that could not be written.
    Internal = 4,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}
