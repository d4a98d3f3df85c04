//! What the GitHub Action runs: papers that are as they should be pass, and of others it says which claim is not.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Exit code, standard output and standard error of the script, as on GitHub.
fn judged(place: &Path) -> (i32, String, String) {
    let program = Path::new(crate::PATH).parent().unwrap();
    let output = Command::new("bash")
        .args([&format!("{ROOT}/action/judge.sh"), "papers", "pages"])
        .current_dir(place)
        .env("PATH", format!("{}:{}", program.display(), std::env::var("PATH").unwrap()))
        .env("GITHUB_ACTIONS", "true")
        .output()
        .unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), stdout, stderr)
}

/// Runs a command; the claims of a new paper are not all true, so `judge` ends with exit code 1.
fn run(place: &Path, arguments: &[&str]) {
    let code = i32::from(arguments[0] == "judge");
    crate::program().args(arguments).current_dir(place).assert().code(code);
}

#[test]
fn papers_are_held_against_what_is_recorded() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    let (code, _, stderr) = judged(place);
    assert_eq!(code, 2, "{stderr}");

    fs::create_dir(place.join("papers")).unwrap();
    run(place, &["new", "papers/deep/mine"]);
    // Nothing is recorded, and P2 is false as it is printed.
    let (code, stdout, stderr) = judged(place);
    assert_eq!(code, 1, "{stdout}{stderr}");
    assert!(stderr.contains("\nP2: k = 1, U = (0, 0, 1, 2), α = -1, x = 3/2: the claim says"), "{stderr}");
    let record = "knotproof judge papers/deep/mine --record papers/deep/mine/verdicts.json";
    assert!(stderr.contains(&format!("If that is right: {record}")), "{stderr}");

    run(place, &record.split(' ').skip(1).collect::<Vec<_>>());
    let (code, stdout, stderr) = judged(place);
    assert_eq!((code, &*stderr), (0, ""), "{stdout}");
    assert!(stdout.ends_with("1 of 1 papers are as they should be; their pages: pages\n"), "{stdout}");
    assert!(stdout.contains("Every verdict is as recorded.") && !stdout.contains("::error::"), "{stdout}");
    let page = fs::read_to_string(place.join("pages/deep/mine/index.html")).unwrap();
    assert!(page.contains("Differences"), "the page says with what it was compared");

    // The sentence becomes another one, and so does its verdict.
    let claims = place.join("papers/deep/mine/claims/01-basis.toml");
    let text = fs::read_to_string(&claims).unwrap();
    fs::write(&claims, text.replace("G[i](x) > 0", "G[i](x) > 1")).unwrap();
    let (code, stdout, stderr) = judged(place);
    assert_eq!(code, 1, "{stdout}{stderr}");
    assert!(stderr.contains("papers/deep/mine: Not as recorded: 1\n  P1, as printed:\n"), "{stderr}");
    assert!(
        stdout.contains("::error::papers/deep/mine: Not as recorded: 1%0A  P1, as printed:%0A"),
        "{stdout}"
    );

    // One that is not in order stops none of the others.
    fs::write(place.join("papers/deep/mine/paper.toml"), "title = 1").unwrap();
    run(place, &["new", "papers/a"]);
    let (code, stdout, stderr) = judged(place);
    assert_eq!(code, 1, "{stdout}{stderr}");
    assert!(stderr.contains("papers/deep/mine: error: FOLDER: papers/deep/mine/paper.toml"), "{stderr}");
    assert!(stdout.contains("0 of 2 papers"), "{stdout}");
    assert!(place.join("pages/a/index.html").exists());
}

/// What is recorded by hand, and wrong, is found as well.
#[test]
fn a_wrong_record_is_told_with_its_claim() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    fs::create_dir(place.join("papers")).unwrap();
    run(place, &["new", "papers/mine"]);
    run(place, &["judge", "papers/mine", "--record", "papers/mine/verdicts.json"]);
    let path = place.join("papers/mine/verdicts.json");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"refuted\"", "\"proved\"")).unwrap();
    let (code, stdout, stderr) = judged(place);
    assert_eq!(code, 1, "{stdout}{stderr}");
    assert!(stderr.contains("Not as recorded: 1\n  P2, as printed:\n    recorded: proved"), "{stderr}");
    assert!(stderr.contains("\n    found:    refuted: k = 1, "), "{stderr}");
}

/// The action calls what is there.
#[test]
fn the_action_runs_the_script() {
    let action = fs::read_to_string(format!("{ROOT}/action.yml")).unwrap();
    let calls: Vec<_> = action.split("$GITHUB_ACTION_PATH/").skip(1).collect();
    assert_eq!(calls.len(), 1);
    let script = calls[0].split('"').next().unwrap();
    assert!(Path::new(ROOT).join(script).exists(), "{script}");
    let steps = ["cargo install --locked", "actions/upload-artifact@", "inputs.papers", "inputs.out"];
    assert!(steps.iter().all(|step| action.contains(step)));
}
