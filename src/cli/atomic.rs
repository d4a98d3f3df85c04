//! Files that are there as a whole or not at all, whenever the program is stopped.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::Builder;

use super::error::CliError;

/// Writes a new file beside the old one, to the disk, and only then puts it in its place. It has the permissions of the
/// old one, or else those of any new file; of a symbolic link the target is replaced.
///
/// # Errors
/// [`CliError::File`]; the old file is then as it was.
pub(super) fn write_atomically(
    argument: &'static str,
    path: &Path,
    content: impl AsRef<[u8]>,
) -> Result<(), CliError> {
    let failed = |error| CliError::File { argument, action: "write", path: path.to_owned(), error };
    let target = match fs::symlink_metadata(path) {
        Ok(_) => fs::canonicalize(path).map_err(failed)?,
        Err(_) => path.to_owned(),
    };
    let folder = match target.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    };
    if !folder.is_dir() {
        let message = format!("there is no folder {}; make it first", folder.display());
        return Err(failed(io::Error::new(io::ErrorKind::NotFound, message)));
    }
    let mut builder = Builder::new();
    #[cfg(unix)]
    builder.permissions(permissions(&target));
    // The kind of the error is enough: its text would name a file that nobody knows.
    let mut file = builder.tempfile_in(&folder).map_err(|error| failed(error.kind().into()))?;
    file.as_file_mut().write_all(content.as_ref()).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(&target).map_err(|error| failed(error.error))?;
    // The new name is on the disk once the folder is; a system that cannot do that has renamed it all the same.
    let _ = File::open(&folder).and_then(|folder| folder.sync_all());
    Ok(())
}

/// Those of the file, if it is there; the system takes away what the umask says.
#[cfg(unix)]
fn permissions(path: &Path) -> fs::Permissions {
    use std::os::unix::fs::PermissionsExt;

    let mode = fs::metadata(path).map_or(0o666, |old| old.permissions().mode() & 0o777);
    fs::Permissions::from_mode(mode)
}
