//! Files that are there as a whole or not at all, whenever the program is stopped.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::error::CliError;

/// Writes a new file beside the old one, to the disk, and only then puts it in its place.
///
/// # Errors
/// [`CliError::File`]; the old file is then as it was.
pub(super) fn write_atomically(argument: &'static str, path: &Path, text: &str) -> Result<(), CliError> {
    let failed = |error| CliError::File { argument, action: "write", path: path.to_owned(), error };
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    };
    let mut file = NamedTempFile::new_in(&folder).map_err(failed)?;
    file.write_all(text.as_bytes()).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    // The new name is on the disk once the folder is; a system that cannot do that has renamed it all the same.
    let _ = File::open(&folder).and_then(|folder| folder.sync_all());
    Ok(())
}
