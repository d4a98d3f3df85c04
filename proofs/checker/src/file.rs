//! The text of a file.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

use crate::token::LONGEST;

/// Reads a statement or a proof as it is, to the last byte.
///
/// # Errors
/// If the file cannot be read, is longer than what [`check`](crate::check) looks at, or is not UTF-8.
pub fn read(path: &Path) -> Result<String> {
    let mut bytes = Vec::new();
    File::open(path)?.take(LONGEST as u64 + 1).read_to_end(&mut bytes)?;
    let wrong = |message: String| Error::new(ErrorKind::InvalidData, message);
    if bytes.len() > LONGEST {
        return Err(wrong(format!("it is longer than {LONGEST} bytes")));
    }
    String::from_utf8(bytes)
        .map_err(|error| wrong(format!("byte {} is not UTF-8 text", error.utf8_error().valid_up_to())))
}
