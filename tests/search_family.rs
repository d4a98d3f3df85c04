//! `search --family`: the functions of a family that has no index, by the same machine as those of an index.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use assert_cmd::Command;
use knotproof::language::families;
use knotproof::scalar::{BigRational, height, parse_rational, rational};
use knotproof::search::{
    Candidate, Enumeration, FamilySpace, Goal, Limits, MemberSpace, Portion, Sample, Search, Shard, Space,
    Subject, local_maxima,
};
use serde_json::{Value, json};

fn space(name: &str, set: &[(&str, &str)], cases: MemberSpace) -> Space {
    let family = families().iter().find(|family| family.name == name).unwrap();
    let set = set.iter().map(|(name, values)| ((*name).to_owned(), (*values).to_owned())).collect();
    Space::Family(FamilySpace { name: name.to_owned(), text: family.text.clone(), set, cases })
}

fn limits(size: u64, gap: Option<u64>, height: Option<u64>) -> MemberSpace {
    MemberSpace::Exhaustive(Limits { size, gap, height })
}

fn cases(degree: usize, space: Space) -> Enumeration {
    Enumeration::of(&Search { degree, find: Goal::Several, space }).unwrap()
}

/// The gaps and the free numbers of all cases, in order.
fn listed(cases: &Enumeration) -> Vec<(Vec<u64>, Vec<BigRational>)> {
    let subjects = cases.subjects(0..cases.positions());
    let parts = |subject: &Subject| {
        let function = subject.member().unwrap();
        (function.gaps().to_vec(), function.numbers().to_vec())
    };
    subjects.map(|(_, subject)| parts(&subject)).collect()
}

/// All lists of so many of these.
fn lists<T: Clone>(length: usize, of: &[T]) -> Vec<Vec<T>> {
    let mut all = vec![vec![]];
    for _ in 0..length {
        let longer = |list: &Vec<T>| {
            let list = list.clone();
            of.iter().map(move |next| [list.clone(), vec![next.clone()]].concat())
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

/// What `search` writes with `--format json`, and its exit code.
fn search(arguments: &[&str]) -> (String, i32) {
    let output = knotproof(&[&["search", "--format", "json"], arguments].concat()).output().unwrap();
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    (String::from_utf8(output.stdout).unwrap(), output.status.code().unwrap())
}

/// The findings, and the summary.
fn records(text: &str) -> (Vec<Value>, Value) {
    let mut records: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let summary = records.pop().unwrap();
    (records, summary)
}

/// Exit code 2, and a message with all parts.
fn rejected(arguments: &[&str], argument: &str, parts: &[&str]) {
    let assert = knotproof(&[&["search"], arguments].concat()).args(["--format", "json"]).assert();
    let message = String::from_utf8(assert.code(2).stdout("").get_output().stderr.clone()).unwrap();
    let report: Value = serde_json::from_str(&message).unwrap();
    assert_eq!(report["error"]["argument"], argument, "{report}");
    assert!(parts.iter().all(|part| message.contains(part)), "{parts:?} in {message}");
}

/// By the definition: all gaps and positive numbers of the size, without those of functions that jump.
#[test]
fn the_cases_are_those_of_the_definition_in_order_of_size() {
    let positive = |tallest: i64| -> Vec<BigRational> {
        let all = (1..=tallest).flat_map(|p| (1..=tallest).map(move |q| rational(p, q)));
        all.collect::<BTreeSet<_>>().into_iter().collect()
    };
    for (family, degree, free, (size, gap, tallest)) in [
        ("knot-weights", 1, 3, (4, None, None)),
        ("knot-weights", 2, 4, (3, None, None)),
        ("knot-weights", 2, 4, (5, Some(2), Some(2))),
        ("lupas", 3, 1, (6, None, None)),
        ("free-ratios", 2, 5, (4, Some(1), Some(2))),
        ("index-per-knot", 1, 3, (5, None, Some(3))),
        ("smoothstep", 3, 0, (5, None, None)),
    ] {
        let cases = cases(degree, space(family, &[], limits(size, gap, tallest)));
        assert_eq!(cases.members().unwrap().free().count(), free, "{family}");
        let size_of = |gaps: &[u64], numbers: &[BigRational]| {
            let heights: u64 = numbers.iter().map(|q| u64::try_from(height(q)).unwrap() - 1).sum();
            gaps.iter().sum::<u64>() + heights
        };
        let gaps: Vec<u64> = (0..=gap.unwrap_or(size)).collect();
        let numbers = positive(tallest.unwrap_or(size).try_into().unwrap());
        let mut expected = BTreeSet::new();
        for gaps in lists(degree + 1, &gaps).into_iter().filter(|gaps| gaps.iter().sum::<u64>() <= size) {
            let filled = |gaps: &[u64]| gaps.iter().any(|&gap| gap > 0);
            if !filled(&gaps[1..]) || !filled(&gaps[..degree]) {
                continue;
            }
            let all = lists(free, &numbers).into_iter();
            expected.extend(all.filter(|n| size_of(&gaps, n) <= size).map(|n| (gaps.clone(), n)));
        }
        let found = listed(&cases);
        assert_eq!(cases.count(), expected.len() as u64, "{family}, degree {degree}, size {size}");
        assert_eq!(found.len(), expected.len());
        assert_eq!(found.iter().cloned().collect::<BTreeSet<_>>(), expected);
        assert!(found.iter().map(|(gaps, numbers)| size_of(gaps, numbers)).is_sorted());
        let subjects: Vec<_> = cases.subjects(0..cases.positions()).collect();
        assert!(subjects.windows(2).all(|pair| pair[0].1 < pair[1].1), "the order is that of the functions");
        // From any position on, the same ones.
        let cut = cases.positions() / 3;
        let parts = cases.subjects(0..cut).chain(cases.subjects(cut..u64::MAX));
        assert!(parts.eq(subjects));
    }
}

/// One ratio for everything is an index: the same functions have two maxima.
#[test]
fn an_index_in_disguise_has_the_same_counterexamples() {
    let (degree, size) = (3, 9);
    let index = Search {
        degree,
        find: Goal::Several,
        space: Space::Exhaustive(Limits { size: size + 3, gap: None, height: Some(3) }),
    };
    let of_index = Enumeration::of(&index).unwrap();
    for (ratio, text) in [((3, 5), "3/5"), ((1, 2), "1/2")] {
        let several = |candidate: &Candidate| local_maxima(candidate).maxima > 1;
        let all = of_index.between(0..of_index.positions()).map(|(_, candidate)| candidate);
        let all = all.filter(|candidate| candidate.ratio() == ratio);
        let all = all.filter(|candidate| candidate.gaps().iter().sum::<u64>() <= size);
        let expected: BTreeSet<_> = all.filter(several).collect();
        assert!(!expected.is_empty());
        let repeated = |n: usize| vec![text; n].join(",");
        let rows = [4, 3, 2].map(repeated).join(";");
        let alpha = Candidate::new(vec![1, 1], ratio).unwrap().index().to_string();
        let alphas = [alpha.as_str(); 5].join(",");
        for (family, set) in [
            ("free-ratios", ("rho", &*rows)),
            ("index-per-knot", ("rho", &*repeated(5))),
            ("index-per-knot", ("alpha", &*alphas)),
        ] {
            let cases = cases(degree, space(family, &[set], limits(size, None, None)));
            let mut found = BTreeSet::new();
            for (_, subject) in cases.subjects(0..cases.positions()) {
                let candidate = Candidate::new(subject.gaps().to_vec(), ratio).unwrap();
                let maxima = subject.local_maxima().unwrap().maxima;
                assert_eq!(maxima, local_maxima(&candidate).maxima, "{family}: {candidate:?}");
                if maxima > 1 {
                    found.insert(candidate.normal_form());
                }
            }
            assert_eq!(found, expected, "{family}");
        }
    }
}

/// U = (0, 30, 60, 65, 67), q = 1/3, and what the search finds of that q.
#[test]
fn lupas_has_two_maxima_in_degree_3() {
    let cases = cases(3, space("lupas", &[], limits(2, None, None)));
    let members = cases.members().unwrap();
    let function = members.function(vec![30, 30, 5, 2], vec![rational(1, 3)]).unwrap();
    assert_eq!(function.local_maxima().unwrap().maxima, 2);
    for space in [&["--limit", "9"][..], &["--count", "1500", "--seed", "1"]] {
        let options = [&["--degree", "3", "--family", "lupas", "--set", "q=1/3"][..], space].concat();
        let (found, code) = search(&options);
        let (findings, summary) = records(&found);
        assert_eq!((code, summary["cases"] == summary["count"]), (1, true));
        assert!(!findings.is_empty());
        let cases: u64 = findings.iter().map(|finding| finding["cases"].as_u64().unwrap()).sum();
        assert_eq!(summary["several"], cases);
        for finding in &findings {
            assert_eq!(finding["family"], json!({"name": "lupas", "parameters": {"q": "1/3"}}));
            assert!(finding.get("alpha").is_none());
            shown_again(finding);
        }
        // Whatever the number of threads.
        assert_eq!(search(&[&options[..], &["--threads", "1"]].concat()).0, found);
    }
}

/// The command of a finding shows the same.
fn shown_again(finding: &Value) {
    let command = finding["reproduce"].as_str().unwrap();
    let mut words = Vec::new();
    for (at, part) in command.split(['"', '\'']).enumerate() {
        match at % 2 {
            0 => words.extend(part.split_whitespace()),
            _ => words.push(part),
        }
    }
    let output = knotproof(&[&words[1..], &["--format", "json"]].concat()).assert().code(1);
    let shapes: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    let function = &shapes["functions"][0];
    assert_eq!(function["local_maxima"], finding["witness"]["local_maxima"]);
    assert_eq!(function["family"], finding["family"]);
    assert_eq!(function["index"], finding["index"]);
}

/// The question that the search is for, as far as a test goes.
#[test]
fn knot_weights_have_one_maximum_within_small_limits() {
    let (found, code) = search(&["--degree", "3", "--family", "knot-weights", "--limit", "4"]);
    let (findings, summary) = records(&found);
    assert_eq!((findings.len(), code), (0, 0));
    assert_eq!((&summary["cases"], &summary["several"]), (&1461.into(), &0.into()));
    assert!(summary["decided"].get("undecided").is_none());
}

/// A ratio for each interval: what is found is shrunk, and its parameters are those of the full knot vector.
#[test]
fn parameters_that_are_free_are_shrunk_as_well() {
    let options = ["--degree", "3", "--family", "free-ratios", "--count", "3000", "--seed", "2"];
    let (found, code) = search(&options);
    let (findings, _) = records(&found);
    assert_eq!(code, 1);
    for finding in &findings {
        let rows = finding["family"]["parameters"]["rho"].as_str().unwrap();
        let numbers: Vec<Vec<_>> = rows.split(';').map(|row| row.split(',').collect()).collect();
        assert_eq!(numbers.iter().map(Vec::len).collect::<Vec<_>>(), [7, 6, 5]);
        assert!(numbers.concat().iter().all(|number| parse_rational(number).is_ok()));
    }
    findings.iter().take(3).for_each(shown_again);
    let gaps = |finding: &Value| -> u64 {
        let gaps = finding["gaps"].as_array().unwrap();
        gaps.iter().map(|gap| gap.as_str().unwrap().parse::<u64>().unwrap()).sum()
    };
    assert!(findings.iter().all(|finding| gaps(finding) < 1000), "random gaps are larger than that");
    // The most maxima, and the deepest dips, of the same cases.
    let most = records(&search(&[&options[..], &["--find", "most"]].concat()).0).0;
    assert!(!most.is_empty());
    let deepest = search(&[&options[..], &["--find", "deepest"]].concat());
    assert!(!records(&deepest.0).0.is_empty());
    assert_eq!(Portion::parse(&deepest.0).unwrap().to_text().unwrap(), deepest.0);
}

fn path_in(folder: &tempfile::TempDir, name: &str) -> PathBuf {
    folder.path().join(name)
}

/// Shards, merged: as if there had been none; and an audit of all of them.
#[test]
fn shards_have_no_influence() {
    let folder = tempfile::tempdir().unwrap();
    for options in [
        &["--degree", "3", "--family", "lupas", "--set", "q=1/3", "--limit", "9"][..],
        &["--degree", "3", "--family", "lupas", "--count", "900"],
        &["--degree", "2", "--family", "knot-weights", "--limit", "4"],
        &["--degree", "3", "--family", "lupas", "--count", "700", "--find", "deepest"],
    ] {
        let whole = search(options);
        let names: Vec<_> = (0..3).map(|i| path_in(&folder, &format!("{i}.jsonl"))).collect();
        for (i, file) in names.iter().enumerate() {
            let (shard, _) = search(&[options, &["--shard", &format!("{i}/3")]].concat());
            fs::write(file, shard).unwrap();
        }
        let out = path_in(&folder, "all.jsonl");
        let _ = fs::remove_file(&out);
        let files: Vec<_> = names.iter().rev().map(|file| file.to_str().unwrap()).collect();
        let merge = [&["merge", "--audit", "all", "--out", out.to_str().unwrap()], &files[..]].concat();
        knotproof(&merge).assert().code(whole.1);
        assert_eq!(fs::read_to_string(&out).unwrap(), whole.0);
    }
}

/// Shards of other families, and of other parameters, are of another search.
#[test]
fn shards_of_two_families_are_not_mixed() {
    let folder = tempfile::tempdir().unwrap();
    let other = path_in(&folder, "lupas.toml");
    let lupas = families().iter().find(|family| family.name == "lupas").unwrap();
    fs::write(&other, lupas.text.replace("q^(d-1)", "q^d")).unwrap();
    let shard = |i: usize, family: &str, set: &str| {
        let file = path_in(&folder, &format!("{i}.jsonl"));
        let options = ["--degree", "3", "--count", "60", "--family", family, "--set", set];
        fs::write(&file, search(&[&options[..], &["--shard", &format!("{i}/2")]].concat()).0).unwrap();
        file.to_str().unwrap().to_owned()
    };
    let zero = shard(0, "lupas", "q=1/2");
    for (family, set) in [(other.to_str().unwrap(), "q=1/2"), ("lupas", "q=1/3")] {
        let one = shard(1, family, set);
        let assert = knotproof(&["merge", &zero, &one]).assert().code(2);
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(message.contains("part of another search"), "{message}");
    }
    let one = shard(1, "lupas", "q=1/2");
    knotproof(&["merge", &zero, &one]).assert().success();
    // Nor goes a checkpoint on with another family.
    let file = path_in(&folder, "state.jsonl");
    let file = file.to_str().unwrap();
    let with = |family: &'static str| {
        let options = ["--degree", "3", "--count", "60", "--family", family, "--checkpoint", file];
        [&["search"], &options[..]].concat()
    };
    knotproof(&with("lupas")).assert().success();
    for (options, what) in [
        (with("knot-weights"), "--family"),
        ([&with("lupas")[..], &["--set", "q=1/3"]].concat(), "--set"),
        (
            vec!["search", "--degree", "3", "--count", "60", "--checkpoint", file],
            "an option that is not given",
        ),
    ] {
        let assert = knotproof(&options).assert().code(2);
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(message.contains(what), "{what} in {message}");
    }
}

/// Stopped wherever it is, and killed, it comes to the same.
#[test]
fn interruptions_have_no_influence() {
    let folder = tempfile::tempdir().unwrap();
    let options = ["--degree", "3", "--family", "lupas", "--set", "q=1/3", "--count", "4000", "--seed", "3"];
    let whole = search(&options);
    assert_eq!(whole.1, 1);
    let file = path_in(&folder, "state.jsonl");
    // After some batches.
    let sample = MemberSpace::Random(Sample { count: 4000, seed: 3, spread: 9 });
    let space = space("lupas", &[("q", "1/3")], sample);
    let mut part = Portion::new(Search { degree: 3, find: Goal::Several, space }, Shard::WHOLE).unwrap();
    let stopped = part.run(|part| if part.done() > 1000 { Err(()) } else { Ok(()) });
    assert_eq!(stopped, Err(()));
    fs::write(&file, part.to_text().unwrap()).unwrap();
    assert_eq!(search(&["--resume", file.to_str().unwrap()]), whole);
    assert_eq!(fs::read_to_string(&file).unwrap(), whole.0);
    // At no particular moment.
    let file = path_in(&folder, "killed.jsonl");
    for _ in 0..2 {
        let mut process = crate::process()
            .arg("search")
            .args(options)
            .args(["--checkpoint", file.to_str().unwrap()])
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        while !file.exists() && process.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(5));
        }
        process.kill().unwrap();
        process.wait().unwrap();
    }
    assert_eq!(search(&["--resume", file.to_str().unwrap()]), whole);
}

/// A weight that may have a pole, and functions that may be negative: each such case is counted, and some are named.
#[test]
fn what_is_not_decided_is_counted_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let file = path_in(&folder, "signed.toml");
    let text = "name = \"signed\"\ntitle = \"Any ratio\"\nsource = \"a test\"\n[parameters]\nc = \"c >= -1\"\n[weight]\n\
                rise = \"c*(x - a)\"\nfall = \"b - x\"\n";
    fs::write(&file, text).unwrap();
    let options = ["--degree", "2", "--family", file.to_str().unwrap(), "--limit", "4"];
    let (found, code) = search(&options);
    let (findings, summary) = records(&found);
    assert_eq!((findings.len(), code), (0, 3));
    let undecided = summary["decided"]["undecided"].as_u64().unwrap();
    let exactly = summary["decided"]["exactly"].as_u64().unwrap();
    assert!(undecided > 0 && exactly > 0);
    assert_eq!(summary["cases"], undecided + exactly);
    let named = summary["undecided"].as_array().unwrap();
    assert_eq!(named.len(), 3);
    assert!(named.iter().all(|case| !case["why"].as_str().unwrap().is_empty()), "{named:?}");
    assert_eq!(Portion::parse(&found).unwrap().to_text().unwrap(), found);
    let text = knotproof(&[&["search"], &options[..]].concat()).assert().code(3);
    let text = String::from_utf8(text.get_output().stdout.clone()).unwrap();
    assert!(text.contains(&format!("{undecided} not decided")) && text.contains("Not decided at position"));
    // The shards know it as well.
    let names: Vec<_> = (0..2)
        .map(|i| {
            let file = path_in(&folder, &format!("{i}.jsonl"));
            let (shard, _) = search(&[&options[..], &["--shard", &format!("{i}/2")]].concat());
            fs::write(&file, shard).unwrap();
            file.to_str().unwrap().to_owned()
        })
        .collect();
    let out = path_in(&folder, "all.jsonl");
    knotproof(&["merge", &names[0], &names[1], "--audit", "all", "--out", out.to_str().unwrap()])
        .assert()
        .code(3);
    assert_eq!(fs::read_to_string(&out).unwrap(), found);
}

/// A random case depends on the seed and its number only, and its numbers are within their bounds.
#[test]
fn random_cases_depend_on_their_number_only() {
    let sample = |seed| MemberSpace::Random(Sample { count: 300, seed, spread: 12 });
    let all = cases(3, space("knot-weights", &[], sample(1)));
    let subjects: Vec<_> = all.subjects(0..300).collect();
    assert_eq!((all.count(), subjects.len()), (300, 300));
    assert!(all.subjects(120..130).eq(subjects[120..130].iter().cloned()));
    assert_ne!(listed(&all), listed(&cases(3, space("knot-weights", &[], sample(2)))));
    let zero = rational(0, 1);
    let numbers = listed(&all).into_iter().flat_map(|(_, numbers)| numbers);
    let numbers: Vec<_> = numbers.collect();
    assert!(numbers.iter().all(|number| *number > zero));
    let small = numbers.iter().filter(|number| **number < rational(1, 4)).count();
    let large = numbers.iter().filter(|number| **number > rational(4, 1)).count();
    assert!((300..900).contains(&small) && (300..900).contains(&large), "{small} and {large} of 1500");
}

#[test]
fn families_of_an_index_are_searched_by_it() {
    let index = ["--degree", "3", "--limit", "7"];
    let named = [&index[..], &["--family", "mobius"]].concat();
    assert_eq!(search(&named), search(&index));
    let degree = |more: &[&'static str]| [&["--degree", "3"], more].concat();
    for (options, argument, parts) in [
        (degree(&["--family", "classical"]), "--family", &["--alpha with --count"][..]),
        (degree(&["--family", "mobius", "--set", "r=2"]), "--family", &["--alpha with --count"]),
        (degree(&["--family", "nurbs"]), "--family", &["clamped"]),
        (degree(&["--family", "nothing"]), "--family", &["nothing"]),
        (degree(&["--family", "lupas", "--find", "equal"]), "--find", &["does not have", "deepest"]),
        (degree(&["--family", "lupas", "--set", "p=1"]), "--set", &["no `p`"]),
        (degree(&["--family", "lupas", "--set", "q=0"]), "--set", &["q > 0"]),
        (degree(&["--family", "knot-weights", "--set", "omega=1,2"]), "--set", &["needs 5 numbers"]),
        (degree(&["--family", "free-ratios", "--set", "rho=1;1;1"]), "--set", &["needs 4; 3; 2 numbers"]),
        (degree(&["--family", "lupas", "--limit", "0"]), "--limit", &["no function of the family"]),
        (degree(&["--family", "knot-weights", "--limit", "1000"]), "--limit", &["too large"]),
        (degree(&["--family", "lupas", "--limit-height", "0"]), "--limit-height", &["height of 0"]),
        (degree(&["--family", "lupas", "--limit-gap", "0"]), "--limit-gap", &["gap of 0"]),
        (degree(&["--set", "q=1"]), "--family --set", &["--family"]),
    ] {
        if argument == "--family --set" {
            knotproof(&[&["search"], &options[..]].concat()).assert().code(2);
        } else {
            rejected(&options, argument, parts);
        }
    }
}

/// A file of a family search that is damaged, or whose family is another one, is refused.
#[test]
fn damage_is_noticed() {
    let (found, _) = search(&["--degree", "3", "--family", "lupas", "--set", "q=1/3", "--limit", "8"]);
    assert!(Portion::parse(&found).is_ok());
    let mut refused = BTreeMap::new();
    for (from, to) in [
        ("q^(d-1)", "q^(d-2)"),
        ("\"q\":\"1/3\"", "\"q\":\"1/4\""),
        ("\"gaps\":[\"0\",\"6\"", "\"gaps\":[\"0\",\"5\""),
        ("\"name\":\"lupas\",\"text\"", "\"name\":\"other\",\"text\""),
        ("rise", "raise"),
    ] {
        assert!(found.contains(from), "{from}");
        let changed = found.replace(from, to);
        let (content, _) = changed.rsplit_once("\"checksum\":").unwrap();
        let sum = crc32fast::hash(format!("{content}\"checksum\":\"\"}}").as_bytes());
        let forged = format!("{content}\"checksum\":\"{sum:08x}\"}}\n");
        let error = Portion::parse(&forged).map(|part| part.done());
        refused.insert(from, error.unwrap_err().to_string());
    }
    assert_eq!(refused.len(), 5);
}
