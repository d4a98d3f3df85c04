//! `knotproof prove`, `verify` and `explain` as a user meets them. What certificates say is tested in
//! `tests/certificates.rs`.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use assert_cmd::Command;
use knotproof::certificate::Sexp;
use knotproof::report::Baseline;
use serde_json::{Value, json};

fn knotproof(arguments: &[&str]) -> Command {
    let mut command = crate::program();
    command.args(arguments);
    command
}

/// The exit code and the result as JSON; nothing on standard error.
fn run(arguments: &[&str]) -> (i32, Value) {
    let output = knotproof(&[arguments, &["--format", "json"]].concat()).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code().unwrap(), serde_json::from_slice(&output.stdout).unwrap())
}

/// The exit code and the result as text.
fn text(arguments: &[&str]) -> (i32, String) {
    let output = knotproof(arguments).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(!text.contains('\u{1b}'), "no escape sequences in a pipe");
    (output.status.code().unwrap(), text)
}

/// The message of a request that is refused.
fn refused(command: &mut Command, argument: &str) -> String {
    let output = command.args(["--format", "json"]).assert().code(2).stdout("").get_output().stderr.clone();
    let report: Value = serde_json::from_slice(&output).unwrap();
    assert_eq!(report["schema"], "knotproof.error/1");
    assert_eq!(report["error"]["argument"], argument, "{report}");
    report["error"]["message"].as_str().unwrap().to_owned()
}

fn certs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/certs")
}

fn names(folder: &Path) -> BTreeSet<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

/// A folder with copies of these certificates.
fn copies(certificates: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in certificates {
        for extension in ["statement", "proof"] {
            let file = format!("{name}.{extension}");
            fs::copy(certs().join(&file), folder.path().join(&file)).unwrap();
        }
    }
    folder
}

/// Replaces a part that occurs in the file.
fn edit(path: &Path, part: &str, instead: &str) {
    let old = fs::read_to_string(path).unwrap();
    assert!(old.contains(part), "`{part}` in {}", path.display());
    fs::write(path, old.replacen(part, instead, 1)).unwrap();
}

fn words(row: &str) -> String {
    row.split_whitespace().collect::<Vec<_>>().join(" ")
}

// prove

#[test]
fn certificates_are_written_in_pairs_and_are_the_recorded_ones() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("not yet").join("there");
    let arguments = ["prove", "--claim", "P2.1.3", "--claim", "X.derivative", "--out", out.to_str().unwrap()];
    let (code, found) = run(&arguments);
    assert_eq!(code, 0);
    assert_eq!((&found["schema"], &found["written"]), (&json!("knotproof.prove/1"), &json!(out)));
    assert_eq!(found["stale"], json!([]));
    let checked = found["checked"].as_array().unwrap();
    let amended = checked.iter().find(|checked| checked["form"] == "amended").unwrap();
    let expected = json!({
        "claim": "P2.1.3", "form": "amended", "verdict": "proved", "scope": "knots", "degrees": [1], "sections": 0,
        "steps": 0, "shown": "derived", "any_weights": false,
    });
    assert_eq!(amended, &expected);
    let degrees = checked.iter().find(|checked| checked["claim"] == "X.derivative").unwrap();
    let expected = json!({
        "claim": "X.derivative", "form": "printed", "verdict": "refuted", "scope": "instance",
        "degrees": [1, 2, 3, 4, 5, 6], "sections": 0, "steps": 0, "shown": "point", "any_weights": false,
    });
    assert_eq!(degrees, &expected);
    // All of what is recorded for the two claims, and the same files.
    let written = names(&out);
    let of_both = |name: &String| name.starts_with("P2.1.3.") || name.starts_with("X.derivative.");
    assert_eq!(written, names(&certs()).into_iter().filter(of_both).collect());
    assert_eq!(written.len(), 2 * checked.len());
    for name in written {
        assert!(fs::read(out.join(&name)).unwrap() == fs::read(certs().join(&name)).unwrap(), "{name}");
    }
}

/// Certificates of other claims stay; it is not known whether they are stale.
#[test]
fn proving_one_claim_says_nothing_of_other_files() {
    let folder = copies(&["T3.5.1.printed"]);
    fs::write(folder.path().join("P2.1.3.printed.proof"), "outdated").unwrap();
    fs::write(folder.path().join("gone.statement"), "(statement 1)").unwrap();
    let out = folder.path().to_str().unwrap();
    let (code, found) = text(&["prove", "--claim", "P2.1.3", "--out", out]);
    assert_eq!(code, 0);
    let rows: Vec<_> = found.lines().map(words).filter(|row| row.starts_with("P2.1.3")).collect();
    assert_eq!(
        rows,
        ["P2.1.3 printed refuted instance 1 point 0", "P2.1.3 amended proved knots 1 derived 0"]
    );
    assert!(
        found.ends_with(&format!(
            "Proved and checked: 2 certificates (derived 1, point 1, argued 0), in {out}\n"
        )),
        "{found}"
    );
    assert!(names(folder.path()).contains("gone.statement"), "nothing is deleted");
    let again = fs::read(folder.path().join("P2.1.3.printed.proof")).unwrap();
    assert!(again == fs::read(certs().join("P2.1.3.printed.proof")).unwrap(), "it is overwritten");
}

/// Where a claim is settled by cases only there is no certificate, and none is invented.
#[test]
fn what_is_not_stated_formally_has_no_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let (code, found) =
        run(&["prove", "--claim", "X.maxima.classical", "--out", folder.path().to_str().unwrap()]);
    assert_eq!(code, 0);
    let degrees = found["checked"].as_array().unwrap().iter().map(|one| one["degrees"].clone());
    assert_eq!(degrees.collect::<Vec<_>>(), [json!([1, 2, 3])]);
    assert_eq!(names(folder.path()).len(), 2);
}

#[test]
fn an_unknown_claim_is_not_proved() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let message =
        refused(&mut knotproof(&["prove", "--claim", "T3.5", "--out", out.to_str().unwrap()]), "--claim");
    assert_eq!(message, "--claim: there is no claim `T3.5`; there are T3.5.1, T3.5.2, T3.5.3, T3.5.4");
    assert!(!out.exists(), "nothing is made for a request that is refused");
}

#[test]
fn a_folder_that_cannot_be_written_is_refused_at_once() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let path = file.path().to_str().unwrap();
    let message = refused(&mut knotproof(&["prove", "--claim", "P2.1.3", "--out", path]), "--out");
    assert!(message.starts_with(&format!("--out: cannot write {path}: ")), "{message}");
    // A folder has the name of a file to be written.
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("P2.1.3.printed.proof")).unwrap();
    let out = folder.path().to_str().unwrap();
    let message = refused(&mut knotproof(&["prove", "--claim", "P2.1.3", "--out", out]), "--out");
    assert!(message.contains("cannot write") && message.contains("P2.1.3.printed.proof"), "{message}");
}

// verify

const SOME: [&str; 3] = ["P3.3.2.amended", "T3.5.1.printed", "X.G1.degrees"];

#[test]
fn a_folder_of_certificates_is_checked_in_the_order_of_the_names() {
    let folder = copies(&SOME);
    let path = folder.path().to_str().unwrap();
    let (code, found) = run(&["verify", "--foreign", path]);
    assert_eq!((code, &found["schema"], &found["missing"]), (0, &json!("knotproof.verify/1"), &json!([])));
    assert_eq!((&found["rejected"], &found["unknown"]), (&json!([]), &json!([])));
    let expected = json!([
        {"claim": "P3.3.2", "form": "amended", "verdict": "proved", "scope": "knots",
            "degrees": [0, 1, 2, 3, 4, 5, 6, 7, 8], "sections": 18, "steps": 90, "shown": "derived", "any_weights": false},
        {"claim": "T3.5.1", "form": "printed", "verdict": "refuted", "scope": "instance", "degrees": [1],
            "sections": 0, "steps": 0, "shown": "point", "any_weights": false},
        {"claim": "X.G1", "form": "degrees", "verdict": "proved", "scope": "knots", "degrees": [2],
            "sections": 1, "steps": 5, "shown": "argued", "any_weights": false},
    ]);
    assert_eq!(found["checked"], expected);
    let (code, found) = text(&["verify", "--foreign", path]);
    assert_eq!(code, 0);
    assert!(found.lines().any(|row| words(row) == "X.G1 degrees proved knots 2 argued 5"), "{found}");
    assert!(found.ends_with("Accepted: 3 (derived 1, point 1, argued 1); rejected: 0\n"), "{found}");
}

/// With no path it is the folder of the recorded ones, below the current folder.
#[test]
fn all_recorded_certificates_are_accepted_and_known() {
    let root = env!("CARGO_MANIFEST_DIR");
    let output = knotproof(&["verify", "--format", "json"]).current_dir(root).assert().code(0).stderr("");
    let found: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    assert_eq!(found["checked"].as_array().unwrap().len() * 2, names(&certs()).len());
    assert_eq!((&found["rejected"], &found["unknown"]), (&json!([]), &json!([])));
    assert_eq!(found["missing"], json!([]));

    let elsewhere = tempfile::tempdir().unwrap();
    let message = refused(knotproof(&["verify"]).current_dir(elsewhere.path()), "PATH");
    for part in ["no folder proofs/certs here", "knotproof prove --out DIR", "knotproof verify DIR"] {
        assert!(message.contains(part), "{message}");
    }
}

/// A folder is a set: whatever is recorded as certified has its certificate there.
#[test]
fn a_certificate_that_is_missing_in_a_folder_is_an_error() {
    let folder = copies(&["P2.1.3.printed", "P2.1.3.amended", "T3.5.1.printed"]);
    let path = folder.path().to_str().unwrap();
    let missing = |arguments: &[&str]| {
        let (code, found) = run(&[&["verify", path], arguments].concat());
        assert_eq!((&found["rejected"], &found["unknown"]), (&json!([]), &json!([])), "{arguments:?}");
        let names = found["missing"].as_array().unwrap().iter();
        (code, names.map(|name| name.as_str().unwrap().to_owned()).collect::<Vec<_>>())
    };
    let recorded = names(&certs()).len() / 2;
    let (code, found) = missing(&[]);
    assert_eq!((code, found.len()), (1, recorded - 3));
    // As `prove --claim` writes them.
    assert_eq!(missing(&["--claim", "P2.1.3"]), (0, vec![]));
    assert_eq!(missing(&["--claim", "P2.1.3", "--claim", "T3.5.1"]), (1, vec!["T3.5.1.amended".to_owned()]));
    assert_eq!(missing(&["--foreign"]), (0, vec![]));
    // The same statement in a file of another name is there; another statement in a file of this name is not.
    for extension in ["statement", "proof"] {
        let file = |name: &str| folder.path().join(format!("{name}.{extension}"));
        fs::rename(file("P2.1.3.amended"), file("other")).unwrap();
        fs::copy(file("T3.5.1.printed"), file("P2.1.3.printed")).unwrap();
    }
    assert_eq!(missing(&["--claim", "P2.1.3"]), (1, vec!["P2.1.3.printed".to_owned()]));
    let (code, found) = text(&["verify", "--claim", "P2.1.3", path]);
    assert_eq!(code, 1);
    assert!(
        found.contains("Missing, though the claim is recorded as certified: P2.1.3.printed\n"),
        "{found}"
    );
    // Single files are no set.
    let file = folder.path().join("other.statement");
    assert_eq!(run(&["verify", file.to_str().unwrap()]).0, 0);
    refused(&mut knotproof(&["verify", path, "--claim", "P2.1"]), "--claim");
}

#[test]
fn single_files_and_folders_can_be_mixed() {
    let (folder, other) = (copies(&SOME[..1]), copies(&SOME));
    let file = other.path().join("T3.5.1.printed.statement");
    let paths = [file.to_str().unwrap(), folder.path().to_str().unwrap()];
    let (code, found) = run(&["verify", "--foreign", paths[0], paths[1]]);
    let claims: Vec<_> =
        found["checked"].as_array().unwrap().iter().map(|checked| &checked["claim"]).collect();
    assert_eq!((code, claims), (0, vec![&json!("T3.5.1"), &json!("P3.3.2")]));
}

#[test]
fn a_damaged_proof_is_rejected_with_section_goal_and_rule() {
    let folder = copies(&SOME);
    let path = |name: &str| folder.path().join(name);
    let damages = [
        ("(goal 1 (by (weights 1)))", "(goal 1 (orders))", "section 1, goal 1, rule orders: "),
        ("(goal 2 (by", "(goal 3 (by", "section 3, goal 2, rule by: "),
        ("(section 2", "(section 3", "section 2: "),
        ("(section 9\n", "(section 9\n(lemma 1 (= 0 1) (by))", "section 9, lemma 1, rule by: "),
        ("(proof 1", "(proof 2", "proof: "),
        ("(weights 1)", "(weights x)", "section 1, goal 1, rule by: "),
    ];
    for (number, (part, instead, _)) in damages.iter().enumerate() {
        for extension in ["statement", "proof"] {
            let copy = path(&format!("Z{number}.{extension}"));
            fs::copy(path(&format!("P3.3.2.amended.{extension}")), copy).unwrap();
        }
        edit(&path(&format!("Z{number}.proof")), part, instead);
    }
    let (code, found) = run(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!((code, found["checked"].as_array().unwrap().len()), (1, 3), "the others are checked");
    let rejected = found["rejected"].as_array().unwrap();
    assert_eq!(rejected.len(), damages.len());
    let (code, found) = text(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!(code, 1);
    for (number, (rejected, (_, instead, reason))) in rejected.iter().zip(damages).enumerate() {
        let file = path(&format!("Z{number}.statement"));
        let said = rejected["reason"].as_str().unwrap();
        assert_eq!(rejected["file"], json!(file));
        assert!(said.starts_with(reason), "{instead}: {said}");
        assert!(found.contains(&format!("Rejected: {}: {said}\n", file.display())), "{found}");
    }
    assert!(found.ends_with("Accepted: 3 (derived 1, point 1, argued 1); rejected: 6\n"), "{found}");
}

#[test]
fn a_false_statement_is_rejected() {
    let folder = copies(&SOME);
    edit(&folder.path().join("P3.3.2.amended.statement"), "(- k i)", "i");
    let (code, found) = run(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!(code, 1);
    let reason = found["rejected"][0]["reason"].as_str().unwrap();
    assert!(reason.starts_with("section 3, goal 1, rule by: "), "{reason}");
}

/// What is proved need not be the claim: the program says whether it knows the statement.
#[test]
fn a_statement_that_is_true_and_not_the_program_s_is_an_error_unless_it_is_allowed() {
    let folder = copies(&SOME);
    let path = |name: &str| folder.path().join(name);
    // Another claim, another form, a sentence that says less; another verdict, another reach, another reason.
    let changes = [
        ("P3.3.2.amended", "(claim \"P3.3.2\")", "(claim \"P3.3.1\")"),
        ("P3.3.2.amended", "(form amended)", "(form printed)"),
        ("P3.3.2.amended", "(degree 0)", "(degree 0 8)"),
        ("X.G1.degrees", "(verdict proved)", "(verdict refuted)"),
        ("X.G1.degrees", "(scope knots)", "(scope alpha)"),
        ("X.G1.degrees", "(because\n    \"", "(because\n    \"Trust me. "),
    ];
    for (number, (name, part, instead)) in changes.iter().enumerate() {
        for extension in ["statement", "proof"] {
            fs::copy(path(&format!("{name}.{extension}")), path(&format!("Z{number}.{extension}"))).unwrap();
        }
        edit(&path(&format!("Z{number}.statement")), part, instead);
    }
    let unknown: Vec<_> = (0..changes.len()).map(|number| path(&format!("Z{number}.statement"))).collect();
    let (code, found) = run(&["verify", "--foreign", folder.path().to_str().unwrap()]);
    assert_eq!((code, &found["rejected"], &found["unknown"]), (0, &json!([]), &json!(unknown)));
    // One of them alone is enough.
    assert_eq!(run(&["verify", unknown[0].to_str().unwrap()]).0, 1);
    assert_eq!(run(&["verify", unknown[0].to_str().unwrap(), "--foreign"]).0, 0);
    assert_eq!(found["checked"].as_array().unwrap().len(), SOME.len() + changes.len(), "they are accepted");
    let (code, found) = text(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!(code, 1);
    for path in unknown {
        let line =
            format!("Accepted, but not the program's own statement of the claim: {}\n", path.display());
        assert!(found.contains(&line), "{found}");
    }
}

/// White space means nothing: the statement is the same.
#[test]
fn a_statement_laid_out_in_another_way_is_known() {
    let folder = copies(&SOME);
    let path = folder.path().join("X.G1.degrees.statement");
    let old = fs::read_to_string(&path).unwrap();
    fs::write(&path, old.replace("\n", "\r\n\t")).unwrap();
    let (code, found) = run(&["verify", path.to_str().unwrap()]);
    assert_eq!((code, &found["unknown"], &found["rejected"]), (0, &json!([]), &json!([])));
}

/// The program and the checker's own program give the same answer to whatever the bytes of a file are: accepted as the
/// program's own statement, or rejected for the same reason, or not read at all.
#[test]
fn both_readers_agree_on_odd_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let good = fs::read(certs().join("abstract.bezier.points.printed.statement")).unwrap();
    let text = String::from_utf8(good.clone()).unwrap();
    let proof = fs::read(certs().join("abstract.bezier.points.printed.proof")).unwrap();
    let changed = |part: &str, instead: &str| {
        assert!(text.contains(part), "{part}");
        text.replacen(part, instead, 1).into_bytes()
    };
    let with = |before: &[u8], after: &[u8]| [before, &good, after].concat();
    let nested = |depth: usize| ("(- ".repeat(depth) + "u" + &")".repeat(depth)).into_bytes();
    let table: Vec<(&str, Vec<u8>, i32, &str)> = vec![
        ("as it is", good.clone(), 0, ""),
        ("CRLF", text.replace('\n', "\r\n").into_bytes(), 0, ""),
        ("CR alone", text.replace('\n', "\r").into_bytes(), 0, ""),
        ("tabs", text.replace(' ', "\t").replace("\t", " \t").into_bytes(), 1, "a string of visible"),
        ("tabs between tokens", changed("(claim ", "(claim\t\t"), 0, ""),
        ("line ends before and after", with(b"\n\r\n \t", b"\n\n \t\r"), 0, ""),
        ("byte order mark", with(b"\xef\xbb\xbf", b""), 1, "no byte order mark"),
        ("byte order mark inside", changed("(claim ", "(claim \u{feff} "), 1, "expected a string, a name or"),
        ("byte order mark after", with(b"", b"\xef\xbb\xbf"), 1, "expected a string, a name or"),
        ("UTF-16", [b"\xff\xfe(\0".as_slice()].concat(), 2, "byte 0 is not UTF-8 text"),
        ("no UTF-8", with(b"", b"\xff"), 2, "is not UTF-8 text"),
        ("a surrogate", with(b"", b"\xed\xa0\x80"), 2, "is not UTF-8 text"),
        ("NUL after", with(b"", b"\0"), 1, "expected"),
        ("NUL in a name", changed("printed", "pri\0nted"), 1, "expected"),
        ("NUL in a text", changed("(because\n    \"", "(because\n    \"\0"), 1, "a string of visible"),
        ("escape code", changed("(because\n    \"", "(because\n    \"\u{1b}[31m"), 1, "a string of visible"),
        ("C1 control", changed("(because\n    \"", "(because\n    \"\u{9b}31m"), 1, "a string of visible"),
        ("line end in a text", changed("(because\n    \"", "(because\n    \"\n"), 1, "a string of visible"),
        ("right to left", changed("(because\n    \"", "(because\n    \"\u{202e}"), 1, "a string of visible"),
        ("isolate", changed("(because\n    \"", "(because\n    \"\u{2067}"), 1, "a string of visible"),
        ("no width", changed("(because\n    \"", "(because\n    \"\u{200b}"), 1, "a string of visible"),
        ("line separator", changed("(because\n    \"", "(because\n    \"\u{2028}"), 1, "a string of visible"),
        ("backslash", changed("(because\n    \"", "(because\n    \"\\"), 1, "a string of visible"),
        (
            "look-alike",
            changed("\"abstract.bezier.points\"", "\"\u{430}bstract.bezier.points\""),
            1,
            "the name of a claim",
        ),
        (
            "claim in two lines",
            changed("\"abstract.bezier.points\"", "\"abstract.bezier.points\n\""),
            1,
            "a string of visible",
        ),
        (
            "claim with more",
            changed("\"abstract.bezier.points\"", "\"abstract.bezier.points (printed): proved\""),
            1,
            "the name of a claim",
        ),
        ("wide space", changed("(claim ", "(claim\u{3000}"), 1, "expected"),
        ("no-break space", changed("(claim ", "(claim\u{a0}"), 1, "expected"),
        ("form feed", changed("(claim ", "(claim\u{c}"), 1, "expected"),
        ("next line", changed("(claim ", "(claim\u{85}"), 1, "expected"),
        ("comment", with(b"; a comment\n", b""), 1, "expected"),
        ("comment after", with(b"", b"# a comment\n"), 1, "expected"),
        ("two statements", with(&good, b""), 1, "expected one bracket"),
        ("a bracket too many", with(b"", b")"), 1, "expected an opening bracket"),
        ("a bracket too few", good[..good.len() - 3].to_vec(), 1, "expected a closing bracket"),
        ("a quote open", with(b"", b"\""), 1, "a string of visible"),
        ("no space before a string", changed("(claim \"", "(claim x\""), 1, "expected white space"),
        ("no space between numbers", changed("(degrees 1)", "(degrees 1\"2\")"), 1, "expected white space"),
        ("zeros", changed("(degrees 1)", "(degrees 01)"), 1, "expected a string, a name or"),
        ("not in lowest terms", changed("(degrees 1)", "(degrees 2/2)"), 1, "expected a string, a name or"),
        (
            "a digit of another script",
            changed("(degrees 1)", "(degrees \u{661})"),
            1,
            "expected a string, a name",
        ),
        ("minus sign", changed("(degrees 1)", "(degrees \u{2212}1)"), 1, "expected a string, a name or"),
        (
            "a long number",
            changed("(degrees 1)", &format!("(degrees {})", "1".repeat(1_001))),
            1,
            "lowest terms",
        ),
        ("nothing", vec![], 1, "expected one bracket"),
        ("white space", b" \r\n\t".to_vec(), 1, "expected one bracket"),
        ("deep", nested(81), 1, "the nesting is beyond the limits"),
        ("very deep", nested(200_000), 1, "the nesting is beyond the limits"),
        ("open for ever", vec![b'('; 1_000_000], 1, "the nesting is beyond the limits"),
        ("long", vec![b' '; 4_000_001], 2, "it is longer than 4000000 bytes"),
    ];
    let path = |name: &str, extension: &str| folder.path().join(format!("{name}.{extension}"));
    for (name, bytes, code, reason) in &table {
        fs::write(path(name, "statement"), bytes).unwrap();
        fs::write(path(name, "proof"), &proof).unwrap();
        let (statement, own) = (path(name, "statement"), Sexp::parse_all(&String::from_utf8_lossy(bytes)));
        let read = knotproof_checker::read(&statement);
        let found = match &read {
            Err(error) => (2, error.to_string()),
            Ok(text) => {
                let checked = knotproof_checker::check(text, &String::from_utf8_lossy(&proof));
                checked.map_or_else(|rejected| (1, rejected.to_string()), |_| (0, String::new()))
            }
        };
        assert!(found.0 == *code && found.1.contains(reason), "{name}: {found:?}");
        // What this package reads is read alike: a token that is none there is none here.
        let of_tokens = reason.contains("name of a claim");
        let one = own.is_ok_and(|items| items.len() == 1);
        assert!(*code == 2 || one == (*code == 0 || of_tokens), "{name}");
        let output = knotproof(&["verify", statement.to_str().unwrap()]).output().unwrap();
        assert_eq!(output.status.code(), Some(*code), "{name}");
        let said = [output.stdout, output.stderr].concat();
        assert!(String::from_utf8(said).unwrap().contains(reason), "{name}");
    }
    // All in one call, on worker threads.
    table.iter().filter(|row| row.2 == 2).for_each(|row| fs::remove_file(path(row.0, "statement")).unwrap());
    let (code, found) = run(&["verify", "--foreign", folder.path().to_str().unwrap()]);
    assert_eq!((code, &found["unknown"]), (1, &json!([])));
    let count = |field: &str| found[field].as_array().unwrap().len();
    let with_code = |code: i32| table.iter().filter(|row| row.2 == code).count();
    assert_eq!((count("checked"), count("rejected")), (with_code(0), with_code(1)));
}

/// A name of a file can hold anything: what a terminal would obey is shown and not done.
#[cfg(unix)]
#[test]
fn names_of_files_are_shown_and_not_obeyed() {
    let folder = copies(&SOME[..1]);
    let odd = folder.path().join("a\u{1b}[31m\nRejected: \u{202e}b.statement");
    fs::write(&odd, "(").unwrap();
    fs::write(odd.with_extension("proof"), "(").unwrap();
    let (code, found) = text(&["verify", "--foreign", folder.path().to_str().unwrap()]);
    assert_eq!(code, 1);
    assert!(found.contains(r"a\u{1b}[31m\u{a}Rejected: \u{202e}b.statement: statement: line 1: "), "{found}");
}

#[test]
fn what_is_no_certificate_is_refused() {
    let folder = copies(&SOME);
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let refusal = |path: &str| refused(&mut knotproof(&["verify", path]), "PATH");
    // The proof is not there.
    fs::remove_file(at("T3.5.1.printed.proof")).unwrap();
    let message = refusal(folder.path().to_str().unwrap());
    assert!(message.contains("cannot read") && message.contains("T3.5.1.printed.proof"), "{message}");
    // No statement, no certificate, nothing, no text.
    let message = refusal(&at("P3.3.2.amended.proof"));
    assert!(message.contains("is no certificate: give files NAME.statement"), "{message}");
    assert!(refusal(&at("none.statement")).contains("cannot read"));
    let empty = tempfile::tempdir().unwrap();
    assert!(refusal(empty.path().to_str().unwrap()).contains("is no certificate"));
    fs::write(at("X.G1.degrees.proof"), b"(proof \xff").unwrap();
    assert!(refusal(&at("X.G1.degrees.statement")).contains("byte 7 is not UTF-8"));
}

/// Nothing of what stands in a file breaks the program.
#[test]
fn nonsense_is_rejected() {
    let folder = tempfile::tempdir().unwrap();
    let good = fs::read_to_string(certs().join("P3.3.2.amended.statement")).unwrap();
    let deep = "(".repeat(100_000);
    let statements = [
        "",
        "(",
        ")",
        "\"",
        "statement",
        "()",
        "(statement 1)",
        "(statement 1/0)",
        "(proof 1)",
        "é",
        &deep,
        &good,
    ];
    let proofs = ["", "(", "(proof 1)", &deep];
    for (i, statement) in statements.iter().enumerate() {
        for (j, proof) in proofs.iter().enumerate() {
            let path = folder.path().join(format!("{i}.{j}.statement"));
            fs::write(&path, statement).unwrap();
            fs::write(path.with_extension("proof"), proof).unwrap();
        }
    }
    let (code, found) = run(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!((code, &found["checked"]), (1, &json!([])));
    assert_eq!(found["rejected"].as_array().unwrap().len(), statements.len() * proofs.len());
}

// explain

/// Outside of a clone there are no files to cite, but a way to write them.
#[test]
fn a_certificate_that_is_not_here_is_not_cited_as_a_file() {
    let elsewhere = tempfile::tempdir().unwrap();
    let output = knotproof(&["explain", "T3.5.3"]).current_dir(elsewhere.path()).assert().code(0);
    let found = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    assert!(!found.contains("proofs/certs"), "{found}");
    for form in ["printed", "amended"] {
        let line = format!(
            "  certificate: T3.5.3.{form}, checked by engine, prover, checker; no file of it is here:\n"
        );
        assert!(found.contains(&line), "{found}");
    }
    assert_eq!(found.matches("    knotproof prove --claim T3.5.3 --out DIR writes it\n").count(), 2);
}

#[test]
fn a_proved_claim_is_explained() {
    let (code, found) = text(&["explain", "T3.5.2"]);
    assert_eq!(code, 0);
    for part in [
        "T3.5.2 (Theorem 3.5 (2)): Positivity\n",
        "As printed: proved (degree, for every k, any weights)\n",
        "  For every U, every 0 ≤ i ≤ n and t_i < x < t_{i+k+1}: G_i^k(x) > 0.\n",
        "  why: Windows and goals follow from the sentence",
        "  theorem: true for every k: T3_5_2_printed in proofs/theory/StatementsBasis.v, printed from the stanza\n",
        "  certificate: proofs/certs/T3.5.2.printed.statement and .proof; checked by engine, prover, checker\n",
    ] {
        assert!(found.contains(part), "{part} in {found}");
    }
    assert!(!found.contains("goals:") && !found.contains("As amended"), "{found}");
    let (_, found) = text(&["explain", "T3.5.2", "--goals"]);
    assert!(found.contains("  goals: (section (window W 0 some) (goals (> (G 0 0 (in W 0)) 0)))"), "{found}");
}

#[test]
fn a_refuted_claim_is_explained_with_witness_and_amendment() {
    let (code, found) = text(&["explain", "T3.5.3"]);
    assert_eq!(code, 0, "a claim that is refuted is explained all the same");
    let place = |part: &str| found.find(part).unwrap_or_else(|| panic!("{part} in {found}"));
    let parts = [
        "T3.5.3 (Theorem 3.5 (3)): Partition of unity\n",
        "As printed: refuted (slip)\n",
        "  For every U, every 0 ≤ j ≤ m − 1 and every x in [t_j, t_{j+1}): Σ_{i=0}^n G_i^k(x) = Σ_{i=j−k}^j G_i^k(x) = 1.\n",
        "  witness: k = 1, U = (0, 0, 1, 2), α = -1, j = 2, x = 3/2: the claim says Σ_{i=0}^1 G_i^1(3/2) = Σ_{i=1}^2 G_i^1(3/2) = 1, but Σ_{i=0}^1 G_i^1(3/2) = 2/3, Σ_{i=1}^2 G_i^1(3/2) does not exist\n",
        "  again: knotproof eval --degree 1 --knots 0,0,1,2 --alpha -1 --x 3/2\n",
        "  why: At these numbers all hypotheses are true",
        "  certificate: proofs/certs/T3.5.3.printed.statement",
        "As amended: proved (degree, for every k, any weights)\n",
        "  For every U, every k ≤ j ≤ n and every x in [t_j, t_{j+1}): ",
        "  certificate: proofs/certs/T3.5.3.amended.statement",
        "Note: ",
    ];
    assert!(parts.map(place).is_sorted(), "{found}");
    assert_eq!(found.matches("certificate: ").count(), 2);
}

#[test]
fn a_question_is_explained_degree_by_degree() {
    let (_, found) = text(&["explain", "X.totalpositivity"]);
    for part in [
        "X.totalpositivity (not in the paper): ",
        "As printed: refuted (serious)\n",
        "Degree 1: proved (knots, for k = 1)\n",
        "Degree 2: proved (knots, for k = 2)\n",
        "Degree 3: refuted\n",
        "proofs/certs/X.totalpositivity.printed.statement",
    ] {
        assert!(found.contains(part), "{part} in {found}");
    }
    let (_, json) = run(&["explain", "X.totalpositivity", "--goals"]);
    let parts = json["parts"].as_array().unwrap();
    assert_eq!((&parts[0]["of"], &parts[2]["of"]), (&json!("as printed"), &json!("degree 2")));
    assert!(parts[3]["goals"].as_str().unwrap().contains("(columns 1 2 3)"), "the witness as a point");
    assert!(parts[1]["goals"].as_str().unwrap().contains("(> (det"));
}

#[test]
fn an_illustration_is_explained() {
    let (_, found) = text(&["explain", "Ill5.1.fig7"]);
    for part in [
        "Ill5.1.fig7 (Illustration 5.1, Fig. 7): ",
        "  witness: instance = U0, k = 3, ",
        "As amended: proved (alpha, for k = 3)\n",
        "  why: It follows from the order of the knots, or of the numbers, at every place of x",
        "proofs/certs/Ill5.1.fig7.amended.statement",
        "Note: The figure misleads",
    ] {
        assert!(found.contains(part), "{part} in {found}");
    }
}

/// What is decided by cases only says so: there is no certificate, and no goals to show.
#[test]
fn what_has_no_certificate_is_explained_without_one() {
    let (_, found) = text(&["explain", "X.maxima.classical", "--goals"]);
    let (formal, by_cases) = found.split_once("\nDegree 4: proved (instance, for k = 4)\n").unwrap();
    for word in ["certificate:", "why:", "goals:"] {
        assert!(formal.contains(word) && !by_cases.contains(word), "{word}: {found}");
    }
}

/// Every claim, with all that is recorded of it.
#[test]
fn every_claim_is_explained_as_json() {
    let recorded = Baseline::recorded().unwrap();
    for entry in &recorded.claims {
        let (code, found) = run(&["explain", &entry.id, "--goals"]);
        assert_eq!((code, &found["schema"]), (0, &json!("knotproof.explain/1")));
        assert_eq!((&found["id"], &found["locator"]), (&json!(entry.id), &json!(entry.locator)));
        let printed = ("as printed".to_owned(), &entry.as_printed);
        let amended = entry.amended.iter().map(|finding| ("as amended".to_owned(), finding));
        let degrees = entry.by_degree.iter().map(|of| (format!("degree {}", of.degree), &of.finding));
        let expected: Vec<_> = [printed].into_iter().chain(amended).chain(degrees).collect();
        let parts = found["parts"].as_array().unwrap();
        assert_eq!(parts.len(), expected.len(), "{}", entry.id);
        for (part, (of, finding)) in parts.iter().zip(expected) {
            assert_eq!((&part["of"], &part["status"]), (&json!(of), &json!(finding.status)), "{}", entry.id);
            assert!(!part["statement"].as_str().unwrap().is_empty());
            for (name, value) in serde_json::to_value(finding).unwrap().as_object().unwrap() {
                assert_eq!(&part[name], value, "{}, {of}: {name}", entry.id);
            }
            // The order of knots may be enough, and no goal is left.
            let said = |name: &str| part.get(name).is_some_and(|text| !text.as_str().unwrap().is_empty());
            let certified = finding.certificate.is_some();
            assert_eq!(
                (said("idea"), part.get("goals").is_some()),
                (certified, certified),
                "{}, {of}",
                entry.id
            );
        }
    }
    let (_, found) = run(&["explain", "T3.5.2"]);
    assert!(found["parts"][0].get("goals").is_none() && found["parts"][0]["idea"].is_string());
}

#[test]
fn an_unknown_claim_is_not_explained() {
    let refusal = |name: &str| refused(&mut knotproof(&["explain", name]), "CLAIM");
    assert_eq!(refusal("L3.1"), "CLAIM: there is no claim `L3.1`; there are L3.10");
    assert!(refusal("t3.5").ends_with("there are T3.5.1, T3.5.2, T3.5.3, T3.5.4"));
    assert!(refusal("").contains("phi.range"), "all of them");
    knotproof(&["explain"]).assert().code(2).stdout("");
}

// All three

#[test]
fn help_has_an_example() {
    for command in ["prove", "verify", "explain"] {
        let (code, help) = text(&[command, "--help"]);
        assert_eq!(code, 0);
        assert!(help.contains("Examples:") && help.contains(&format!("  knotproof {command}")), "{help}");
    }
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = copies(&SOME);
    let path = folder.path().to_str().unwrap();
    for arguments in [
        &["explain", "X.G1", "--goals"][..],
        &["verify", "--foreign", path],
        &["prove", "--claim", "P2.1.3", "--out", path],
    ] {
        for format in ["text", "json"] {
            let mut child = crate::process()
                .args(arguments)
                .args(["--format", format])
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            // The reader leaves before anything is written.
            drop(child.stdout.take());
            let output = child.wait_with_output().unwrap();
            assert_eq!(
                (output.status.code(), output.stderr.as_slice()),
                (Some(0), &b""[..]),
                "{arguments:?} {format}"
            );
        }
    }
}
