//! What every command owes to the shell: a result that could not be written is no success, and nothing that was supplied
//! reaches the terminal as it is.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

/// A folder with a file for every command that reads one, by names that a terminal would obey.
struct Files {
    folder: TempDir,
}

/// Sets the title, clears, colours, turns the direction of writing, hides, and breaks the line.
const EVIL: &str = "\u{1b}]0;x\u{7}\u{1b}[2J\u{1b}[31m\u{9b}1m\u{202e}\u{2066}\u{200b}\rAccepted: 9\nok";

impl Files {
    fn new() -> Self {
        let files = Self { folder: tempfile::tempdir().unwrap() };
        let write = |name: &str, content: &str| fs::write(files.path(name), content).unwrap();
        write("instance.json", r#"{"degree":1,"knots":[0,1,2],"alpha":-1,"points":[[1]]}"#);
        write("points.csv", "1/2\n");
        write("bad.json", "{");
        write("statement.statement", "(claim");
        write("statement.proof", "(");
        let family =
            "name = \"f\"\ntitle = \"\"\nsource = \"\"\n[weight]\nrise = \"x - a\"\nfall = \"2*(b - x)\"\n";
        write("family.toml", family);
        let search =
            run(crate::process().args(["search", "--degree", "3", "--limit", "7", "--format", "json"]));
        fs::write(files.path("search.jsonl"), search.stdout).unwrap();
        files
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(format!("{EVIL}{name}"))
    }

    fn text(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }
}

fn run(command: &mut Command) -> Output {
    command.stdin(Stdio::null()).output().unwrap()
}

/// One call or more of every command that writes a result, and their names.
fn calls(files: &Files) -> Vec<Vec<String>> {
    let u4 = ["--instance", "U4", "--alpha", "-1"];
    let mut calls: Vec<Vec<String>> = Vec::new();
    let mut call = |start: &[&str], rest: &[&str], paths: &[String]| {
        let words = start.iter().chain(rest).map(ToString::to_string);
        calls.push(words.chain(paths.iter().cloned()).collect());
    };
    let instance = files.text("instance.json");
    call(&["eval", "--x", "1/2"], &u4, &[]);
    call(&["eval", "--x", "1/2", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["eval"], &u4, &["--points-file".to_owned(), files.text("points.csv")]);
    call(&["formula", "--index", "1"], &u4, &[]);
    call(&["bezier", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["joins", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["joins", "--all"], &[], &[]);
    call(&["solve", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["bounds", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["length", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["interpolate", "--at", "1", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["insert", "--at", "1", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["plot", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["check", "--property", "T3.5.2", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["shape", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["shape", "--alpha", "all", "--instance"], &[], std::slice::from_ref(&instance));
    call(&["float", "--x", "1/2"], &u4, &[]);
    call(&["figures", "two-maxima", "--out"], &[], &[files.text("figures")]);
    call(&["judge", "rational-bsplines", "--claim", "P2.1.1"], &[], &[]);
    call(&["explain", "P2.1.1"], &[], &[]);
    call(&["prove", "--claim", "P2.1.1", "--out"], &[], &[files.text("certificates")]);
    call(&["verify"], &[], &[files.text("statement.statement")]);
    call(&["families"], &[], &[files.text("family.toml")]);
    call(&["vectors", "--degree", "1", "--out"], &[], &[files.text("vectors.json")]);
    let knots = ["--degree", "1", "--knots", "0 0 1 1", "--classical", "--family"];
    call(&["check"], &knots, &[files.text("family.toml")]);
    call(&["search", "--degree", "3", "--limit", "7"], &[], &[]);
    call(&["merge"], &[], &[files.text("search.jsonl")]);
    call(&["schema"], &[], &[]);
    call(&["completions", "bash"], &[], &[]);
    call(&["man", "--out"], &[], &[files.text("pages")]);
    call(&["help"], &[], &[]);
    call(&["help", "eval"], &[], &[]);
    calls
}

/// The commands, as an error names them.
fn commands() -> Vec<String> {
    let error = String::from_utf8(run(crate::process().args(["help", "nonsense"])).stderr).unwrap();
    let (_, list) = error.trim().split_once("there are ").unwrap();
    list.split(", ").map(str::to_owned).collect()
}

#[test]
fn every_command_has_a_call() {
    let files = Files::new();
    let calls = calls(&files);
    let commands = commands();
    assert!(commands.len() > 12, "{commands:?}");
    for command in commands {
        // A report takes its time: it has a call of its own below. A folder is made once only: tests/cli_judge.rs.
        assert!(
            ["report", "new"].contains(&&*command) || calls.iter().any(|call| call[0] == command),
            "{command}"
        );
    }
}

/// On a full disk and without standard output the exit code is 4; into a pipe that nobody reads it is what it is
/// anyway, and all is quiet.
#[test]
fn a_lost_result_is_no_success() {
    let files = Files::new();
    let mut calls = calls(&files);
    for arguments in [vec!["--version"], vec!["--help"], vec!["-h"], vec!["-V"]] {
        calls.push(arguments.into_iter().map(str::to_owned).collect());
    }
    for command in commands() {
        calls.push(vec![command, "--help".to_owned()]);
    }
    for call in calls {
        for format in ["text", "json"] {
            // Where the folder is there already, the same is written again.
            let with_format = || {
                let mut command = crate::process();
                command.args(&call).args(["--format", format]).stdin(Stdio::null());
                command
            };
            let usual = with_format().output().unwrap();
            assert!(!usual.stdout.is_empty() && usual.status.code() < Some(2), "{call:?}: {usual:?}");

            let full = File::options().write(true).open("/dev/full").unwrap();
            let full = with_format()
                .stdout(full)
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
                .wait_with_output()
                .unwrap();
            let closed = Command::new("sh")
                .args(["-c", "exec \"$0\" \"$@\" >&-", crate::PATH])
                .args(&call)
                .args(["--format", format])
                .stdin(Stdio::null())
                .stderr(Stdio::piped())
                .output()
                .unwrap();
            for lost in [full, closed] {
                let message = String::from_utf8(lost.stderr).unwrap();
                assert_eq!(lost.status.code(), Some(4), "{call:?} {format}: {message}");
                assert!(message.contains("cannot write the result"), "{call:?}: {message}");
            }

            let (reader, writer) = std::io::pipe().unwrap();
            drop(reader);
            let unread = with_format()
                .stdout(writer)
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
                .wait_with_output()
                .unwrap();
            assert_eq!(
                (unread.status.code(), unread.stderr),
                (usual.status.code(), vec![]),
                "{call:?} {format}"
            );
        }
    }
}

#[test]
fn a_lost_report_is_no_success() {
    let full = File::options().write(true).open("/dev/full").unwrap();
    let status = crate::process().args(["report", "--claim", "P2.1.1"]).stdout(full).status().unwrap();
    assert_eq!(status.code(), Some(4));
}

/// `/dev/null` is a standard output like any other, also where it was opened to be read as well.
#[test]
fn what_is_thrown_away_on_purpose_is_written() {
    let both = File::options().read(true).write(true).open("/dev/null").unwrap();
    for null in [Stdio::null(), both.into()] {
        assert!(crate::process().arg("schema").stdout(null).status().unwrap().success());
    }
}

/// Nothing but text, line breaks, tabs and the program's own styles.
fn harmless(output: &Output, what: &[String]) {
    for bytes in [&output.stdout, &output.stderr] {
        let text = String::from_utf8(bytes.clone()).unwrap();
        let mut rest = text.as_str();
        while let Some(at) = rest.find(|c: char| c.is_control() && c != '\n' && c != '\t') {
            let style = [
                "\u{1b}[0m",
                "\u{1b}[1m",
                "\u{1b}[4m",
                "\u{1b}[31m",
                "\u{1b}[32m",
                "\u{1b}[33m",
                "\u{1b}[2m",
            ]
            .into_iter()
            .find(|style| rest[at..].starts_with(style));
            assert!(style.is_some(), "{what:?}: {text:?}");
            rest = &rest[at + style.map_or(1, str::len)..];
        }
        assert!(!text.contains(['\u{202e}', '\u{2066}', '\u{200b}']), "{what:?}: {text:?}");
        assert!(!text.lines().any(|line| line.starts_with("Accepted: 9")), "{what:?}: {text:?}");
        assert!(!text.contains("\u{1b}[31m\\u{9b}"), "a style that was supplied: {what:?}: {text:?}");
    }
}

#[test]
fn nothing_supplied_reaches_the_terminal_as_it_is() {
    let files = Files::new();
    let mut all = calls(&files);
    // As every argument, and as every file that is there and is not what it should be.
    let (bad, missing) = (files.text("bad.json"), files.text("none"));
    for value in [EVIL, &bad, &missing] {
        for command in commands() {
            all.push(vec![command, value.to_owned()]);
        }
        for (command, option) in [
            ("eval", "--instance"),
            ("eval", "--knots"),
            ("eval", "--alpha"),
            ("eval", "--x"),
            ("eval", "--side"),
            ("eval", "--degree"),
            ("eval", "--index"),
            ("eval", "--points"),
            ("eval", "--points-file"),
            ("formula", "--as"),
            ("check", "--property"),
            ("check", "--scope"),
            ("shape", "--width"),
            ("shape", "--free-knot"),
            ("float", "--x"),
            ("report", "--claim"),
            ("report", "--baseline"),
            ("prove", "--claim"),
            ("search", "--shard"),
            ("search", "--resume"),
            ("search", "--limit"),
        ] {
            let mut call = vec![command.to_owned(), option.to_owned(), value.to_owned()];
            for (given, other) in
                [("--degree", "2"), ("--knots", "0 0 0 1 2 2 2"), ("--alpha", "2"), ("--x", "1")]
            {
                if command == "eval" && option != given && !(option == "--points-file" && given == "--x") {
                    call.extend([given.to_owned(), other.to_owned()]);
                }
            }
            all.push(call);
        }
        all.push(vec![format!("--{value}")]);
        all.push(vec!["eval".to_owned(), format!("--{value}")]);
    }
    for call in all {
        for format in ["text", "json"] {
            let mut command = crate::process();
            // `new` makes a folder of that name.
            command.current_dir(files.folder.path());
            let output = run(command.args(&call).args(["--format", format]).env("CLICOLOR_FORCE", "1"));
            assert_ne!(output.status.code(), Some(4), "{call:?}: {output:?}");
            harmless(&output, &call);
        }
    }
}

/// Certificates, tables and pictures are compared byte by byte: nothing may turn their line ends.
#[test]
fn what_is_compared_has_line_feeds_everywhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let attributes = fs::read_to_string(root.join(".gitattributes")).unwrap();
    let rules: Vec<&str> = attributes.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(rules[0], "* text=auto eol=lf");
    assert!(rules[1..].iter().all(|rule| rule.ends_with(" binary")), "{rules:?}");
    for folder in ["", "docs", "proofs", "proofs/certs", "tests", "tests/golden", ".ci"] {
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file()
                && !rules
                    .iter()
                    .any(|rule| path.extension().is_some_and(|e| rule.contains(&*e.to_string_lossy())))
            {
                assert!(!fs::read(&path).unwrap().contains(&b'\r'), "{}", path.display());
            }
        }
    }
}
