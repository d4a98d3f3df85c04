//! The program: one line a certificate, and an exit code that cannot be mistaken.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Exit code, standard output and standard error.
fn run(files: &[PathBuf]) -> (Option<i32>, String, String) {
    let run = Command::new(env!("CARGO_BIN_EXE_knotproof-checker")).args(files).output();
    let output = run.expect("the program starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pass").join(name)
}

#[test]
fn the_exit_code_tells() {
    let pair = |name: &str| [file(&format!("{name}.statement")), file(&format!("{name}.proof"))];
    let good = [pair("unity"), pair("det")].concat();
    let (code, out, err) = run(&good);
    assert_eq!((code, out.lines().count(), err.as_str()), (Some(0), 2, ""));
    // One that is rejected among others: they are checked, and it is not forgotten.
    let mixed = [[file("unity.statement"), file("det.proof")], pair("det")].concat();
    let (code, out, err) = run(&mixed);
    assert_eq!((code, out.lines().count()), (Some(1), 1));
    assert!(err.contains("unity.statement: section 1"), "{err}");
    let missing = [pair("det"), pair("no-such")].concat();
    let (code, _, err) = run(&missing);
    assert!(code == Some(2) && err.contains("no-such.statement"), "{err}");
    // Of what cannot be read the others are read all the same.
    let folder = std::env::temp_dir().join(format!("knotproof-checker-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for files");
    let odd = folder.join("odd\u{1b}[31m\n.statement");
    for bytes in [b"\xff".as_slice(), b"(", b"", &[b'('; 1_000_000], &[b' '; 4_000_001]] {
        std::fs::write(&odd, bytes).expect("a file");
        let mixed = [vec![odd.clone(), file("det.proof")], pair("det").to_vec()].concat();
        let (code, out, err) = run(&mixed);
        assert!(code == Some(1) || code == Some(2), "{code:?}");
        assert_eq!((out.lines().count(), err.lines().count()), (1, 1), "{err}");
        assert!(err.contains(r"odd\u{1b}[31m\n.statement: "), "{err}");
    }
    std::fs::remove_dir_all(&folder).expect("it is there");
    assert_eq!(run(&[]).0, Some(2));
    assert_eq!(run(&[file("det.statement")]).0, Some(2));
}
