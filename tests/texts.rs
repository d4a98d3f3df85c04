//! What people read: the text of every command, with its exit code, next to a snapshot in `tests/snapshots` that somebody
//! has read and compared with other sources. After a change that is meant,
//!
//! ```sh
//! INSTA_UPDATE=always cargo test --test suite texts::
//! ```
//!
//! writes the snapshots anew; then `git diff tests/snapshots` is there to be read, number by number.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use std::fmt::Write;
use std::fs;
use std::path::Path;

use insta::{Settings, assert_snapshot};

/// The arguments as a shell would split them: at spaces, but not between double quotes.
fn arguments(line: &str) -> Vec<String> {
    let quoted = line.split('"').enumerate();
    let parts = quoted.flat_map(|(at, part)| match at % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    parts.collect()
}

/// A session in a folder: each line as it is typed, and what comes of it on the two streams and as the exit code.
/// Nothing of it depends on the terminal.
fn session_in(folder: &Path, lines: &[&str]) -> String {
    let mut session = String::new();
    for line in lines {
        let mut command = crate::program();
        command.args(arguments(line)).current_dir(folder).env_clear();
        command.env("NO_COLOR", "1").env("KNOTPROOF_PROGRESS", "never");
        let output = command.output().unwrap();
        writeln!(session, "$ knotproof {line}").unwrap();
        session += &String::from_utf8(output.stdout).unwrap();
        let messages = String::from_utf8(output.stderr).unwrap();
        messages.lines().for_each(|message| writeln!(session, "[stderr] {message}").unwrap());
        writeln!(session, "[exit code {}]\n", output.status.code().unwrap()).unwrap();
    }
    session
}

fn session(lines: &[&str]) -> String {
    session_in(tempfile::tempdir().unwrap().path(), lines)
}

/// Compares with the snapshot of that name.
fn reads(name: &str, text: &str) {
    let mut settings = Settings::clone_current();
    settings.set_omit_expression(true);
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| assert_snapshot!(name, text));
}

/// The first lines of what a command prints.
fn beginning(line: &str, count: usize) -> String {
    session(&[line]).lines().take(count).collect::<Vec<_>>().join("\n")
}

/// The first section of a page in Markdown whose heading begins like this, up to the next heading.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let from = page.find(&format!("\n{heading}")).unwrap() + 1;
    let end = page[from..].find("\n#").map_or(page.len(), |end| from + end);
    &page[from..end]
}

/// A corner at x = 1 and a jump, with limits from both sides; what is special about x; a curve.
#[test]
fn eval() {
    reads(
        "eval",
        &session(&[
            "eval --instance U4 --alpha -1 --x 1 --side left --derivatives 1",
            "eval --instance U4 --alpha -1 --x 1 --derivatives 1",
            "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --x 1/2 --points \"0,0 1,2 2,2 3,0\" --derivatives 1",
            "eval --degree 1 --knots \"0 0 1 1\" --alpha inf --x 1 --derivatives 1",
            "eval --degree 1 --knots \"0 0 1 1\" --alpha inf --x 0 --side left",
            "eval --degree 1 --knots \"0 0 1 1\" --alpha inf --x 7",
            "eval --degree 1 --knots \"0 1 3 4\" --alpha -1 --x 2/3 --points \"4 1\" --index 1 --digits 5",
        ]),
    );
}

#[test]
fn eval_at_the_points_of_a_file() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("points.csv"), "x,side\n1/2,\n1,left\n1,right\n2,\n").unwrap();
    let all =
        "eval --degree 2 --knots \"0 0 0 1 1 2 2 2\" --alpha 5 --derivatives 1 --points-file points.csv";
    let lines = [
        all,
        &format!("{all} --index 2"),
        &format!("{all} --index 2 --float"),
        &format!("{all} --points \"0,0 1,2 2,2 3,0 4,1\" --digits 4"),
    ];
    reads("eval_at_the_points_of_a_file", &session_in(folder.path(), &lines));
}

#[test]
fn formula() {
    let function = "formula --degree 2 --knots \"0 0 1 1 3\" --alpha -1 --index 1";
    reads(
        "formula",
        &session(&[
            function,
            &format!("{function} --expanded"),
            &format!("{function} --as latex"),
            &format!("{function} --as maxima"),
            &format!("{function} --as sympy"),
            "formula --degree 1 --knots \"0 1 3\" --alpha symbolic",
            "formula --degree 2 --knots \"0 0 1 1 2\" --alpha inf --expanded",
        ]),
    );
}

#[test]
fn formula_equals() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        (
            "equal",
            "G_0(x) := if 0 <= x and x < 1 then 2*x/(x + 1) elseif 1 <= x and x <= 3 then (3 - x)/(x + 1) else 0$",
        ),
        (
            "other",
            "G_0(x) := if 0 <= x and x < 1 then 2*x/(x + 1) elseif 1 <= x and x <= 3 then (3 - x)/(x + 2) else 0$",
        ),
        ("piece", "(3 - x)/(x + 1)"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let equals = |rest: &str| format!("formula --degree 1 --knots \"0 1 3\" --alpha 2 {rest}");
    reads(
        "formula_equals",
        &session_in(
            folder.path(),
            &[
                &equals("--equals equal"),
                &equals("--equals other"),
                &equals("--index 0 --span 1 --equals piece"),
                &equals("--index 0 --span 0 --equals piece"),
            ],
        ),
    );
}

#[test]
fn bezier() {
    let curve = "bezier --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --points \"0,0 1,2 2,2 3,0\"";
    reads("bezier", &session(&[curve, &format!("{curve} --digits 3"), &format!("{curve} --derivative")]));
}

/// One curve, and with jumps; in standard form with a λ that is rational and with one that is not; files for other programs.
#[test]
fn bezier_as_nurbs() {
    let curve = "bezier --degree 2 --knots \"0 0 0 1 2 2 2\" --points \"0,0 1,2 2,2 3,0\"";
    let jumps = "bezier --degree 1 --knots \"0 0 1 1 2 2\" --alpha -1 --points \"0,0 1,1 2,0 3,3\"";
    reads(
        "bezier_as_nurbs",
        &session(&[
            &format!("{curve} --alpha 5 --as nurbs"),
            &format!("{curve} --alpha 5 --as nurbs --standard-form"),
            &format!("{curve} --alpha inf --as nurbs"),
            &format!("{jumps} --as nurbs --standard-form"),
            &format!("{jumps} --as step"),
            &format!("{curve} --alpha inf --as geomdl --from 1"),
            "bezier --degree 2 --knots \"0 1 2 3 4 5\" --alpha inf --points \"1 4 2\" --as nurbs",
        ]),
    );
}

/// Corners, a jump and a knot without a tangent, several indices, a closed curve.
#[test]
fn joins() {
    let knots = "joins --degree 2 --knots \"0 0 0 1 1 2 2 2\" --alpha -1";
    reads(
        "joins",
        &session(&[
            "joins --instance C5 --alpha -4",
            "joins --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha inf --alpha 5 --points \"0,0 1,2 2,2 3,0\" --digits 5",
            &format!("{knots} --points \"0,0 4,2 4,2 6,3 8,4\""),
            &format!("{knots} --points \"0,0 4,0 4,2 4,2 4,2\""),
            "joins --degree 1 --knots \"0 0 1 1 2 3 3\" --alpha inf --points \"0,0 1,0 2,0 1,1 0,0\"",
            "joins --degree 1 --knots \"0 0 1 1\" --alpha 2 --points \"0 1\"",
        ]),
    );
}

#[test]
fn joins_of_all_curves() {
    reads("joins_of_all_curves", &beginning("joins --all", 24));
}

/// Crossings and touches, a whole interval, limits at a jump and a value that it passes, a line in the plane.
#[test]
fn solve() {
    let jumps = "solve --degree 1 --knots \"0 0 1 1 2 2\" --alpha 5 --points \"0 3 1 0\"";
    reads(
        "solve",
        &session(&[
            "solve --instance C5 --alpha -4 --coordinate 1 --value 4",
            "solve --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha inf --points \"0,0 1,2 2,2 3,0\" --normal \"1 1\" --value 3 --digits 20",
            &format!("{jumps} --value 3 --value 2 --value 1 --value 7"),
            "solve --degree 2 --knots \"0 0 0 1 1 1\" --alpha -1 --points \"1 -1 1\"",
            "solve --degree 0 --knots \"0 1 2 3\" --alpha -1 --points \"1 0 1\"",
        ]),
    );
}

/// Rational and irrational places, two of one height, a limit that is not taken, a constant.
#[test]
fn bounds() {
    reads(
        "bounds",
        &session(&[
            "bounds --instance C5 --alpha -4 --alpha inf",
            "bounds --degree 3 --knots \"0 0 0 0 1 2 3 3 3 3\" --alpha inf --points \"0 4 1 1 4 0\"",
            "bounds --degree 1 --knots \"0 0 1 1 2 2\" --alpha 5 --points \"0,7 3,7 1,7 0,7\" --digits 3",
            "bounds --instance C5 --alpha -4 --normal \"1 1\" --from 1 --to 2",
            "shape --instance C5 --alpha -4 --curve",
        ]),
    );
}

/// By the series, with a cusp, exactly.
#[test]
fn length() {
    reads(
        "length",
        &session(&[
            "length --instance C5 --alpha -4 --alpha inf",
            "length --degree 3 --knots \"0 0 0 0 1 1 1 1\" --alpha inf --points \"0,0 1,1 0,1 1,0\" --digits 6",
            "length --degree 1 --knots \"0 0 1 2 2\" --alpha 5 --points \"0,0 3,4 3,5\" --width 1e-30 --digits 25",
        ]),
    );
}

/// A curve, the matrix alone, a place outside of its support, too few places, places that fall.
#[test]
fn interpolate() {
    let on = "interpolate --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5";
    reads(
        "interpolate",
        &session(&[
            &format!("{on} --at \"0 1/2 3/2 2\" --points \"0,0 1,2 2,2 3,0\""),
            &format!("{on} --at \"0 1/2 1\""),
            &format!("{on} --at \"0 1/4 1/2 3/4\" --points \"0 1 2 3\""),
            &format!("{on} --at \"0 1/2 2\" --points \"0 1 2 3\""),
            &format!("{on} --at \"0 2 1 1/2\""),
        ]),
    );
}

/// α = ∞; a full knot; no such curve.
#[test]
fn insert() {
    let points = "--points \"0,0 1,2 2,2 3,0\"";
    reads(
        "insert",
        &session(&[
            &format!("insert --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha inf {points} --at \"1/2 1\""),
            "insert --degree 2 --knots \"0 0 0 1 1 2 2 2\" --alpha 5 --points \"0 1 3 2 0\" --at 1",
            &format!("insert --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 {points} --at 1/2"),
            &format!("insert --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 {points} --at 3"),
        ]),
    );
}

/// With what is refuted and what is not applicable.
#[test]
fn check() {
    reads(
        "check",
        &session(&[
            "check --degree 1 --knots \"0 1 2 3\" --alpha -1 --alpha inf",
            "check --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --property T3.5.1 --property T3.5.2",
            "check --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --property T3.5.1 --amended",
            "check --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --property T3.5.1 --baseline",
            "check --degree 1 --knots \"0 1 2 3\" --alpha -1 --property T3.5.1 --scope knots",
            "check --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --claim \"i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1\"",
            "check --claim \"k = 2; U clamped; i in 0..n : maxima(G[i]) = 1\"",
        ]),
    );
}

/// The weights and the questions, which no other call judges.
#[test]
fn check_all() {
    reads("check_all", &session(&["check --degree 1 --knots \"0 0 2 2\" --alpha 2 --all"]));
}

/// Two maxima with a corner between them, jumps of both kinds, plateaus, the zero function.
#[test]
fn shape() {
    reads(
        "shape",
        &session(&[
            "shape --degree 3 --knots \"0 0 0 0 1 2 4 4\" --alpha 5/2 --index 2",
            "shape --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --index 2",
            "shape --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --index 3",
            "shape --degree 0 --knots \"0 1 2\" --alpha -1",
            "shape --degree 1 --knots \"0 0 0 1\" --alpha -1",
            "shape --degree 1 --knots \"0 1 4\" --alpha inf --digits 4",
        ]),
    );
}

#[test]
fn shape_for_all_values_of_a_parameter() {
    reads(
        "shape_for_all_values_of_a_parameter",
        &session(&[
            "shape --degree 2 --knots \"0 1 2 3 3\" --alpha all",
            "shape --degree 4 --knots \"0 1 2 3 4 5 5 5 5\" --index 0 --alpha all",
            "shape --degree 3 --knots \"0 0 0 0 1 2 4 4\" --index 2 --alpha 5/2 --free-knot 5",
        ]),
    );
}

#[test]
fn float() {
    reads(
        "float",
        &session(&[
            "float --degree 1 --knots \"0 1 2 3\" --alpha 3 --count 20 --steps 0",
            "float --degree 2 --knots \"0 1 2 4 5\" --alpha -1 --x 1/3",
        ]),
    );
}

#[test]
fn search_and_merge() {
    reads(
        "search_and_merge",
        &session(&[
            "search --degree 2 --limit 5",
            "search --degree 3 --limit 9 --shard 0/2 --checkpoint 0",
            "search --degree 3 --limit 9 --shard 1/2 --checkpoint 1",
            "merge 0 1",
            "merge 1 0 --audit 1 --seed 7",
            "merge 1",
            "search --degree 3 --limit 9 --find deepest",
            "search --degree 3 --limit 9 --find most",
        ]),
    );
}

#[test]
fn figures() {
    reads("figures", &session(&["figures 7 two-maxima --out pictures", "figures 8 nine --out pictures"]));
}

#[test]
fn vectors() {
    let of_index = "vectors --alpha -4 --degree 2 --derivatives 1 --out vectors.json";
    reads("vectors", &session(&[of_index, "vectors --degree 99 --out vectors.json"]));
}

/// A theorem that is proved, one that is refuted and amended, a question with hypotheses.
#[test]
fn explain() {
    reads("explain", &session(&["explain T3.5.2", "explain T3.5.1 --goals", "explain X.linear"]));
}

/// The text and the report's section on each claim.
#[test]
fn report() {
    let folder = tempfile::tempdir().unwrap();
    let printed = session_in(folder.path(), &["report --claim T3.5.1 --claim P3.1.2 --out report"]);
    let page = fs::read_to_string(folder.path().join("report/report.md")).unwrap();
    let sections =
        ["## The paper's statements", "### T3.5.1", "### P3.1.2"].map(|heading| section(&page, heading));
    reads("report", &format!("{printed}report.md:\n{}", sections.join("\n")));
}

#[test]
fn prove_and_verify() {
    reads(
        "prove_and_verify",
        &session(&[
            "prove --claim P2.1.1 --out certificates",
            "verify --claim P2.1.1 certificates",
            "verify --claim T3.5.2 certificates",
        ]),
    );
}

#[test]
fn help() {
    reads("help", &session(&["help"]));
}

#[test]
fn schema() {
    reads("schema", &beginning("schema", 8));
}

/// One of each kind: each names the place and the rule.
#[test]
fn errors() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("points.csv", "x,side\n1/2,above\n"),
        ("broken.json", "{\"degree\": 2,\n \"knots\": [0, 0, 1,}"),
        ("falling.json", "{\"degree\": 1, \"knots\": [0, 2, 1], \"alpha\": \"-1\"}"),
        ("syntax", "2*x/(1 +* x)"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    reads(
        "errors",
        &session_in(
            folder.path(),
            &[
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 1/2 --x 1",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha two --x 1",
                "eval --degree 2 --knots \"0 0 0 2 1 2 2\" --alpha -1 --x 1",
                "eval --degree 2 --knots \"0 1 2\" --alpha -1 --x 1",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --x 1e500",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --x 1/0",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --x 1 --index 9",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --x 1 --points \"0,0 1\"",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --x 1 --derivatives 51",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1",
                "eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha -1 --points-file points.csv",
                "eval --instance U99 --alpha -1 --x 1",
                "eval --instance missing.json --x 1",
                "eval --instance broken.json --x 1",
                "eval --instance falling.json --x 1",
                "eval --alpha -1 --x 1",
                "formula --degree 9 --knots \"0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18\" --alpha -1",
                "formula --degree 1 --knots \"0 1 3\" --alpha 2 --index 0 --span 0 --equals syntax",
                "bezier --degree 1 --knots \"0 0 1 1\" --alpha -1",
                "joins --degree 1 --knots \"0 0 1 1\" --alpha -1",
                "joins --all --instance C5",
                "solve --degree 1 --knots \"0 0 1 1\" --alpha -1 --points \"0,0 1,1\"",
                "solve --degree 1 --knots \"0 0 1 1\" --alpha -1 --points \"0,0 1,1\" --coordinate 2",
                "bounds --degree 1 --knots \"0 0 1 1\" --alpha -1 --points \"0,0 1,1\" --normal \"1 2 3\"",
                "bounds --degree 1 --knots \"0 0 1 1\" --alpha -1 --points \"0,0 1,1\" --from 1",
                "length --degree 1 --knots \"0 0 1 1\" --alpha -1 --points \"0,0 1,1\" --width 0",
                "plot --degree 1 --knots \"0 0 1 1\" --alpha -1 --out picture.gif",
                "plot --degree 1 --knots \"0 0 1 1\" --alpha -1 --show curve",
                "check --degree 1 --knots \"0 0 1 1\" --alpha -1 --property T3.5.9",
                "check --claim \"k; U; i in 0..n; x in [t[0], t[m] : G[i](x) <= 1\"",
                "shape --degree 1 --knots \"0 0 1 1\" --alpha -1 --width 0",
                "search --degree 3 --shard 2/2",
                "figures 99 --out pictures",
                "explain T3.5",
                "evaluate",
                "check --degre 2",
            ],
        ),
    );
}
