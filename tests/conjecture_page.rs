//! The page on Conjecture 3.1 in `docs` is the one that the recorded verdicts make.

use std::fs;
use std::path::Path;

use knotproof::report::{Baseline, conjecture_page};

#[test]
fn the_page_in_docs_is_made_from_the_recorded_verdicts() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let files = conjecture_page(&Baseline::recorded().unwrap()).unwrap();
    assert_eq!(files[0].0, "conjecture.md");
    for (name, text) in &files {
        let written = fs::read_to_string(docs.join(name)).unwrap_or_default();
        assert!(written == *text, "docs/{name} is not what `knotproof report --record` writes");
    }
    let known = |name: &str| files.iter().any(|(made, _)| made == name);
    for entry in fs::read_dir(docs).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(!name.starts_with("conjecture") || known(&name), "docs/{name} is left over");
    }
    // Every picture is on the page, and nothing else is.
    let page = &files[0].1;
    assert!(files[1..].iter().all(|(name, _)| page.contains(&format!("]({name})"))));
    assert_eq!(page.matches("![").count(), files.len() - 1);
}
