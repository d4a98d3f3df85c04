//! A basis of any family, and all that is asked of it exactly.

use std::ffi::OsString;
use std::sync::Arc;

use knotproof::analysis::{
    Collocation, ExtremumKind, Factored, FormalBasis, InterpolationError, Location, Pieces, Shape,
    knot_slopes, settled,
};
use knotproof::cli::{CliError, family_of};
use knotproof::formula::{Form, Language, expression, formula};
use knotproof::language::Family;
use knotproof::meaning::{Instance, Values, Weighting};
use knotproof::scalar::{BigRational, integer};
use knotproof::spline::{self, AnyWeights, Index, KnotVector, Side};
use knotproof::typed::TypedError;
use pyo3::prelude::*;

use crate::check::{Wanted, judged};
use crate::curve::{Curve, Point};
use crate::error::Wrong;
use crate::floats;
use crate::work::{wait, wait_for};

/// Digits beside an exact enclosure.
pub(crate) const DIGITS: usize = 10;

/// α as it is given: a text, which may be `inf`, or a number.
#[derive(FromPyObject)]
pub(crate) enum Alpha {
    Text(String),
    Number(BigRational),
}

/// Settings of parameters, by rows.
pub(crate) type Settings = Vec<(String, Vec<Vec<BigRational>>)>;

impl Alpha {
    pub(crate) fn index(self) -> Result<Index, Wrong> {
        let index = match self {
            Self::Text(text) => text.parse(),
            Self::Number(alpha) => Index::from_alpha(alpha),
        };
        index.map_err(|error| Wrong::with("alpha", error))
    }
}

/// A family, and what is set of its parameters.
pub(crate) type Chosen = (Arc<Family>, Vec<(String, Values)>);

/// A family by its name or file, and its settings.
pub(crate) fn family(name: &str, settings: Settings) -> Result<Chosen, Wrong> {
    let family = family_of(&OsString::from(name))?;
    let shaped = |(name, rows): (String, _)| {
        let values = Values::shaped(rows, &family, &name);
        (name, values)
    };
    let given = settings.into_iter().map(shaped).collect();
    Ok((family, given))
}

/// The basis and the weights that it was made from.
#[derive(Debug)]
pub(crate) struct Inner {
    pub(crate) basis: spline::Basis<AnyWeights>,
    pub(crate) weights: Weighting,
}

/// Behind `knotproof.Basis`.
#[pyclass(frozen, module = "knotproof._native")]
#[derive(Debug, Clone)]
pub(crate) struct Basis(pub(crate) Arc<Inner>);

/// An extremum: kind, bounds of the place, is it a plateau, is it at a knot, bounds of the value, digits of both.
type Turn =
    (&'static str, (BigRational, BigRational), bool, bool, (BigRational, BigRational), (String, String));
/// A jump: where, the limits from below and from above.
type Step = (BigRational, BigRational, BigRational);
/// A knot with the slopes on both sides.
type Slope = (BigRational, Option<BigRational>, Option<BigRational>);
/// A piece: its ends, does the right one belong to it, numerator and denominator by rising powers of x, and both as text and in LaTeX.
type Piece = ((BigRational, BigRational), bool, [Vec<BigRational>; 2], [[String; 2]; 2]);
/// The rows of a collocation matrix, its rank and determinant, each i with G_i(x_i) = 0, and a relation of its columns.
type Matrix = (Vec<Vec<BigRational>>, usize, Option<BigRational>, Vec<usize>, Option<Vec<BigRational>>);

#[pymethods]
impl Basis {
    #[new]
    fn new(
        py: Python<'_>,
        knots: Vec<BigRational>,
        degree: usize,
        name: String,
        alpha: Option<Alpha>,
        settings: Settings,
    ) -> PyResult<Self> {
        let knots = KnotVector::new(knots).map_err(|error| Wrong::with("knots", error))?;
        let weights = match alpha {
            Some(alpha) => Weighting::Index(alpha.index()?),
            None => {
                let (of, given) = family(&name, settings)?;
                let weights = Weighting::of(&of, &given);
                weights.map_err(|error| Wrong::from(TypedError::Member { argument: "family", error }))?
            }
        };
        // Before the weights, whose number grows with the degree.
        let basis = spline::Basis::over(knots, degree, ()).map_err(|error| Wrong::with("knots", error))?;
        if weights.index().is_none() {
            return wait(py, move || Self::over(&basis, weights));
        }
        Ok(Self::over(&basis, weights)?)
    }

    #[getter]
    fn knots(&self) -> Vec<BigRational> {
        self.0.basis.knots().knots().to_vec()
    }

    #[getter]
    fn degree(&self) -> usize {
        self.0.basis.degree()
    }

    #[getter]
    fn n(&self) -> usize {
        self.0.basis.n()
    }

    /// α, `inf`, or nothing for another family.
    #[getter]
    fn alpha(&self) -> Option<String> {
        self.0.weights.index().map(ToString::to_string)
    }

    /// The name of another family than that of an index, and its parameters.
    #[getter]
    fn member(&self) -> Option<(String, Vec<(String, String)>)> {
        let member = self.0.weights.member()?;
        let named = member.named().map(|(name, values)| (name.to_string(), values.to_string()));
        Some((member.family().name.clone(), named.collect()))
    }

    fn multiplicity(&self, x: BigRational) -> usize {
        self.0.basis.knots().multiplicity(&x)
    }

    fn support(&self, i: usize) -> (BigRational, BigRational) {
        let (from, to) = self.0.basis.support(i);
        (from.clone(), to.clone())
    }

    /// The derivatives of order `nu` of all functions at x.
    fn values(&self, py: Python<'_>, x: BigRational, nu: usize, left: bool) -> PyResult<Vec<BigRational>> {
        let (own, side) = (self.clone(), side(left));
        wait_for(py, nu >= SLOW, move || {
            Ok(match nu {
                0 => own.0.basis.values(&x, side),
                _ => {
                    own.0.basis.jets(&x, side, nu).iter().filter_map(|jet| jet.derivatives().pop()).collect()
                }
            })
        })
    }

    fn pieces(&self, py: Python<'_>, i: usize) -> PyResult<Vec<Piece>> {
        let own = self.clone();
        wait(py, move || {
            let formal = own.formal()?;
            let of = |piece: &knotproof::analysis::FormalPiece| {
                let both = [&piece.numerator, &piece.denominator];
                let texts = [Language::Text, Language::Latex]
                    .map(|language| both.map(|part| expression(part, language, Form::Factored)));
                ((piece.from.clone(), piece.to.clone()), piece.closed, both.map(coefficients), texts)
            };
            Ok(formal.functions()[i].pieces.iter().map(of).collect())
        })
    }

    /// All functions or one, as a program of SymPy or in LaTeX.
    fn formula(&self, py: Python<'_>, i: Option<usize>, sympy: bool) -> PyResult<String> {
        let own = self.clone();
        let language = if sympy { Language::Sympy } else { Language::Latex };
        wait(py, move || Ok(formula(&own.formal()?, i, language, Form::Factored)))
    }

    #[expect(clippy::type_complexity, reason = "a tuple that Python takes apart")]
    fn shape(
        &self,
        py: Python<'_>,
        i: usize,
        width: BigRational,
    ) -> PyResult<(Vec<Turn>, Vec<Step>, Vec<Slope>, Option<bool>)> {
        let own = self.clone();
        wait(py, move || {
            let mut shape = own.shape_of(i)?;
            shape.refine_to(&width);
            let turns = shape.extrema().iter().map(|extremum| {
                let kind = match extremum.kind {
                    ExtremumKind::Maximum => "maximum",
                    ExtremumKind::Minimum => "minimum",
                };
                let (lo, hi) = extremum.place.interval();
                let plateau = matches!(extremum.place, Location::Plateau { .. });
                let digits = (settled(&mut extremum.x(), DIGITS), settled(&mut extremum.height(), DIGITS));
                (kind, (lo.clone(), hi.clone()), plateau, extremum.at_knot, extremum.value.clone(), digits)
            });
            let turns = turns.collect();
            let jumps = shape.jumps().iter().cloned().map(|jump| (jump.at, jump.left, jump.right)).collect();
            let slopes = knot_slopes(&own.0.basis, i).into_iter();
            let slopes = slopes.map(|slope| (slope.at, slope.left, slope.right)).collect();
            Ok((turns, jumps, slopes, shape.weak()))
        })
    }

    /// What claims come to on this basis, each as JSON.
    fn check(
        &self,
        py: Python<'_>,
        claims: Vec<String>,
        sentence: Option<String>,
        paper: Option<String>,
        classical: bool,
        points: Option<Vec<Vec<BigRational>>>,
    ) -> PyResult<Vec<String>> {
        let own = self.clone();
        let wanted = Wanted { claims, sentence, paper, classical, points };
        wait(py, move || judged(&own.0, wanted))
    }

    fn curve(&self, points: Vec<Vec<BigRational>>) -> Result<Curve, Wrong> {
        let curve = spline::Curve::new(self.0.basis.clone(), points);
        let curve = curve.map_err(|error| Wrong::with("points", error))?;
        Ok(Curve(Arc::new(curve)))
    }

    /// The matrix of all functions at these places.
    fn collocation(&self, py: Python<'_>, at: Vec<BigRational>) -> PyResult<Matrix> {
        let own = self.clone();
        wait(py, move || {
            let collocation = Collocation::new(&own.0.basis, at).map_err(CliError::from)?;
            let (rows, rank) = (collocation.rows().to_vec(), collocation.rank());
            let (determinant, misplaced) = (collocation.determinant(), collocation.misplaced());
            Ok((rows, rank, determinant, misplaced, collocation.relation()))
        })
    }

    /// The control points of the curve through these points.
    fn interpolate(&self, py: Python<'_>, at: Vec<BigRational>, points: Vec<Point>) -> PyResult<Vec<Point>> {
        let own = self.clone();
        wait(py, move || {
            let collocation = Collocation::new(&own.0.basis, at).map_err(CliError::from)?;
            let curve = collocation.interpolate(&points).map_err(|error| {
                let of_points =
                    matches!(error, InterpolationError::Points { .. } | InterpolationError::Curve(_));
                Wrong::with(if of_points { "points" } else { "at" }, error)
            });
            Ok(curve?.points().to_vec())
        })
    }

    /// The first function that lives at each x, and k + 1 values for each: see [`floats::design`].
    fn floats(&self, py: Python<'_>, xs: &[u8]) -> PyResult<(Vec<u8>, Vec<u8>)> {
        let (own, xs) = (self.clone(), floats::read(xs));
        wait(py, move || {
            let (first, values) = floats::design(&own.0.basis, &xs)?;
            Ok((first.into_iter().flat_map(i64::to_ne_bytes).collect(), floats::written(&values)))
        })
    }
}

/// The order from which on derivatives may take long.
pub(crate) const SLOW: usize = 8;

pub(crate) fn side(left: bool) -> Side {
    if left { Side::Left } else { Side::Right }
}

/// By rising powers of x.
fn coefficients(polynomial: &Factored) -> Vec<BigRational> {
    let parts = polynomial.expanded().coefficients_in(FormalBasis::X);
    parts.iter().map(|c| integer(c.as_constant().unwrap_or_default())).collect()
}

impl Basis {
    fn over(basis: &spline::Basis<()>, weights: Weighting) -> Result<Self, Wrong> {
        let on = weights.on_knots(basis.knots(), basis.degree());
        let on = on.map_err(|error| TypedError::Member { argument: "family", error })?;
        Ok(Self(Arc::new(Inner { basis: basis.with(on), weights })))
    }

    fn formal(&self) -> Result<FormalBasis, Wrong> {
        let Inner { basis, weights } = &*self.0;
        let formal = match basis.weights() {
            AnyWeights::Index(index) => FormalBasis::of(&basis.with(index.clone())),
            AnyWeights::Forms(table) => {
                CliError::if_quotients_exceed(FormalBasis::QUOTIENT_LIMIT, basis)?;
                FormalBasis::of_forms(&basis.with(table.clone()), weights.to_string())
            }
        };
        let (degree, limit) = (basis.degree(), FormalBasis::DEGREE_LIMIT);
        let reason = "a numerator has up to (k + 2)²/4 powers of x; B gives values of every degree";
        Ok(formal.ok_or(CliError::TooHigh { degree, limit, reason })?)
    }

    /// The shape of G_i, which has to be ≥ 0: of another family that is looked at first.
    fn shape_of(&self, i: usize) -> Result<Shape, Wrong> {
        let Inner { basis, weights } = &*self.0;
        if weights.member().is_some() {
            let on = Instance::on(basis.with(weights.clone()));
            let on = on.map_err(|error| TypedError::Member { argument: "family", error })?;
            if on.is_nonnegative(weights, (i, basis.degree())) != Some(true) {
                let why = on
                    .obligation(weights)
                    .map(|((j, i, d), why)| format!("w[{i},{d}] on [t_{j}, t_{}]: {why}", j + 1));
                let why = why.unwrap_or_default();
                return Err(CliError::Negative { index: i, family: weights.to_string(), why }.into());
            }
        }
        Ok(Shape::of(&Pieces::of(basis), i))
    }
}
