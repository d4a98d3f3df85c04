//! A function of a family with one parameter t, by the slopes on its spans.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::analysis::decision::sign_sequence;
use crate::analysis::extremum::{ExtremumKind, turns};
use crate::analysis::integer_polynomial::IntegerPolynomial;
use crate::analysis::local_knots::LocalKnots;
use crate::analysis::roots::{IsolatedRoot, roots_of};
use crate::analysis::sign::{Sign, sign_changes};
use crate::scalar::{Polynomial, Ring};

use super::boxes::PartitionEvent;

/// Numerators of the slope, N_s(u, t) for each span s from left to right, for 0 < t < 1.
#[derive(Debug, Clone)]
pub(super) struct RatioFamily {
    slopes: Vec<(usize, Polynomial<Polynomial<BigInt>>)>,
}

impl RatioFamily {
    /// From local knots whose gaps and ratio are polynomials in t.
    ///
    /// Powers of u, of t and of 1 − t that divide N_s are positive and left out.
    pub(super) fn new(knots: &LocalKnots<Polynomial<BigInt>>) -> Self {
        let slope = |s| Some((s, reduced(&knots.on_span(s)?.slope())));
        Self { slopes: knots.spans().filter_map(slope).collect() }
    }

    /// Is there a t in (0, 1] at which the function could be constant on a whole span? It is a common root of all the
    /// coefficients of N_s, and boxes in u and t say nothing about it.
    pub(super) fn may_be_constant(&self) -> bool {
        self.slopes.iter().any(|(_, slope)| {
            let row = |row: &Polynomial<BigInt>| IntegerPolynomial::primitive(row.coefficients().to_vec());
            let rows = || slope.coefficients().iter().map(row);
            let without_root = |p: &IntegerPolynomial| sign_changes(p.coefficients()) == 0;
            !rows().any(|row| !row.is_zero() && without_root(&row))
                && rows()
                    .reduce(|common, row| common.gcd(&row))
                    .is_none_or(|common| common.is_zero() || roots_of(common).into_iter().any(at_most_one))
        })
    }

    /// The spans, with their N_s.
    pub(super) fn slopes(&self) -> &[(usize, Polynomial<Polynomial<BigInt>>)] {
        &self.slopes
    }

    /// Are these events, each at one t of [from, to] at most, at the same t? One alone is; several are if the
    /// polynomials that vanish at them have a common root there.
    pub(super) fn coincide(
        &self,
        events: &[(usize, PartitionEvent)],
        from: &BigRational,
        to: &BigRational,
    ) -> bool {
        let sign = |p: &IntegerPolynomial, t: &BigRational| p.sign_at(t.numer(), t.denom());
        events.len() == 1
            || self.edge(events).is_some_and(|common| {
                let signs = (sign(&common, from), sign(&common, to));
                signs.0 == Sign::Zero || signs.1 == Sign::Zero || signs.0 != signs.1
            })
    }

    /// The polynomial in t, without repeated factors, that vanishes where critical points are at the ends of these
    /// spans; `None` for a fold.
    pub(super) fn edge(&self, events: &[(usize, PartitionEvent)]) -> Option<IntegerPolynomial> {
        let edges = events.iter().map(|&(span, event)| edge(self.rows(span)?, event));
        edges.reduce(|common, next| Some(common?.gcd(&next?))).flatten()
    }

    /// What defines the place of events that coincide: their polynomial in t, or for a fold the coefficients of N.
    pub(super) fn polynomials(&self, events: &[(usize, PartitionEvent)]) -> Vec<Polynomial<BigInt>> {
        match self.edge(events) {
            Some(edge) => edge.coefficients().split_first().into_iter().map(polynomial).collect(),
            None => {
                let rows = events.first().and_then(|(span, _)| self.rows(*span));
                rows.map(<[_]>::to_vec).unwrap_or_default()
            }
        }
    }

    fn rows(&self, span: usize) -> Option<&[Polynomial<BigInt>]> {
        self.slopes.iter().find(|(s, _)| *s == span).map(|(_, slope)| slope.coefficients())
    }

    /// The number of local maxima at t > 0, for a function that is continuous.
    pub(super) fn local_maxima(&self, t: &BigRational) -> usize {
        local_maxima(self.signs(t).iter())
    }

    /// The number of local maxima at the t of [from, to] where events coincide. On each span there are two zeros, or
    /// one, more on one side than on the other; at the event itself the sign does not change there.
    pub(super) fn local_maxima_at_event(&self, from: &BigRational, to: &BigRational) -> usize {
        let (from, to) = (self.signs(from), self.signs(to));
        let shorter = from.iter().zip(&to).map(|(a, b)| if a.len() < b.len() { a } else { b });
        local_maxima(shorter)
    }

    /// The signs of the slope, span by span; none where it is 0.
    fn signs(&self, t: &BigRational) -> Vec<Vec<Sign>> {
        let signs = |p: IntegerPolynomial| if p.is_zero() { Vec::new() } else { sign_sequence(&p) };
        self.slopes.iter().map(|(_, slope)| signs(at(slope, t))).collect()
    }
}

/// Is the root ≤ 1? That is y ≤ 1/2.
fn at_most_one(mut root: IsolatedRoot) -> bool {
    let half = BigRational::new(1.into(), 2.into());
    while *root.lo() < half && half < *root.hi() {
        root.refine();
    }
    *root.lo() < half || root.exact() == Some(&half)
}

/// The function rises at first.
fn local_maxima<'a>(spans: impl Iterator<Item = &'a Vec<Sign>>) -> usize {
    let signs = std::iter::once(Sign::Positive).chain(spans.flatten().copied());
    turns(signs).filter(|turn| *turn == ExtremumKind::Maximum).count()
}

/// N at the end of the span that the event is about.
fn edge(rows: &[Polynomial<BigInt>], event: PartitionEvent) -> Option<IntegerPolynomial> {
    let row = match event {
        PartitionEvent::Start => rows.first()?,
        PartitionEvent::End => rows.last()?,
        PartitionEvent::Fold => return None,
    };
    Some(IntegerPolynomial::primitive(row.coefficients().to_vec()).without_root_at_zero().square_free())
}

fn polynomial((first, rest): (&BigInt, &[BigInt])) -> Polynomial<BigInt> {
    Polynomial::new(first.clone(), rest.iter().cloned())
}

/// N(·, t), times a positive number.
fn at(slope: &Polynomial<Polynomial<BigInt>>, t: &BigRational) -> IntegerPolynomial {
    let degree = slope.coefficients().iter().map(Polynomial::degree).max().unwrap_or(0);
    let (a, d) = (t.numer(), t.denom());
    let value = |p: &Polynomial<BigInt>| {
        let mut sum = BigInt::default();
        let mut power = d.power(degree - p.degree());
        for c in p.coefficients().iter().rev() {
            sum = sum * a + c * &power;
            power *= d;
        }
        sum
    };
    IntegerPolynomial::primitive(slope.coefficients().iter().map(value).collect())
}

/// Without the powers of u, of t and of 1 − t that divide all of it.
fn reduced(slope: &Polynomial<Polynomial<BigInt>>) -> Polynomial<Polynomial<BigInt>> {
    let order = |row: &[BigInt]| row.iter().take_while(|c| c.is_zero()).count();
    let rows = slope.coefficients().iter().skip_while(|row| row.is_zero());
    let mut rows: Vec<Vec<BigInt>> = rows.map(|row| row.coefficients().to_vec()).collect();
    if rows.is_empty() {
        return slope.zero();
    }
    let common = rows.iter().filter(|row| order(row) < row.len()).map(|row| order(row)).min().unwrap_or(0);
    for row in &mut rows {
        row.drain(..common.min(row.len()));
    }
    // p = (1 − t)q: the coefficients of q are the partial sums of those of p, and the last sum is 0.
    while rows.iter().all(|row| row.iter().sum::<BigInt>().is_zero()) {
        for row in &mut rows {
            let mut sum = BigInt::default();
            for c in &mut *row {
                sum += &*c;
                c.clone_from(&sum);
            }
            row.pop();
        }
    }
    let mut rows = rows
        .iter()
        .map(|row| row.split_first().map_or_else(|| Polynomial::constant(BigInt::default()), polynomial));
    match rows.next() {
        Some(first) => Polynomial::new(first, rows),
        None => slope.zero(),
    }
}
