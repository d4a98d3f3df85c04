//! What the study measures at: knots, degree, α and x as floats, drawn at random and changed at random.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use std::sync::Arc;

use super::member::FloatMember;
use crate::float::FloatBasis;
use crate::float::power::power;
use crate::scalar::BigRational;
use crate::spline::{Active, Side, Span};

/// A point of a span of a basis in `f64`. Limits are taken in the span.
#[derive(Debug, Clone)]
pub struct Probe {
    /// The basis.
    pub basis: FloatBasis<f64>,
    /// The member of another family that has its weights, if they are not those of α.
    pub member: Option<Arc<FloatMember>>,
    /// A span of it.
    pub span: Span,
    /// A point of the closed span.
    pub x: f64,
}

impl Probe {
    /// The case of the limit from a side at x; `None` outside of [t_0, t_m].
    #[must_use]
    pub fn at(basis: FloatBasis<f64>, x: f64, side: Side) -> Option<Self> {
        let span = basis.span_at(x, side).ok().flatten()?;
        Some(Self { basis, member: None, span, x })
    }

    /// The same for a member of another family than that of an index.
    #[must_use]
    pub fn of_member(member: &Arc<FloatMember>, x: f64, side: Side) -> Option<Self> {
        let case = Self::at(member.knots().clone(), x, side)?;
        Some(Self { member: Some(Arc::clone(member)), ..case })
    }

    /// The same basis at another point, as the limit from the right.
    fn moved_to(&self, x: f64) -> Option<Self> {
        let case = Self::at(self.basis.clone(), x, Side::Right)?;
        Some(Self { member: self.member.clone(), ..case })
    }

    /// The functions that live on the span at an exact x of it, for these very floats.
    pub(super) fn exact(&self, x: &BigRational) -> Option<Active<BigRational>> {
        let j = self.span.index();
        match &self.member {
            Some(member) => member.exact().active(member.exact().knots().span(j)?, x).ok(),
            None => {
                let exact = self.basis.exact();
                exact.active(exact.knots().span(j)?, x).ok()
            }
        }
    }
}

/// Random cases, and random changes to cases: each stream is a function of the seed and its number.
#[derive(Debug, Clone)]
pub(super) struct Source {
    bits: ChaCha8Rng,
}

/// Gaps, and r or 1/r, differ from 1 by factors up to 2^SPREAD.
pub(super) const SPREAD: i32 = 10;

impl Source {
    pub(super) fn new(seed: u64, stream: u64) -> Self {
        let mut bits = ChaCha8Rng::seed_from_u64(seed);
        bits.set_stream(stream);
        Self { bits }
    }

    /// Evenly in 0..n.
    fn below(&mut self, n: u64) -> u64 {
        (self.bits.next_u64() >> 32).wrapping_mul(n) >> 32
    }

    /// Evenly in [0, 1), 53 bits.
    fn part(&mut self) -> f64 {
        f64::from_bits((1023 << 52) | (self.bits.next_u64() >> 12)) - 1.0
    }

    /// m·2^e with m even in [1, 2) and e even in −SPREAD, …, SPREAD − 1.
    fn spread(&mut self) -> f64 {
        let e = i32::try_from(self.below(2 * u64::from(SPREAD.unsigned_abs()))).unwrap_or(0) - SPREAD;
        (1.0 + self.part()) * power(e)
    }

    /// −s, 1 + s or, one time in eight, ∞, with s spread over the scales.
    fn alpha(&mut self) -> f64 {
        match self.below(8) {
            0 => f64::INFINITY,
            1..4 => 1.0 + self.spread(),
            _ => -self.spread(),
        }
    }

    /// 2k + 2 knots around one span, and a point of it. A gap is 0 one time in eight, but that of the span never.
    pub(super) fn case(&mut self, degree: usize) -> Probe {
        loop {
            let mut knots = vec![self.spread() - self.spread()];
            for i in 1..2 * degree + 2 {
                let gap = if self.below(8) == 0 && i != degree + 1 { 0.0 } else { self.spread() };
                knots.push(knots[i - 1] + gap);
            }
            let x = knots[degree] + self.part() * (knots[degree + 1] - knots[degree]);
            if let Some(case) = Self::checked(knots, degree, self.alpha(), x) {
                return case;
            }
        }
    }

    /// A basis evenly, a span of it evenly, and a point evenly in the span.
    pub(super) fn point(&mut self, bases: &[FloatBasis<f64>]) -> Option<Probe> {
        let basis = bases.get(self.place(bases.len()))?;
        let knots = basis.knots();
        let starts: Vec<usize> = (1..knots.len()).filter(|&i| knots[i - 1] < knots[i]).collect();
        let end = *starts.get(self.place(starts.len()))?;
        let (a, b, part) = (knots[end - 1], knots[end], self.part());
        let width = b - a;
        let x = if width.is_finite() { a + part * width } else { (1.0 - part) * a + part * b };
        Probe::at(basis.clone(), x.min(b), Side::Right)
    }

    /// Likewise for a member of another family.
    pub(super) fn point_of(&mut self, member: &Arc<FloatMember>) -> Option<Probe> {
        let case = self.point(std::slice::from_ref(member.knots()))?;
        Probe::of_member(member, case.x, Side::Right)
    }

    /// A place in a list, evenly.
    fn place(&mut self, length: usize) -> usize {
        usize::try_from(self.below(u64::try_from(length).unwrap_or(0))).unwrap_or(0)
    }

    fn checked(knots: Vec<f64>, degree: usize, alpha: f64, x: f64) -> Option<Probe> {
        let basis = FloatBasis::new(knots, degree, alpha).ok()?;
        Probe::at(basis, x, Side::Right)
    }

    /// The case with one number changed: by a few units in the last place, by a factor, or drawn anew. With `fixed`, only x
    /// changes. `None` if nothing valid came out.
    pub(super) fn changed(&mut self, case: &Probe, fixed: bool) -> Option<Probe> {
        if fixed {
            return case.moved_to(self.moved(case));
        }
        let mut knots = case.basis.knots().to_vec();
        let (mut alpha, mut x) = (case.basis.alpha(), case.x);
        match self.below(8) {
            0..3 => x = self.moved(case),
            3 => alpha = self.nudged(alpha),
            4 => alpha = self.alpha(),
            5 => {
                let i = self.place(knots.len());
                knots[i] = self.nudged(knots[i]);
            }
            6 => {
                // One gap is scaled, and what lies behind it moves along.
                let i = 1 + self.place(knots.len() - 1);
                let more = (knots[i] - knots[i - 1]) * (self.spread() - 1.0);
                for t in &mut knots[i..] {
                    *t += more;
                }
            }
            _ => {
                let shift = self.spread() - self.spread();
                knots.iter_mut().for_each(|t| *t += shift);
                x += shift;
            }
        }
        Self::checked(knots, case.basis.degree(), alpha, x)
    }

    fn moved(&mut self, case: &Probe) -> f64 {
        let anew = if self.below(4) == 0 { self.point(std::slice::from_ref(&case.basis)) } else { None };
        anew.map_or_else(|| self.nudged(case.x), |case| case.x)
    }

    /// The float some units in the last place away, up to 2^20 of them, all scales alike.
    fn nudged(&mut self, value: f64) -> f64 {
        let steps = 1 + (self.bits.next_u64() >> (44 + self.below(20)));
        let away =
            value.to_bits().wrapping_add(if self.below(2) == 0 { steps } else { steps.wrapping_neg() });
        let moved = f64::from_bits(away);
        if moved.is_finite() { moved } else { value }
    }
}
