//! The floors of the crate: a module uses those on its own floor and below, never one above, and no two modules, down to
//! single files, use each other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The top-level modules, from the ground up.
const FLOORS: &[&[&str]] = &[
    &["scalar", "json"],
    &["language", "spline"],
    &["analysis"],
    &["meaning", "formula"],
    &["judge", "certificate", "search", "typed"],
    &["settle", "float", "study"],
    &["report"],
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
    let segments = split_at_commas(group);
    segments.iter().map(|item| leading_word(item.trim())).filter(|word| !word.is_empty()).collect()
}

/// The items of a group, as far as its closing brace; a group within one stays in one piece.
fn split_at_commas(group: &str) -> Vec<String> {
    let (mut depth, mut item, mut items) = (0, String::new(), Vec::new());
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                items.push(std::mem::take(&mut item));
                continue;
            }
            _ => {}
        }
        item.push(c);
    }
    items.push(item);
    items
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

/// The first line of a room says on which floor it is.
#[test]
fn every_folder_says_its_floor() {
    for (module, path) in modules().into_iter().filter(|(_, path)| path.is_dir()) {
        let text = fs::read_to_string(path.join("mod.rs")).expect("a folder has a mod.rs");
        let number = floor(&module).map_or(0, |floor| floor + 1);
        assert!(text.starts_with(&format!("//! Floor {number}: ")), "{module} is on floor {number}");
    }
}

#[test]
fn a_wrong_use_is_found() {
    let clean = "use crate::scalar::Ring;\nfn f(x: &crate::spline::Basis) {}\n";
    assert!(offences("analysis", 2, clean).is_empty());
    for (module, text, found) in [
        ("scalar", clean, vec!["spline"]),
        ("analysis", "use crate::judge::Verdict;", vec!["judge"]),
        ("certificate", "use crate::settle::settle;", vec!["settle"]),
        ("settle", "let x = crate::report::write();", vec!["report"]),
        ("report", "use crate::{cli, settle::{self, report}};", vec!["cli"]),
        ("spline", "use crate::{\n    scalar::{self, Ring},\n    analysis::Pieces,\n};", vec!["analysis"]),
        ("scalar", "use super::super::spline::Basis;", vec!["spline"]),
        ("search", "pub(crate) use crate::cli::main;", vec!["cli"]),
    ] {
        assert_eq!(offences(module, 2, text), found, "{module}: {text}");
    }
    assert_eq!(offences("scalar", 1, "use super::spline::Basis;"), ["spline"]);
    assert!(offences("scalar", 2, "use super::float::ulp;").is_empty(), "the sibling, not the floor");
    // On one floor, and in comments, everything may be named.
    assert!(offences("report", 2, "use crate::{float, settle};").is_empty());
    assert!(offences("scalar", 2, "/// See [`crate::analysis`].\n// crate::cli").is_empty());
}

/// Every module by its path from the root, `analysis::pieces` for one, with its text.
type Texts = BTreeMap<String, String>;

/// The modules that each module names.
type Uses<'a> = BTreeMap<&'a str, BTreeSet<String>>;

fn texts() -> Texts {
    let read = |file: PathBuf| {
        let path = file.strip_prefix(source()).expect("the file is in the source folder").with_extension("");
        let names: Vec<_> = path.iter().map(|name| name.to_string_lossy().into_owned()).collect();
        let names = names.strip_suffix(&["mod".to_owned()]).unwrap_or(&names);
        (names.join("::"), fs::read_to_string(&file).expect("a source file can be read"))
    };
    let roots = ["lib", "main"].map(|root| source().join(root).with_extension("rs"));
    files_below(&source()).into_iter().filter(|file| !roots.contains(file)).map(read).collect()
}

/// The code of a text, without comments and without what is compiled for tests only.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or(text);
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// A path that a text names, and whether it does so to hand it on (`pub use`).
struct Named {
    path: Vec<String>,
    handed_on: bool,
}

/// The paths of all `use` and those written out in the code, with the groups spread out.
fn paths(text: &str) -> Vec<Named> {
    let code = code(text);
    let mut named = Vec::new();
    let mut rest = code.as_str();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    while let Some(at) = rest.find(is_word) {
        let word = leading_word(&rest[at..]);
        let before = &rest[..at];
        rest = &rest[at + word.len()..];
        let line = code[..code.len() - rest.len()].rsplit('\n').next().unwrap_or_default().trim();
        // A `use` begins a line, for its own module or for others; a word of a message does not.
        let handed_on = line.starts_with("pub") && line.ends_with(" use");
        if line == "use" || handed_on {
            let (tree, after) = rest.split_once(';').expect("a `use` ends");
            named.extend(spread(tree).into_iter().map(|path| Named { path, handed_on }));
            rest = after;
        } else if !before.ends_with("::") && rest.starts_with("::") {
            let path = rest.find(|c| !is_word(c) && c != ':').unwrap_or(rest.len());
            let path = format!("{word}{}", &rest[..path]);
            named.push(Named { path: path.split("::").map(str::to_owned).collect(), handed_on: false });
        }
    }
    named
}

/// `a::{b, c::{d as e}}` as a::b and a::c::d.
fn spread(tree: &str) -> Vec<Vec<String>> {
    let Some((head, group)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap_or(tree);
        return vec![path.split("::").map(|name| name.trim().to_owned()).collect()];
    };
    let head: Vec<_> =
        head.split("::").map(|name| name.trim().to_owned()).filter(|n| !n.is_empty()).collect();
    let group = group.rsplit_once('}').map_or(group, |(inner, _)| inner);
    let items = split_at_commas(group);
    let items = items.iter().filter(|item| !item.trim().is_empty());
    items.flat_map(|item| spread(item)).map(|tail| [head.clone(), tail].concat()).collect()
}

/// The module in which what a path names from within a module is written: as far as the path leads through modules, and
/// on through what a folder's `mod.rs` hands on.
fn written_in(texts: &Texts, module: &str, path: &[String]) -> Option<String> {
    let parent =
        |module: &str| module.rsplit_once("::").map_or(String::new(), |(parent, _)| parent.to_owned());
    let child = |module: &str, name: &str| match module {
        "" => name.to_owned(),
        _ => format!("{module}::{name}"),
    };
    let mut at = match path.first()?.as_str() {
        "crate" => String::new(),
        "self" => module.to_owned(),
        "super" => parent(module),
        name => Some(child(module, name)).filter(|child| texts.contains_key(child))?,
    };
    for name in &path[1..] {
        let next = child(&at, name);
        if name == "super" {
            at = parent(&at);
        } else if texts.contains_key(&next) {
            at = next;
        } else {
            let given = texts.get(&at).map(|text| paths(text)).unwrap_or_default();
            let given = given.into_iter().find(|given| given.handed_on && given.path.last() == Some(name));
            return given.map_or(Some(at.clone()), |given| written_in(texts, &at, &given.path));
        }
    }
    Some(at)
}

/// The modules that each module names. A folder's `mod.rs` names what is in the folder, and holds what its files share:
/// that is one module in several files, and no use.
fn uses(texts: &Texts) -> Uses<'_> {
    let of = |module: &str, text: &str| {
        let inside = |target: &str| target.strip_prefix(module).is_some_and(|rest| rest.starts_with("::"));
        let named = paths(text).into_iter().filter_map(|named| written_in(texts, module, &named.path));
        named.filter(|target| texts.contains_key(target) && target != module && !inside(target)).collect()
    };
    texts.iter().map(|(module, text)| (module.as_str(), of(module, text))).collect()
}

/// All that a module leads to.
fn reach<'a>(uses: &'a Uses, from: &'a str) -> BTreeSet<&'a str> {
    let (mut seen, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(module) = next.pop() {
        let used = uses.get(module).into_iter().flatten().map(String::as_str);
        next.extend(used.filter(|used| seen.insert(*used)));
    }
    seen
}

/// The groups of modules each of which leads to every other one.
fn circles(uses: &Uses) -> BTreeSet<Vec<String>> {
    let reached: BTreeMap<&str, _> = uses.keys().map(|&module| (module, reach(uses, module))).collect();
    let with = |(module, reached_from): (&&str, &BTreeSet<&str>)| -> Vec<String> {
        let back = |other: &&&str| reached[*other].contains(module);
        reached_from.iter().filter(back).map(|&other| other.to_owned()).collect()
    };
    reached.iter().map(with).filter(|circle| !circle.is_empty()).collect()
}

/// Circles that are left, each with its reason; none may be added.
const LEFT: [[&str; 2]; 1] = [
    // A formula is said with words, and a word is said of formulas: one recursion.
    ["meaning::reading", "meaning::words"],
];

#[test]
fn modules_do_not_go_round_in_circles() {
    let texts = texts();
    let uses = uses(&texts);
    assert!(uses.values().flatten().count() > 500, "the test does not see the uses");
    assert!(uses["analysis::shape"].contains("analysis::pieces"), "a sibling");
    assert!(uses["search::decide"].contains("analysis::monotonicity"), "handed on by `analysis`");
    let left = LEFT.map(|circle| circle.map(str::to_owned).to_vec());
    assert_eq!(circles(&uses), left.into(), "no other circles, and these if they are still there");
}

#[test]
fn a_circle_is_found() {
    let found = |files: &[(&str, &str)]| {
        let texts = files.iter().map(|(module, text)| ((*module).to_owned(), (*text).to_owned())).collect();
        circles(&uses(&texts)).into_iter().collect::<Vec<_>>()
    };
    let two = [vec!["a::x".to_owned(), "a::y".to_owned()]];
    let y = ("a::y", "use super::{x::X, z as other};\npub struct Y(X);");
    for (folder, x) in [
        ("mod x;\nmod y;", "use super::y::Y;"),
        ("mod x;\nmod y;", "use crate::{\n    a::y::{self, Y},\n    b,\n};"),
        ("mod x;\nmod y;", "fn f() -> crate::a::y::Y {}"),
        ("mod x;\nmod y;", "mod inside {\n    use crate::a::y;\n}"),
        // Handed on by the folder.
        ("mod x;\nmod y;\npub use y::Y;", "use crate::a::Y;"),
        ("mod x;\nmod y;\npub use self::y::{Y, Z as T};", "use super::Y;"),
    ] {
        assert_eq!(found(&[("a", folder), ("a::x", x), y]), two, "{folder} {x}");
    }
    let three = [("a", "use crate::b::B;"), ("b::c", "use crate::a;"), ("b", "pub(crate) use c::B;\nmod c;")];
    assert_eq!(found(&three), [["a", "b::c"]]);
    for x in [
        "use super::Z;",
        "use y::Y;",
        "// crate::a::y",
        "#[cfg(test)]\nmod tests {\n    use super::super::y::Y;",
    ] {
        let folder = "mod x;\nmod y;\npub use x::X;\npub use y::Y;\nfn f() { x::g(); }\npub struct Z;";
        assert_eq!(found(&[("a", folder), ("a::x", x), y]), [[""; 0]; 0], "{x}");
    }
}
