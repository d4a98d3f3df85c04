//! Every command block of every page is run, and ends as the page says.
//!
//! A line ends with exit code 0, or with the one that a comment behind it names: `# exit code 1`. A block that can't be
//! run here says so in a comment before it, `<!-- not run by tests/pages.rs: REASON -->`. Lines that take long are marked
//! `# takes a while`: they are left out here and run by `tests/pages.sh`.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const EXCUSE: &str = "<!-- not run by tests/pages.rs: ";

/// A command block, and where it begins.
struct Block {
    page: String,
    line: usize,
    excuse: Option<String>,
    commands: String,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README.md, and what lies in docs.
fn pages() -> Vec<PathBuf> {
    let docs = fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut pages: Vec<_> = docs.filter(|path| path.extension().is_some_and(|of| of == "md")).collect();
    pages.push(root().join("README.md"));
    pages.sort();
    pages
}

fn blocks() -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let name = page.file_name().unwrap().to_str().unwrap().to_owned();
        let (mut excuse, mut open) = (None, false);
        for (line, text) in (1..).zip(text.lines()) {
            if open && text == "```" {
                open = false;
            } else if open {
                let commands = &mut blocks.last_mut().unwrap().commands;
                commands.push_str(text);
                commands.push('\n');
            } else if text.starts_with("```sh")
                || text.starts_with("```bash")
                || text.starts_with("```console")
            {
                open = true;
                let excuse = excuse.take();
                blocks.push(Block { page: name.clone(), line, excuse, commands: String::new() });
            } else if let Some(reason) = text.strip_prefix(EXCUSE) {
                excuse = Some(reason.strip_suffix(" -->").unwrap().to_owned());
            }
        }
        assert!(!open, "{name}: a block has no end");
    }
    blocks
}

/// The block as a script that ends at the first line that does not end as it says.
fn script(commands: &str) -> String {
    let mut script = String::new();
    for line in commands.lines() {
        let (command, comment) = line.split_once("  #").unwrap_or((line, ""));
        let command = command.trim_end();
        if command.is_empty() || command.starts_with('#') || comment.trim() == "takes a while" {
            continue;
        }
        let code = comment.trim().strip_prefix("exit code ").unwrap_or("0");
        let shown = line.replace('\'', "'\\''");
        script += &format!(
            "{command}\ncode=$?\n[ $code -eq {code} ] || {{ echo \"exit code $code:\" '{shown}' >&2; exit 1; }}\n"
        );
    }
    script
}

/// Runs commands in a folder, up to the first that does not end as it says.
pub(crate) fn shell(folder: &Path, commands: &str) -> Output {
    let program = Path::new(crate::PATH);
    let path = format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap());
    Command::new("bash")
        .args(["-c", &script(commands)])
        .current_dir(folder)
        .env("PATH", &path)
        .env("KNOTPROOF_PROGRESS", "never")
        .output()
        .unwrap()
}

#[test]
fn every_command_block_ends_as_the_page_says() {
    let (mut run, mut failed) = (0, Vec::new());
    for block in blocks().iter().filter(|block| block.excuse.is_none()) {
        let folder = tempfile::tempdir().unwrap();
        let output = shell(folder.path(), &block.commands);
        if !output.status.success() {
            let messages = String::from_utf8_lossy(&output.stderr);
            failed.push(format!("{}, line {}: {messages}", block.page, block.line));
        }
        run += 1;
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    assert!(run >= 15, "{run} blocks");
}

/// An excuse has a reason, and belongs to a block.
#[test]
fn blocks_are_left_out_for_a_reason() {
    let excused = blocks().iter().filter_map(|block| block.excuse.clone()).collect::<Vec<_>>();
    let written =
        pages().iter().map(|page| fs::read_to_string(page).unwrap().matches(EXCUSE).count()).sum::<usize>();
    assert_eq!(excused.len(), written, "an excuse without a block");
    assert!(excused.iter().all(|reason| reason.len() > 10), "{excused:?}");
}

#[test]
fn a_line_that_ends_otherwise_is_found() {
    let code = |commands: &str| Command::new("bash").args(["-c", &script(commands)]).status().unwrap().code();
    assert_eq!(code("true\nfalse  # exit code 1\n# a remark\n\nsleep 1000  # takes a while\n"), Some(0));
    for wrong in [
        "false\ntrue\n",
        "true  # exit code 1\n",
        "exit 3 | cat; (exit 2)  # exit code 3\n",
        "true\nnothing-of-that-name\n",
    ] {
        assert_eq!(code(wrong), Some(1), "{wrong}");
    }
}
