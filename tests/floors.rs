//! The floors of the crate: a module uses those on its own floor and below, never one above.

use std::fs;
use std::path::{Path, PathBuf};

/// The top-level modules, from the ground up.
const FLOORS: &[&[&str]] = &[
    &["scalar", "json"],
    &["language", "spline"],
    &["analysis"],
    &["meaning"],
    &["judge"],
    &["claims", "search", "certificate"],
    &["report", "float"],
    &["cli"],
];

fn floor(module: &str) -> Option<usize> {
    FLOORS.iter().position(|modules| modules.contains(&module))
}

/// The modules that a text names by `crate::X`, or as the X, Y of `crate::{X::…, Y}`, or by climbing to the root
/// from a file `depth` modules below it, as in `super::super::X`. Lines of comment do not count: a link in the
/// documentation may lead anywhere.
fn named(text: &str, depth: usize) -> Vec<String> {
    let code: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let mut names = Vec::new();
    let climb = "super::".repeat(depth);
    for (at, path) in code.match_indices("crate::").chain(code.match_indices(&climb)) {
        let rest = &code[at + path.len()..];
        match rest.strip_prefix('{') {
            Some(group) => names.extend(first_segments(group)),
            None => names.push(leading_word(rest)),
        }
    }
    names
}

fn leading_word(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// The first segments of a group `a::b, c::{d, e}, f}`, as far as its closing brace.
fn first_segments(group: &str) -> Vec<String> {
    let (mut depth, mut item, mut segments) = (0, String::new(), Vec::new());
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => segments.push(std::mem::take(&mut item)),
            _ if depth == 0 => item.push(c),
            _ => {}
        }
    }
    segments.push(item);
    segments.iter().map(|item| leading_word(item.trim())).filter(|word| !word.is_empty()).collect()
}

/// What a file of the module must not name.
fn offences(module: &str, depth: usize, text: &str) -> Vec<String> {
    let own = floor(module);
    named(text, depth).into_iter().filter(|name| floor(name).is_some_and(|other| Some(other) > own)).collect()
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn files_below(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        // A font or a template names no module.
        let source = path.extension().is_some_and(|extension| extension == "rs");
        return if source { vec![path.to_owned()] } else { Vec::new() };
    }
    let entries = fs::read_dir(path).expect("a source folder can be read");
    entries.flat_map(|entry| files_below(&entry.expect("so can its entries").path())).collect()
}

/// How far below the root the module of a file is: 1 for `src/x.rs` and `src/x/mod.rs`, 2 for `src/x/y.rs`.
fn depth(file: &Path) -> usize {
    let below = file.strip_prefix(source()).expect("the file is in the source folder").components().count();
    if file.ends_with("mod.rs") { below - 1 } else { below }
}

/// The entries of `src` with the modules that they are: all but the two roots.
fn modules() -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(source()).expect("the source folder can be read");
    let paths = entries.map(|entry| entry.expect("so can its entries").path());
    let name = |path: &PathBuf| path.file_stem().expect("an entry has a name").to_string_lossy().into_owned();
    paths.map(|path| (name(&path), path)).filter(|(name, _)| name != "lib" && name != "main").collect()
}

#[test]
fn no_file_names_a_floor_above_its_own() {
    let mut seen = 0;
    for (module, path) in modules() {
        for file in files_below(&path) {
            let text = fs::read_to_string(&file).expect("a source file can be read");
            let depth = depth(&file);
            let offences = offences(&module, depth, &text);
            assert!(offences.is_empty(), "{} is below {offences:?}", file.display());
            seen += named(&text, depth).len();
        }
    }
    assert!(seen > 10, "only {seen} uses of other modules were found: the test does not see them");
}

#[test]
fn every_module_has_a_floor() {
    for (module, path) in modules() {
        assert!(floor(&module).is_some(), "{} stands on no floor", path.display());
    }
    let library = fs::read_to_string(source().join("lib.rs")).expect("the root can be read");
    let declared: Vec<_> =
        library.lines().filter_map(|line| line.strip_prefix("pub mod ")).map(leading_word).collect();
    assert!(declared.len() >= 5);
    for module in declared {
        assert!(floor(&module).is_some(), "`{module}` stands on no floor");
    }
}

#[test]
fn a_wrong_use_is_found() {
    let clean = "use crate::scalar::Ring;\nfn f(x: &crate::spline::Basis) {}\n";
    assert!(offences("analysis", 2, clean).is_empty());
    for (module, text, found) in [
        ("scalar", clean, vec!["spline"]),
        ("analysis", "use crate::claims::Verdict;", vec!["claims"]),
        ("claims", "use crate::float::study;", vec!["float"]),
        ("claims", "let x = crate::report::write();", vec!["report"]),
        ("report", "use crate::{cli, claims::{self, report}};", vec!["cli"]),
        ("spline", "use crate::{\n    scalar::{self, Ring},\n    analysis::Pieces,\n};", vec!["analysis"]),
        ("scalar", "use super::super::spline::Basis;", vec!["spline"]),
        ("search", "pub(crate) use crate::cli::main;", vec!["cli"]),
    ] {
        assert_eq!(offences(module, 2, text), found, "{module}: {text}");
    }
    assert_eq!(offences("scalar", 1, "use super::spline::Basis;"), ["spline"]);
    assert!(offences("scalar", 2, "use super::float::ulp;").is_empty(), "the sibling, not the floor");
    // On one floor, and in comments, everything may be named.
    assert!(offences("report", 2, "use crate::{float, claims};").is_empty());
    assert!(offences("scalar", 2, "/// See [`crate::analysis`].\n// crate::cli").is_empty());
}
