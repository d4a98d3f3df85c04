//! The index α of the class, kept as its slope ratio.

use std::fmt;
use std::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use thiserror::Error;

use crate::scalar::{NumberError, parse_rational};

/// An index α in (−∞, 0) ∪ (1, ∞) ∪ {∞} (D2.3), kept as its slope ratio r = α/(α − 1) > 0.
///
/// r runs over (0, 1) for α < 0 and over (1, ∞) for α > 1; r = 1 is α = ∞, the classical case (−∞ is the
/// same index). The conjugate index 1 − α has the ratio 1/r.
///
/// ```
/// use knotproof::spline::Index;
///
/// let index: Index = "-1".parse()?;
/// assert_eq!(index.ratio().to_string(), "1/2");
/// assert_eq!(index.conjugate().to_string(), "2");
/// assert!("1/2".parse::<Index>().is_err());
/// # Ok::<(), knotproof::spline::IndexError>(())
/// ```
#[derive(Debug, Clone, Eq)]
pub struct Index {
    ratio: BigRational,
}

/// A fraction in lowest terms is its parts; the library would divide on and on.
impl PartialEq for Index {
    fn eq(&self, other: &Self) -> bool {
        self.parts() == other.parts()
    }
}

impl Hash for Index {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.parts().hash(state);
    }
}

/// Why something is not an index.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum IndexError {
    /// α in [0, 1].
    #[error("{0} lies in [0, 1]: an index is negative, greater than 1, or inf (D2.3); {reason}", reason = why(.0))]
    Excluded(BigRational),
    /// r ≤ 0.
    #[error("a slope ratio is positive, and {0} is not")]
    Ratio(BigRational),
    /// Not a number at all.
    #[error(transparent)]
    Number(#[from] NumberError),
}

/// What goes wrong with the weight α(x − a)/(x + (α − 1)b − αa) for an excluded α.
fn why(alpha: &BigRational) -> &'static str {
    if !alpha.is_positive() {
        "with 0 the weight vanishes everywhere"
    } else if alpha.is_one() {
        "with 1 the weight is constant"
    } else {
        "between 0 and 1 the weight has a pole between its knots"
    }
}

impl Index {
    fn parts(&self) -> (&BigInt, &BigInt) {
        (self.ratio.numer(), self.ratio.denom())
    }

    /// From α itself.
    ///
    /// # Errors
    /// [`IndexError::Excluded`] for α in [0, 1].
    pub fn from_alpha(alpha: BigRational) -> Result<Self, IndexError> {
        let one = BigRational::one();
        if !alpha.is_negative() && alpha <= one {
            return Err(IndexError::Excluded(alpha));
        }
        let ratio = &alpha / (&alpha - one);
        Ok(Self { ratio })
    }

    /// From the slope ratio r = α/(α − 1).
    ///
    /// # Errors
    /// [`IndexError::Ratio`] unless r > 0.
    pub fn from_ratio(ratio: BigRational) -> Result<Self, IndexError> {
        if ratio.is_positive() { Ok(Self { ratio }) } else { Err(IndexError::Ratio(ratio)) }
    }

    /// α = ∞, the polynomial B-splines.
    #[must_use]
    pub fn infinity() -> Self {
        Self { ratio: BigRational::one() }
    }

    /// r = α/(α − 1) > 0.
    #[must_use]
    pub fn ratio(&self) -> &BigRational {
        &self.ratio
    }

    /// (p, q) with r = p/q in lowest terms: the slopes of its weights, p(x − a) : q(b − x).
    pub(crate) fn slopes(&self) -> (BigInt, BigInt) {
        (self.ratio.numer().clone(), self.ratio.denom().clone())
    }

    /// α = r/(r − 1); `None` for α = ∞.
    #[must_use]
    pub fn alpha(&self) -> Option<BigRational> {
        (!self.is_infinite()).then(|| &self.ratio / (&self.ratio - BigRational::one()))
    }

    /// Is this α = ∞?
    #[must_use]
    pub fn is_infinite(&self) -> bool {
        self.ratio.is_one()
    }

    /// The index 1 − α, of ratio 1/r.
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Self { ratio: self.ratio.recip() }
    }
}

/// α as a number, or `inf`.
impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.alpha() {
            Some(alpha) => write!(f, "{alpha}"),
            None => f.write_str("inf"),
        }
    }
}

/// α as an exact number, or ±inf.
impl std::str::FromStr for Index {
    type Err = IndexError;

    fn from_str(text: &str) -> Result<Self, IndexError> {
        let trimmed = text.trim();
        let lower = trimmed.strip_prefix(['+', '-']).unwrap_or(trimmed).to_ascii_lowercase();
        if ["inf", "infinity", "∞"].contains(&lower.as_str()) {
            return Ok(Self::infinity());
        }
        Self::from_alpha(parse_rational(text)?)
    }
}
