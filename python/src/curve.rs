//! Curves.

use std::sync::Arc;

use knotproof::analysis::{
    Angle, Branch, CurvePartError, Join, Nurbs, NurbsError, NurbsRequest, RationalBezier, Surd, joins,
    refined, settled,
};
use knotproof::cli::{CliError, if_too_high};
use knotproof::report::{NurbsFile, nurbs_file};
use knotproof::scalar::BigRational;
use knotproof::spline::{self, AnyWeights, CurveEvaluator};
use pyo3::prelude::*;

use crate::basis::{DIGITS, SLOW, side};
use crate::error::Wrong;
use crate::floats;
use crate::measure::{self, Bounds, Function, Known, Part, Solved};
use crate::work::{wait, wait_for};

pub(crate) type Point = Vec<BigRational>;

/// A side of a join: point, first derivative, direction and vector of curvature.
type SideOf = (Point, Point, Option<Point>, Option<Point>);
/// A join: knot, multiplicity, does the curve close there, G⁰, G¹, G², cos² and is it obtuse, degrees, the square of the ratio of
/// speeds, the jump of the curvature, both sides.
type JoinOf = (
    (BigRational, usize, bool),
    (bool, Option<bool>, Option<bool>),
    Option<(BigRational, bool, String)>,
    (Option<BigRational>, Option<String>),
    (SideOf, SideOf),
);
/// A NURBS curve: degree, knots, weights, control points, and for each span its ends, λ and the weight at its end.
type NurbsOf = (
    usize,
    Vec<BigRational>,
    Vec<BigRational>,
    Vec<Point>,
    Vec<([BigRational; 2], BigRational, BigRational)>,
);

/// Behind `knotproof.Curve`.
#[pyclass(frozen, module = "knotproof._native")]
#[derive(Debug, Clone)]
pub(crate) struct Curve(pub(crate) Arc<spline::Curve<AnyWeights>>);

#[pymethods]
impl Curve {
    #[getter]
    fn points(&self) -> Vec<Point> {
        self.0.points().to_vec()
    }

    /// The derivative of order `nu`.
    fn point(&self, py: Python<'_>, x: BigRational, nu: usize, left: bool) -> PyResult<Point> {
        let own = self.clone();
        wait_for(py, nu >= SLOW, move || {
            let jets = own.0.jets(&x, side(left), nu);
            Ok(jets.iter().filter_map(|jet| jet.derivatives().pop()).collect())
        })
    }

    fn tangent(
        &self,
        py: Python<'_>,
        x: BigRational,
        left: bool,
    ) -> PyResult<Option<(usize, Point, Option<Point>)>> {
        let own = self.clone();
        wait_for(py, false, move || {
            let tangent = CurveEvaluator::new(&own.0).tangent(&x, side(left));
            Ok(tangent.map(|tangent| (tangent.order, tangent.direction, tangent.curvature)))
        })
    }

    fn joins(&self, py: Python<'_>) -> PyResult<Vec<JoinOf>> {
        let own = self.clone();
        wait(py, move || Ok(joins(&own.0).iter().map(join).collect()))
    }

    /// The same curve as NURBS curves, one for each connected run; with a `file` the text of one, too.
    fn nurbs(
        &self,
        py: Python<'_>,
        degree_and_ends: (Option<usize>, Option<BigRational>, Option<BigRational>),
        standard_form: bool,
        file: Option<String>,
    ) -> PyResult<(Vec<NurbsOf>, Option<String>)> {
        let (own, (degree, from, to)) = (self.clone(), degree_and_ends);
        let request = NurbsRequest { degree, from, to, standard_form };
        wait(py, move || {
            let pieces = RationalBezier::pieces(&own.0).collect::<Result<Vec<_>, _>>();
            let runs = Nurbs::joined(&own.0, &pieces.map_err(CliError::from)?, &request);
            let runs = runs.map_err(|error| {
                let argument = match error {
                    NurbsError::Degree { .. } => "degree",
                    NurbsError::Part(CurvePartError::From { .. }) => "start",
                    NurbsError::Part(CurvePartError::To { .. }) => "end",
                };
                Wrong::with(argument, error)
            })?;
            // Turned back it has to be the curve, for every x.
            for piece in runs.iter().flat_map(Nurbs::pieces) {
                piece.disagreement(&own.0).map_or(Ok(()), |x| Err(CliError::Conversion { x }))?;
            }
            let text = match file.as_deref() {
                None => None,
                Some("geomdl") => Some(nurbs_file(&runs, NurbsFile::Geomdl)),
                Some("step") => Some(nurbs_file(&runs, NurbsFile::Step)),
                Some(other) => {
                    return Err(Wrong::with("format", format!("`{other}` is neither geomdl nor step")));
                }
            };
            let text = text.transpose().map_err(|error| Wrong::with("format", error))?;
            Ok((runs.iter().map(nurbs).collect(), text))
        })
    }

    /// Where a·c(x) is a value.
    fn solve(
        &self,
        py: Python<'_>,
        part: Part,
        function: Function,
        value: BigRational,
    ) -> PyResult<Vec<Solved>> {
        let own = self.clone();
        wait(py, move || measure::solutions(&own.0, &part, function, &value))
    }

    /// The lowest and the highest value of a·c(x), or of each coordinate.
    fn bounds(&self, py: Python<'_>, part: Part, function: Option<Function>) -> PyResult<Vec<[Bounds; 2]>> {
        let own = self.clone();
        wait(py, move || measure::bounds(&own.0, &part, function))
    }

    fn length(&self, py: Python<'_>, part: Part) -> PyResult<Known> {
        let own = self.clone();
        wait(py, move || measure::length_of(&own.0, &part))
    }

    /// Of each coordinate.
    fn integrals(&self, py: Python<'_>, part: Part) -> PyResult<Vec<Known>> {
        let own = self.clone();
        wait(py, move || measure::integrals_of(&own.0, &part))
    }

    /// The control points of the same curve on its knots and these; `family` is what its basis is of.
    fn insert(&self, py: Python<'_>, at: Vec<BigRational>, family: String) -> PyResult<Vec<Point>> {
        let own = self.clone();
        wait(py, move || {
            let AnyWeights::Index(index) = own.0.basis().weights() else {
                return Err(CliError::OnlyIndices { option: "--at", family }.into());
            };
            if_too_high(own.0.basis())?;
            let finer = refined(&own.0.with(index.clone()), &at).map_err(CliError::from)?;
            Ok(finer.points().to_vec())
        })
    }

    /// Points at floats of the base interval, one after the other.
    fn floats(&self, py: Python<'_>, xs: &[u8]) -> PyResult<Vec<u8>> {
        let (own, xs) = (self.clone(), floats::read(xs));
        wait(py, move || Ok(floats::written(&floats::points(&own.0, &xs)?)))
    }
}

fn join(join: &Join) -> JoinOf {
    let angle = join.angle().map(|mut angle: Angle| {
        let degrees = settled(&mut angle, DIGITS);
        (angle.cosine_square().clone(), angle.is_obtuse(), degrees)
    });
    let jump = join.curvature_jump().map(|mut jump: Surd| settled(&mut jump, DIGITS));
    (
        (join.knot.clone(), join.multiplicity, join.closing),
        (join.g0(), join.g1(), join.g2()),
        angle,
        (join.speed_ratio_square(), jump),
        (branch(&join.before), branch(&join.after)),
    )
}

fn branch(branch: &Branch) -> SideOf {
    let tangent = branch.tangent.as_ref();
    (
        branch.point.clone(),
        branch.velocity.clone(),
        tangent.map(|tangent| tangent.direction.clone()),
        tangent.and_then(|tangent| tangent.curvature.clone()),
    )
}

fn nurbs(run: &Nurbs) -> NurbsOf {
    let parameters = run.parameters().iter().cloned();
    let parameters = parameters.map(|parameter| (parameter.ends, parameter.ratio, parameter.weight));
    (run.degree(), run.knots().to_vec(), run.weights().cloned().collect(), run.points(), parameters.collect())
}
