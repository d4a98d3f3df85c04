//! Papers on a command line: a folder, or the name of one that comes with the program.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::certificate::window_fault;
use crate::language::{Complaint, Family, Paper, shipped, shipped_names};
use crate::meaning::row_faults;

use super::error::CliError;
use super::file::read;

/// The folder of files of claims.
const CLAIMS: &str = "claims";

/// The paper in a folder, or, where there is no such folder, the one of that name that comes with the program.
///
/// # Errors
/// [`CliError::NoPaper`] for neither; [`CliError::Claim`] with all that is wrong in the folder.
pub fn paper_of(argument: &'static str, name: &OsStr) -> Result<Cow<'static, Paper>, CliError> {
    let folder = Path::new(name);
    if folder.is_dir() {
        return read_folder(argument, folder).map(Cow::Owned);
    }
    let known = name.to_str().and_then(shipped).map(Cow::Borrowed);
    known.ok_or_else(|| {
        let failed = |error| CliError::File { argument, action: "read", path: folder.to_owned(), error };
        match fs::metadata(folder) {
            Ok(_) => failed(io::Error::other("it is a file; name the folder that it lies in")),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let name = name.to_string_lossy().into_owned();
                CliError::NoPaper { argument, name, names: shipped_names().collect() }
            }
            Err(error) => failed(error),
        }
    })
}

/// Reads all files before any is understood: what is replaced later changes nothing.
fn read_folder(argument: &'static str, folder: &Path) -> Result<Paper, CliError> {
    let (mut files, mut complaints) = (BTreeMap::new(), Vec::new());
    for below in ["", CLAIMS] {
        let listed = match list(&folder.join(below)) {
            Ok(listed) => listed,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => {
                return Err(CliError::File { argument, action: "read", path: folder.join(below), error });
            }
        };
        for path in listed {
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            let name = if below.is_empty() { file.into_owned() } else { format!("{below}/{file}") };
            match text(argument, &path) {
                Ok(text) => _ = files.insert(name, text),
                Err(why) => {
                    let advice = "make it a text file that can be read, or move it away";
                    complaints.push(Complaint::in_file((&name, ""), 0..0, why, advice));
                    // It is there: nothing else is to be said of it.
                    files.insert(name, String::new());
                }
            }
        }
    }
    let unread: Vec<String> = complaints.iter().map(|complaint| complaint.source().to_owned()).collect();
    let (paper, wrong) = Paper::as_far_as_read(&files);
    complaints
        .extend(wrong.into_iter().filter(|complaint| !unread.iter().any(|name| name == complaint.source())));
    complaints.extend(row_faults(&paper));
    complaints.extend(window_fault(&paper));
    if complaints.is_empty() {
        let mut paper = Paper { called: Some(quoted(folder)), ..paper };
        // A family of the folder's own is found from outside.
        if let Some(file) = Some(&paper.about.family.given).filter(|given| files.contains_key(*given)) {
            let given = folder.join(file).display().to_string();
            paper.about.family = Arc::new(Family { given, ..Family::clone(&paper.about.family) });
        }
        return Ok(paper);
    }
    complaints.sort_by(|a, b| (a.source(), a.place()).cmp(&(b.source(), b.place())));
    let name = folder.display().to_string();
    let complaints =
        complaints.into_iter().map(|complaint| complaint.below(name.trim_end_matches('/'))).collect();
    Err(CliError::Claim { argument, complaints })
}

/// The files of data in a folder, by name. Hidden ones are an editor's.
fn list(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let hidden = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
        if !hidden && path.extension().is_some_and(|extension| extension == "toml") {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

/// The text of a file, or why there is none.
fn text(argument: &'static str, path: &Path) -> Result<String, String> {
    match fs::metadata(path) {
        // Opening a pipe would wait for somebody to write.
        Ok(about) if !about.is_file() => return Err("this is no file".to_owned()),
        Ok(_) => {}
        Err(error) => return Err(format!("this can't be read: {error}")),
    }
    read(argument, path).map_err(|error| match error {
        CliError::File { error, .. } => format!("this can't be read: {error}"),
        other => other.to_string(),
    })
}

/// A path as a shell reads it.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let plain = |c: char| c.is_ascii_alphanumeric() || "._-/+,:@".contains(c);
    if text.chars().all(plain) { text } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_quoted_where_a_shell_would_split_them() {
        for (path, shown) in
            [("papers/mine", "papers/mine"), ("my paper", "'my paper'"), ("it's", "'it'\\''s'")]
        {
            assert_eq!(quoted(Path::new(path)), shown);
        }
    }
}
