//! The command `schema`: what is read and what is written, as JSON Schema.

use clap::ValueEnum;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema, schema_for};
use serde_json::Value;

use crate::language::{family_schema, schema as claims_schema};
use crate::report::Errata;
use crate::search::{FindingRecord, SummaryRecord};

use super::error::CliError;
use super::exit::Exit;
use super::file::InstanceFile;
use super::output::{ErrorReport, OfPaper, Output, Stamped};
use super::{
    bezier, bounds, check, completions, eval, explain, families, figures, float, formula, help, insert,
    interpolate, joins, judge, length, man, merge, new, plot, prove, report, shape, solve, vectors, verify,
};

/// Prints a JSON Schema: of instance files (for --instance FILE), of files of claims (for check --claims FILE), of families (for
/// --family FILE), or of what
/// a command writes with --format json.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// The command whose JSON is described, each key with what it means; or `error`, for errors; or `claims`, for files of
    /// claims; or `family`, for files of families.
    #[arg(value_name = "COMMAND", value_enum)]
    command: Option<Written>,
}

const EXAMPLE: &str = r#"Examples:
  knotproof schema > instance.schema.json
  knotproof schema eval > eval.schema.json
  knotproof schema claims > claims.schema.json
  knotproof schema family > family.schema.json
An instance file:
  {"degree": 2, "knots": ["0", 0, 0, "1/2", 1, 1, 1], "alpha": "-1", "points": [["0", "2"], [1, 3], [2, 3], [3, 0]]}"#;

/// Who writes JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Written {
    Eval,
    Formula,
    Bezier,
    Joins,
    Solve,
    Bounds,
    Length,
    Interpolate,
    Insert,
    Check,
    Shape,
    Float,
    Plot,
    Figures,
    Judge,
    New,
    Report,
    Explain,
    Prove,
    Verify,
    Families,
    Vectors,
    Search,
    Merge,
    Completions,
    Man,
    Help,
    /// What is wrong with a request, on standard error.
    Error,
    /// Files of claims, which are read.
    Claims,
    /// Files of families, which are read.
    Family,
}

const EVAL: &str = "One object for one point. With --points-file JSON lines: the first has what all points share, each other is a point, in the order of the file. With --format text a file of points is answered as CSV, with the columns x, side, G_0, …, G_n (or the one function that was asked for), G_0^(d), …, G_n^(d) for each derivative d from 1, and with control points curve_0, … (the coordinates) and curve_0^(d), … likewise.";
const FORMULA: &str = "Formulas; with --equals, whether those of a file are the functions.";
const BEZIER: &str = "The curve as rational Bézier pieces; with --as joined to NURBS curves.";
const SHAPE: &str = "Extrema; with --alpha all or --free-knot, how their number depends on the parameter; with --curve or --points, those of a curve.";
const REPORT: &str = "All verdicts of a run, as in report.json; with --errata the errata from recorded verdicts, as in errata.json.";
const SEARCH: &str =
    "JSON lines, also in a checkpoint: one for each finding, and at the end a summary of what was searched.";
const HELP: &str = "All tasks, or the help of one command.";
const CLAIMS: &str = "Files of claims, for check --claims: TOML, here as the data that it stands for. docs/language.md says how sentences are written.";
const FAMILY: &str = "Files of families, for --family: TOML, here as the data that it stands for. docs/language.md says how weights are written.";
const VECTORS: &str = "What was written, and the file: exact values for the tests of other spline libraries.";
const FAMILIES: &str = "Families of splines; with --table the page of their classical properties.";
const ERROR: &str = "The object on standard error, with exit code 2, or 4 for a bug of the program.";

/// Prints the schema; it is JSON in either format.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    output.json(&args.command.map_or_else(|| schema_for!(InstanceFile), Written::schema))?;
    Ok(Exit::Holds)
}

impl Written {
    fn schema(self) -> Schema {
        let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let (description, mut shapes) = self.shapes(&mut generator);
        let mut schema = match (shapes.pop(), shapes.is_empty()) {
            (Some(only), true) => only,
            (last, _) => json_schema!({ "anyOf": shapes.into_iter().chain(last).collect::<Vec<_>>() }),
        };
        let name = self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        schema.insert("$schema".to_owned(), SchemaSettings::draft2020_12().meta_schema.into());
        schema.insert("description".to_owned(), description.into());
        // What is read has both already.
        let fields = schema.ensure_object();
        fields.entry("title").or_insert_with(|| format!("knotproof {name} --format json").into());
        fields.entry("$defs").or_insert_with(|| Value::Object(generator.take_definitions(true)));
        schema
    }

    /// A word on the whole, and each kind of object that is written.
    fn shapes(self, to: &mut SchemaGenerator) -> (&'static str, Vec<Schema>) {
        match self {
            Self::Eval => (
                EVAL,
                vec![
                    titled("The answer at one point", of::<eval::Evaluation>(to)),
                    titled("The first line for a file of points", of::<eval::Head>(to)),
                    titled("A point of a file", to.subschema_for::<eval::PointValues>()),
                ],
            ),
            Self::Formula => (
                FORMULA,
                vec![
                    titled("Formulas", of::<formula::Formulas>(to)),
                    titled("A comparison (--equals)", of::<formula::Comparison>(to)),
                ],
            ),
            Self::Bezier => (
                BEZIER,
                vec![
                    titled("Pieces", of::<bezier::Conversion>(to)),
                    titled("NURBS curves (--as)", of::<bezier::Joined>(to)),
                ],
            ),
            Self::Joins => (
                "How smooth a curve is at its knots; with --all, all curves of a paper.",
                vec![
                    titled("A curve", of::<joins::Joins>(to)),
                    titled("All curves of a paper (--all)", of::<OfPaper<joins::AllJoins>>(to)),
                ],
            ),
            Self::Solve => ("Where a curve takes a value.", vec![of::<solve::Solved>(to)]),
            Self::Bounds => ("The bounding box of a curve.", vec![of::<bounds::Bounds>(to)]),
            Self::Length => (
                "The length of a curve, and the integrals of its coordinates.",
                vec![of::<length::Lengths>(to)],
            ),
            Self::Interpolate => (
                "The curve through given points, or why there is none.",
                vec![of::<interpolate::Interpolation>(to)],
            ),
            Self::Insert => {
                ("A curve on more knots, or why it is none on them.", vec![of::<insert::Inserted>(to)])
            }
            Self::Check => (
                "The verdicts on the claims of the paper, on one instance.",
                vec![of::<OfPaper<check::Check>>(to)],
            ),
            Self::Shape => (
                SHAPE,
                vec![
                    titled("Extrema", of::<shape::Shapes>(to)),
                    titled("By a parameter (--alpha all, --free-knot)", of::<shape::Partitions>(to)),
                    titled("The coordinates of a curve (--curve, --points)", of::<shape::CurveShapes>(to)),
                ],
            ),
            Self::Float => ("The errors of `f64` against exact values.", vec![of::<float::Comparison>(to)]),
            Self::Plot => ("The picture that was drawn.", vec![of::<plot::Plotted>(to)]),
            Self::Figures => ("The pictures that were written.", vec![of::<figures::Drawn>(to)]),
            Self::New => ("The folder that was written.", vec![of::<new::Written>(to)]),
            Self::Judge => {
                ("All verdicts on a paper, as in report.json.", vec![of::<judge::Judged<'static>>(to)])
            }
            Self::Report => (
                REPORT,
                vec![
                    titled("A report", of::<report::Outcome<'static>>(to)),
                    titled("Errata (--errata)", of::<OfPaper<Errata<'static>>>(to)),
                ],
            ),
            Self::Explain => {
                ("One claim with its recorded verdicts.", vec![of::<OfPaper<explain::Explanation>>(to)])
            }
            Self::Prove => ("The certificates that were written.", vec![of::<OfPaper<prove::Proved>>(to)]),
            Self::Verify => {
                ("What the checker says of certificates.", vec![of::<OfPaper<verify::Verified>>(to)])
            }
            Self::Families => (
                FAMILIES,
                vec![
                    titled("Families", of::<families::Families>(to)),
                    titled("The page of properties (--table)", of::<families::Page>(to)),
                ],
            ),
            Self::Vectors => (
                VECTORS,
                vec![
                    titled("What was written", of::<vectors::Written>(to)),
                    titled("The file", of::<vectors::Vectors>(to)),
                ],
            ),
            Self::Search => (
                SEARCH,
                vec![
                    titled("A finding", to.subschema_for::<FindingRecord>()),
                    titled("The last line", to.subschema_for::<SummaryRecord>()),
                ],
            ),
            Self::Merge => {
                ("The shards of a search, put together.", vec![of::<OfPaper<merge::Merged<'static>>>(to)])
            }
            Self::Completions => ("The script for a shell.", vec![of::<completions::Completions>(to)]),
            Self::Man => ("The manual pages that were written.", vec![of::<man::Pages>(to)]),
            Self::Help => (
                HELP,
                vec![
                    titled("All tasks", of::<help::Examples>(to)),
                    titled("One command", of::<help::Topic>(to)),
                ],
            ),
            Self::Error => (ERROR, vec![of::<ErrorReport<'static>>(to)]),
            Self::Claims => (CLAIMS, vec![claims_schema()]),
            Self::Family => (FAMILY, vec![family_schema()]),
        }
    }
}

/// A result as it is written.
fn of<T: JsonSchema>(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<Stamped<T>>()
}

fn titled(title: &str, mut schema: Schema) -> Schema {
    schema.insert("title".to_owned(), title.into());
    schema
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn every_command_is_described() {
        let program = super::super::Program::command();
        for command in program.get_subcommands().map(|command| command.get_name()) {
            let known = <Written as ValueEnum>::from_str(command, false).is_ok();
            assert_ne!(known, command == "schema", "{command}: all are described but this one itself");
        }
    }
}
