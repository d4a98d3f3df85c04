//! Hypotheses of the paper's statements, as data.

use crate::scalar::BigRational;
use crate::spline::Basis;

/// A condition on a knot vector, a degree and an index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hypothesis {
    /// α ≠ ∞.
    FiniteIndex,
    /// α = ∞.
    ClassicalIndex,
    /// k ≥ the number.
    DegreeAtLeast(usize),
    /// k ≤ the number.
    DegreeAtMost(usize),
    /// U is open (D3.2).
    Open,
    /// U is symmetric (D3.2).
    Symmetric,
    /// Open, with no interior knot: n = k, m = 2k + 1 (P3.3).
    Bernstein,
    /// Every knot has multiplicity 1.
    SimpleKnots,
    /// All gaps between consecutive knots are equal.
    EqualGaps,
    /// Every interior knot t_{k+1}, …, t_{m−k−1} has multiplicity at most k.
    InteriorMultiplicityAtMostDegree,
    /// No knot inside (t_0, t_m) has multiplicity greater than k.
    InnerMultiplicityAtMostDegree,
    /// t_k < t_{k+1}: the first knot of an open vector occurs only k + 1 times.
    FirstSpan,
    /// t_n < t_{n+1}: the last knot of an open vector occurs only k + 1 times.
    LastSpan,
    /// t_m does not occur exactly k + 2 times.
    LastMultiplicityNotDegreePlusTwo,
    /// t_k < t_{m−k}: the paper's a < b (D3.2).
    BaseInterval,
    /// m ≥ 2k (D3.2).
    EnoughKnots,
}

/// What is said of the refutations by an end knot that occurs more than k + 1 times.
pub(super) const STATED_IN_THE_PROOF: &str = "A hypothesis stated in the proof, not in the statement: the proof begins with end knots that occur k + 1 times, and its formulas divide by t_{k+1} − t_0 and t_m − t_n. An open vector by D3.2 may repeat them more often; G_0^k or G_n^k is 0 then.";

impl Hypothesis {
    /// Does it hold?
    #[must_use]
    pub fn holds(self, basis: &Basis) -> bool {
        let (knots, k, n) = (basis.knots(), basis.degree(), basis.n());
        match self {
            Self::FiniteIndex => !basis.index().is_infinite(),
            Self::ClassicalIndex => basis.index().is_infinite(),
            Self::DegreeAtLeast(least) => k >= least,
            Self::DegreeAtMost(most) => k <= most,
            Self::Open => knots.is_open(k),
            Self::Symmetric => knots.is_symmetric(),
            Self::Bernstein => knots.is_open(k) && knots.m() == 2 * k + 1,
            Self::SimpleKnots => knots.stop_knots().all(|(_, p)| p == 1),
            Self::EqualGaps => {
                let gap = |pair: &[BigRational]| &pair[1] - &pair[0];
                knots.knots().windows(3).all(|three| gap(&three[..2]) == gap(&three[1..]))
            }
            Self::InteriorMultiplicityAtMostDegree => {
                knots.interior(k).iter().all(|t| knots.multiplicity(t) <= k)
            }
            Self::InnerMultiplicityAtMostDegree => knots.inner_stop_knots().all(|(_, p)| p <= k),
            Self::FirstSpan => knots.t(k) < knots.t(k + 1),
            Self::LastSpan => knots.t(n) < knots.t(n + 1),
            Self::LastMultiplicityNotDegreePlusTwo => knots.multiplicity(knots.last()) != k + 2,
            Self::BaseInterval => basis.base_interval().is_some(),
            Self::EnoughKnots => knots.m() >= 2 * k,
        }
    }
}

impl std::fmt::Display for Hypothesis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::FiniteIndex => f.write_str("α is finite"),
            Self::ClassicalIndex => f.write_str("α = ∞"),
            Self::DegreeAtLeast(least) => write!(f, "k ≥ {least}"),
            Self::DegreeAtMost(most) => write!(f, "k ≤ {most}"),
            Self::Open => f.write_str("U is open"),
            Self::Symmetric => f.write_str("U is symmetric"),
            Self::Bernstein => f.write_str("U is open without interior knots"),
            Self::SimpleKnots => f.write_str("every knot is simple"),
            Self::EqualGaps => f.write_str("the knots are uniform and simple"),
            Self::InteriorMultiplicityAtMostDegree => f.write_str("interior knots have multiplicity ≤ k"),
            Self::InnerMultiplicityAtMostDegree => {
                f.write_str("no knot inside (t_0, t_m) has multiplicity > k")
            }
            Self::FirstSpan => f.write_str("t_k < t_{k+1}"),
            Self::LastSpan => f.write_str("t_n < t_{n+1}"),
            Self::LastMultiplicityNotDegreePlusTwo => f.write_str("t_m does not occur exactly k + 2 times"),
            Self::BaseInterval => f.write_str("t_k < t_{m−k}"),
            Self::EnoughKnots => f.write_str("m ≥ 2k"),
        }
    }
}

/// A condition on an interval and an index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WeightHypothesis {
    /// a < b.
    Proper,
    /// α ≠ ∞.
    FiniteIndex,
}

impl std::fmt::Display for WeightHypothesis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Proper => "a < b",
            Self::FiniteIndex => "α is finite",
        })
    }
}
