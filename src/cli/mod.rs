//! Floor 8: the program. Arguments, results on standard output, everything else on standard error, exit codes.
//!
//! One file a command, each with its `Args` and a `run` that returns an [`Exit`]; a result is written by the
//! [`Output`], as text or as JSON. What is wrong with a request is a [`CliError`]: one message, exit code 2,
//! and nothing on standard output.
//!
//! For programs that take the same from their users: [`paper_of`] and [`family_of`] find what a name or a path means, [`native`] says
//! whether weights are those of a paper, [`settle_error`] and [`search_error`] what to change in it or in a search.

mod atomic;
mod bezier;
mod bounds;
mod check;
mod completions;
mod error;
mod eval;
mod exact;
mod exit;
mod explain;
mod families;
mod family;
mod figures;
mod file;
mod float;
mod formula;
mod help;
mod insert;
mod instance;
mod interpolate;
mod joins;
mod judge;
mod length;
mod man;
mod merge;
mod new;
mod notation;
mod of_weights;
mod offered;
mod on_curve;
mod on_knots;
mod output;
mod paper;
mod plot;
mod point_error;
mod progress;
mod prove;
mod report;
mod schema;
mod search;
mod shape;
mod solve;
mod table;
mod usage;
mod vectors;
mod verdict;
mod verify;
mod visible;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

pub use check::native;
pub use error::CliError;
pub use exit::Exit;
pub use family::find as family_of;
pub use judge::settle_error;
pub use on_curve::if_too_high;
pub use output::{Format, Output};
pub use paper::paper_of;
pub use point_error::PointError;
pub use search::blame as search_error;

/// Judges claims about rational B-splines in exact arithmetic.
#[derive(Debug, Parser)]
#[command(name = "knotproof", version, disable_help_subcommand = true, after_help = EXAMPLE)]
struct Program {
    #[command(subcommand)]
    command: Command,
    /// How results and errors are written.
    #[arg(long, global = true, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLE: &str = "\
Numbers are exact: 3, -1/2, 0.4 (that is 2/5), 1e-3, 0x1.8p-3; an index can be inf.
Exit codes: 0 everything asked holds, 1 something is refuted, 2 bad usage or input, 3 undecided, 4 internal error.
Long work tells on standard error how far it is: a bar on a terminal, a line now and then elsewhere; with
KNOTPROOF_PROGRESS=never in the environment it does not.

Example:
  knotproof eval --instance U4 --alpha -1 --x 1/2
More, by task: knotproof help";

#[derive(Debug, Subcommand)]
enum Command {
    Eval(Box<eval::Args>),
    Formula(Box<formula::Args>),
    Bezier(Box<bezier::Args>),
    Joins(Box<joins::Args>),
    Solve(Box<solve::Args>),
    Bounds(Box<bounds::Args>),
    Length(Box<length::Args>),
    Interpolate(Box<interpolate::Args>),
    Insert(Box<insert::Args>),
    Check(Box<check::Args>),
    Shape(Box<shape::Args>),
    Float(Box<float::Args>),
    Plot(Box<plot::Args>),
    Figures(figures::Args),
    Judge(judge::Args),
    New(new::Args),
    Report(report::Args),
    Explain(explain::Args),
    Prove(prove::Args),
    Verify(verify::Args),
    Families(families::Args),
    Vectors(vectors::Args),
    Search(Box<search::Args>),
    Merge(merge::Args),
    Schema(schema::Args),
    Completions(completions::Args),
    Man(man::Args),
    Help(help::Args),
}

impl Command {
    fn run(&self, output: &Output) -> Result<Exit, CliError> {
        match self {
            Self::Eval(args) => eval::run(args, output),
            Self::Formula(args) => formula::run(args, output),
            Self::Bezier(args) => bezier::run(args, output),
            Self::Joins(args) => joins::run(args, output),
            Self::Solve(args) => solve::run(args, output),
            Self::Bounds(args) => bounds::run(args, output),
            Self::Length(args) => length::run(args, output),
            Self::Interpolate(args) => interpolate::run(args, output),
            Self::Insert(args) => insert::run(args, output),
            Self::Check(args) => check::run(args, output),
            Self::Shape(args) => shape::run(args, output),
            Self::Float(args) => float::run(args, output),
            Self::Plot(args) => plot::run(args, output),
            Self::Figures(args) => figures::run(args, output),
            Self::New(args) => new::run(args, output),
            Self::Judge(args) => judge::run(args, output),
            Self::Report(args) => report::run(args, output),
            Self::Explain(args) => explain::run(args, output),
            Self::Prove(args) => prove::run(args, output),
            Self::Verify(args) => verify::run(args, output),
            Self::Families(args) => families::run(args, output),
            Self::Vectors(args) => vectors::run(args, output),
            Self::Search(args) => search::run(args, output),
            Self::Merge(args) => merge::run(args, output),
            Self::Schema(args) => schema::run(args, output),
            Self::Completions(args) => completions::run(args, output),
            Self::Man(args) => man::run(args, output),
            Self::Help(args) => help::run(args, output),
        }
    }
}

/// The program: reads the arguments of the process, and returns its exit code.
///
/// `stdout_closed`: was there no standard output when the process began? The standard library opens `/dev/null` in its
/// place, where every result would be lost without a word.
#[must_use]
pub fn main(stdout_closed: bool) -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    // Whether JSON was asked for has to be known before the arguments are understood: their errors are JSON too.
    let errors = Output::new(usage::asked_format(&arguments)).without_stdout(stdout_closed);
    std::panic::set_hook(Box::new(move |panic| errors.internal_error(panic)));
    guarded(|| run(arguments, errors)).into()
}

/// A panic is a bug of this program and no verdict: it gets an exit code of its own. The panic hook has
/// written the message by then.
fn guarded(run: impl FnOnce() -> Exit) -> Exit {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or(Exit::Internal)
}

fn run(arguments: Vec<OsString>, errors: Output) -> Exit {
    let program = match Program::try_parse_from(arguments) {
        Ok(program) => program,
        Err(error) => return usage::answer(&error, errors),
    };
    let output = errors.in_format(program.format);
    match program.command.run(&output) {
        Ok(exit) => exit,
        Err(error) => {
            output.refusal(&error);
            error.exit()
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        Program::command().debug_assert();
    }

    #[test]
    fn every_command_shows_an_example() {
        for command in Program::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.contains(&format!("knotproof {}", command.get_name())), "{}", command.get_name());
        }
    }

    #[test]
    fn a_panic_becomes_exit_code_4() {
        assert_eq!(guarded(|| panic!("a bug, on purpose")), Exit::Internal);
        assert_eq!(guarded(|| Exit::Refuted), Exit::Refuted);
    }
}
