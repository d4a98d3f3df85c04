//! `search` and `merge` as a user meets them: what is found, that nothing but the search has an influence on the result,
//! and that bad input changes nothing.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command as Process, Stdio};
use std::thread::sleep;
use std::time::Duration;

use assert_cmd::Command;
use knotproof::scalar::BigRational;
use serde_json::Value;

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
    assert!(records.iter().all(|record| record["record"] == "finding"));
    assert_eq!(summary["record"], "summary");
    (records, summary)
}

/// Exit code 2, nothing on standard output, and one message with the argument and all parts of it, in either format.
fn rejected(arguments: &[&str], argument: &str, parts: &[&str]) {
    for format in ["text", "json"] {
        let assert = knotproof(arguments).args(["--format", format]).assert().code(2).stdout("");
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(!message.contains("panicked"), "{message}");
        for part in parts {
            assert!(message.contains(part), "{part:?} in {message}");
        }
        if format == "json" {
            let report: Value = serde_json::from_str(&message).unwrap();
            assert_eq!(report["error"]["argument"], argument, "{report}");
        }
    }
}

fn path_in(folder: &tempfile::TempDir, name: &str) -> PathBuf {
    folder.path().join(name)
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// A search in a process of its own, which says nothing.
fn start(arguments: &[&str]) -> Child {
    let mut process = crate::process();
    process.args(["search", "--format", "json"]).args(arguments);
    process.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Waits until the process has come so far that something is there, or has ended: then it is never there.
fn wait_for<T>(process: &mut Child, mut there: impl FnMut() -> Option<T>) -> Option<T> {
    loop {
        let ended = process.try_wait().unwrap().is_some();
        let found = there();
        if ended || found.is_some() {
            return found;
        }
        sleep(Duration::from_millis(5));
    }
}

/// SIGKILL.
fn kill(mut process: Child) {
    process.kill().unwrap();
    process.wait().unwrap();
}

/// A file of a search with other lines, and a checksum that fits to them.
fn forged(text: &str, change: impl FnOnce(&mut Vec<Value>)) -> String {
    let mut records: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    change(&mut records);
    let summary = records.last_mut().unwrap();
    summary["checksum"] = "".into();
    let content = records.iter().map(Value::to_string).collect::<Vec<_>>().join("\n");
    let sum = crc32fast::hash(content.as_bytes());
    content.replace("\"checksum\":\"\"", &format!("\"checksum\":\"{sum:08x}\"")) + "\n"
}

/// Degree 3 fails first with the gaps 2, 1, 1, 0 and α = −3/2: no other function up to size 8 has two maxima.
#[test]
fn the_smallest_counterexample_of_degree_3() {
    let (found, code) = search(&["--degree", "3", "--limit", "8"]);
    let (findings, summary) = records(&found);
    assert_eq!((findings.len(), code), (1, 1));
    let finding = &findings[0];
    assert_eq!(finding["gaps"], serde_json::json!(["2", "1", "1", "0"]));
    assert_eq!(finding["knots"], serde_json::json!(["0", "0", "2", "3", "4", "4", "4", "4"]));
    assert_eq!(
        (&finding["alpha"], &finding["index"], &finding["degree"]),
        (&"-3/2".into(), &1.into(), &3.into())
    );
    assert_eq!(finding["witness"]["local_maxima"], 2);
    let kinds: Vec<_> =
        finding["witness"]["extrema"].as_array().unwrap().iter().map(|e| &e["kind"]).collect();
    assert_eq!(kinds, ["maximum", "minimum", "maximum"]);
    assert_eq!(finding["witness"]["extrema"][1]["interval"], serde_json::json!(["3", "3"]));
    assert_eq!(
        finding["reproduce"],
        "knotproof shape --degree 3 --knots \"0 0 2 3 4 4 4 4\" --alpha -3/2 --index 1"
    );
    assert_eq!(
        (&summary["count"], &summary["cases"], &summary["several"]),
        (&1581.into(), &1581.into(), &1.into())
    );
    let text = knotproof(&["search", "--degree", "3", "--limit", "8"]).assert().code(1);
    let text = String::from_utf8(text.get_output().stdout.clone()).unwrap();
    assert!(
        text.contains("1581 cases") && text.contains("2 1 1 0") && text.contains("--alpha -3/2 --index 1")
    );
}

#[test]
fn degrees_1_and_2_have_none() {
    for degree in ["1", "2"] {
        for space in [&["--limit", "12"][..], &["--count", "500"]] {
            let (found, code) = search(&[&["--degree", degree], space].concat());
            let (findings, summary) = records(&found);
            assert_eq!((findings.len(), code), (0, 0));
            assert_eq!(summary["cases"], summary["count"]);
        }
    }
    knotproof(&["search", "--degree", "2"]).assert().code(0);
}

/// Each finding is a function that `check` finds wrong as well, by the general path.
#[test]
fn findings_stand_in_check() {
    let (found, _) = search(&["--degree", "3", "--count", "600", "--seed", "1"]);
    let (findings, _) = records(&found);
    assert!(!findings.is_empty());
    for finding in findings.iter().take(2) {
        let knots: Vec<_> =
            finding["knots"].as_array().unwrap().iter().map(|t| t.as_str().unwrap()).collect();
        let alpha = finding["alpha"].as_str().unwrap();
        let arguments = ["check", "--degree", "3", "--knots", &knots.join(" "), "--alpha", alpha];
        knotproof(&arguments).args(["--property", "Conj3.1.strong.continuous"]).assert().code(1);
    }
}

#[test]
fn the_most_maxima() {
    let (found, code) = search(&["--degree", "3", "--find", "most", "--limit", "10"]);
    let (findings, summary) = records(&found);
    assert_eq!((code, findings.len() as u64), (1, summary["findings"].as_u64().unwrap()));
    assert!(findings.iter().all(|finding| finding["witness"]["local_maxima"] == 2));
    // Everything with two maxima counts, so it is what `several` finds.
    let (several, _) = search(&["--degree", "3", "--limit", "10"]);
    let gaps = |findings: &[Value]| {
        findings.iter().map(|f| (f["gaps"].clone(), f["alpha"].clone())).collect::<Vec<_>>()
    };
    assert_eq!(gaps(&findings), gaps(&records(&several).0));
}

/// The two maxima of the gaps 0, 5, 2, 1 change places next to α = −1; those of 2, 1, 1, 0 below −3/2.
#[test]
fn equal_maxima_between_two_indices() {
    let (found, code) = search(&["--degree", "3", "--find", "equal", "--limit", "9"]);
    let (findings, _) = records(&found);
    assert_eq!(code, 1);
    for (gaps, low, high) in [("2 1 1 0", -1.6, -1.4), ("0 5 2 1", -1.2, -0.9)] {
        let list: Vec<_> = gaps.split(' ').collect();
        let finding = findings.iter().find(|finding| finding["gaps"] == serde_json::json!(list)).unwrap();
        let equal = &finding["witness"]["equal"];
        let alphas: Vec<_> = equal["alpha"].as_array().unwrap().iter().map(|a| a.as_str().unwrap()).collect();
        let number = |text: &str| {
            let (p, q) = text.split_once('/').unwrap_or((text, "1"));
            p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap()
        };
        assert!(low < number(alphas[0]) && number(alphas[0]) < number(alphas[1]) && number(alphas[1]) < high);
        assert_ne!(equal["higher"][0], equal["higher"][1]);
        assert_eq!(finding["alpha"], equal["alpha"][0]);
        let reproduce = finding["reproduce"].as_str().unwrap();
        assert!(reproduce.contains(&format!("--alpha {} --alpha {}", alphas[0], alphas[1])), "{reproduce}");
    }
}

#[test]
fn threads_have_no_influence() {
    for space in [
        &["--degree", "3", "--limit", "11"][..],
        &["--degree", "4", "--count", "5000", "--seed", "5"],
        &["--degree", "3", "--count", "5000", "--find", "most"],
        &["--degree", "3", "--count", "5000", "--find", "deepest"],
        &["--degree", "4", "--count", "3000", "--find", "deepest", "--alpha", "-1/2", "--alpha", "-1/7"],
    ] {
        let one = search(&[space, &["--threads", "1"]].concat());
        assert_eq!(search(&[space, &["--threads", "2"]].concat()), one);
        assert_eq!(search(&[space, &["--threads", "5"]].concat()), one);
    }
    assert_ne!(
        search(&["--degree", "3", "--count", "300", "--seed", "1"]),
        search(&["--degree", "3", "--count", "300"])
    );
}

/// Shards as they are written to standard output, and as checkpoints, merged: as if there had been none.
#[test]
fn shards_have_no_influence() {
    let folder = tempfile::tempdir().unwrap();
    for space in [
        &["--degree", "3", "--limit", "11"][..],
        &["--degree", "3", "--count", "4001", "--seed", "9"],
        &["--degree", "3", "--limit", "9", "--find", "equal"],
        &["--degree", "3", "--count", "4001", "--find", "deepest"],
    ] {
        let whole = search(space);
        let files: Vec<_> = (0..3).map(|i| path_in(&folder, &format!("{i}.jsonl"))).collect();
        for (i, file) in files.iter().enumerate() {
            let shard = format!("{i}/3");
            let mut arguments = [space, &["--shard", &shard]].concat();
            if i == 1 {
                let _ = fs::remove_file(file);
                arguments.extend(["--checkpoint", text(file)]);
            }
            let (found, _) = search(&arguments);
            if i == 1 {
                assert_eq!(fs::read_to_string(file).unwrap(), found);
            } else {
                fs::write(file, found).unwrap();
            }
        }
        let out = path_in(&folder, "all.jsonl");
        let _ = fs::remove_file(&out);
        let files: Vec<_> = files.iter().rev().map(|file| text(file)).collect();
        let arguments = [&["merge", "--format", "json", "--out", text(&out)], &files[..]].concat();
        let merged = knotproof(&arguments).assert().code(whole.1).get_output().stdout.clone();
        assert_eq!(fs::read_to_string(&out).unwrap(), whole.0);
        let merged: Value = serde_json::from_slice(&merged).unwrap();
        let (findings, summary) = records(&whole.0);
        assert_eq!((&merged["schema"], &merged["covered"]), (&"knotproof.merge/1".into(), &true.into()));
        assert_eq!(merged["findings"], Value::from(findings));
        assert_eq!(
            (&merged["searched"]["cases"], &merged["searched"]["search"]),
            (&summary["cases"], &summary["search"])
        );
        // There is nothing that it would be the checksum of.
        assert!(merged["searched"].get("checksum").is_none(), "{merged}");
        // The whole is one shard of one.
        assert_eq!(search(&[space, &["--shard", "0/1"]].concat()), whole);
        let again = knotproof(&["merge", "--format", "text", text(&out)]).assert().code(whole.1);
        assert!(String::from_utf8_lossy(&again.get_output().stdout).contains("cover the search"));
    }
}

/// Killed again and again at no particular moment, and resumed each time.
#[test]
fn interruptions_have_no_influence() {
    let folder = tempfile::tempdir().unwrap();
    let file = path_in(&folder, "state.jsonl");
    let space = ["--degree", "4", "--count", "300000", "--seed", "2"];
    let whole = search(&space);
    let mut reached = 0;
    for round in 0..4_u64 {
        // The file is the state whether it is there already or not.
        let arguments = match round % 2 {
            0 => [&space[..], &["--checkpoint", text(&file)]].concat(),
            _ => vec!["--resume", text(&file)],
        };
        let mut process = start(&arguments);
        // At the first state, and then each time as soon as the search has come further.
        let further = |done: &u64| round == 0 || *done > reached;
        let done = || {
            let (_, summary) = records(&fs::read_to_string(&file).ok()?);
            assert!(summary["done"].as_u64() <= summary["to"].as_u64());
            summary["done"].as_u64().filter(further)
        };
        // A fast machine may be done before the last rounds.
        let Some(state) = wait_for(&mut process, done) else { break };
        assert!(round > 0 || state < 300_000, "the search is too short for this test");
        reached = state;
        kill(process);
    }
    assert!(reached > 0, "nothing was interrupted");
    assert_eq!(search(&["--resume", text(&file)]), whole);
    assert_eq!(fs::read_to_string(&file).unwrap(), whole.0);
    // Once more: nothing is left to do, and the result is the same.
    assert_eq!(search(&[&space[..], &["--checkpoint", text(&file)]].concat()), whole);
}

#[test]
fn searches_that_cannot_be() {
    for (options, argument, parts) in [
        (&["--degree", "0"][..], "--degree", &["0 is out of range", "1 to 16"][..]),
        (&["--degree", "17"], "--degree", &["17 is out of range"]),
        (&["--degree", "x"], "--degree", &["whole number"]),
        (&[], "--degree", &["--degree is missing"]),
        (&["--degree", "3", "--limit", "0"], "--limit", &["no case", "up to 0"]),
        (&["--degree", "1", "--limit", "2"], "--limit", &["no case", "empty"]),
        (&["--degree", "3", "--limit", "9", "--limit-gap", "0"], "--limit-gap", &["gap of 0"]),
        (&["--degree", "3", "--limit", "9", "--limit-height", "0"], "--limit-height", &["height of 0"]),
        (&["--degree", "3", "--limit", "1001"], "--limit", &["too large", "at most 1000"]),
        (
            &["--degree", "16", "--limit", "1000"],
            "--limit",
            &["number of cases up to size 1000 is too large", "lower --limit"],
        ),
        (&["--degree", "3", "--limit", "-1"], "--limit", &["whole number"]),
        (&["--degree", "3", "--limit", "9", "--count", "9"], "--limit --count", &["--count", "--limit"]),
        (&["--degree", "3", "--count", "0"], "--count", &["0 cases"]),
        (&["--degree", "3", "--seed", "1"], "--count", &["--count is missing"]),
        (&["--degree", "3", "--spread", "1"], "--count", &["--count is missing"]),
        (&["--degree", "3", "--count", "9", "--spread", "0"], "--spread", &["0 is out of range", "1 to 40"]),
        (&["--degree", "3", "--count", "9", "--spread", "99"], "--spread", &["99 is out of range"]),
        (
            &["--degree", "3", "--count", "9", "--spread", "99999999999"],
            "--spread",
            &["99999999999 is out of range", "1 to 40"],
        ),
        (&["--degree", "3", "--find", "none"], "--find", &["several, most, equal, deepest"]),
        (&["--degree", "3", "--count", "9", "--alpha", "1/2"], "--alpha", &["1/2"]),
        (&["--degree", "3", "--count", "9", "--alpha", "-1/99999999999"], "--alpha", &["below 2^32"]),
        (&["--degree", "3", "--threads", "0"], "--threads", &["1 thread at least"]),
        (&["--degree", "3", "--threads", "1025"], "--threads", &["1025 is too many", "at most 1024"]),
        (&["--degree", "3", "--shard", "3/3"], "--shard", &["no shard 3 of 3", "0 to 2"]),
        (&["--degree", "3", "--shard", "0/0"], "--shard", &["0 shards"]),
        (&["--degree", "3", "--shard", "1"], "--shard", &["`1` is no shard", "write I/N"]),
        (&["--degree", "3", "--shard", "-1/2"], "--shard", &["`-1/2` is no shard"]),
        (
            &["--degree", "3", "--count", "5", "--shard", "0/6"],
            "--shard",
            &["6 shards are too many", "5 positions"],
        ),
        (&["--resume", "/nowhere/at/all"], "--resume", &["cannot read /nowhere/at/all"]),
        (
            &["--degree", "3", "--checkpoint", "/nowhere/at/all"],
            "--checkpoint",
            &["cannot write /nowhere/at/all: there is no folder /nowhere/at;"],
        ),
    ] {
        let options = [&["search"], options].concat();
        // clap names both options of a conflict, in its own order.
        if argument.contains(' ') {
            knotproof(&options).assert().code(2).stdout("");
        } else {
            rejected(&options, argument, parts);
        }
    }
    rejected(&["merge"], "<FILE>...", &["FILE"]);
}

/// Nothing of what is there is overwritten.
#[test]
fn checkpoints_of_something_else() {
    let folder = tempfile::tempdir().unwrap();
    let file = path_in(&folder, "state.jsonl");
    let space = ["--degree", "3", "--limit", "7"];
    let (state, _) = search(&[&space[..], &["--checkpoint", text(&file)]].concat());
    let unchanged = |content: &[u8]| assert_eq!(fs::read(&file).unwrap(), content);

    for (options, what) in [
        (&["--degree", "4", "--limit", "7"][..], "--degree differs"),
        (&["--degree", "3", "--limit", "6"], "--limit differs"),
        (&["--degree", "3", "--limit", "7", "--limit-gap", "2"], "--limit-gap differs"),
        (&["--degree", "3", "--limit", "7", "--find", "most"], "--find differs"),
        (&["--degree", "3", "--limit", "7", "--shard", "0/2"], "--shard differs"),
        (&["--degree", "3", "--count", "7"], "--count differs"),
        (&["--degree", "3", "--count", "7", "--alpha", "-1"], "--count differs"),
    ] {
        for option in ["--checkpoint", "--resume"] {
            let arguments = [&["search"], options, &[option, text(&file)]].concat();
            rejected(&arguments, option, &[text(&file), "another search", what, "nothing was overwritten"]);
            unchanged(state.as_bytes());
        }
    }
    rejected(
        &["search", "--degree", "3", "--checkpoint", text(&file)],
        "--checkpoint",
        &["not given", "differs"],
    );

    let version = format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION"));
    let other = state.replace(&version, "\"version\":\"0.0.1\"");
    assert_ne!(other, state);
    let middle = state.len() / 2;
    let mut flipped = state.clone().into_bytes();
    // A digit of the checksum.
    flipped[state.rfind("\"checksum\":").unwrap() + 12] ^= 1;
    let others = forged(&state, |records| records.last_mut().unwrap()["decides"] = "0123456789abcdef".into());
    for (content, part) in [
        (other.as_bytes(), "version 0.0.1"),
        (others.as_bytes(), "deciding sources are others (0123456789abcdef"),
        (&flipped, "damaged"),
        (&state.as_bytes()[..state.len() - 1], "damaged"),
        (&state.as_bytes()[..middle], "cut off"),
        (b"", "no line"),
        (b"{}\n", "no summary"),
        (b"a letter to my aunt", "no summary"),
        (state.replace('\n', "\r\n").as_bytes(), "line endings"),
        (state.replace("knotproof.search/1", "knotproof.search/2").as_bytes(), "another format"),
        (b"\xff\xfe", "UTF-8"),
    ] {
        fs::write(&file, content).unwrap();
        for arguments in [
            &["search", "--resume", text(&file)][..],
            &["search", "--degree", "3", "--limit", "7", "--checkpoint", text(&file)],
            &["merge", text(&file)],
        ] {
            let argument = if arguments[0] == "merge" { "FILE" } else { arguments[arguments.len() - 2] };
            rejected(arguments, argument, &[text(&file), part]);
            unchanged(content);
        }
    }
}

#[test]
fn shards_that_do_not_make_up_a_search() {
    let folder = tempfile::tempdir().unwrap();
    let shard = |name: &str, options: &[&str]| {
        let path = path_in(&folder, name);
        fs::write(&path, search(options).0).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let part =
        |name: &str, shard_of: &str| shard(name, &["--degree", "3", "--limit", "7", "--shard", shard_of]);
    let thirds: Vec<_> = (0..3).map(|i| part(&format!("third-{i}"), &format!("{i}/3"))).collect();
    let half = part("half", "0/2");
    let most = shard("most", &["--degree", "3", "--limit", "7", "--shard", "1/3", "--find", "most"]);
    let seeds: Vec<_> = ["1", "2"]
        .iter()
        .zip(["0/2", "1/2"])
        .map(|(seed, part)| {
            shard(
                &format!("seed-{seed}"),
                &["--degree", "3", "--count", "50", "--seed", seed, "--shard", part],
            )
        })
        .collect();
    let [a, b, c] = [&*thirds[0], &*thirds[1], &*thirds[2]];
    let out = path_in(&folder, "all.jsonl");
    for (files, parts) in [
        (&[a, b][..], &["in none of the shards", "one is missing"][..]),
        (&[b, c], &["positions 0 to", "in none of the shards"]),
        (&[a, c], &["in none of the shards"]),
        (&[a, b, c, b], &[b, "overlaps with", "are in both"]),
        (&[&half, b, c], &[b, "overlaps with", &half]),
        (&[a, &most, c], &[&most, "another search than", a]),
        (&[&seeds[0], &seeds[1]], &[&seeds[1], "another search than", &seeds[0]]),
        (&[a, "/nowhere/at/all"], &["cannot read /nowhere/at/all"]),
    ] {
        rejected(&[&["merge", "--out", text(&out)], files].concat(), "FILE", parts);
        assert!(!out.exists());
    }
    // An unfinished shard: what a search has written before it was stopped.
    let state = path_in(&folder, "state.jsonl");
    let mut process = start(&["--degree", "6", "--count", "1000000", "--checkpoint", text(&state)]);
    wait_for(&mut process, || state.exists().then_some(())).expect("a state");
    kill(process);
    rejected(&["merge", text(&state)], "FILE", &[text(&state), "not finished", "--resume"]);
    // What is in the way of the result stays there.
    fs::write(&out, "mine").unwrap();
    rejected(&["merge", "--out", text(&out), a, b, c], "--out", &[text(&out), "nothing was overwritten"]);
    rejected(&["merge", "--out", b, a, b, c], "--out", &[b, "nothing was overwritten"]);
    assert_eq!(fs::read_to_string(&out).unwrap(), "mine");
}

/// The state is a file like any other: new with the permissions of a new file, then with those that it was given.
#[cfg(unix)]
#[test]
fn permissions_are_those_of_other_files() {
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().unwrap();
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    let (file, out, other) =
        (path_in(&folder, "state.jsonl"), path_in(&folder, "all.jsonl"), path_in(&folder, "other"));
    fs::write(&other, "").unwrap();
    let space = ["--degree", "3", "--limit", "5", "--checkpoint", text(&file)];
    search(&space);
    knotproof(&["merge", text(&file), "--out", text(&out)]).assert().code(0);
    assert_eq!((mode(&file), mode(&out)), (mode(&other), mode(&other)));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    search(&space);
    assert_eq!(mode(&file), 0o600);
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    use std::os::unix::fs::symlink;

    let folder = tempfile::tempdir().unwrap();
    let (file, link, dangling) =
        (path_in(&folder, "state.jsonl"), path_in(&folder, "link"), path_in(&folder, "dangling"));
    search(&["--degree", "3", "--limit", "5", "--checkpoint", text(&file)]);
    let before = fs::read_to_string(&file).unwrap();
    symlink("state.jsonl", &link).unwrap();
    search(&["--resume", text(&link)]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(&file).unwrap(), before);
    symlink("nothing", &dangling).unwrap();
    rejected(
        &["search", "--degree", "3", "--checkpoint", text(&dangling)],
        "--checkpoint",
        &["cannot write", text(&dangling)],
    );
    assert!(fs::symlink_metadata(&dangling).unwrap().is_symlink());
}

/// A pipe that nobody writes to, a device without end, a folder.
#[cfg(unix)]
#[test]
fn only_regular_files_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = path_in(&folder, "pipe");
    assert!(Process::new("mkfifo").arg(&pipe).status().unwrap().success());
    for path in [text(&pipe), "/dev/zero", text(folder.path())] {
        for (arguments, argument) in [
            (&["search", "--resume", path][..], "--resume"),
            (&["search", "--degree", "3", "--checkpoint", path], "--checkpoint"),
            (&["merge", path], "FILE"),
        ] {
            rejected(arguments, argument, &[path, "no regular file"]);
        }
    }
}

/// A reader that has seen enough, as `| head` does.
#[test]
fn a_closed_pipe_is_no_error() {
    let mut process = crate::process();
    process.args(["search", "--degree", "3", "--limit", "11", "--format", "json"]);
    let mut process = process.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(process.stdout.take());
    let output = process.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(1), &b""[..]));
}

/// The dips of the findings are bounds of ten digits, one unit apart, and those of `deepest` fall.
#[test]
fn dips_are_enclosed_and_the_deepest_come_first() {
    let number = |text: &Value| -> BigRational { text.as_str().unwrap().parse().unwrap() };
    let dips = |findings: &[Value]| -> Vec<[BigRational; 2]> {
        findings.iter().map(|f| [&f["witness"]["dip"][0], &f["witness"]["dip"][1]].map(number)).collect()
    };
    let (found, code) = search(&["--degree", "3", "--count", "6000", "--find", "deepest", "--seed", "1"]);
    let (findings, _) = records(&found);
    assert_eq!((code, findings.len()), (1, 10));
    let deepest = dips(&findings);
    assert!(deepest.windows(2).all(|pair| pair[0][0] >= pair[1][0]));
    let billion = BigRational::from_integer(1_000_000_000.into());
    for [lo, hi] in &deepest {
        assert!(lo < hi && (hi - lo) * &billion <= *hi, "{lo} {hi}");
    }
    // The smallest function of degree 3 with two maxima.
    let (found, _) = search(&["--degree", "3", "--limit", "8"]);
    let [[lo, hi]] = &dips(&records(&found).0)[..] else { panic!("one finding") };
    let computed: BigRational = SMALLEST_DIP.parse().unwrap();
    assert!(*lo <= computed && computed <= *hi, "{lo} {hi}");
}

/// (0.6361607781784060467310688 − 285/448)/0.6361633978505121206080454, computed elsewhere in fractions.
const SMALLEST_DIP: &str = "1004344040806172083/10000000000000000000000000";

#[test]
fn given_indices_are_the_only_ones() {
    let space =
        ["--degree", "3", "--count", "4000", "--alpha", "-1/7", "--alpha", "3/2", "--find", "deepest"];
    let (findings, summary) = records(&search(&space).0);
    assert!(!findings.is_empty());
    // 3/2 by its conjugate.
    assert!(findings.iter().all(|finding| ["-1/7", "-1/2"].contains(&finding["alpha"].as_str().unwrap())));
    assert_eq!(summary["search"]["space"]["indices"]["alpha"], serde_json::json!(["-1/7", "3/2"]));
}

/// A summary with one more or less of something in the block of a position.
fn in_block(records: &mut [Value], at: u64, name: &str, change: i64) {
    let last = records.len() - 1;
    let summary = &mut records[last];
    let add = |number: &mut Value| *number = (number.as_i64().unwrap() + change).into();
    let blocks = summary["blocks"].as_array_mut().unwrap();
    let holds = |block: &&mut Value| block["from"].as_u64() <= Some(at) && Some(at) < block["to"].as_u64();
    add(&mut blocks.iter_mut().find(holds).unwrap()[name]);
    match name {
        "several" => add(&mut summary["several"]),
        _ => add(&mut summary["decided"][name]),
    }
}

/// Whatever a shard says that is not so, with numbers that add up and a valid checksum: merged it is believed, and named
/// as soon as its block is computed again.
#[test]
fn forged_shards_are_found_out() {
    let folder = tempfile::tempdir().unwrap();
    let space = ["--degree", "3", "--count", "1500", "--seed", "1"];
    let shards: Vec<_> =
        (0..2).map(|i| search(&[&space[..], &["--shard", &format!("{i}/2")]].concat()).0).collect();
    let files: Vec<_> = (0..2).map(|i| path_in(&folder, &format!("{i}.jsonl"))).collect();
    let out = path_in(&folder, "all.jsonl");
    let merge = |options: &[&str]| -> (Value, i32) {
        let files = files.iter().map(|file| text(file));
        let arguments: Vec<_> =
            ["merge", "--format", "json"].into_iter().chain(files).chain(options.iter().copied()).collect();
        let output = knotproof(&arguments).output().unwrap();
        let result = if output.stdout.is_empty() { output.stderr } else { output.stdout };
        (serde_json::from_slice(&result).unwrap(), output.status.code().unwrap())
    };
    let write = |first: &str| {
        fs::write(&files[0], first).unwrap();
        fs::write(&files[1], &shards[1]).unwrap();
    };
    let (findings, _) = records(&shards[0]);
    let gone = findings.iter().find(|finding| finding["cases"] == 1).unwrap().clone();
    let at = gone["found_at"].as_u64().unwrap();
    // Another function with two maxima, from a case that has two, and not that.
    let invented = |records: &mut Vec<Value>| {
        let (other, _) = search(&["--degree", "3", "--limit", "9"]);
        let (mut others, _) = self::records(&other);
        let known = |finding: &Value| records.iter().any(|record| record["gaps"] == finding["gaps"]);
        let mut new = others.drain(..).find(|finding| !known(finding)).unwrap();
        (new["found_at"], new["cases"]) = (at.into(), 1.into());
        let place = records.iter().position(|record| record["found_at"] == at).unwrap();
        records[place] = new;
        let last = records.len() - 1;
        let size = |r: &Value| -> (u64, Vec<u64>) {
            let gaps: Vec<u64> =
                r["gaps"].as_array().unwrap().iter().map(|g| g.as_str().unwrap().parse().unwrap()).collect();
            let alpha = r["alpha"].as_str().unwrap();
            let (p, q) = alpha.split_once('/').unwrap_or((alpha, "1"));
            let height = p.trim_start_matches('-').parse::<u64>().unwrap().max(q.parse().unwrap());
            (gaps.iter().sum::<u64>() + height, [vec![height], gaps].concat())
        };
        records[..last].sort_by_key(size);
    };
    type Forgery<'a> = (&'a str, Box<dyn Fn(&mut Vec<Value>) + 'a>);
    let forgeries: Vec<Forgery<'_>> = vec![
        (
            "removed finding",
            Box::new(|records: &mut Vec<Value>| {
                records.retain(|record| record["found_at"] != at);
                in_block(records, at, "several", -1);
                let last = records.len() - 1;
                records[last]["findings"] = last.into();
            }),
        ),
        (
            "all findings removed",
            Box::new(|records: &mut Vec<Value>| {
                records.drain(..records.len() - 1);
                records[0]["findings"] = 0.into();
                records[0]["several"] = 0.into();
                records[0]["blocks"]
                    .as_array_mut()
                    .unwrap()
                    .iter_mut()
                    .for_each(|block| block["several"] = 0.into());
            }),
        ),
        ("invented finding", Box::new(invented)),
        (
            "count",
            Box::new(|records: &mut Vec<Value>| {
                in_block(records, at, "exactly", 1);
                in_block(records, at, "by_intervals", -1);
            }),
        ),
        (
            "digest",
            Box::new(|records: &mut Vec<Value>| {
                let last = records.len() - 1;
                let block = &mut records[last]["blocks"][0];
                let digest = u64::from_str_radix(block["digest"].as_str().unwrap(), 16).unwrap();
                block["digest"] = format!("{:016x}", digest ^ 1).into();
            }),
        ),
        (
            "found later",
            Box::new(|records: &mut Vec<Value>| {
                let several: Vec<u64> =
                    records.iter().filter_map(|r| r["found_at"].as_u64()).filter(|&p| p > at).collect();
                let place = records.iter().position(|record| record["found_at"] == at).unwrap();
                records[place]["found_at"] = several[0].into();
            }),
        ),
        (
            "cases",
            Box::new(|records: &mut Vec<Value>| {
                let place = records.iter().position(|record| record["found_at"] == at).unwrap();
                let other =
                    records.iter().position(|r| r["record"] == "finding" && r["found_at"] != at).unwrap();
                records[place]["cases"] = 2.into();
                let cases = records[other]["cases"].as_u64().unwrap();
                records[other]["cases"] = (cases - 1).into();
                if cases == 1 {
                    records.remove(other);
                    let last = records.len() - 1;
                    records[last]["findings"] = last.into();
                }
            }),
        ),
    ];
    // What is so passes every audit.
    write(&shards[0]);
    for audit in ["1", "3", "all", "1000"] {
        let (merged, code) = merge(&["--audit", audit, "--seed", "5"]);
        assert_eq!((code, &merged["audited"]["differences"]), (1, &serde_json::json!([])), "{merged}");
        let again = merged["audited"]["recomputed"].as_array().unwrap().len() as u64;
        let rest = merged["audited"]["not_recomputed"].as_u64().unwrap();
        assert_eq!(again + rest, merged["audited"]["blocks"].as_u64().unwrap());
    }
    for (what, change) in forgeries {
        write(&forged(&shards[0], |records| change(records)));
        // Nobody looks.
        let (merged, code) = merge(&[]);
        assert_eq!(
            (&merged["covered"], &merged["audited"], code),
            (&true.into(), &Value::Null, 1),
            "{what}: {merged}"
        );
        for audit in ["all", "1000"] {
            let (merged, code) = merge(&["--audit", audit, "--out", text(&out)]);
            let differences = merged["audited"]["differences"].as_array().unwrap();
            assert!(code == 1 && !differences.is_empty() && merged["covered"] == false, "{what}: {merged}");
            assert!(!out.exists());
            let named = |d: &Value| d["files"].as_array().unwrap().contains(&text(&files[0]).into());
            assert!(differences.iter().any(named), "{what}: {merged}");
        }
        // A block is found out if it is among those that are drawn, and only then.
        let all = merge(&["--audit", "all"]).0;
        let bad: Vec<_> =
            all["audited"]["differences"].as_array().unwrap().iter().map(|d| d["from"].clone()).collect();
        for seed in ["0", "1", "2", "3", "4"] {
            let (merged, _) = merge(&["--audit", "2", "--seed", seed]);
            let drawn = merged["audited"]["recomputed"].as_array().unwrap();
            assert_eq!((drawn.len(), &merged["audited"]["seed"]), (2, &seed.parse::<u64>().unwrap().into()));
            let met = what != "cases" && drawn.iter().any(|block| bad.contains(&block[0]));
            let found = !merged["audited"]["differences"].as_array().unwrap().is_empty();
            assert!(found || !met, "{what}, seed {seed}: {merged}");
            assert_eq!(merged["covered"], Value::from(!found));
        }
        let shown =
            knotproof(&["merge", text(&files[0]), text(&files[1]), "--audit", "all"]).assert().code(1);
        let shown = String::from_utf8(shown.get_output().stdout.clone()).unwrap();
        assert!(
            shown.contains("are not what comes out of the search") && !shown.contains("Functions with"),
            "{shown}"
        );
    }
    // Another search under the same numbers: the cases of seed 2, said to be those of seed 1.
    let other: Vec<_> = (0..2)
        .map(|i| search(&["--degree", "3", "--count", "1500", "--seed", "2", "--shard", &format!("{i}/2")]).0)
        .map(|text| {
            forged(&text, |records| {
                records.last_mut().unwrap()["search"]["space"]["random"]["seed"] = 1.into()
            })
        })
        .collect();
    fs::write(&files[0], &other[0]).unwrap();
    fs::write(&files[1], &other[1]).unwrap();
    let (merged, code) = merge(&["--audit", "1"]);
    assert!(code == 2 || merged["covered"] == false, "{merged}");
    rejected(&["merge", "--audit", "0", text(&files[0])], "--audit", &["0 blocks"]);
    rejected(&["merge", "--audit", "some", text(&files[0])], "--audit", &["whole number"]);
}

/// Off a terminal a line comes now and then, and something moves inside a single decision that takes long.
#[test]
fn long_searches_say_so_in_a_log() {
    let mut process = crate::process();
    process.args(["search", "--degree", "16", "--count", "2", "--threads", "1"]);
    process.env_remove("KNOTPROOF_PROGRESS");
    let mut process = process.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(process.stderr.take().unwrap()).lines().map(Result::unwrap);
    let [first, second] = [lines.next(), lines.next()].map(|line| line.expect("a line"));
    kill(process);
    for line in [&first, &second] {
        assert!(line.starts_with("progress: ") && line.contains(" of 2 done"), "{line}");
        assert!(line.contains("inside") && line.contains("steps of it"), "{line}");
    }
    assert_ne!(first, second);
}
