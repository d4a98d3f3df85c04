//! The arguments that say what a command works on: a paper instance, a file, or degree, knots and index.

use std::collections::HashSet;
use std::ffi::OsString;
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;

use crate::language::Family;
use crate::meaning::{Example, Weighting, examples};
use crate::spline::{AnyWeights, Basis, Curve, Index, IndexError, KnotVector, Point};
use crate::typed::{ChosenFamily, Provenance, TypedError, curve, knot_vector, numbers, points, whole_number};

use super::error::CliError;
use super::exact::Exact;
use super::family::FamilyArgs;
use super::file::InstanceFile;
use super::offered::{instance_name, instance_names};
use super::visible::visible_path;

/// What a command works on. Options override what an instance brings along.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct InstanceArgs {
    /// An instance of the paper (U0 to U13, C5, C6a, C6b, C7a to C7c, S1 to S7), or a JSON file as in
    /// `knotproof schema`.
    #[arg(long, value_name = "NAME|FILE", value_parser = instance_name(), hide_possible_values = true)]
    instance: Option<OsString>,
    /// The degree k; chooses among the degrees of an instance that has several.
    #[arg(long, value_name = "K", value_parser = whole_number, allow_hyphen_values = true)]
    degree: Option<usize>,
    /// The knots t_0 ≤ … ≤ t_m, separated by commas or spaces: "0 0 0 1/2 1 1 1". Exponents: 1e-400 to 1e400, 0x1p-1100 to
    /// 0x1p1100.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    knots: Option<String>,
    /// The index α: less than 0, greater than 1, or inf. Replaces the indices of an instance; may be repeated
    /// where several make sense.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    alpha: Vec<IndexChoice>,
    /// The control points of a curve: "0,2 3/2,5 5/2,4", "(0,2),(3/2,5)", "0 2; 3/2 5" or JSON. With commas only,
    /// or none, points of one coordinate: "0 1 4".
    #[arg(long, value_name = "POINTS", allow_hyphen_values = true)]
    points: Option<String>,
    #[command(flatten)]
    family: FamilyArgs,
}

/// A value of `--alpha`.
#[derive(Debug, Clone, PartialEq, Eq)]
enum IndexChoice {
    One(Index),
    /// `all`, for the commands that take the index as unknown.
    All,
    /// `symbolic`, for formulas with the index as a letter.
    Symbolic,
}

impl FromStr for IndexChoice {
    type Err = IndexError;

    fn from_str(text: &str) -> Result<Self, IndexError> {
        match text.trim().to_ascii_lowercase().as_str() {
            "all" => Ok(Self::All),
            "symbolic" => Ok(Self::Symbolic),
            _ => text.parse().map(Self::One),
        }
    }
}

/// What a command works on, and the argument that picks one basis function of it.
#[derive(Debug, clap::Args)]
pub(super) struct FunctionArgs {
    #[command(flatten)]
    pub(super) instance: InstanceArgs,
    /// Only the basis function G_I, I from 0 to n.
    #[arg(long, value_name = "I", value_parser = whole_number, allow_hyphen_values = true)]
    index: Option<usize>,
}

/// What a command works on, checked: one case for each index, at least one.
#[derive(Debug)]
pub(super) struct Subjects {
    /// The name of the paper's instance, or the file.
    pub(super) label: Option<String>,
    /// The same degree, knots and points with each index.
    pub(super) cases: Vec<Subject>,
}

/// What a command works on, of any family.
#[derive(Debug)]
pub(super) enum Resolved {
    /// With the weights of indices.
    Indices(Subjects),
    /// With those of another family's member.
    Member(MemberSubject),
}

/// A degree on knots with a member of another family than that of an index.
#[derive(Debug)]
pub(super) struct MemberSubject {
    /// The name of the paper's instance, or the file.
    pub(super) label: Option<String>,
    /// Its knots and weights.
    pub(super) basis: Basis<Weighting>,
    /// Control points, as many as there are functions, and where they stand.
    pub(super) points: Option<(Vec<Point>, Provenance)>,
}

impl MemberSubject {
    /// The name of the family.
    pub(super) fn family(&self) -> String {
        self.basis.weights().member().map(|member| member.family().name.clone()).unwrap_or_default()
    }
}

/// One basis of any family with its weights, and the curve if there are control points.
#[derive(Debug)]
pub(super) struct Case {
    /// The name of the paper's instance, or the file.
    pub(super) label: Option<String>,
    /// α, or the member of another family.
    pub(super) weights: Weighting,
    /// The basis.
    pub(super) basis: Basis<AnyWeights>,
    /// The curve on it.
    pub(super) curve: Option<Curve<AnyWeights>>,
}

/// A basis, and the curve if there are control points.
#[derive(Debug)]
pub(super) struct Subject {
    /// The basis.
    pub(super) basis: Basis,
    /// The curve on it.
    pub(super) curve: Option<Curve>,
}

/// What an instance brings along, and where each part stands.
#[derive(Debug, Default)]
struct Given {
    label: Option<String>,
    degree: Option<usize>,
    knots: Option<(KnotVector, Provenance)>,
    weights: Vec<Weighting>,
    points: Option<(Vec<Point>, Provenance)>,
}

impl InstanceArgs {
    /// Reads the instance, lets the options override it, and checks that all of it fits together; for the commands that know
    /// the weights of an index only.
    ///
    /// # Errors
    /// [`CliError`], for the first thing that is wrong.
    pub(super) fn resolve(&self) -> Result<Subjects, CliError> {
        match self.resolve_any()? {
            Resolved::Indices(subjects) => Ok(subjects),
            Resolved::Member(subject) => {
                Err(CliError::OnlyIndices { option: "--alpha", family: subject.family() })
            }
        }
    }

    /// The same for any family.
    ///
    /// # Errors
    /// [`CliError`], for the first thing that is wrong.
    pub(super) fn resolve_any(&self) -> Result<Resolved, CliError> {
        self.resolve_among(examples(), None)
    }

    /// The same, with these instances for names, and a paper's `own` family where no other is named.
    ///
    /// # Errors
    /// [`CliError`], for the first thing that is wrong.
    pub(super) fn resolve_among(
        &self,
        examples: &[Example],
        own: Option<&Arc<Family>>,
    ) -> Result<Resolved, CliError> {
        let member = self.family(own)?.as_ref().map(ChosenFamily::member).transpose()?;
        let given = match &self.instance {
            Some(name) => self.named(name, examples)?,
            None => Given::default(),
        };
        let knots = match &self.knots {
            Some(text) => {
                let place = Provenance::option("--knots");
                Some((knot_vector(numbers(text, &place)?, &place)?, place))
            }
            None => given.knots,
        };
        let points = match &self.points {
            Some(text) => Some((points(text)?, Provenance::option("--points"))),
            None => given.points,
        };
        let missing = |argument, purpose| CliError::Missing { argument, purpose };
        let label = given.label.map(|label| self.changed(&label, given.degree));
        let degree = self.degree.or(given.degree);
        let degree = degree.ok_or_else(|| missing("--degree", "give the degree, such as --degree 2"))?;
        let (knots, place) =
            knots.ok_or_else(|| missing("--knots", "give the knots, such as --knots \"0 0 0 1 2 2 2\""))?;
        let member = member.map(|member| vec![member]);
        let alpha = self.indices()?.map(|list| list.into_iter().map(Weighting::Index).collect());
        let mut weights = member.or(alpha).unwrap_or(given.weights);
        // What an index α is missing for, --alpha gives: only another family asks for its own parameters.
        if let (true, Some(own)) =
            (weights.is_empty(), own.filter(|own| !matches!(own.moebius(), Some(Some(_)))))
        {
            weights.push(ChosenFamily { family: Arc::clone(own), given: Vec::new() }.member()?);
        }
        if let Some(weights @ Weighting::Family(_)) = weights.first() {
            let basis = Basis::over(knots, degree, weights.clone())
                .map_err(|error| TypedError::Basis { place: place.clone(), error })?;
            if let Some((points, place)) = &points {
                curve(&basis, points, place)?;
            }
            return Ok(Resolved::Member(MemberSubject { label, basis, points }));
        }
        let mut indices: Vec<_> = weights.iter().filter_map(Weighting::index).cloned().collect();
        let mut seen = HashSet::new();
        indices.retain(|index| seen.insert(index.clone()));
        if indices.is_empty() {
            return Err(missing("--alpha", "give the index, such as --alpha -1 or --alpha inf"));
        }
        // The degree is to blame if it is all that the user chose.
        let place = if self.degree.is_some() && self.knots.is_none() {
            Provenance::option("--degree")
        } else {
            place
        };
        let case = |index| {
            let basis = Basis::new(knots.clone(), degree, index)
                .map_err(|error| TypedError::Basis { place: place.clone(), error })?;
            let curve = points.as_ref().map(|(points, place)| curve(&basis, points, place)).transpose()?;
            Ok(Subject { basis, curve })
        };
        let cases = indices.into_iter().map(case).collect::<Result<_, CliError>>()?;
        Ok(Resolved::Indices(Subjects { label, cases }))
    }

    /// The family that is chosen, if there is one: see [`FamilyArgs::chosen`].
    ///
    /// # Errors
    /// [`CliError`], where it is not there or not well formed, or a setting is not.
    pub(super) fn family(&self, own: Option<&Arc<Family>>) -> Result<Option<ChosenFamily>, CliError> {
        self.family.chosen(own)
    }

    /// Are control points given by an option?
    pub(super) fn has_points(&self) -> bool {
        self.points.is_some()
    }

    /// Is nothing said at all?
    pub(super) fn is_absent(&self) -> bool {
        self.is_without_knots() && self.family.is_absent()
    }

    /// Is nothing said but perhaps a family?
    pub(super) fn is_without_knots(&self) -> bool {
        let Self { instance, degree, knots, alpha, points, family: _ } = self;
        instance.is_none() && degree.is_none() && knots.is_none() && alpha.is_empty() && points.is_none()
    }

    /// The name of an instance, and what the options have made different in it. Indices are shown anyway.
    fn changed(&self, label: &str, degree: Option<usize>) -> String {
        let parts = [
            ("degree", self.degree.is_some() && self.degree != degree),
            ("knots", self.knots.is_some()),
            ("points", self.points.is_some()),
        ];
        let other: Vec<_> = parts.iter().filter(|(_, other)| *other).map(|(part, _)| *part).collect();
        match other.split_last() {
            None => label.to_owned(),
            Some((last, [])) => format!("{label}, with other {last}"),
            Some((last, rest)) => format!("{label}, with other {} and {last}", rest.join(", ")),
        }
    }

    /// The degree, where no knots are given or named.
    pub(super) fn degree_alone(&self) -> Option<Result<usize, CliError>> {
        let missing = CliError::Needed {
            argument: "--degree",
            purpose: "give the degree of random cases, such as --degree 3, or knots with --knots or --instance",
        };
        (self.instance.is_none() && self.knots.is_none()).then(|| self.degree.ok_or(missing))
    }

    /// The indices of `--alpha`, if there are any.
    pub(super) fn indices(&self) -> Result<Option<Vec<Index>>, CliError> {
        let one = |choice: &IndexChoice| match choice {
            IndexChoice::One(index) => Ok(index.clone()),
            IndexChoice::All => Err(CliError::AllIndices),
            IndexChoice::Symbolic => Err(CliError::SymbolicIndex),
        };
        let indices = self.alpha.iter().map(one).collect::<Result<Vec<_>, _>>()?;
        Ok((!indices.is_empty()).then_some(indices))
    }

    /// Is `--alpha all` what is asked for? Then there is one case, and its index stands for nothing.
    pub(super) fn every_index(&self) -> Option<Self> {
        (self.alpha == [IndexChoice::All]).then(|| self.with_stand_in())
    }

    /// Is `--alpha symbolic` what is asked for? Then likewise.
    pub(super) fn symbolic_index(&self) -> Option<Self> {
        (self.alpha == [IndexChoice::Symbolic]).then(|| self.with_stand_in())
    }

    fn with_stand_in(&self) -> Self {
        Self { alpha: vec![IndexChoice::One(Index::infinity())], ..self.clone() }
    }

    /// A paper instance if the name is known, a file otherwise.
    fn named(&self, name: &OsString, examples: &[Example]) -> Result<Given, CliError> {
        let known: Vec<_> =
            examples.iter().filter(|example| name.to_str() == Some(&*example.name)).cloned().collect();
        if known.is_empty() { from_file(Path::new(name), examples) } else { self.choose(known) }
    }

    /// The instance of the name that has the degree asked for.
    fn choose(&self, mut known: Vec<Example>) -> Result<Given, CliError> {
        let position = match self.degree {
            // With one degree only, another one overrides it: a choice is wanted where there are several.
            _ if known.len() == 1 => Some(0),
            Some(degree) => known.iter().position(|instance| instance.degree == degree),
            None => None,
        };
        let Some(position) = position else {
            let argument = if self.degree.is_some() { "--degree" } else { "--instance" };
            let degrees = known.iter().map(|instance| instance.degree).collect();
            return Err(CliError::Degree { argument, name: known[0].name.to_string(), degrees });
        };
        let chosen = known.swap_remove(position);
        Ok(Given {
            label: Some(format!("{} ({})", chosen.name, chosen.figure)),
            degree: Some(chosen.degree),
            knots: Some((chosen.knots, Provenance::paper(&chosen.name, "knots"))),
            weights: chosen.weights,
            points: chosen.points.map(|points| (points, Provenance::paper(&chosen.name, "points"))),
        })
    }
}

impl FunctionArgs {
    /// The function asked for, if any.
    ///
    /// # Errors
    /// [`CliError::Function`] if the basis has no such function.
    pub(super) fn chosen<W>(&self, basis: &Basis<W>) -> Result<Option<usize>, CliError> {
        match self.index {
            Some(index) if index > basis.n() => Err(CliError::Function { index, n: basis.n() }),
            index => Ok(index),
        }
    }

    /// That function, or all of them.
    ///
    /// # Errors
    /// As [`chosen`](Self::chosen).
    pub(super) fn range<W>(&self, basis: &Basis<W>) -> Result<RangeInclusive<usize>, CliError> {
        Ok(self.chosen(basis)?.map_or(0..=basis.n(), |i| i..=i))
    }
}

impl Resolved {
    /// A case for each index, or that of the member, with its weights on the knots; at least one.
    ///
    /// # Errors
    /// [`CliError::Member`] if the member of a family gives no weights on the knots.
    pub(super) fn cases(self) -> Result<Vec<Case>, CliError> {
        match self {
            Self::Indices(Subjects { label, cases }) => {
                let case = |Subject { basis, curve }| {
                    let index = Basis::index(&basis).clone();
                    let weights = AnyWeights::Index(index.clone());
                    Case {
                        label: label.clone(),
                        weights: Weighting::Index(index),
                        curve: curve.map(|curve| curve.with(weights.clone())),
                        basis: basis.with(weights),
                    }
                };
                Ok(cases.into_iter().map(case).collect())
            }
            Self::Member(MemberSubject { label, basis, points }) => {
                let weights = basis.weights().clone();
                let on = weights.on_knots(basis.knots(), basis.degree());
                let on = on.map_err(|error| TypedError::Member { argument: "--family", error })?;
                let basis = basis.with(on);
                let curve = points.map(|(points, place)| curve(&basis, &points, &place)).transpose()?;
                Ok(vec![Case { label, weights, basis, curve }])
            }
        }
    }

    /// The one case there is.
    ///
    /// # Errors
    /// Those of [`cases`](Self::cases), and [`CliError::SeveralIndices`] if there are several.
    pub(super) fn only_case(self) -> Result<Case, CliError> {
        let mut cases = self.cases()?;
        match (cases.pop(), cases.is_empty()) {
            (Some(case), true) => Ok(case),
            (last, _) => {
                let cases = cases.iter().chain(&last);
                Err(CliError::SeveralIndices {
                    indices: cases.filter_map(|case| case.weights.index()).map(ToString::to_string).collect(),
                })
            }
        }
    }
}

fn from_file(path: &Path, examples: &[Example]) -> Result<Given, CliError> {
    let file = InstanceFile::read(path).map_err(|error| match error {
        CliError::File { path, error, .. } if error.kind() == std::io::ErrorKind::NotFound => {
            unknown(&path, examples)
        }
        error => error,
    })?;
    let exact = |numbers: Vec<Exact>| numbers.into_iter().map(|Exact(number)| number).collect::<Vec<_>>();
    let place = Provenance::field(path, "knots");
    let knots = knot_vector(exact(file.knots), &place)?;
    let indices = match file.alpha {
        Some(indices) if indices.0.is_empty() => {
            return Err(CliError::NoIndices { place: Provenance::field(path, "alpha") });
        }
        Some(indices) => indices.0,
        None => Vec::new(),
    };
    let points = file.points.map(|points| points.into_iter().map(exact).collect());
    Ok(Given {
        label: Some(visible_path(path)),
        degree: Some(file.degree.0),
        knots: Some((knots, place)),
        weights: indices.into_iter().map(Weighting::Index).collect(),
        points: points.map(|points| (points, Provenance::field(path, "points"))),
    })
}

fn unknown(path: &Path, examples: &[Example]) -> CliError {
    let names = instance_names(examples).into_iter().map(str::to_owned).collect();
    CliError::UnknownInstance { name: path.display().to_string(), names }
}
