//! The certificates that are accepted.

use std::fs;
use std::path::Path;

pub(crate) struct Certificate {
    pub(crate) name: String,
    pub(crate) statement: String,
    pub(crate) proof: String,
}

/// All of `pass/`, by name.
pub(crate) fn certificates() -> Vec<Certificate> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pass");
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("its entries can be read").path();
        if path.extension().is_some_and(|extension| extension == "statement") {
            let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
            let read =
                |extension| fs::read_to_string(path.with_extension(extension)).expect("both files are there");
            all.push(Certificate { name, statement: read("statement"), proof: read("proof") });
        }
    }
    all.sort_by(|a, b| a.name.cmp(&b.name));
    assert!(all.len() > 15, "certificates are missing");
    all
}
