//! The folder of the paper: nothing to complain of, in the recorded order, and faults in it are found.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use knotproof::language::{Complaint, Paper, Said, Source, claims};

/// What is in the folder, by the paths below it.
fn folder() -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("papers/rational-bsplines");
    let mut files = BTreeMap::new();
    for below in ["", "claims"] {
        for entry in fs::read_dir(root.join(below)).unwrap().map(Result::unwrap) {
            if entry.file_type().unwrap().is_file() {
                let path = entry.path();
                let name = path.strip_prefix(&root).unwrap().to_str().unwrap().to_owned();
                files.insert(name, fs::read_to_string(path).unwrap());
            }
        }
    }
    files
}

fn read(files: &BTreeMap<String, String>) -> Paper {
    Paper::read(files).unwrap_or_else(|complaints| {
        let complaints: Vec<_> = complaints.iter().map(ToString::to_string).collect();
        panic!("{}", complaints.join("\n"))
    })
}

/// The program has it built in: this is the same one.
#[test]
fn nothing_is_wrong_with_the_folder() {
    let paper = read(&folder());
    assert!(paper.claims().map(|(_, stanza)| stanza).eq(claims().iter().map(|claim| claim.stanza)));
}

#[test]
fn claims_stand_in_the_order_of_the_recorded_verdicts() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/verdicts.json")).unwrap();
    let recorded: serde_json::Value = serde_json::from_str(&text).unwrap();
    let recorded = recorded["claims"].as_array().unwrap().iter().map(|entry| entry["id"].as_str().unwrap());
    let claims = claims();
    assert_eq!(recorded.collect::<Vec<_>>(), claims.iter().map(|claim| claim.id()).collect::<Vec<_>>());
}

#[test]
fn few_claims_are_words() {
    let words = |said: &Said| matches!(said, Said::Words { .. });
    let mut claims = claims();
    claims.retain(|claim| {
        let stanza = claim.stanza;
        [Some(&stanza.printed), stanza.amended.as_ref(), stanza.fails.as_ref()]
            .into_iter()
            .flatten()
            .any(words)
    });
    let ids: Vec<_> = claims.iter().map(|claim| claim.id()).collect();
    assert!((1..=10).contains(&ids.len()), "{}: {ids:?}", ids.len());
}

/// What is amended fails as printed, so there is a cause; of questions, which nobody claims, not all that fail are amended.
#[test]
fn a_cause_is_given_where_a_sentence_is_amended() {
    for claim in claims() {
        let stanza = claim.stanza;
        let question = claim.source() == Source::Question && stanza.cause.is_some();
        assert_eq!(stanza.cause.is_some(), question || stanza.amended.is_some(), "{}", claim.id());
        assert!(stanza.fails.is_none() || stanza.amended.is_some(), "{}", claim.id());
        assert!(!stanza.at.is_empty() && !stanza.title.is_empty(), "{}", claim.id());
    }
}

/// Each fault, planted into the folder, is complained of once, where it is.
#[test]
fn planted_faults_are_complained_of() {
    const FILE: &str = "claims/04-basis.toml";
    let with = |name: &str, text: &str| {
        let mut files = folder();
        files.insert(name.to_owned(), text.to_owned());
        files
    };
    let changed = |part: &str, instead: &str| {
        let text = &folder()[FILE];
        assert!(text.contains(part), "{part}");
        with(FILE, &text.replacen(part, instead, 1))
    };
    let mut without = folder();
    without.remove("found.toml").unwrap();
    for (files, source, rule) in [
        (with("claims/99-more.toml", ""), "paper.toml", "nothing names claims/99-more.toml"),
        (with("more.toml", ""), "paper.toml", "nothing names more.toml"),
        (without, "claims/06-maximum.toml", "there is no file found.toml"),
        (changed("id = \"proof.T3.5.2.cover\"", "id = \"T3.5.0\""), FILE, "`T3.5.0`"),
        (changed("id = \"T3.5.1\"", "id = \"L2.1\""), FILE, "claims/02-weights.toml has a claim `L2.1`, too"),
        (changed("G[i](x) = 0", "G[i](x) = z"), FILE, "`z`"),
    ] {
        let complaints = Paper::read(&files).unwrap_err();
        let told = |complaint: &Complaint| complaint.source() == source && complaint.rule().contains(rule);
        assert!(complaints.iter().any(told), "{rule}: {complaints:#?}");
    }
}
