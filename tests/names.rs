//! Names of public types: one meaning each. The tables are in `docs/glossary.md`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms in which a public type of a name is written, once for each time.
type Rooms = BTreeMap<String, Vec<String>>;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files_below(path: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(path).expect("a source folder can be read");
    let paths = entries.map(|entry| entry.expect("so can its entries").path());
    let files = paths.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] });
    files.filter(|file| file.extension().is_some_and(|extension| extension == "rs")).collect()
}

/// The name that a line makes public, if it declares a type.
fn declared(line: &str) -> Option<&str> {
    let rest = line.trim_start().strip_prefix("pub ")?;
    let kinds = ["struct ", "enum ", "trait ", "type ", "union "];
    let rest = kinds.iter().find_map(|kind| rest.strip_prefix(kind))?;
    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}

fn public_types() -> Rooms {
    let source = root().join("src");
    let mut rooms = Rooms::new();
    for file in files_below(&source) {
        let text = fs::read_to_string(&file).expect("a source file can be read");
        let text = text.split("#[cfg(test)]\nmod tests").next().expect("its beginning");
        let below = file.strip_prefix(&source).expect("it is in the source folder");
        let room = below.iter().next().expect("its room").to_string_lossy().replace(".rs", "");
        for name in text.lines().filter_map(declared) {
            rooms.entry(name.to_owned()).or_default().push(room.clone());
        }
    }
    rooms.values_mut().for_each(|rooms| rooms.sort());
    rooms
}

/// The rows of the table with this head: a name, the rooms, and what is said of it.
fn table(head: &str) -> Rooms {
    let glossary = fs::read_to_string(root().join("docs/glossary.md")).expect("the glossary can be read");
    let (_, rows) = glossary.split_once(head).unwrap_or_else(|| panic!("a table `{head}`"));
    let rows = rows.lines().skip(2).take_while(|line| line.starts_with('|'));
    let row = |line: &str| {
        let [_, name, rooms, says, _] = line.split('|').map(str::trim).collect::<Vec<_>>()[..] else {
            panic!("three columns: {line}");
        };
        assert!(!says.is_empty(), "{line}");
        (name.trim_matches('`').to_owned(), rooms.split(", ").map(str::to_owned).collect())
    };
    rows.map(row).collect()
}

/// The names that are there more than once.
fn repeated(types: &Rooms) -> Rooms {
    types
        .iter()
        .filter(|(_, rooms)| rooms.len() > 1)
        .map(|(name, rooms)| (name.clone(), rooms.clone()))
        .collect()
}

#[test]
fn no_public_type_shares_its_name_but_for_those_with_a_reason() {
    let types = public_types();
    assert!(types.len() > 150, "the test does not see the types");
    assert_eq!(repeated(&types), table("| type | rooms | because |"));
}

#[test]
fn the_names_of_the_glossary_are_those_of_types() {
    let (types, names) = (public_types(), table("| type | room | means |"));
    assert!(names.len() > 15);
    for (name, rooms) in names {
        let found: BTreeSet<_> = types.get(&name).into_iter().flatten().collect();
        assert!(rooms.iter().all(|room| found.contains(room)), "`{name}` is in {found:?}, not in {rooms:?}");
    }
}

#[test]
fn a_name_that_is_there_twice_is_found() {
    for (line, name) in [
        ("pub struct Piece(u8);", Some("Piece")),
        ("    pub enum Side {", Some("Side")),
        ("pub type Piece = RationalFunction<BigRational>;", Some("Piece")),
        ("pub(super) struct Piece {", None),
        ("pub fn piece() {}", None),
        ("/// pub struct Piece;", None),
    ] {
        assert_eq!(declared(line), name, "{line}");
    }
    let types = [("One", vec!["a"]), ("Two", vec!["a", "b"]), ("Same", vec!["a", "a"])];
    let types = types.map(|(name, rooms)| (name.to_owned(), rooms.into_iter().map(str::to_owned).collect()));
    assert_eq!(repeated(&types.into()).into_keys().collect::<Vec<_>>(), ["Same", "Two"]);
}
