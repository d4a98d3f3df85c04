//! What can be wrong with a request: one message for each.

use std::io;
use std::path::PathBuf;

use num_rational::BigRational;
use thiserror::Error;

use crate::analysis::{
    CurvePartError, FreeKnotError, InterpolationError, NurbsError, RationalBezierError, RefinementError,
    SiteError,
};
use crate::certificate::CertificateError;
use crate::formula::ScriptError;
use crate::json::JsonError;
use crate::language::Complaint;
use crate::report::{BaselineError, NurbsFileError, PageError, PictureError};
use crate::search::{AuditError, MergeError, PortionError, RecordError};
use crate::settle::SettleError;
use crate::spline::{Basis, HasWeights};
use crate::study::FloatMemberError;
use crate::typed::{Provenance, TypedError};

use super::exit::Exit;
use super::point_error::PointError;

/// Why a request was not carried out.
#[derive(Debug, Error)]
pub enum CliError {
    /// What is typed is no number, no list, no basis, no curve or no member of a family.
    #[error(transparent)]
    Typed(#[from] TypedError),
    /// A list of indices in an instance file is empty.
    #[error("{place}: the list is empty; leave the field out, or name an index")]
    NoIndices {
        /// Where it stands.
        place: Provenance,
    },
    /// Something that is needed was not given.
    #[error("{argument} is missing: {purpose}; or name an example with --instance")]
    Missing {
        /// The option.
        argument: &'static str,
        /// What to give with it.
        purpose: &'static str,
    },
    /// `--instance` is neither a name nor a file.
    #[error(
        "--instance: `{name}` is no instance of the paper ({names}) and no file; \
         `knotproof schema` describes instance files",
        names = names.join(", ")
    )]
    UnknownInstance {
        /// What was given.
        name: String,
        /// The names that the paper's instances have.
        names: Vec<String>,
    },
    /// An instance file that is not what the schema says.
    #[error("--instance: {}: {error}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What is wrong, with line and column.
        error: JsonError,
    },
    /// An instance of several degrees, and none of them chosen.
    #[error("{argument}: the paper shows {name} for the degrees {list}: choose one with --degree", list = list(degrees))]
    Degree {
        /// The option to blame: `--degree`, or `--instance` if no degree was given.
        argument: &'static str,
        /// The name of the instance.
        name: String,
        /// Its degrees.
        degrees: Vec<usize>,
    },
    /// Several indices where one is wanted.
    #[error("--alpha: one index is wanted, and here are {}: choose one with --alpha", list(indices))]
    SeveralIndices {
        /// The indices.
        indices: Vec<String>,
    },
    /// `--alpha all` among other indices, or where the index has to be known.
    #[error(
        "--alpha: `all` stands alone, and only `knotproof shape` takes it; give an index, such as -1 or inf"
    )]
    AllIndices,
    /// `--alpha symbolic` among other indices, or where the index has to be known.
    #[error(
        "--alpha: `symbolic` stands alone, and only `knotproof formula` takes it; give an index, such as -1 or inf"
    )]
    SymbolicIndex,
    /// A width that is not positive.
    #[error("--width: {0} is not positive; give the longest interval wanted, such as 1e-9")]
    Width(BigRational),
    /// Two parameters at once.
    #[error("--free-knot: the index has to be known where a knot is free; give one, such as --alpha -1")]
    TwoParameters,
    /// A knot that cannot be free.
    #[error("--free-knot: {0}")]
    FreeKnot(#[from] FreeKnotError),
    /// No basis function has this index.
    #[error("--index: there is no function {index}: the basis has the functions 0 to {n}")]
    Function {
        /// What was given.
        index: usize,
        /// n.
        n: usize,
    },
    /// More than the program is willing to compute.
    #[error("{argument}: {given} is too many: at most {limit}")]
    TooMany {
        /// Which argument.
        argument: &'static str,
        /// What was given.
        given: usize,
        /// The most that is allowed.
        limit: usize,
    },
    /// A line of a file of points that is no point.
    #[error("--points-file: {name}, line {line}: {error}")]
    Points {
        /// The file.
        name: String,
        /// The number of the line, from 1.
        line: u64,
        /// What is wrong with it.
        error: PointError,
    },
    /// A file of points without any.
    #[error("--points-file: {name}: there is no point in it: write one x on each line")]
    NoPoint {
        /// The file.
        name: String,
    },
    /// No control points where a curve is wanted.
    #[error("--points is missing: there is no curve without control points; give {needed}, d_0 to d_{}", needed - 1)]
    NoPoints {
        /// n + 1.
        needed: usize,
    },
    /// A degree of which the result would be too long, or take too long.
    #[error("--degree: {degree} is too high for this: at most {limit}; {reason}")]
    TooHigh {
        /// k.
        degree: usize,
        /// The highest that is allowed.
        limit: usize,
        /// Why.
        reason: &'static str,
    },
    /// Weights of which the functions are quotients that take too long.
    #[error(
        "--degree: with these weights the functions are quotients of degree up to {degree} in x, and at most {limit} is \
         possible here; choose a lower degree k, or weights of a lower degree"
    )]
    Quotients {
        /// The degree of a function, above and below.
        degree: usize,
        /// The highest that is allowed.
        limit: usize,
    },
    /// A file with expressions that cannot be read, or not compared.
    #[error("--equals: {}, {error}", path.display())]
    Expression {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        error: ScriptError,
    },
    /// A file with expressions for other functions.
    #[error("--index: {} has no definition of G_{index}", path.display())]
    NoDefinition {
        /// The file.
        path: PathBuf,
        /// The function that was asked for.
        index: usize,
    },
    /// An interval between knots that is none.
    #[error("--span: [t_{given}, t_{}) is empty, or not there; take one of {}", given.saturating_add(1), list(spans))]
    NoSpan {
        /// j.
        given: usize,
        /// Those that are not empty.
        spans: Vec<usize>,
    },
    /// Help about a command that is not there.
    #[error("COMMAND: there is no command `{name}`; there are {}", list(commands))]
    UnknownCommand {
        /// What was given.
        name: String,
        /// The commands.
        commands: Vec<String>,
    },
    /// Neither a folder nor the name of a paper.
    #[error(
        "{argument}: there is no folder `{name}`, and no paper of that name comes with the program (there are {}); \
         `knotproof new FOLDER` writes a folder to start from",
        list(names)
    )]
    NoPaper {
        /// The argument.
        argument: &'static str,
        /// What was given.
        name: String,
        /// The papers that come with the program.
        names: Vec<&'static str>,
    },
    /// The windows of a paper in a folder are about something else than its claims.
    #[error("{argument}: {}: {error}; correct it, or remove what it is about", path.display())]
    Windows {
        /// The argument that names the folder.
        argument: &'static str,
        /// The file of windows.
        path: PathBuf,
        /// What is wrong.
        error: Box<CertificateError>,
    },
    /// Weights that the family of the paper has not.
    #[error("{argument}: the family `{family}` of the paper has no {weights}; {advice}")]
    Foreign {
        /// The argument.
        argument: &'static str,
        /// The family.
        family: String,
        /// α, or a member of another family.
        weights: String,
        /// What to write instead.
        advice: String,
    },
    /// Degrees that are none.
    #[error("--degrees: `{0}` is no range of degrees; write one, such as 2, or the first and the last: 1..3")]
    Degrees(String),
    /// No claim has this identifier.
    #[error("{argument}: there is no claim `{name}`; there are {near}", near = list(near))]
    UnknownClaim {
        /// The option.
        argument: &'static str,
        /// What was given.
        name: String,
        /// The identifiers that come closest, or all.
        near: Vec<String>,
    },
    /// The claim is about examples that the paper shows, not about any instance.
    #[error(
        "--property: {claim} is about examples of the paper, not about instances in general; \
         judge it with `{judges}`"
    )]
    NotGeneral {
        /// The claim.
        claim: String,
        /// The command that judges it.
        judges: String,
    },
    /// A file or folder that cannot be read or written.
    #[error("{argument}: cannot {action} {}: {error}", path.display())]
    File {
        /// The option.
        argument: &'static str,
        /// `read` or `write`.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A file that holds no verdicts.
    #[error("--baseline: {}: {error}", path.display())]
    Baseline {
        /// The file.
        path: PathBuf,
        /// What is wrong, with line and column.
        error: BaselineError,
    },
    /// The verdicts that the program was built with are damaged.
    #[error("the recorded verdicts are damaged: {0}")]
    Recorded(BaselineError),
    /// A claim that has no verdict among those the program was built with.
    #[error("no verdict on {0} is recorded with this program; `knotproof report --claim {0}` judges it")]
    NotRecorded(&'static str),
    /// A converted piece is not the curve: a bug.
    #[error(
        "internal error: the rational Bézier curve differs from the curve at x = {x}; \
         please report this bug with the command line"
    )]
    Conversion {
        /// Where.
        x: BigRational,
    },
    /// A piece of a curve that has no rational Bézier form with positive weights.
    #[error("--family: {0}; choose other parameters, or a curve over fewer functions")]
    Bezier(#[from] RationalBezierError),
    /// A NURBS form that the curve has not.
    #[error("{argument}: {0}", argument = nurbs_argument(.0))]
    Nurbs(#[from] NurbsError),
    /// An interval that is no part of the curve.
    #[error("{argument}: {0}", argument = part_argument(.0))]
    Part(#[from] CurvePartError),
    /// A coordinate that a point has not.
    #[error("--coordinate: there is no coordinate {coordinate}: a point has {dimension}, counted from 0")]
    Coordinate {
        /// What was given.
        coordinate: usize,
        /// The number of coordinates.
        dimension: usize,
    },
    /// No coordinate, where there are several.
    #[error(
        "--coordinate is missing: a point has {dimension} coordinates, so say which one is meant, counted from 0, or \
         give a·c(x) by --normal"
    )]
    NoCoordinate {
        /// The number of coordinates.
        dimension: usize,
    },
    /// Not a number for each coordinate.
    #[error("--normal: here are {count} numbers, and a point has {dimension} coordinates: give one for each")]
    Normal {
        /// What was given.
        count: usize,
        /// The number of coordinates.
        dimension: usize,
    },
    /// Numbers that are no places for interpolation.
    #[error("--at: {0}")]
    Sites(#[from] SiteError),
    /// Points or places of another number than is needed.
    #[error("--at: {0}")]
    Interpolation(#[from] InterpolationError),
    /// Knots that can't be new ones.
    #[error("--at: {0}")]
    Refinement(#[from] RefinementError),
    /// A NURBS curve that no file in floats can hold.
    #[error("--as: {0}; {advice}", advice = nurbs_advice(.0))]
    NurbsFile(#[from] NurbsFileError),
    /// Neither a certificate nor a folder of certificates.
    #[error("PATH: {} is no certificate: give files NAME.statement, with NAME.proof beside them, or a folder of such", path.display())]
    NoCertificate {
        /// What was given.
        path: PathBuf,
    },
    /// Something that a search needs was not given.
    #[error("{argument} is missing: {purpose}")]
    Needed {
        /// The option.
        argument: &'static str,
        /// What to give with it.
        purpose: &'static str,
    },
    /// A search that cannot begin.
    #[error("{argument}: {error}")]
    Search {
        /// The option to blame.
        argument: &'static str,
        /// What is wrong.
        error: PortionError,
    },
    /// A file that holds no part of a search, or a damaged one.
    #[error("{argument}: {}: {error}; nothing was overwritten", path.display())]
    SearchFile {
        /// The option.
        argument: &'static str,
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: Box<RecordError>,
    },
    /// A file with another search than the one that is asked for.
    #[error(
        "{argument}: {}: it belongs to another search: {what} differs; nothing was overwritten, so name another \
         file, or ask for the same",
        path.display()
    )]
    OtherSearch {
        /// The option.
        argument: &'static str,
        /// The file.
        path: PathBuf,
        /// The option that differs.
        what: &'static str,
    },
    /// Shards that do not make up a search.
    #[error("FILE: {0}; nothing was written")]
    Merge(MergeError),
    /// An audit of nothing.
    #[error("--audit: {0}")]
    Audit(AuditError),
    /// A number that is too small or too large.
    #[error("{argument}: {given} is not between {least} and {most}")]
    Limits {
        /// The option.
        argument: &'static str,
        /// What was given.
        given: usize,
        /// The least that is allowed.
        least: usize,
        /// The most that is allowed.
        most: usize,
    },
    /// Numbers that are none for floats.
    #[error("{place}: in f64, {error}")]
    Float {
        /// Where they stand.
        place: Provenance,
        /// What is wrong with them.
        error: FloatMemberError,
    },
    /// Threads that cannot be had.
    #[error("--threads: {reason}")]
    Threads {
        /// Why not.
        reason: String,
    },
    /// A claim could not be certified: this program has a bug.
    #[error("internal error: {0}; please report this bug with the command line")]
    Certificate(#[from] CertificateError),
    /// There is no such figure.
    #[error(
        "NUMBER: there is no figure `{name}`: those of the paper are 1 to {last} (or fig1 to fig{last}), ours are {ours}",
        ours = list(ours)
    )]
    UnknownFigure {
        /// What was given.
        name: String,
        /// The last figure of the paper.
        last: usize,
        /// The names of the others.
        ours: Vec<&'static str>,
    },
    /// A file that is no picture by its name.
    #[error("--out: {}: the name ends neither in .svg nor in .png, which says what to draw", path.display())]
    PictureFile {
        /// The file.
        path: PathBuf,
    },
    /// Numbers of which no picture can be drawn.
    #[error(
        "--knots: nothing could be seen: numbers are beyond 1e150, or knots are equal as f64; move or stretch them"
    )]
    Unseen,
    /// A picture could not be drawn: a bug.
    #[error("internal error: {0}; please report this bug with the command line")]
    Picture(#[from] PictureError),
    /// The page of the report could not be written: a bug.
    #[error("internal error: {0}; please report this bug with the command line")]
    Page(#[from] PageError),
    /// Two parts of this program disagree: a bug.
    #[error("internal error: {0}; please report this bug with the command line")]
    Settle(#[from] SettleError),
    /// Text in the claim language that can't be read: all that is wrong with it.
    #[error("{argument}: {}", first(complaints))]
    Claim {
        /// Where it stands.
        argument: &'static str,
        /// What is wrong, each with its place and what to write instead.
        complaints: Vec<Complaint>,
    },
    /// An option that is about an index.
    #[error(
        "{option}: it is for the weights of an index only (families classical and mobius), and {family} has others; leave it \
         away, or choose an index with --alpha"
    )]
    OnlyIndices {
        /// The option.
        option: &'static str,
        /// The family.
        family: String,
    },
    /// A shape that can't be told.
    #[error(
        "--family: G_{index} is negative somewhere for {family} ({why}), and a shape is that of a function ≥ 0; choose \
         other parameters, or ask `knotproof check --claim` what you want to know"
    )]
    Negative {
        /// i.
        index: usize,
        /// The member.
        family: String,
        /// Which weight is not as those of nonnegative functions are, and why.
        why: String,
    },
    /// A result could not be written.
    #[error("cannot write the result: {0}")]
    Output(#[from] io::Error),
}

/// The first complaint, and how many there are.
fn first(complaints: &[Complaint]) -> String {
    let first = complaints.first().map(Complaint::message).unwrap_or_default();
    if complaints.len() > 1 { format!("{first} (the first of {})", complaints.len()) } else { first }
}

fn nurbs_argument(error: &NurbsError) -> &'static str {
    match error {
        NurbsError::Degree { .. } => "--degree-to",
        NurbsError::Part(error) => part_argument(error),
    }
}

fn part_argument(error: &CurvePartError) -> &'static str {
    match error {
        CurvePartError::From { .. } => "--from",
        CurvePartError::To { .. } => "--to",
    }
}

fn nurbs_advice(error: &NurbsFileError) -> &'static str {
    match error {
        NurbsFileError::Knots(..) => "move the knots nearer to 0, or stretch them; --as nurbs is exact",
        NurbsFileError::Range { .. } => "weights become smaller with --standard-form; --as nurbs is exact",
    }
}

fn list(items: &[impl ToString]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

impl CliError {
    /// The option that has to change.
    #[must_use]
    pub fn argument(&self) -> Option<&str> {
        match self {
            Self::Typed(error) => Some(error.argument()),
            Self::Float { place, .. } | Self::NoIndices { place } => Some(place.argument()),
            Self::Missing { argument, .. } | Self::Degree { argument, .. } => Some(argument),
            Self::NoPoints { .. } => Some("--points"),
            Self::Points { .. } | Self::NoPoint { .. } => Some("--points-file"),
            Self::OnlyIndices { option, .. } => Some(option),
            Self::TooHigh { .. } | Self::Quotients { .. } => Some("--degree"),
            Self::Nurbs(error) => Some(nurbs_argument(error)),
            Self::Part(error) => Some(part_argument(error)),
            Self::Coordinate { .. } | Self::NoCoordinate { .. } => Some("--coordinate"),
            Self::Normal { .. } => Some("--normal"),
            Self::Sites(_) | Self::Interpolation(_) | Self::Refinement(_) => Some("--at"),
            Self::NurbsFile(_) => Some("--as"),
            Self::UnknownInstance { .. } | Self::Malformed { .. } => Some("--instance"),
            Self::SeveralIndices { .. } | Self::AllIndices | Self::SymbolicIndex => Some("--alpha"),
            Self::UnknownCommand { .. } => Some("COMMAND"),
            Self::Width(_) => Some("--width"),
            Self::FreeKnot(_) | Self::TwoParameters => Some("--free-knot"),
            Self::Function { .. } | Self::NoDefinition { .. } => Some("--index"),
            Self::Expression { .. } => Some("--equals"),
            Self::NoSpan { .. } => Some("--span"),
            Self::UnknownClaim { argument, .. }
            | Self::TooMany { argument, .. }
            | Self::File { argument, .. }
            | Self::NoPaper { argument, .. }
            | Self::Windows { argument, .. } => Some(argument),
            Self::Degrees(_) => Some("--degrees"),
            Self::NotGeneral { .. } => Some("--property"),
            Self::Baseline { .. } => Some("--baseline"),
            Self::Needed { argument, .. }
            | Self::Limits { argument, .. }
            | Self::Search { argument, .. }
            | Self::SearchFile { argument, .. }
            | Self::OtherSearch { argument, .. } => Some(argument),
            Self::UnknownFigure { .. } => Some("NUMBER"),
            Self::PictureFile { .. } => Some("--out"),
            Self::Unseen => Some("--knots"),
            Self::Merge(_) => Some("FILE"),
            Self::Audit(_) => Some("--audit"),
            Self::Threads { .. } => Some("--threads"),
            Self::Claim { argument, .. } | Self::Foreign { argument, .. } => Some(argument),
            Self::Negative { .. } | Self::Bezier(_) => Some("--family"),
            Self::Recorded(_)
            | Self::NotRecorded(_)
            | Self::Conversion { .. }
            | Self::Certificate(_)
            | Self::Picture(_)
            | Self::Page(_)
            | Self::Settle(_)
            | Self::Output(_) => None,
            Self::NoCertificate { .. } => Some("PATH"),
        }
    }

    /// Are the functions of a basis quotients of a degree that is not too high?
    ///
    /// # Errors
    /// [`CliError::Quotients`], if not.
    pub fn if_quotients_exceed<W: HasWeights>(limit: usize, basis: &Basis<W>) -> Result<(), Self> {
        let degree = basis.knots().spans().map(|span| basis.quotient_degree(span)).max().unwrap_or(0);
        if degree > limit { Err(Self::Quotients { degree, limit }) } else { Ok(()) }
    }

    /// The claim that is not there, with those that begin like it.
    #[must_use]
    pub fn unknown_claim(argument: &'static str, name: &str, ids: &[&str]) -> Self {
        let like = |length: usize| -> Vec<String> {
            let start: String = name.chars().take(length).collect::<String>().to_lowercase();
            ids.iter().filter(|id| id.to_lowercase().starts_with(&start)).map(ToString::to_string).collect()
        };
        let near = (0..=name.chars().count()).rev().map(like).find(|near| !near.is_empty());
        Self::UnknownClaim { argument, name: name.to_owned(), near: near.unwrap_or_default() }
    }

    /// The lines of a text that the error is in, with a mark below the place; then what else is wrong with it.
    #[must_use]
    pub fn excerpt(&self) -> Option<String> {
        match self {
            Self::Expression { error, .. } => Some(error.excerpt()),
            Self::Claim { complaints, .. } => {
                let (first, others) = complaints.split_first()?;
                let others = others.iter().map(ToString::to_string);
                Some(std::iter::once(first.excerpt()).chain(others).collect::<Vec<_>>().join("\n\n"))
            }
            _ => None,
        }
    }

    /// All that is wrong with text in the claim language.
    #[must_use]
    pub fn complaints(&self) -> &[Complaint] {
        if let Self::Claim { complaints, .. } = self { complaints } else { &[] }
    }

    /// The exit code: the request is to blame, unless the program or its surroundings fail.
    #[must_use]
    pub fn exit(&self) -> Exit {
        match self {
            Self::Output(_)
            | Self::Settle(_)
            | Self::Certificate(_)
            | Self::Picture(_)
            | Self::Page(_)
            | Self::Conversion { .. }
            | Self::Recorded(_)
            | Self::NotRecorded(_) => Exit::Internal,
            _ => Exit::Usage,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;

    #[test]
    fn a_wrong_conversion_is_a_fault_of_the_program() {
        let error = CliError::Conversion { x: rational(1, 2) };
        assert_eq!((error.exit(), error.argument()), (Exit::Internal, None));
        assert!(error.to_string().contains("internal error") && error.to_string().contains("x = 1/2"));
    }
}
