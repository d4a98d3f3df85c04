//! The command `help`: what to do for which purpose, by example.

use std::fmt;

use clap::CommandFactory;
use schemars::JsonSchema;
use serde::Serialize;

use super::Program;
use super::error::CliError;
use super::exit::Exit;
use super::output::Output;
use super::table::HEADING;

/// Worked examples by task, or all about one command.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// A command: its options and examples.
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

const EXAMPLE: &str = "Examples:
  knotproof help
  knotproof help check";

/// What somebody wants to do.
#[derive(Debug, Serialize, JsonSchema)]
struct Task {
    /// What it is.
    task: &'static str,
    /// Commands that do it.
    examples: &'static [Example],
}

/// A command line, what it shows, and the exit code that it ends with; a test runs each.
#[derive(Debug, Serialize, JsonSchema)]
struct Example {
    /// A command line.
    command: &'static str,
    /// What it shows.
    shows: &'static str,
    /// The exit code that it ends with.
    exit: u8,
}

const fn example(command: &'static str, shows: &'static str, exit: Exit) -> Example {
    Example { command, shows, exit: exit as u8 }
}

const TASKS: &[Task] = &[
    Task {
        task: "Evaluate",
        examples: &[
            example(
                "knotproof eval --instance U4 --alpha -1 --x 1/2",
                "All basis functions of the paper's example U4 at x = 1/2, as fractions and as decimals.",
                Exit::Holds,
            ),
            example(
                "knotproof eval --instance U4 --alpha -1 --x 1 --side left --derivatives 1",
                "The slopes just left of the knot 1. With --side right they differ: a corner.",
                Exit::Holds,
            ),
            example(
                "knotproof eval --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --x 1/2 --points \"0,0 1,2 2,2 3,0\"",
                "A point of a curve on your own knots, with all points of de Boor's algorithm.",
                Exit::Holds,
            ),
        ],
    },
    Task {
        task: "See how smooth a curve is",
        examples: &[example(
            "knotproof joins --instance C5 --alpha -4",
            "By how much the tangent turns at the knots, and how speed and curvature jump. With --all: all curves of the paper.",
            Exit::Holds,
        )],
    },
    Task {
        task: "Ask a curve",
        examples: &[
            example(
                "knotproof solve --instance C5 --alpha -4 --coordinate 1 --value 4",
                "Every x where the second coordinate is 4, and the points there. With --normal: a line or a plane.",
                Exit::Holds,
            ),
            example(
                "knotproof bounds --instance C5 --alpha -4",
                "The bounding box, and where the curve touches it. shape --curve has all local maxima and minima.",
                Exit::Holds,
            ),
            example(
                "knotproof length --instance C5 --alpha -4",
                "The length, and the integrals of the coordinates, between exact bounds.",
                Exit::Holds,
            ),
            example(
                "knotproof interpolate --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --at \"0 1/2 3/2 2\" --points \"0,0 1,2 2,2 3,0\"",
                "The control points of the curve through four points, or why there is none.",
                Exit::Holds,
            ),
            example(
                "knotproof insert --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --points \"0,0 1,2 2,2 3,0\" --at 1/2",
                "Knot insertion: for finite α this curve is none on the new knots, and the ranks that show it. With --alpha inf it is.",
                Exit::Refuted,
            ),
        ],
    },
    Task {
        task: "Draw a basis or a curve",
        examples: &[example(
            "knotproof plot --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --points \"0,0 1,2 2,2 3,0\"",
            "The curve with its control polygon and its corners, as SVG; --out FILE.png writes PNG.",
            Exit::Holds,
        )],
    },
    Task {
        task: "Get a formula",
        examples: &[
            example(
                "knotproof formula --instance U4 --alpha -1 --index 1",
                "G_1 as a quotient of polynomials in x on each interval between knots.",
                Exit::Holds,
            ),
            example(
                "knotproof formula --degree 1 --knots \"0 1 3\" --alpha symbolic --as sympy",
                "The same for every α at once, as a Python program for SymPy; --as maxima and --as latex write for others.",
                Exit::Holds,
            ),
        ],
    },
    Task {
        task: "Take a curve to another program",
        examples: &[
            example(
                "knotproof bezier --degree 2 --knots \"0 0 0 1 2 2 2\" --alpha 5 --points \"0,0 1,2 2,2 3,0\" --as nurbs",
                "The curve as one NURBS curve, exactly.",
                Exit::Holds,
            ),
            example(
                "knotproof bezier --instance C5 --alpha -4 --as step --standard-form",
                "A STEP file of it for CAD programs, with weights near 1; --as geomdl is for Python.",
                Exit::Holds,
            ),
        ],
    },
    Task {
        task: "Test a spline library of your own",
        examples: &[example(
            "knotproof vectors --out vectors.json",
            "Exact values and one-sided derivatives on knots of every kind, as a file for your tests.",
            Exit::Holds,
        )],
    },
    Task {
        task: "Check a claim",
        examples: &[
            example(
                "knotproof explain T3.5.2",
                "What Theorem 3.5 (2) says, what is known of it, and why.",
                Exit::Holds,
            ),
            example(
                "knotproof check --instance U4 --alpha -1 --property T3.5.2",
                "Is it true on these knots for every x? Positive inside of the support: it is.",
                Exit::Holds,
            ),
            example(
                "knotproof check --degree 2 --knots \"0 0 0 1 1 1 2 2 2\" --alpha -1 --property T3.5.1",
                "As printed every function is 0 at both ends of its support; at t_0 the first one is 1.",
                Exit::Refuted,
            ),
        ],
    },
    Task {
        task: "Hunt for counterexamples",
        examples: &[
            example(
                "knotproof shape --degree 3 --knots \"0 0 0 0 1 2 4 4\" --alpha 5/2 --index 2",
                "A basis function with two local maxima, which Conjecture 3.1 excludes: where they are, and how high.",
                Exit::Refuted,
            ),
            example(
                "knotproof search --degree 3 --limit 9",
                "All functions of degree 3 in order of size: the sum of the gaps and the height of α. Three have two maxima.",
                Exit::Refuted,
            ),
        ],
    },
    Task {
        task: "Judge a paper of your own",
        examples: &[
            example(
                "knotproof new my-paper",
                "A folder with four claims that work, and comments that say how to go on.",
                Exit::Holds,
            ),
            example(
                "knotproof judge my-paper --out my-report",
                "Its report. One of the claims is false as printed, and true as amended.",
                Exit::Refuted,
            ),
        ],
    },
    Task {
        task: "Judge the whole paper",
        examples: &[example(
            "knotproof report --claim P2.1.1 --claim P2.1.3",
            "Two claims, one proved and one refuted with a witness, as recorded. Without --claim: all of them; with \
             --out DIR: the report as files.",
            Exit::Holds,
        )],
    },
];

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Examples {
    /// What this object is: `knotproof.help/1`.
    #[schemars(extend("const" = "knotproof.help/1"))]
    schema: &'static str,
    /// By task.
    tasks: &'static [Task],
}

/// Help for one command.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Topic {
    /// What this object is: `knotproof.help/1`.
    #[schemars(extend("const" = "knotproof.help/1"))]
    schema: &'static str,
    /// Its name.
    command: String,
    /// Its options and examples, as text.
    help: String,
}

/// Prints the examples, or the help of a command.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let Some(name) = &args.command else {
        output.result(&Examples { schema: "knotproof.help/1", tasks: TASKS })?;
        return Ok(Exit::Holds);
    };
    let mut program = Program::command();
    program.build();
    let Some(command) = program.find_subcommand_mut(name) else {
        let commands = program.get_subcommands().map(|command| command.get_name().to_owned()).collect();
        return Err(CliError::UnknownCommand { name: name.clone(), commands });
    };
    let help = command.render_long_help().to_string();
    output.result(&Topic { schema: "knotproof.help/1", command: name.clone(), help })?;
    Ok(Exit::Holds)
}

impl fmt::Display for Examples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Task { task, examples } in self.tasks {
            writeln!(f, "{HEADING}{task}{HEADING:#}")?;
            for Example { command, shows, exit } in *examples {
                writeln!(f, "  {command}\n      {shows}")?;
                if *exit != Exit::Holds as u8 {
                    writeln!(f, "      Exit code {exit}: something is refuted.")?;
                }
            }
            writeln!(f)?;
        }
        writeln!(f, "knotproof help COMMAND tells all about one command; knotproof --help lists them.")
    }
}

impl fmt::Display for Topic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.help)
    }
}
