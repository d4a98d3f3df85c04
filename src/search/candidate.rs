//! One basis function as the search sees it: the gaps between its own knots, and its slope ratio.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use thiserror::Error;

use crate::analysis::{LocalKnots, is_continuous};
use crate::spline::{Basis, Index};

/// A basis function G_i^k by all that its shape depends on: the k + 1 gaps t_{i+1} − t_i, …, t_{i+k+1} − t_{i+k} and
/// the slope ratio r = p/q. It is continuous: no end of its support is a knot of multiplicity k + 1.
///
/// Scaling the gaps changes nothing of the shape, and reversing them together with r ↦ 1/r (the conjugate index)
/// mirrors it; so each function has a [normal form](Self::normal_form). The **size** of a candidate is the sum of
/// its gaps plus the [height](Self::height) of α; candidates are ordered by size, then height of α, then gaps
/// (lexicographically), then r.
///
/// ```
/// use knotproof::search::Candidate;
///
/// // Gaps 0, 2, 2, 4 with r = 5/3, that is α = 5/2; its mirror image, divided by 2, has α = −3/2.
/// let candidate = Candidate::new(vec![0, 2, 2, 4], (5, 3))?;
/// let normal = candidate.normal_form();
/// assert_eq!(normal.gaps(), [2, 1, 1, 0]);
/// assert_eq!(normal.index().to_string(), "-3/2");
/// assert_eq!((normal.height(), normal.size()), (3, 7));
/// # Ok::<(), knotproof::search::CandidateError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Candidate {
    gaps: Vec<u64>,
    /// p and q, coprime.
    ratio: (u64, u64),
}

/// Why gaps and a ratio are no candidate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum CandidateError {
    /// Degree 0, or no gap at all.
    #[error("a continuous function has degree 1 at least, and so two gaps at least")]
    Degree,
    /// A knot of multiplicity k + 1.
    #[error("the first k gaps, or the last k, are all 0: the function jumps at that end of its support")]
    Jump,
    /// p or q is 0.
    #[error("the slope ratio is positive and finite: p and q are not 0")]
    Ratio,
    /// The size does not fit.
    #[error("the sum of the gaps and the height of α must be less than 2^63")]
    TooLarge,
}

/// The full knot vector on which a candidate is G_i^k.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FullKnots {
    /// t_0, …, t_{2k+1}.
    pub knots: Vec<u64>,
    /// i.
    pub index: usize,
}

impl Candidate {
    /// From the gaps, and (p, q) for r = p/q, which need not be in lowest terms.
    ///
    /// # Errors
    /// [`CandidateError`], for the first rule that is broken.
    pub fn new(gaps: Vec<u64>, (p, q): (u64, u64)) -> Result<Self, CandidateError> {
        if gaps.len() < 2 {
            return Err(CandidateError::Degree);
        }
        if !is_continuous(&gaps) {
            return Err(CandidateError::Jump);
        }
        if p == 0 || q == 0 {
            return Err(CandidateError::Ratio);
        }
        let total = gaps.iter().try_fold(p.max(q), |sum, &gap| sum.checked_add(gap));
        if total.is_none_or(|total| total >= 1 << 63) {
            return Err(CandidateError::TooLarge);
        }
        let common = p.gcd(&q);
        Ok(Self { gaps, ratio: (p / common, q / common) })
    }

    /// The function G_i^k of a basis, if it is continuous and its gaps, as coprime integers, are not too large.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn of(basis: &Basis, i: usize) -> Option<Self> {
        let knots = LocalKnots::of(basis, i)?;
        let (p, q) = knots.ratio();
        let gaps: Option<_> = knots.gaps().iter().map(ToPrimitive::to_u64).collect();
        Self::new(gaps?, (p.to_u64()?, q.to_u64()?)).ok()
    }

    /// One that is known to fulfil the rules, with coprime p and q.
    pub(super) fn assumed(gaps: Vec<u64>, ratio: (u64, u64)) -> Self {
        Self { gaps, ratio }
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.gaps.len() - 1
    }

    /// The gaps.
    #[must_use]
    pub fn gaps(&self) -> &[u64] {
        &self.gaps
    }

    /// (p, q) with r = p/q in lowest terms.
    #[must_use]
    pub fn ratio(&self) -> (u64, u64) {
        self.ratio
    }

    /// α.
    #[must_use]
    pub fn index(&self) -> Index {
        let (p, q) = self.ratio;
        match Index::from_ratio(BigRational::new(p.into(), q.into())) {
            Ok(index) => index,
            Err(_) => unreachable!("p and q are positive"),
        }
    }

    /// The height of α = p/(p − q), max(|numerator|, denominator) in lowest terms; 1 for α = ∞.
    #[must_use]
    pub fn height(&self) -> u64 {
        let (p, q) = self.ratio;
        p.max(p.abs_diff(q))
    }

    /// The sum of the gaps plus the height of α.
    #[must_use]
    pub fn size(&self) -> u64 {
        self.gaps.iter().sum::<u64>() + self.height()
    }

    /// The representative of the function up to scaling and reversal: coprime gaps, and r ≤ 1 (α < 0, or α = ∞);
    /// for r = 1 the lexicographically smaller of the gaps and their reverse. It is the smallest candidate of all
    /// that show the same function: of α < 0 and its conjugate 1 − α the first has the lesser height.
    #[must_use]
    pub fn normal_form(&self) -> Self {
        let common = self.gaps.iter().fold(0, |common: u64, gap| common.gcd(gap)).max(1);
        let mut gaps: Vec<u64> = self.gaps.iter().map(|gap| gap / common).collect();
        let (p, q) = self.ratio;
        if p > q || (p == q && is_above_its_reverse(&gaps)) {
            gaps.reverse();
        }
        Self { gaps, ratio: (p.min(q), p.max(q)) }
    }

    /// Is this its own normal form?
    #[must_use]
    pub fn is_normal(&self) -> bool {
        *self == self.normal_form()
    }

    /// The knots t_i, …, t_{i+k+1} for t_i = 0.
    #[must_use]
    pub fn own_knots(&self) -> Vec<u64> {
        own_knots(&self.gaps)
    }

    /// The full knot vector on which it is G_i^k.
    #[must_use]
    pub fn full_knots(&self) -> FullKnots {
        FullKnots::of(&self.gaps)
    }

    /// The function over the integers.
    #[must_use]
    pub fn local_knots(&self) -> LocalKnots<BigInt> {
        let (p, q) = self.ratio;
        match LocalKnots::new(self.gaps.iter().map(|&gap| gap.into()).collect(), (p.into(), q.into())) {
            Ok(knots) => knots,
            Err(error) => unreachable!("a candidate fulfils the rules: {error}"),
        }
    }

    /// The order of the search, with the size first.
    fn key(&self) -> (u64, u64, &[u64]) {
        (self.size(), self.height(), &self.gaps)
    }
}

/// Is the list lexicographically larger than its reverse?
pub(super) fn is_above_its_reverse(gaps: &[u64]) -> bool {
    gaps.iter().gt(gaps.iter().rev())
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        let product = |(p, _): (u64, u64), (_, q): (u64, u64)| u128::from(p) * u128::from(q);
        self.key()
            .cmp(&other.key())
            .then_with(|| product(self.ratio, other.ratio).cmp(&product(other.ratio, self.ratio)))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// 0 and the sums of the gaps.
fn own_knots(gaps: &[u64]) -> Vec<u64> {
    let mut knots = vec![0];
    let mut last = 0;
    for gap in gaps {
        last += gap;
        knots.push(last);
    }
    knots
}

impl FullKnots {
    /// The smallest knot vector with the paper's hypotheses (m = n + k + 1, n ≥ k, t_k < t_{m−k}; D3.2–3.3) on which
    /// the function with these gaps is one of the basis: m = 2k + 1, its own knots and k copies of its end knots.
    ///
    /// t_k and t_{k+1} are the ends of a span of its own. It is the first one, which makes the left end open (k + 1
    /// equal knots), unless only the right end knot is repeated: then the last one, which makes that end open.
    pub(super) fn of(gaps: &[u64]) -> Self {
        let k = gaps.len().saturating_sub(1);
        let filled = |s: &usize| gaps[*s] > 0;
        let right = gaps[0] > 0 && gaps[k] == 0;
        let span = if right { (0..=k).rev().find(filled) } else { (0..=k).find(filled) }.unwrap_or(0);
        let own = own_knots(gaps);
        let (first, last) = (own[0], own[k + 1]);
        let index = k - span;
        let knots = std::iter::repeat_n(first, index).chain(own).chain(std::iter::repeat_n(last, span));
        Self { knots: knots.collect(), index }
    }

    /// The knots as rational numbers.
    #[must_use]
    pub fn rational(&self) -> Vec<BigRational> {
        self.knots.iter().map(|&t| BigRational::from_integer(t.into())).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::KnotVector;

    fn candidate(gaps: &[u64], ratio: (u64, u64)) -> Candidate {
        Candidate::new(gaps.to_vec(), ratio).unwrap()
    }

    #[test]
    fn normal_forms_are_fixed_and_blind_to_the_symmetries() {
        for gaps in [&[0, 1, 1, 2][..], &[6, 0, 3], &[1, 1], &[2, 4, 4, 2, 0], &[3, 1, 3]] {
            for (p, q) in [(5, 3), (3, 5), (1, 1), (4, 2)] {
                let original = candidate(gaps, (p, q));
                let normal = original.normal_form();
                assert_eq!(normal, normal.normal_form());
                assert!(normal.is_normal() && normal <= original);
                let mut reversed: Vec<u64> = gaps.iter().map(|gap| gap * 3).collect();
                reversed.reverse();
                assert_eq!(candidate(&reversed, (q, p)).normal_form(), normal);
            }
        }
        assert!(!candidate(&[2, 0, 1], (1, 1)).is_normal());
        assert!(!candidate(&[1, 0, 2], (2, 1)).is_normal());
        assert!(!candidate(&[2, 0, 2], (1, 2)).is_normal());
    }

    #[test]
    fn heights_are_those_of_alpha() {
        for (ratio, alpha, height) in [
            ((1, 1), "inf", 1),
            ((1, 2), "-1", 1),
            ((2, 1), "2", 2),
            ((5, 3), "5/2", 5),
            ((3, 5), "-3/2", 3),
            ((1, 4), "-1/3", 3),
        ] {
            let candidate = candidate(&[1, 1], ratio);
            assert_eq!((candidate.index().to_string().as_str(), candidate.height()), (alpha, height));
        }
    }

    #[test]
    fn what_is_no_candidate_is_refused() {
        for (gaps, ratio, error) in [
            (&[][..], (1, 1), CandidateError::Degree),
            (&[1], (1, 1), CandidateError::Degree),
            (&[0, 0, 1], (1, 1), CandidateError::Jump),
            (&[1, 0, 0], (1, 1), CandidateError::Jump),
            (&[0, 0, 0], (1, 1), CandidateError::Jump),
            (&[1, 1], (0, 1), CandidateError::Ratio),
            (&[1, 1], (1, 0), CandidateError::Ratio),
            (&[u64::MAX, 1], (1, 1), CandidateError::TooLarge),
            (&[1 << 62, 1 << 62], (1, 1), CandidateError::TooLarge),
        ] {
            assert_eq!(Candidate::new(gaps.to_vec(), ratio), Err(error), "{gaps:?}");
        }
    }

    /// m = 2k + 1, t_k < t_{k+1}, and the function's own knots where the index says.
    #[test]
    fn full_knot_vectors_have_the_hypotheses_of_the_paper() {
        for (gaps, knots, index) in [
            (&[2, 1, 1, 0][..], &[0, 0, 2, 3, 4, 4, 4, 4][..], 1),
            (&[0, 1, 1, 2], &[0, 0, 0, 0, 1, 2, 4, 4], 2),
            (&[0, 5, 2, 0], &[0, 0, 0, 0, 5, 7, 7, 7], 2),
            (&[1, 2, 3, 4], &[0, 0, 0, 0, 1, 3, 6, 10], 3),
            (&[0, 1, 0], &[0, 0, 0, 1, 1, 1], 1),
            (&[1, 1], &[0, 0, 1, 2], 1),
        ] {
            let candidate = candidate(gaps, (1, 2));
            let (k, full) = (candidate.degree(), candidate.full_knots());
            assert_eq!((&full.knots[..], full.index), (knots, index), "{gaps:?}");
            assert_eq!(full.knots.len(), 2 * k + 2);
            assert!(full.knots[k] < full.knots[k + 1]);
            assert_eq!(full.knots[index..index + k + 2], candidate.own_knots());
            assert!(KnotVector::new(full.rational()).is_ok());
        }
    }

    #[test]
    fn the_order_is_by_size_first() {
        let list = [
            candidate(&[0, 1, 0], (1, 2)),
            candidate(&[0, 1, 1], (1, 2)),
            candidate(&[1, 1, 0], (1, 2)),
            candidate(&[1, 1, 0], (1, 1)),
            candidate(&[0, 1, 0], (1, 3)),
            candidate(&[0, 1, 0], (2, 3)),
        ];
        for (small, large) in list.iter().zip(&list[1..]) {
            assert!(small < large, "{small:?} {large:?}");
        }
    }
}
