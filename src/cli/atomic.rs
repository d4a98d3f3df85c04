//! Files and folders that are there as a whole or not at all, whenever the program is stopped.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, TempDir};

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
    builder.permissions(permissions(&target, 0o666));
    // The kind of the error is enough: its text would name a file that nobody knows.
    let mut file = builder.tempfile_in(&folder).map_err(|error| failed(error.kind().into()))?;
    file.as_file_mut().write_all(content.as_ref()).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(&target).map_err(|error| failed(error.error))?;
    // The new name is on the disk once the folder is; a system that cannot do that has renamed it all the same.
    let _ = File::open(&folder).and_then(|folder| folder.sync_all());
    Ok(())
}

/// A folder of files that belong together: they are written into a new folder beside it, which then takes its place.
///
/// Whatever else lies in the old folder lies in the new one too. Where the system can exchange two folders in one
/// step (Linux, macOS), a reader finds the old one or the new one at any moment, also after a kill; elsewhere there is
/// an instant in which it finds none.
pub(super) struct Folder {
    argument: &'static str,
    /// As the user calls it.
    name: PathBuf,
    /// The folder itself, if the name is a link.
    target: PathBuf,
    fresh: TempDir,
}

impl Folder {
    /// Finds out whether the folder can be written, before the work for it begins.
    ///
    /// # Errors
    /// [`CliError::File`].
    pub(super) fn try_out(argument: &'static str, target: &Path) -> Result<(), CliError> {
        Self::beside(argument, target).map(drop)
    }

    /// An empty folder beside the one that it will replace.
    ///
    /// # Errors
    /// [`CliError::File`], if nothing can be made there, or if the folder can't be replaced.
    pub(super) fn beside(argument: &'static str, target: &Path) -> Result<Self, CliError> {
        let failed = |error| CliError::File { argument, action: "write", path: target.to_owned(), error };
        let refused = |why: &str| Err(failed(io::Error::new(io::ErrorKind::InvalidInput, why.to_owned())));
        let path = match fs::canonicalize(target) {
            Ok(path) if !path.is_dir() => return refused("it is a file; name a folder"),
            // Replaced as a whole, it would be taken away under whoever stands in it.
            Ok(path) if std::env::current_dir().is_ok_and(|here| here.starts_with(&path)) => {
                return refused("the current folder can't be replaced as a whole; name a folder in it");
            }
            Ok(path) => path,
            Err(_) if fs::symlink_metadata(target).is_ok() => {
                return refused("it is a link that leads nowhere; remove it, or name a folder");
            }
            Err(_) => target.to_owned(),
        };
        let (Some(name), Some(parent)) = (path.file_name(), path.parent()) else {
            return refused("it can't be replaced as a whole; name a folder in it");
        };
        let parent = if parent == Path::new("") { Path::new(".") } else { parent };
        fs::create_dir_all(parent).map_err(failed)?;
        let prefix = format!(".{}.", name.to_string_lossy());
        let mut builder = Builder::new();
        builder.prefix(&prefix);
        #[cfg(unix)]
        builder.permissions(permissions(&path, 0o777));
        // The kind of the error is enough: its text would name a folder that nobody knows.
        let fresh = builder.tempdir_in(parent).map_err(|error| failed(error.kind().into()))?;
        Ok(Self { argument, name: target.to_owned(), target: path, fresh })
    }

    /// Writes a file, whose name may have folders in it; it will be at the path that is returned.
    ///
    /// # Errors
    /// [`CliError::File`]; the old folder is then as it was.
    pub(super) fn write(&self, name: &str, content: impl AsRef<[u8]>) -> Result<PathBuf, CliError> {
        let path = self.name.join(name);
        let fresh = self.fresh.path().join(name);
        let around = fresh.parent().map_or(Ok(()), fs::create_dir_all);
        let written = around.and_then(|()| File::create(&fresh)).and_then(|mut file| {
            file.write_all(content.as_ref())?;
            file.sync_all()
        });
        written.map_err(|error| self.failed(&path, error))?;
        Ok(path)
    }

    /// Puts the new folder in the place of the old one.
    ///
    /// # Errors
    /// [`CliError::File`]; the old folder is then as it was.
    pub(super) fn put_in_place(self) -> Result<(), CliError> {
        let Self { argument, name, target, fresh } = self;
        let placed = match fs::symlink_metadata(&target) {
            Ok(_) => adopt(&target, fresh.path()).and_then(|()| exchange(fresh.path(), &target)),
            Err(_) => fs::rename(fresh.path(), &target),
        };
        if let Some(parent) = target.parent().filter(|_| placed.is_ok()) {
            // The new name is on the disk once its folder is; a system that cannot do that has renamed it all the same.
            let _ = File::open(parent).and_then(|folder| folder.sync_all());
        }
        // What is left there now is the old folder; that it can't be removed does no harm to the new one.
        let _ = fresh.close();
        placed.map_err(|error| CliError::File { argument, action: "write", path: name, error })
    }

    fn failed(&self, path: &Path, error: io::Error) -> CliError {
        CliError::File { argument: self.argument, action: "write", path: path.to_owned(), error }
    }
}

/// Everything in the old folder that the new one has not: the same files under a second name, so that nothing is lost
/// whatever happens next.
fn adopt(old: &Path, new: &Path) -> io::Result<()> {
    for entry in fs::read_dir(old)? {
        let entry = entry?;
        let (from, to) = (entry.path(), new.join(entry.file_name()));
        match fs::symlink_metadata(&to) {
            Ok(new) if entry.file_type()?.is_dir() && !new.is_dir() => {
                let name = entry.file_name();
                let message = format!("{} is a folder there, and would be a file", name.to_string_lossy());
                return Err(io::Error::new(io::ErrorKind::IsADirectory, message));
            }
            Ok(_) => {}
            Err(_) if entry.file_type()?.is_dir() => {
                fs::create_dir(&to)?;
                fs::set_permissions(&to, entry.metadata()?.permissions())?;
                adopt(&from, &to)?;
            }
            // Not every file system has second names.
            Err(_) => fs::hard_link(&from, &to).or_else(|_| fs::copy(&from, &to).map(drop))?,
        }
    }
    Ok(())
}

/// Exchanges two folders.
fn exchange(fresh: &Path, target: &Path) -> io::Result<()> {
    #[cfg(any(target_os = "linux", target_vendor = "apple"))]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        // Some file systems cannot; they get the two steps below.
        if renameat_with(CWD, fresh, CWD, target, RenameFlags::EXCHANGE).is_ok() {
            return Ok(());
        }
    }
    let mut aside = fresh.as_os_str().to_owned();
    aside.push("old");
    fs::rename(target, &aside)?;
    if let Err(error) = fs::rename(fresh, target) {
        fs::rename(&aside, target)?;
        return Err(error);
    }
    fs::rename(&aside, fresh)
}

/// Those of the file or folder, if it is there, otherwise those of a new one; the system takes away what the umask says.
#[cfg(unix)]
fn permissions(path: &Path, new: u32) -> fs::Permissions {
    use std::os::unix::fs::PermissionsExt;

    let mode = fs::metadata(path).map_or(new, |old| old.permissions().mode() & 0o777);
    fs::Permissions::from_mode(mode)
}
