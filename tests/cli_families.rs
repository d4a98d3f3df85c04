//! Families of splines on the command line.

use std::fs;
use std::path::Path;
use std::process::Output;

fn run(arguments: &[&str]) -> Output {
    crate::process().args(arguments).output().expect("it runs")
}

fn said(arguments: &[&str]) -> (i32, String) {
    let output = run(arguments);
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("UTF-8");
    let all = format!("{}{}", text(&output.stdout), text(&output.stderr));
    (output.status.code().expect("it ends by itself"), all)
}

const ON: [&str; 4] = ["--degree", "2", "--knots", "0 0 0 1 2 2 2"];
const LUPAS: [&str; 4] = ["--family", "lupas", "--set", "q=1/2"];

fn on(command: &str, more: &[&str]) -> Vec<String> {
    [&[command], &ON[..], more].concat().into_iter().map(str::to_owned).collect()
}

fn ask(command: &str, more: &[&str]) -> (i32, String) {
    let all = on(command, more);
    said(&all.iter().map(String::as_str).collect::<Vec<_>>())
}

/// `knotproof families --table > docs/families.md` writes it.
#[test]
fn the_page_of_families_is_what_is_judged() {
    let recorded = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/families.md");
    let recorded = fs::read_to_string(recorded).expect("the page is there");
    let (code, page) = said(&["families", "--table"]);
    assert_eq!((code, page.trim_end()), (0, recorded.trim_end()));
}

/// Each witness of the page, by the command that stands behind it.
#[test]
fn the_commands_of_the_page_show_what_they_say() {
    let recorded = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/families.md");
    let recorded = fs::read_to_string(recorded).expect("the page is there");
    let commands: Vec<_> = recorded
        .lines()
        .filter_map(|line| line.split('`').find(|part| part.starts_with("knotproof ")))
        .collect();
    assert!(commands.len() > 20, "{}", commands.len());
    for command in commands.into_iter().filter(|command| command.contains("--family")) {
        let arguments: Vec<_> =
            command.split(' ').skip(1).map(|word| word.trim_matches(['"', '\''])).collect();
        let (code, text) = said(&arguments);
        // What is looked at is shown, or judged again.
        let expected = if arguments[0] == "eval" { 0 } else { 1 };
        assert_eq!(code, expected, "{command}: {text}");
    }
}

#[test]
fn values_and_shapes_of_a_member() {
    let (code, text) = ask("eval", &[&LUPAS[..], &["--x", "1/3"]].concat());
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("family lupas, q = 1/2") && text.contains("8/15"), "{text}");
    let (code, text) = ask("shape", &LUPAS);
    assert!(code == 0 && text.contains("G_1, family lupas, q = 1/2"), "{text}");
    // What is an index is computed and shown as one.
    let [one, other] = [&["--family", "mobius", "--set", "r=1/2"][..], &["--alpha", "-1"]];
    for command in [
        &["eval", "--x", "1/3"][..],
        &["shape"],
        &["formula", "--as", "latex"],
        &["formula", "--format", "json"],
        &["bezier", "--points", "0,0 1,2 2,2 3,0"],
        &["float", "--steps", "20"],
        &["float", "--x", "1/3", "--format", "json"],
        &["check", "--property", "T3.5.2"],
    ] {
        let [one, other] = [one, other].map(|of| ask(command[0], &[&command[1..], of].concat()));
        assert_eq!(one, other);
    }
    let negative =
        ["shape", "--degree", "2", "--knots", "0 0 0 1 1 1", "--family", "phillips", "--set", "q=3"];
    let (code, text) = said(&negative);
    assert!(code == 2 && text.contains("negative somewhere for phillips, q = 3 (w["), "{text}");
}

#[test]
fn claims_of_ones_own_name_parameters() {
    let claim = "sum(i in 0..n: G[i](1/2)) = 1 and q = 1/2 and G[0](1/2) > 1/4";
    let (code, text) = ask("check", &[&LUPAS[..], &["--claim", &format!(": {claim}")]].concat());
    assert!(code == 0 && text.contains("Family lupas, q = 1/2, for every x:"), "{text}");
    let (code, text) =
        said(&["check", "--family", "lupas", "--claim", "k = 2; U clamped : G'[0](t[0]) = -2*q/(t[3]-t[0])"]);
    assert!(code == 1 && text.contains("at k = 2") && text.contains("q = 2"), "{text}");
    let (code, text) = said(&["check", "--family", "lupas", "--claim", "k; U : alpha = infinity"]);
    assert!(
        code == 2 && text.contains("the family lupas has no `alpha`; it has q") && text.contains("^^^^^"),
        "{text}"
    );
    // The paper's claims are about an index: none is proved by what holds for those.
    let (code, text) = ask("check", &[&LUPAS[..], &["--property", "T3.5.3", "--format", "json"]].concat());
    assert!(code == 0 && text.contains("\"engine\"") && !text.contains("checker"), "{text}");
}

#[test]
fn what_is_wrong_with_a_request_is_told() {
    let missing = Path::new("no-such-family.toml");
    assert!(!missing.exists());
    for (command, more, told) in [
        (
            "eval",
            &["--family", "lupas", "--x", "1"][..],
            "--set: the family lupas needs `q`: give it, such as --set q=1/3",
        ),
        ("eval", &["--family", "lupas", "--set", "q", "--x", "1"], "`q` has no `=`: write NAME=VALUES"),
        ("eval", &["--family", "lupas", "--set", "q=1", "--set", "q=2", "--x", "1"], "`q` is set twice"),
        (
            "eval",
            &["--family", "lupas", "--set", "q=x", "--x", "1"],
            "--set, position 0: `x` is not a number",
        ),
        ("eval", &["--family", "lupas", "--set", "q=0", "--x", "1"], "can't be 0: q > 0"),
        (
            "eval",
            &["--family", "lupsa", "--x", "1"],
            "there is no family `lupsa`, and no such file; there are classical",
        ),
        ("eval", &["--family", "no-such-family.toml", "--x", "1"], "no such file"),
        ("eval", &["--family", "phillips", "--set", "q=2", "--x", "1"], "for knots that are bernstein"),
        ("eval", &["--set", "q=2", "--x", "1"], "--family"),
        ("eval", &["--family", "lupas", "--set", "q=2", "--alpha", "2", "--x", "1"], "cannot be used with"),
        ("eval", &["--set", "q=2", "--alpha", "2", "--x", "1"], "cannot be used with"),
        (
            "eval",
            &["--family", "lupas", "--set", "q=2", "--points", "0 1 2", "--x", "1"],
            "takes 4 control points",
        ),
        (
            "formula",
            &["--family", "lupas", "--set", "q=symbolic"],
            "`q` has to be a number, and here is `symbolic`: only α can stay unknown",
        ),
        (
            "float",
            &["--family", "lupas", "--set", "q=1e-400"],
            "--set: in f64, `q` of the family lupas can't be 0",
        ),
        ("float", &["--family", "lupas", "--set", "q=1e400"], "--set: in f64, a parameter is inf"),
        ("shape", &["--family", "lupas", "--set", "q=all"], "`q` has to be a number, and here is `all`"),
        ("bezier", &LUPAS, "--points is missing"),
        (
            "float",
            &[&LUPAS[..], &["--out", "maps"]].concat(),
            "--out: it is for the weights of an index only",
        ),
        (
            "shape",
            &[&LUPAS[..], &["--free-knot", "3"]].concat(),
            "--free-knot: it is for the weights of an index only",
        ),
        (
            "check",
            &["--family", "lupas", "--set", "q=2", "--classical", "--property", "C2"],
            "there is no claim `C2`; there are C0, C1",
        ),
    ] {
        let (code, text) = ask(command, more);
        assert!(code == 2 && text.contains(told), "{command} {more:?}: {code} {text}");
    }
    let (code, text) = said(&["float", "--degree", "2", "--family", "lupas", "--set", "q=2"]);
    assert!(code == 2 && text.contains("give the knots of the family"), "{text}");
    let (code, text) = said(&["families", "--like", "y*(x-a) : b-"]);
    assert!(code == 2 && text.contains("expected a term"), "{text}");
}

/// Every command that takes a family complains of it in the same words.
#[test]
fn what_is_wrong_with_a_family_is_told_by_every_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, weight: &str| {
        let path = folder.path().join(name);
        let text = format!("name = \"own\"\ntitle = \"own\"\nsource = \"a test\"\n{weight}");
        fs::write(&path, text).expect("written");
        path.to_str().expect("UTF-8").to_owned()
    };
    let pole = file("pole.toml", "[weight]\nrise = \"x - a\"\nfall = \"2*(x - b)\"\n");
    let circle = file(
        "circle.toml",
        "[define]\n\"c[i]\" = \"c[i+1]\"\n[weight]\nrise = \"c[i]*(x - a)\"\nfall = \"b - x\"\n",
    );
    let commands: [&[&str]; 6] = [
        &["eval", "--x", "1"],
        &["shape"],
        &["check", "--classical", "--property", "unity"],
        &["formula"],
        &["bezier", "--points", "0 1 2 3"],
        &["float"],
    ];
    for command in commands {
        for (member, told) in [
            (&["--family", "lupas"][..], "--set: the family lupas needs `q`: give it, such as --set q=1/3"),
            (&["--family", "lupas", "--set", "p=1"], "--set: the family lupas has no `p`: it has q"),
            (&["--family", "lupas", "--set", "q=0"], "`q` of the family lupas can't be 0: q > 0"),
            (&["--family", "nurbs", "--set", "omega=1"], "omega[2] is not given: give more numbers"),
            (&["--family", "nurbs", "--set", "omega=1,0"], "`omega[i]` of the family nurbs can't be 0"),
            (
                &["--family", "phillips", "--set", "q=2"],
                "the family phillips is for knots that are bernstein",
            ),
            (&["--family", "lupsa"], "--family: there is no family `lupsa`, and no such file"),
            (&["--family", &pole], "its denominator is 0 at some x there"),
            (&["--family", &circle], "the recursion of `c` never ends"),
            (&["--set", "q=1"], "--family is missing: say whose parameters are set"),
        ] {
            let (code, text) = ask(command[0], &[&command[1..], member].concat());
            assert!(code == 2 && text.contains(told), "{command:?} {member:?}: {code} {text}");
        }
    }
}

/// The family of a paper is the one that --set is about.
#[test]
fn a_papers_own_family_need_not_be_named() {
    let on = ["check", "--paper", "pq", "--degree", "2", "--knots", "0 0 0 1 1 1"];
    let set = ["--set", "p=2", "--set", "q=3"];
    let short = said(&[&on[..], &set].concat());
    assert_eq!(short, said(&[&on[..], &["--family", "pq-lupas"], &set].concat()));
    assert!(short.1.contains("Family pq-lupas, p = 2, q = 3, for every x:"), "{}", short.1);
    let (code, text) = said(&on);
    assert!(code == 2 && text.contains("--set: the family pq-lupas needs `p`"), "{text}");
    let claim = ["check", "--paper", "pq", "--claim", "k; U : p = 2*q/3"];
    assert_eq!(said(&[&claim[..], &set].concat()).0, 0);
    assert_eq!(said(&[&claim[..], &["--set", "p=1", "--set", "q=3"]].concat()).0, 1);
    // Polynomial B-splines have no parameter, and functions with an index have α.
    let on = ["--degree", "2", "--knots", "0 0 0 1 1 1"];
    let classical = said(&[&["check", "--paper", "classical"], &on[..]].concat());
    assert_eq!(classical, said(&[&["check", "--paper", "classical"], &on[..], &["--alpha", "inf"]].concat()));
    let (code, text) = said(&[&["check", "--paper", "rational-bsplines"], &on[..]].concat());
    assert!(code == 2 && text.contains("--alpha is missing"), "{text}");
}

#[test]
fn a_file_of_ones_own_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cubic.toml");
    let name = path.to_str().expect("UTF-8");
    let text = "name = \"cubic\"\ntitle = \"A cubic core\"\nsource = \"a test\"\n[weight]\nrise = \"(x - a)^3\"\nfall = \"(b - x)^3\"\n[dual]\n";
    fs::write(&path, text).expect("written");
    let (code, shown) = said(&["families", name]);
    assert!(code == 0 && shown.contains("cubic: A cubic core"), "{shown}");
    let (code, found) =
        said(&["check", "--family", name, "--classical", "--property", "unity", "--property", "reflection"]);
    assert!(code == 0 && found.contains("2 proved"), "{found}");
    let (code, found) = ask("check", &["--family", name, "--classical", "--property", "linear"]);
    assert!(code == 1, "{found}");
    fs::write(&path, text.replace("x - a)^3", "y - a)^3")).expect("written");
    let (code, shown) = said(&["families", name]);
    assert!(code == 2 && shown.contains("nothing is called `y`") && shown.contains('^'), "{shown}");
}
