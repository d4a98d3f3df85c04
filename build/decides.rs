//! A digest of the sources that decide a case of the search, so that results of programs that may decide differently
//! are not mixed.

use std::fs;
use std::hash::Hasher;
use std::io;
use std::path::{Path, PathBuf};

use siphasher::sip::SipHasher24;

/// Numbers, splines, decisions, families and the weights that they give, and the search itself.
const DECIDING: [&str; 6] =
    ["src/scalar", "src/spline", "src/analysis", "src/language", "src/meaning", "src/search"];

/// The digest, as `KNOTPROOF_DECIDES` for the compiler.
pub(crate) fn tell() -> io::Result<()> {
    let mut files = Vec::new();
    for folder in DECIDING {
        println!("cargo::rerun-if-changed={folder}");
        sources(Path::new(folder), &mut files)?;
    }
    let mut hasher = SipHasher24::new();
    // In one order on every machine.
    files.sort_by_cached_key(|path| name(path));
    for path in files {
        // Line endings may have been converted, and decide nothing.
        let text = fs::read_to_string(&path)?.replace("\r\n", "\n");
        for part in [name(&path).as_bytes(), text.as_bytes()] {
            hasher.write(&(part.len() as u64).to_le_bytes());
            hasher.write(part);
        }
    }
    println!("cargo::rustc-env=KNOTPROOF_DECIDES={:016x}", hasher.finish());
    Ok(())
}

fn sources(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sources(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

fn name(path: &Path) -> String {
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
