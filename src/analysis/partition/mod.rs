//! A function of one parameter, by the number of its local maxima.

mod bernstein_table;
mod boxes;
mod family;
mod parameter;
mod sweep;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use thiserror::Error;

use crate::scalar::{Polynomial, Ring, integer, over_one_denominator, rationals_between};
use crate::spline::{Basis, Index, KnotVector};

use super::algebraic::Algebraic;
use super::integer_polynomial::IntegerPolynomial;
use super::local_knots::LocalKnots;
use super::pieces::Pieces;
use super::roots::{IsolatedRoot, roots_of};
use super::shape::Shape;
use family::RatioFamily;
use parameter::Parameter;
use sweep::{Content, Stretch, sweep};

pub use boxes::PartitionEvent;

/// All values of a parameter, by the number of local maxima that G_i^k has.
///
/// The parameter is the slope ratio r in (0, ∞), or a knot between its two neighbours. The slope on span s has the
/// sign of a polynomial N_s(u, r), and the number of local maxima can change only where a critical point passes
/// an end of a span, or where two critical points meet. Boxes in (u, r) show that there is no such r in an interval,
/// or one at most: see [`PartitionEvent`].
///
/// Exact: for every value of the parameter, except where a cell says that it is undecided.
///
/// ```
/// use knotproof::analysis::Partition;
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Index, KnotVector};
///
/// // The function of degree 4 on the knots 0, 1, …, 5 has two local maxima for some r near 2/5, and near 5/2.
/// let knots = KnotVector::new([0, 1, 2, 3, 4, 5, 5, 5, 5].map(integer).to_vec())?;
/// let basis = Basis::new(knots, 4, Index::infinity())?;
/// let partition = Partition::by_ratio(&basis, 0, &rational(1, 1 << 20));
/// let counts: Vec<_> = partition.cells().iter().map(|cell| cell.local_maxima).collect();
/// assert_eq!(counts, [1, 2, 1, 2, 1].map(Some));
/// let (lo, hi) = &partition.ends()[0].interval;
/// assert!(rational(39, 100) < *lo && lo < hi && *hi < rational(40, 100));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Partition {
    cells: Vec<RatioCell>,
    ends: Vec<PartitionEnd>,
}

/// An open interval of the parameter on which the number of local maxima is constant.
#[derive(Debug, Clone, PartialEq)]
pub struct RatioCell {
    /// Its lower end, or an upper bound of that where it is no rational number: the cell is from the one
    /// [end](PartitionEnd) to the next.
    pub from: BigRational,
    /// Its upper end, or a lower bound of that; `None` for ∞.
    pub to: Option<BigRational>,
    /// The number, confirmed by the [`Shape`] at a rational number of the cell; `None` if it is undecided between
    /// these two bounds.
    pub local_maxima: Option<usize>,
}

/// Where one cell ends and the next begins.
#[derive(Debug, Clone, PartialEq)]
pub struct PartitionEnd {
    /// (lo, hi) with lo ≤ end ≤ hi, and lo = hi if the end is known to be rational.
    pub interval: (BigRational, BigRational),
    /// The number of local maxima there.
    pub local_maxima: usize,
    /// What happens there, and the knots t_s at which the spans begin where it happens.
    pub events: Vec<(usize, PartitionEvent)>,
    /// Integer polynomials in the parameter, lowest coefficient first. For a critical point at an end of a span
    /// one of them, which has the end as its only root in the interval. For two that meet, the coefficients of
    /// u⁰, u¹, … of N: there N = ∂N/∂u = 0 at some u > 0.
    pub polynomials: Vec<Vec<BigInt>>,
    number: Algebraic,
}

impl PartitionEnd {
    /// The end as a number: of one where two critical points meet no more is known than the interval.
    #[must_use]
    pub fn number(&self) -> Algebraic {
        self.number.clone()
    }
}

/// Why a knot cannot be the parameter.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FreeKnotError {
    /// t_0, t_m, or none at all.
    #[error("knot {knot} does not lie between two others: give one of 1 to {last}")]
    NoNeighbours {
        /// J.
        knot: usize,
        /// m − 1.
        last: usize,
    },
    /// The neighbours are at one place.
    #[error("knot {knot} cannot move, since its neighbours are both {place}: free another one")]
    Fixed {
        /// J.
        knot: usize,
        /// t_{J−1} = t_{J+1}.
        place: BigRational,
    },
}

/// Halvings of the parameter's interval before a part of it is given up.
const DEPTH: u32 = 40;

/// A cell or an end, in terms of the family's own t.
enum Step {
    Cell {
        from: BigRational,
        to: BigRational,
        local_maxima: Option<usize>,
    },
    End {
        lo: BigRational,
        hi: BigRational,
        root: Option<IsolatedRoot>,
        local_maxima: usize,
        events: Vec<(usize, PartitionEvent)>,
    },
}

impl Partition {
    /// The partition of all slope ratios r in (0, ∞), for G_i^k on the knots of `basis`, whose index is ignored. The
    /// ends of cells are isolated to intervals of at most `width` > 0.
    ///
    /// For r > 1 the function with reversed knots is taken, which has the same number of local maxima at 1/r.
    ///
    /// # Panics
    /// If i > n.
    #[must_use]
    pub fn by_ratio(basis: &Basis, i: usize, width: &BigRational) -> Self {
        let knots = &basis.knots().knots()[i..=i + basis.degree() + 1];
        let gaps = integer_gaps(knots);
        let constant = |gap: &BigInt| Polynomial::constant(gap.clone());
        let one = Polynomial::constant(BigInt::from(1));
        let ratio = (Polynomial::variable(&BigInt::from(1)), one);
        let at = |r: &BigRational| {
            let index = Index::from_ratio(r.clone()).ok()?;
            count(&Basis::new(basis.knots().clone(), basis.degree(), index).ok()?, i)
        };
        let mut partition = Self { cells: Vec::new(), ends: Vec::new() };
        let low = family(gaps.iter().map(constant).collect(), ratio.clone());
        let high = family(gaps.iter().rev().map(constant).collect(), ratio);
        if let (Some(low), Some(high)) = (low, high) {
            let last = basis.degree();
            let identity = Parameter::Identity;
            for step in steps(&low, true, &identity, width) {
                partition.push(step, &low, &identity, |s| i + s);
            }
            let mut above = steps(&high, true, &Parameter::Reciprocal, width);
            above.reverse();
            for step in above {
                partition.push(step, &high, &Parameter::Reciprocal, |s| i + last - s);
            }
        } else {
            partition.cells.push(RatioCell { from: integer(0), to: None, local_maxima: at(&integer(1)) });
        }
        partition.confirm(at);
        partition
    }

    /// The partition of the places of the knot t_J strictly between its neighbours, for G_i^k with the index and
    /// the other knots of `basis`.
    ///
    /// # Errors
    /// [`FreeKnotError`] if t_J is t_0 or t_m, or its neighbours are equal.
    ///
    /// # Panics
    /// If i > n.
    pub fn by_knot(basis: &Basis, i: usize, knot: usize, width: &BigRational) -> Result<Self, FreeKnotError> {
        let all = basis.knots();
        if knot == 0 || knot >= all.m() {
            return Err(FreeKnotError::NoNeighbours { knot, last: all.m() - 1 });
        }
        let (from, to) = (all.t(knot - 1).clone(), all.t(knot + 1).clone());
        if from == to {
            return Err(FreeKnotError::Fixed { knot, place: from });
        }
        let moved = |x: &BigRational| {
            let mut knots = all.knots().to_vec();
            knots[knot] = x.clone();
            let knots = KnotVector::new(knots).ok()?;
            count(&Basis::new(knots, basis.degree(), basis.index().clone()).ok()?, i)
        };
        let parameter = Parameter::Affine { start: from.clone(), length: &to - &from };
        let mut partition = Self { cells: Vec::new(), ends: Vec::new() };
        match knot_family(basis, i, knot) {
            Some(family) => {
                for step in steps(&family, false, &parameter, width) {
                    partition.push(step, &family, &parameter, |s| i + s);
                }
            }
            None => {
                let local_maxima = rationals_between(&from, &to).next().and_then(|x| moved(&x));
                partition.cells.push(RatioCell { from, to: Some(to), local_maxima });
            }
        }
        partition.confirm(moved);
        Ok(partition)
    }

    /// The cells, from left to right.
    #[must_use]
    pub fn cells(&self) -> &[RatioCell] {
        &self.cells
    }

    /// The ends between decided cells, from left to right.
    #[must_use]
    pub fn ends(&self) -> &[PartitionEnd] {
        &self.ends
    }

    /// Is every value of the parameter decided?
    #[must_use]
    pub fn is_decided(&self) -> bool {
        self.cells.iter().all(|cell| cell.local_maxima.is_some())
    }

    /// The next step, in terms of the parameter. Cells with the same number grow together.
    fn push(
        &mut self,
        step: Step,
        family: &RatioFamily,
        parameter: &Parameter,
        knot: impl Fn(usize) -> usize,
    ) {
        match step {
            Step::Cell { from, to, local_maxima } => {
                let (from, to) = parameter.interval(&from, &to);
                let end_before = self.ends.last().is_some_and(|end| end.interval.1 == from);
                match self.cells.last_mut().filter(|_| !end_before) {
                    Some(last) if last.local_maxima == local_maxima && last.to.as_ref() == Some(&from) => {
                        last.to = to
                    }
                    _ => self.cells.push(RatioCell { from, to, local_maxima }),
                }
            }
            Step::End { lo, hi, root, local_maxima, events } => {
                let (lo, Some(hi)) = parameter.interval(&lo, &hi) else { return };
                // An end between two parts of the family belongs to both.
                if self.ends.last().is_some_and(|last| last.interval == (lo.clone(), hi.clone())) {
                    return;
                }
                let polynomials = parameter.polynomials(&family.polynomials(&events));
                let turned = |event: PartitionEvent| {
                    if *parameter == Parameter::Reciprocal { event.reversed() } else { event }
                };
                let events = events.into_iter().map(|(span, event)| (knot(span), turned(event))).collect();
                let number = match root {
                    Some(root) => parameter.number(root),
                    None => Algebraic::between(lo.clone(), hi.clone()),
                };
                self.ends.push(PartitionEnd {
                    interval: (lo, hi),
                    local_maxima,
                    events,
                    polynomials,
                    number,
                });
            }
        }
    }

    /// Compares every cell with the number of local maxima at a simple rational of it, by the pieces of the
    /// function and not by the family. A cell of which that says something else would be a fault of this program: it
    /// is undecided.
    fn confirm(&mut self, at: impl Fn(&BigRational) -> Option<usize>) {
        for cell in &mut self.cells {
            let to = cell.to.clone().unwrap_or_else(|| &cell.from + integer(2));
            let sample = rationals_between(&cell.from, &to).next();
            if sample.and_then(|sample| at(&sample)) != cell.local_maxima {
                cell.local_maxima = None;
            }
        }
    }
}

/// The number of local maxima of one function, by its shape.
fn count(basis: &Basis, i: usize) -> Option<usize> {
    Some(Shape::of(&Pieces::of(basis), i).local_maxima().count())
}

/// The gaps between the knots, times a positive number that makes the knots integers.
fn integer_gaps(knots: &[BigRational]) -> Vec<BigInt> {
    over_one_denominator(knots).0.windows(2).map(|pair| &pair[1] - &pair[0]).collect()
}

/// G_i^k with t_J = t_{J−1} + t·(t_{J+1} − t_{J−1}); `None` if it lives on one span only.
fn knot_family(basis: &Basis, i: usize, knot: usize) -> Option<RatioFamily> {
    let knots = basis.knots().knots();
    let local = i..=i + basis.degree() + 1;
    let mut gaps: Vec<_> = integer_gaps(knots).into_iter().map(Polynomial::constant).collect();
    let length = gaps[knot - 1].plus(&gaps[knot]).coefficients()[0].clone();
    gaps[knot - 1] = Polynomial::new(BigInt::default(), [length.clone()]);
    gaps[knot] = Polynomial::new(length.clone(), [-length]);
    let ratio = basis.index().ratio();
    let constant = |n: &BigInt| Polynomial::constant(n.clone());
    let ratio = (constant(ratio.numer()), constant(ratio.denom()));
    family(gaps[*local.start()..*local.end()].to_vec(), ratio)
}

/// The family of these local knots; `None` if there is one span only. There the function has no local maximum
/// inside, or one, whatever the parameter is: G_i^k = C(k, j)·w^j(1 − w)^{k−j}, where w rises from 0 to 1.
fn family(
    gaps: Vec<Polynomial<BigInt>>,
    ratio: (Polynomial<BigInt>, Polynomial<BigInt>),
) -> Option<RatioFamily> {
    let local = LocalKnots::new(gaps, ratio).ok()?;
    (local.spans().count() > 1).then(|| RatioFamily::new(&local))
}

/// The cells and ends of a family from left to right, ends isolated to `width` in terms of the parameter.
fn steps(family: &RatioFamily, closed_at_one: bool, parameter: &Parameter, width: &BigRational) -> Vec<Step> {
    let mut steps = Vec::new();
    for Stretch { from, to, content } in sweep(family, closed_at_one, DEPTH) {
        let events = match content {
            Content::Events(events) => events,
            Content::Constant => {
                let middle = (&from + &to) / BigInt::from(2);
                let local_maxima = Some(family.local_maxima(&middle));
                steps.push(Step::Cell { from, to, local_maxima });
                continue;
            }
            Content::Undecided => {
                steps.push(Step::Cell { from, to, local_maxima: None });
                continue;
            }
        };
        let (below, above) = (family.local_maxima(&from), family.local_maxima(&to));
        let local_maxima = family.local_maxima_at_event(&from, &to);
        if below == above && below == local_maxima {
            steps.push(Step::Cell { from, to, local_maxima: Some(below) });
            continue;
        }
        let (lo, hi) = isolated(family, &events, (&from, &to), |lo, hi| {
            !width.is_positive() || parameter.distance(lo, hi) <= *width
        });
        steps.push(Step::Cell { from, to: lo.clone(), local_maxima: Some(below) });
        let root = family.edge(&events).and_then(|edge| irrational_root(edge, &lo, &hi));
        steps.push(Step::End { lo, hi: hi.clone(), root, local_maxima, events });
        steps.push(Step::Cell { from: hi, to, local_maxima: Some(above) });
    }
    steps.retain(|step| !matches!(step, Step::Cell { from, to, .. } if from == to));
    steps
}

/// The t of [from, to] where the events are: exactly if it is a rational number at which a critical point is at an
/// end of its span, and otherwise by halving until the interval is `narrow` and lies inside of (from, to): so there is
/// room for a cell before it and after it, even if the next events are close by.
fn isolated(
    family: &RatioFamily,
    events: &[(usize, PartitionEvent)],
    (from, to): (&BigRational, &BigRational),
    narrow: impl Fn(&BigRational, &BigRational) -> bool,
) -> (BigRational, BigRational) {
    let edge = family.edge(events);
    let exact = edge.clone().and_then(|edge| {
        let mut places = roots_of(edge).into_iter().filter_map(|mut root| root.rational());
        places.find(|t| from <= t && t <= to)
    });
    if let Some(t) = exact {
        return (t.clone(), t);
    }
    let (mut lo, mut hi) = (from.clone(), to.clone());
    let below = family.local_maxima(from);
    // An irrational place leaves both ends at last. Two critical points may meet at a rational one.
    let mut patience = DEPTH;
    let mut inside = |lo: &BigRational, hi: &BigRational| {
        patience = patience.saturating_sub(1);
        (from < lo && hi < to) || (edge.is_none() && patience == 0)
    };
    while !narrow(&lo, &hi) || !inside(&lo, &hi) {
        let middle = (&lo + &hi) / BigInt::from(2);
        let still_below = match &edge {
            Some(edge) => {
                edge.sign_at(middle.numer(), middle.denom()) == edge.sign_at(from.numer(), from.denom())
            }
            None => family.local_maxima(&middle) == below,
        };
        if still_below { lo = middle } else { hi = middle }
    }
    (lo, hi)
}

/// The root of a polynomial between two rational numbers, if it is irrational.
fn irrational_root(edge: IntegerPolynomial, lo: &BigRational, hi: &BigRational) -> Option<IsolatedRoot> {
    let irrational = |root: &IsolatedRoot| root.clone().rational().is_none();
    roots_of(edge).into_iter().filter(irrational).find_map(|mut root| {
        loop {
            let (from, to) = root.interval();
            if *lo <= from && to <= *hi {
                return Some(root);
            }
            if to < *lo || *hi < from {
                return None;
            }
            root.refine();
        }
    })
}
