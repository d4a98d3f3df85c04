//! All tests of the library and of the commands, as one program: what is expensive is computed once, and no core waits for the
//! last test of a file. One file of them is run by its name,
//!
//! ```sh
//! cargo test --test suite golden::
//! ```

mod action;
mod analysis;
mod certificates;
mod cli_bezier;
mod cli_check;
mod cli_claims;
mod cli_errors;
mod cli_eval;
mod cli_eval_points;
mod cli_families;
mod cli_float;
mod cli_folders;
mod cli_formula;
mod cli_input;
mod cli_joins;
mod cli_judge;
mod cli_notation;
mod cli_prove;
mod cli_report;
mod cli_search;
mod cli_shape;
mod cli_shell;
mod cli_vectors;
mod collocation;
mod conjecture_page;
mod corners;
mod curve_evaluator;
mod engine;
mod evaluator;
mod families;
mod figures;
mod float;
mod float_basis;
mod float_curve;
mod float_derivatives;
mod floors;
mod formula_equals;
mod formula_languages;
mod golden;
mod graph;
mod guide;
mod joins;
mod language;
mod language_errors;
mod library;
mod licences;
mod monotonicity;
mod names;
mod nurbs;
mod pages;
mod paper;
mod partition;
mod quadrature;
mod rational_bezier;
mod readings;
mod referee;
mod refinement;
mod report_page;
mod scalars;
mod schemas;
mod search_family;
mod sentences;
mod shape_oracle;
mod spline;
mod texts;
mod theory;
mod variants;
mod verdicts;
mod windows;

/// Where the program is, for a shell that runs it.
const PATH: &str = env!("CARGO_BIN_EXE_knotproof");

/// The program, silent about its progress: on a busy machine it would have something to say of that, and a test compares all
/// that is said.
fn process() -> std::process::Command {
    let mut process = std::process::Command::new(PATH);
    process.env("KNOTPROOF_PROGRESS", "never");
    process
}

/// The same, to be given an input and a limit of time.
fn program() -> assert_cmd::Command {
    assert_cmd::Command::from_std(process())
}

/// A file that is not named here would never run.
#[test]
fn every_file_of_tests_is_part_of_the_suite() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let suite = include_str!("suite.rs");
    let files = std::fs::read_dir(folder)
        .expect("the folder of tests")
        .map(|entry| entry.expect("it can be read").path());
    let files: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|extension| extension == "rs")).collect();
    assert!(files.len() > 40);
    for file in files {
        let name = file.file_stem().and_then(|name| name.to_str()).expect("a name");
        assert!(name == "suite" || suite.contains(&format!("\nmod {name};\n")), "{name} is not run");
    }
}

/// A program that is run in another way says on a busy machine what no test expects.
#[test]
fn every_test_runs_the_program_that_is_silent() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    for file in std::fs::read_dir(folder).expect("the folder of tests") {
        let file = file.expect("it can be read").path();
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        let runs = text.contains("CARGO_BIN_EXE") || text.contains("cargo_bin");
        assert!(!runs || file.ends_with("suite.rs"), "{}: crate::process() runs it", file.display());
    }
}
