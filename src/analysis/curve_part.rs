//! A part of a curve: the interval of x that a question is about.

use num_rational::BigRational;
use thiserror::Error;

use crate::spline::Curve;

/// [from, to], of positive length, inside [t_0, t_m]: the curve on it, closed, with the limits from inside at its ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CurvePart {
    ends: [BigRational; 2],
}

/// An interval that is no part of a curve.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CurvePartError {
    /// The curve does not begin there.
    #[error("{given} is not in [{first}, {last}), where the curve is")]
    From {
        /// What was asked for.
        given: BigRational,
        /// t_0.
        first: BigRational,
        /// t_m.
        last: BigRational,
    },
    /// The curve does not end there.
    #[error("{given} is not in ({from}, {last}], where the curve goes on")]
    To {
        /// What was asked for.
        given: BigRational,
        /// Where the curve begins.
        from: BigRational,
        /// t_m.
        last: BigRational,
    },
}

impl CurvePart {
    /// From the one x to the other; from t_0, and to t_m, where none is given.
    ///
    /// # Errors
    /// [`CurvePartError`] unless t_0 ≤ from < to ≤ t_m.
    pub fn of<W>(
        curve: &Curve<W>,
        from: Option<&BigRational>,
        to: Option<&BigRational>,
    ) -> Result<Self, CurvePartError> {
        let (first, last) = (curve.basis().knots().first(), curve.basis().knots().last());
        let (from, to) = (from.unwrap_or(first), to.unwrap_or(last));
        if from < first || from >= last {
            let (given, first, last) = (from.clone(), first.clone(), last.clone());
            return Err(CurvePartError::From { given, first, last });
        }
        if to <= from || to > last {
            let (given, from, last) = (to.clone(), from.clone(), last.clone());
            return Err(CurvePartError::To { given, from, last });
        }
        Ok(Self { ends: [from.clone(), to.clone()] })
    }

    /// (from, to).
    #[must_use]
    pub fn ends(&self) -> [&BigRational; 2] {
        self.ends.each_ref()
    }
}
