//! Folders of results: whenever the program is killed, the old one is there, or the new one.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use assert_cmd::Command;

fn knotproof(arguments: &[&str], folder: &Path) -> Command {
    let mut command = crate::program();
    command.args(arguments).current_dir(folder);
    command
}

/// Every file below the folder, with its content.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if entry.file_type().unwrap().is_dir() {
            found.extend(
                files(&entry.path()).into_iter().map(|(below, text)| (format!("{name}/{below}"), text)),
            );
        } else {
            found.insert(name, fs::read(entry.path()).unwrap());
        }
    }
    found
}

/// A folder whose pages are all old, with something of the user's beside them.
fn old_pages(folder: &Path, names: impl Iterator<Item = String>) -> BTreeMap<String, Vec<u8>> {
    fs::create_dir_all(folder.join("mine/deep")).unwrap();
    fs::write(folder.join("mine/deep/notes.txt"), "mine").unwrap();
    for name in names {
        fs::write(folder.join(name), "old").unwrap();
    }
    files(folder)
}

#[test]
fn a_kill_leaves_the_old_folder_or_the_new_one() {
    let place = tempfile::tempdir().unwrap();
    knotproof(&["man", "--out", "fresh"], place.path()).assert().success();
    let pages = files(&place.path().join("fresh"));
    let mut new = pages.clone();
    new.insert("mine/deep/notes.txt".to_owned(), b"mine".to_vec());
    let (mut was_old, mut was_new) = (0, 0);
    for round in 0..60 {
        let round_place = place.path().join(format!("round-{round}"));
        let old = old_pages(&round_place.join("pages"), pages.keys().cloned());
        let mut child = crate::process()
            .args(["man", "--out", "pages"])
            .current_dir(&round_place)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        // From when the new folder begins to grow, a little later each time.
        while fs::read_dir(&round_place).unwrap().count() == 1 && child.try_wait().unwrap().is_none() {}
        sleep(Duration::from_micros(100 * round));
        child.kill().unwrap();
        child.wait().unwrap();
        let found = files(&round_place.join("pages"));
        assert!(found == old || found == new, "round {round}: a mixture: {:?}", found.keys());
        *(if found == old { &mut was_old } else { &mut was_new }) += 1;
        // Whatever was left beside it is in nobody's way.
        knotproof(&["man", "--out", "pages"], &round_place).assert().success();
        assert_eq!(files(&round_place.join("pages")), new);
    }
    println!("old {was_old} times, new {was_new} times");
}

#[test]
fn nothing_is_left_beside_the_folder_and_nothing_of_the_user_is_lost() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join("pages");
    old_pages(&out, ["knotproof.1".to_owned()].into_iter());
    for _ in 0..2 {
        knotproof(&["man", "--out", "pages"], place.path()).assert().success();
        assert_eq!(fs::read(out.join("mine/deep/notes.txt")).unwrap(), b"mine");
        assert_ne!(fs::read(out.join("knotproof.1")).unwrap(), b"old");
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_a_folder_stays_a_link() {
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(place.path().join("real")).unwrap();
    std::os::unix::fs::symlink("real", place.path().join("link")).unwrap();
    knotproof(&["man", "--out", "link"], place.path()).assert().success();
    assert!(fs::symlink_metadata(place.path().join("link")).unwrap().is_symlink());
    assert!(place.path().join("real/knotproof.1").is_file());
    // One that leads nowhere is not followed.
    std::os::unix::fs::symlink("gone", place.path().join("dangling")).unwrap();
    knotproof(&["man", "--out", "dangling"], place.path()).assert().code(2);
}

#[test]
fn what_cannot_be_replaced_is_refused_before_the_work_begins() {
    let place = tempfile::tempdir().unwrap();
    let here = place.path().join("here");
    fs::create_dir(&here).unwrap();
    fs::write(here.join("file"), "a file").unwrap();
    for out in [".", "..", "/", "file", "file/below"] {
        let output = knotproof(&["man", "--out", out], &here).assert().code(2).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.contains("--out") && message.lines().count() == 1, "{out}: {message}");
    }
    assert_eq!(files(place.path()).keys().collect::<Vec<_>>(), ["here/file"]);
}

/// One place writes: what is written elsewhere may be cut short.
#[test]
fn commands_write_files_in_one_place_only() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/cli");
    for (name, text) in files(&root) {
        let text = String::from_utf8(text).unwrap();
        let code = text.split("#[cfg(test)]").next().unwrap();
        for call in ["fs::write", "File::create", "OpenOptions", "create_dir", "fs::rename"] {
            assert!(name == "atomic.rs" || !code.contains(call), "src/cli/{name} calls {call}");
        }
    }
}
