//! What the questions of a curve have in common: the curve, a part of it, and numbers that are known by bounds.

use num_rational::BigRational;
use num_traits::Signed;
use schemars::JsonSchema;
use serde::Serialize;

use crate::analysis::{Algebraic, CurvePart, Location, RationalBezier};
use crate::scalar::parse_rational;
use crate::spline::{AnyWeights, Basis, Curve, HasWeights};

use super::error::CliError;
use super::exact::{Exact, as_given};
use super::instance::{Case, InstanceArgs};
use super::notation::{Decimal, Notation, NotationArgs};
use super::on_knots::OnKnots;
use super::progress::Progress;

/// The arguments of a question of a curve.
#[derive(Debug, clap::Args)]
pub(super) struct CurveArgs {
    #[command(flatten)]
    instance: InstanceArgs,
    /// Where the part begins that is asked about, in place of the first knot. At its ends it has the limits from inside.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true)]
    from: Option<BigRational>,
    /// Where it ends, in place of the last knot.
    #[arg(long, value_name = "X", value_parser = parse_rational, allow_hyphen_values = true)]
    to: Option<BigRational>,
    /// The longest interval for a number that is not known exactly.
    #[arg(long, value_name = "W", value_parser = parse_rational, allow_hyphen_values = true, default_value = "1e-12")]
    width: BigRational,
    #[command(flatten)]
    notation: NotationArgs,
}

/// The knots and the control points that an answer is about; and the part of the curve.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct OnCurve {
    #[serde(flatten)]
    pub(super) on: OnKnots,
    /// The number of coordinates of a point.
    pub(super) dimension: usize,
    /// Where the part begins that the answer is about.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "String")]
    pub(super) from: Exact,
    /// Where it ends.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "String")]
    pub(super) to: Exact,
}

/// A curve with the pieces of the part of it that is asked about.
pub(super) struct Pieces {
    /// Its weights.
    pub(super) case: Case,
    /// From left to right.
    pub(super) pieces: Vec<RationalBezier>,
}

/// A real number: exact bounds, and settled digits.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(super) struct Known {
    /// Exact bounds of the number, equal if it is known exactly.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "[String; 2]")]
    pub(super) interval: [Exact; 2],
    /// Settled digits of the number.
    pub(super) decimal: Decimal,
}

/// Where something is: a point, or a whole interval.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Place {
    /// The x; of an interval its first one.
    pub(super) x: Known,
    /// Where an interval ends; `null` for a point.
    #[serde(serialize_with = "as_given")]
    #[schemars(with = "Option<String>")]
    pub(super) until: Option<Exact>,
    /// Does the end of an interval belong to it? Not if the curve jumps there; `null` for a point.
    pub(super) closed: Option<bool>,
}

/// The highest degree k of which pieces are made. One has degree k(k + 1)/2 in general, and the time grows with about the sixth power
/// of k: on knots of a few digits this one takes two seconds a span.
const DEGREE_LIMIT: usize = 10;

/// The highest degree of the functions as quotients, for weights of a higher degree in x than those of an index.
const QUOTIENT_LIMIT: usize = 120;

/// Refuses what would take too long to be brought into pieces.
///
/// # Errors
/// [`CliError::TooHigh`], [`CliError::Quotients`].
pub fn if_too_high<W: HasWeights>(basis: &Basis<W>) -> Result<(), CliError> {
    if basis.degree() > DEGREE_LIMIT {
        let reason = "a piece has degree k(k + 1)/2, and the time grows with the sixth power of k";
        return Err(CliError::TooHigh { degree: basis.degree(), limit: DEGREE_LIMIT, reason });
    }
    CliError::if_quotients_exceed(QUOTIENT_LIMIT, basis)
}

impl CurveArgs {
    /// How numbers are written.
    ///
    /// # Errors
    /// [`CliError::Limits`].
    pub(super) fn notation(&self) -> Result<Notation, CliError> {
        self.notation.notation()
    }

    /// The longest interval for a number.
    pub(super) fn width(&self) -> &BigRational {
        &self.width
    }

    /// What the answer is about, and the pieces of the curve for each of its weights; at least one.
    ///
    /// # Errors
    /// [`CliError`], for the first thing that is wrong.
    pub(super) fn pieces(&self) -> Result<(OnCurve, Vec<Pieces>), CliError> {
        if !self.width.is_positive() {
            return Err(CliError::Width(self.width.clone()));
        }
        let cases = self.instance.resolve_any()?.cases()?;
        let progress = Progress::new(cases.len());
        let (mut on, mut all) = (None, Vec::new());
        for case in cases {
            let curve = curve_of(&case)?;
            if_too_high(&case.basis)?;
            progress.step(&case.weights.to_string());
            let part = CurvePart::of(curve, self.from.as_ref(), self.to.as_ref())?;
            let pieces = RationalBezier::pieces_on(curve, &part).collect::<Result<_, _>>()?;
            if on.is_none() {
                on = Some(OnCurve::of(&case, curve, &part));
            }
            all.push(Pieces { case, pieces });
        }
        match on {
            Some(on) => Ok((on, all)),
            None => unreachable!("an instance has a case"),
        }
    }
}

/// The curve of a case.
///
/// # Errors
/// [`CliError::NoPoints`], if it has no control points.
pub(super) fn curve_of(case: &Case) -> Result<&Curve<AnyWeights>, CliError> {
    case.curve.as_ref().ok_or(CliError::NoPoints { needed: case.basis.n() + 1 })
}

impl OnCurve {
    fn of(case: &Case, curve: &Curve<AnyWeights>, part: &CurvePart) -> Self {
        let [from, to] = part.ends().map(|end| Exact(end.clone()));
        Self {
            on: OnKnots::of(&case.basis, case.label.clone()).with_points_of(curve),
            dimension: curve.dimension(),
            from,
            to,
        }
    }
}

impl Known {
    /// A number, between bounds that are at most so far apart.
    pub(super) fn of(mut number: Algebraic, width: &BigRational, notation: Notation) -> Self {
        let (lo, hi) = number.bounds_within(width);
        Self { interval: [lo, hi].map(Exact), decimal: notation.settled(&mut number) }
    }

    /// Of which no more is known than two bounds.
    pub(super) fn between((lo, hi): (BigRational, BigRational), notation: Notation) -> Self {
        let interval = [lo.clone(), hi.clone()].map(Exact);
        Self { interval, decimal: notation.settled(&mut Algebraic::between(lo, hi)) }
    }

    /// The number itself, where it is known.
    pub(super) fn exact(&self) -> Option<&Exact> {
        (self.interval[0] == self.interval[1]).then_some(&self.interval[0])
    }

    /// For people: the fraction if it is short, or nothing.
    pub(super) fn fraction(&self) -> String {
        /// A longer fraction says nothing to people.
        const LENGTH_LIMIT: usize = 24;
        let exact = self.exact().map(ToString::to_string);
        exact.filter(|text| text.len() <= LENGTH_LIMIT).unwrap_or_default()
    }
}

impl Place {
    /// A place, its x between bounds that are at most so far apart.
    pub(super) fn of(place: &Location, width: &BigRational, notation: Notation) -> Self {
        let (until, closed) = match place {
            Location::Plateau { to, closed, .. } => (Some(Exact(to.clone())), Some(*closed)),
            Location::Point(_) | Location::Irrational { .. } => (None, None),
        };
        Self { x: Known::of(place.x(), width, notation), until, closed }
    }

    /// For people: the x, or the interval.
    pub(super) fn exactly(&self) -> String {
        match &self.until {
            Some(until) => {
                let end = if self.closed == Some(true) { "]" } else { ")" };
                format!("[{}, {until}{end}", self.x.fraction())
            }
            None => self.x.fraction(),
        }
    }

    /// For people: the digits of an x.
    pub(super) fn nearly(&self) -> &str {
        if self.until.is_some() { "" } else { &self.x.decimal.0 }
    }
}
