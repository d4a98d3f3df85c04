//! What there is to say of one point: the one place where `eval` computes.

use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use crate::meaning::Weighting;
use crate::scalar::{Jet, integer};
use crate::spline::{Active, AnyWeights, Basis, Curve, CurveEvaluator, Sampler};

use super::super::exact::Exact;
use super::OneSide;

/// What is asked for at every point.
pub(super) struct Request<'a> {
    pub(super) basis: &'a Basis<AnyWeights>,
    pub(super) weights: &'a Weighting,
    pub(super) curve: Option<&'a Curve<AnyWeights>>,
    /// The one function that is wanted; all if there is none.
    pub(super) index: Option<usize>,
    /// The highest derivative.
    pub(super) order: usize,
}

/// What is prepared once for all points.
pub(super) struct Prepared<'a> {
    functions: Sampler<'a, AnyWeights>,
    pub(super) curve: Option<CurveEvaluator<'a, AnyWeights>>,
}

/// The values at a point: the fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(in super::super) struct PointValues {
    /// x.
    pub(super) x: Exact,
    /// The side from which limits are taken.
    pub(super) side: OneSide,
    /// G_0^k(x), …, G_n^k(x), or the one that was asked for.
    pub(super) values: Vec<Exact>,
    /// Entry d − 1 holds the d-th derivatives of the functions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) derivatives: Vec<Vec<Exact>>,
    /// With control points: the point of the curve, as a list of coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) curve: Option<Vec<Exact>>,
    /// Entry d − 1 holds the d-th derivative of the curve.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) curve_derivatives: Vec<Vec<Exact>>,
}

impl<'a> Request<'a> {
    /// Prepares the basis and the curve.
    pub(super) fn prepared(&self) -> Prepared<'a> {
        Prepared { functions: Sampler::new(self.basis), curve: self.curve.map(CurveEvaluator::new) }
    }

    /// The indices of the functions that are asked for.
    pub(super) fn functions(&self) -> std::ops::RangeInclusive<usize> {
        self.index.map_or(0..=self.basis.n(), |index| index..=index)
    }

    /// Values and derivatives at x, as limits from the side.
    pub(super) fn at(&self, prepared: &mut Prepared<'_>, x: BigRational, side: OneSide) -> PointValues {
        let zero = Jet::constant(integer(0), self.order);
        let active = prepared
            .functions
            .jets(&x, side.into(), self.order)
            .unwrap_or_else(|| Active::new(0, Vec::new()));
        let functions = self.functions().map(|i| active.get(i).unwrap_or(&zero).clone()).collect::<Vec<_>>();
        let mut derivatives = self.by_order(&functions);
        let values = derivatives.remove(0);
        let jets = prepared.curve.as_mut().map(|curve| curve.jets(&x, side.into(), self.order));
        let mut curve_derivatives = jets.map(|jets| self.by_order(&jets)).unwrap_or_default();
        let curve = (!curve_derivatives.is_empty()).then(|| curve_derivatives.remove(0));
        PointValues { x: Exact(x), side, values, derivatives, curve, curve_derivatives }
    }

    /// Entry d holds the d-th derivatives of all the jets.
    fn by_order(&self, jets: &[Jet<BigRational>]) -> Vec<Vec<Exact>> {
        let derivatives: Vec<_> = jets.iter().map(Jet::derivatives).collect();
        let of_order = |d: usize| derivatives.iter().map(|of_one| Exact(of_one[d].clone())).collect();
        (0..=self.order).map(of_order).collect()
    }
}
