//! Every command that the help shows is run, and ends as it says; what the guide quotes is printed; completions and manual
//! pages are there.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn knotproof() -> Command {
    crate::program()
}

fn text(arguments: &[&str]) -> String {
    let output = knotproof().args(arguments).assert().success().stderr("").get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

/// The arguments as a shell would split them: at spaces, but not between double quotes.
fn arguments(line: &str) -> Vec<String> {
    let quoted = line.split('"').enumerate();
    let parts = quoted.flat_map(|(at, part)| match at % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    parts.collect()
}

/// Runs `knotproof …` in a folder.
fn run(folder: &Path, line: &str, exit: i32) {
    let arguments = arguments(line);
    assert_eq!(arguments[0], "knotproof", "{line}");
    let output = knotproof().args(&arguments[1..]).current_dir(folder).output().unwrap();
    let messages = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(exit), "{line}\n{messages}");
    assert!(!output.stdout.is_empty(), "{line} prints nothing");
}

#[test]
fn every_example_of_the_help_ends_as_it_says() {
    let help: Value = serde_json::from_str(&text(&["help", "--format", "json"])).unwrap();
    let shown = text(&["help"]);
    let mut count = 0;
    // What one writes, the next one reads.
    let folder = tempfile::tempdir().unwrap();
    for task in help["tasks"].as_array().unwrap() {
        for example in task["examples"].as_array().unwrap() {
            let line = example["command"].as_str().unwrap();
            assert!(shown.contains(&format!("  {line}\n")), "{line}");
            run(folder.path(), line, i32::try_from(example["exit"].as_i64().unwrap()).unwrap());
            count += 1;
        }
    }
    assert!(count >= 10, "{count}");
}

/// The examples at the end of what `--help` prints, each on a line of its own or on several that end with `\`.
fn examples(help: &str) -> Vec<String> {
    let mut lines = help.lines().skip_while(|line| !line.starts_with("Example"));
    let mut examples = Vec::new();
    while let Some(line) = lines.next() {
        let Some(begun) = line.strip_prefix("  ").filter(|line| line.contains("knotproof ")) else {
            continue;
        };
        let mut example = begun.to_owned();
        while let Some(open) = example.strip_suffix('\\') {
            example = format!("{}{}", open, lines.next().unwrap().trim_start());
        }
        examples.push(example);
    }
    examples
}

/// What one of them writes, the next one of the same command reads, beside points of the reader's own and the certificates of the project.
/// Those of `completions` and `man` are about the reader's own folders.
#[test]
#[cfg(unix)]
fn every_example_of_a_command_ends_as_it_says() {
    let pages = tempfile::tempdir().unwrap();
    let named = text(&["man", "--out", pages.path().join("man1").to_str().unwrap()]);
    let commands = named.lines().filter_map(|path| path.strip_suffix(".1")?.rsplit_once("knotproof-"));
    let mut count = 0;
    for (_, command) in commands.filter(|(_, command)| !["completions", "man"].contains(command)) {
        let topic: Value = serde_json::from_str(&text(&["help", command, "--format", "json"])).unwrap();
        let examples = examples(topic["help"].as_str().unwrap());
        assert!(!examples.is_empty(), "{command} has no example");
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("points.csv"), "0\n1/2\n").unwrap();
        let proofs = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs");
        std::os::unix::fs::symlink(proofs, folder.path().join("proofs")).unwrap();
        let output = crate::pages::shell(folder.path(), &examples.join("\n"));
        assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
        count += examples.len();
    }
    assert!(count >= 90, "{count}");
}

/// What the guide prints in ```` ```text ```` blocks after a command comes out of the program.
#[test]
fn the_guide_quotes_what_the_program_prints() {
    let guide = include_str!("../docs/guide.md");
    let mut count = 0;
    for part in guide.split("```sh\n").skip(1) {
        let (command, after) = part.split_once("```").unwrap();
        let Some(quoted) = after.trim_start().strip_prefix("```text\n") else { continue };
        let quoted = quoted.split("```").next().unwrap();
        let (command, _) = command.trim().split_once('#').unwrap_or((command.trim(), ""));
        let output = knotproof().args(&arguments(command)[1..]).output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        for line in quoted.lines().map(str::trim_end).filter(|line| !line.is_empty() && *line != "…") {
            assert!(
                printed.lines().any(|printed| printed.trim_end() == line),
                "{command}: {line}\n{printed}"
            );
            count += 1;
        }
    }
    assert!(count >= 5, "{count}");
}

#[test]
fn every_picture_of_the_guide_is_there() {
    let guide = include_str!("../docs/guide.md");
    let pictures: Vec<_> = guide.split("](").skip(1).filter_map(|part| part.split(')').next()).collect();
    assert!(pictures.iter().any(|link| link.ends_with(".svg")));
    for link in pictures.iter().filter(|link| !link.starts_with("http")) {
        assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(link).exists(), "{link}");
    }
}

#[test]
fn help_about_one_command() {
    assert!(text(&["help", "check"]).contains("knotproof check --"));
    let output = knotproof().args(["help", "chek"]).assert().code(2).stdout("").get_output().stderr.clone();
    assert!(
        String::from_utf8(output).unwrap().contains("there is no command `chek`; there are eval, formula")
    );
}

#[test]
fn completions_know_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = text(&["completions", shell]);
        // Commands and options everywhere, and where the shell's script can offer them, names of claims and instances.
        assert!(script.contains("formula") && script.contains("points-file"), "{shell}");
        let offers = ["bash", "zsh", "fish"].contains(&shell);
        for name in ["Conj3.1.strong.continuous", "U12"] {
            assert_eq!(script.contains(name), offers, "{shell}: {name}");
        }
    }
    knotproof().args(["completions", "tcsh"]).assert().code(2);
}

#[test]
fn there_is_a_manual_page_for_every_command() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("man1");
    let printed = text(&["man", "--out", out.to_str().unwrap()]);
    let help = text(&["--help"]);
    let (_, commands) = help.split_once("Commands:\n").unwrap();
    let commands: Vec<_> = commands
        .lines()
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next().filter(|name| !name.is_empty()))
        .collect();
    assert!(commands.len() > 10);
    for name in commands {
        let page = std::fs::read_to_string(out.join(format!("knotproof-{name}.1"))).unwrap();
        assert!(page.starts_with(".nh\n") && page.contains(".SH NAME") && page.contains("Example"), "{name}");
        assert!(printed.contains(&format!("knotproof-{name}.1\n")));
    }
    assert!(out.join("knotproof.1").exists());
}
