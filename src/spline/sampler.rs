//! A basis of any weights at a point, or at many.

use num_rational::BigRational;

use crate::scalar::{Jet, RationalAlgebra, integer};

use super::basis::Basis;
use super::evaluator::Evaluator;
use super::kind::HasWeights;
use super::knots::Side;
use super::triangle::Active;

impl<W: HasWeights> Basis<W> {
    /// G_0^k, …, G_n^k at x as jets of the given order: values and one-sided derivatives.
    ///
    /// For many points of one basis, a [`Sampler`] prepares what it can once only.
    #[must_use]
    pub fn jets(&self, x: &BigRational, side: Side, order: usize) -> Vec<Jet<BigRational>> {
        self.all(Sampler::new(self).jets(x, side, order), &Jet::constant(integer(0), order))
    }

    /// G_0^k(x), …, G_n^k(x), as limits from the given side; for many points as [`jets`](Self::jets).
    #[must_use]
    pub fn values(&self, x: &BigRational, side: Side) -> Vec<BigRational> {
        self.all(Sampler::new(self).values(x, side), &integer(0))
    }
}

/// A basis at many points: where all weights are linear, by an [`Evaluator`], which prepares the knots once.
#[derive(Debug, Clone)]
pub struct Sampler<'a, W> {
    basis: &'a Basis<W>,
    kernel: Option<Evaluator>,
}

impl<'a, W: HasWeights> Sampler<'a, W> {
    /// Prepares what can be prepared.
    #[must_use]
    pub fn new(basis: &'a Basis<W>) -> Self {
        Self { basis, kernel: Evaluator::of(basis) }
    }

    /// The fast kernel, of linear weights.
    pub(super) fn kernel(&mut self) -> Option<&mut Evaluator> {
        self.kernel.as_mut()
    }

    /// The functions that live at x as jets of the given order, limits from the side: values and one-sided derivatives;
    /// `None` where all are 0, as in [`Evaluator::at`].
    pub fn jets(&mut self, x: &BigRational, side: Side, order: usize) -> Option<Active<Jet<BigRational>>> {
        match &mut self.kernel {
            Some(kernel) => kernel.jets(x, side, order),
            None => self.recursion(x, side, &Jet::variable(x.clone(), order)),
        }
    }

    /// The values of the functions that live at x; `None` likewise.
    pub fn values(&mut self, x: &BigRational, side: Side) -> Option<Active<BigRational>> {
        match &mut self.kernel {
            Some(kernel) => kernel.values(x, side),
            None => self.recursion(x, side, x),
        }
    }

    fn recursion<S: RationalAlgebra>(&self, x: &BigRational, side: Side, scalar: &S) -> Option<Active<S>> {
        self.basis.active(self.basis.knots().span_at(x, side)?, scalar).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;
    use crate::spline::{Curve, CurveEvaluator, FormTable, Forms, Index, KnotVector};

    /// Linear forms with one ratio are an index: the same functions as by its own kernels.
    #[test]
    fn forms_of_an_index_give_its_functions() {
        let knots = KnotVector::new([0, 0, 0, 1, 1, 2, 4, 4, 5].map(integer).to_vec()).unwrap();
        let index = Index::from_ratio(rational(2, 3)).unwrap();
        let forms = || Forms::new(vec![integer(0), integer(2)], vec![integer(3), integer(0)], None).unwrap();
        for degree in 1..=4 {
            let Ok(basis) = Basis::new(knots.clone(), degree, index.clone()) else { continue };
            let table = FormTable::new(&knots, degree, |_, _, _| Ok::<_, ()>(forms())).unwrap();
            assert_eq!(table.get(3, 3, 1), None, "[t_3, t_4] is empty");
            let other = basis.with(table);
            for x in [rational(0, 1), rational(1, 3), rational(1, 1), rational(9, 2), rational(5, 1)] {
                for side in [Side::Left, Side::Right] {
                    assert_eq!(other.jets(&x, side, 2), basis.jets(&x, side, 2), "{degree}, {x}");
                    assert_eq!(other.values(&x, side), basis.values(&x, side), "{degree}, {x}");
                }
            }
        }
    }

    /// Every weight with a ratio of its own, on knots of every kind: the kernel gives what the recursion gives, at points, as jets, and
    /// for curves, in words and beyond.
    #[test]
    fn linear_forms_have_a_kernel() {
        let knots = KnotVector::new([0, 0, 0, 1, 1, 2, 4, 4, 5, 7, 7].map(integer).to_vec()).unwrap();
        for (degree, scale) in [(0, 1), (1, 1), (2, 3), (3, 1), (4, 1_i64 << 40)] {
            let slope =
                |a: usize, b: usize| rational(i64::try_from(a * 7 % 5 + b).unwrap_or(1), 3) * integer(scale);
            let forms = |j: usize, i: usize, d: usize| {
                Forms::new(vec![integer(0), slope(i, d)], vec![slope(d, j + 1), integer(0)], None).ok_or(())
            };
            let table = FormTable::new(&knots, degree, forms).unwrap();
            let basis = Basis::over(knots.clone(), degree, table).unwrap();
            let points =
                (0..=basis.n()).map(|i| vec![integer(i64::try_from(i * i % 7).unwrap_or(0))]).collect();
            let curve = Curve::new(basis.clone(), points).unwrap();
            let (mut sampler, mut evaluator) = (Sampler::new(&basis), CurveEvaluator::new(&curve));
            assert!(sampler.kernel().is_some());
            for x in [
                rational(0, 1),
                rational(1, 3),
                rational(1, 1),
                rational(9, 2),
                rational(5, 1),
                rational(7, 1),
            ] {
                for side in [Side::Left, Side::Right] {
                    let recursion = |order| sampler.recursion(&x, side, &Jet::variable(x.clone(), order));
                    let (values, jets) = (recursion(0), recursion(2));
                    assert_eq!(sampler.jets(&x, side, 2), jets, "{degree}, {x}");
                    let values = values.map(|all| all.into_map(|jet| jet.coefficients()[0].clone()));
                    assert_eq!(sampler.values(&x, side), values, "{degree}, {x}");
                    assert_eq!(evaluator.point(&x, side), curve.point(&x, side), "{degree}, {x}");
                    assert_eq!(evaluator.jets(&x, side, 2), curve.jets(&x, side, 2), "{degree}, {x}");
                    assert_eq!(evaluator.de_boor(&x, side), curve.de_boor(&x, side), "{degree}, {x}");
                }
            }
        }
    }

    /// One weight that is not linear, and all of them are left to the recursion.
    #[test]
    fn other_forms_have_none() {
        let knots = KnotVector::new([0, 0, 0, 1, 1, 1].map(integer).to_vec()).unwrap();
        let square = |d: usize| {
            let (rise, fall) = (vec![integer(0), integer(1)], vec![integer(1), integer(0)]);
            let squared =
                (vec![integer(0), integer(0), integer(1)], vec![integer(1), integer(0), integer(0)]);
            let (rise, fall) = if d == 2 { squared } else { (rise, fall) };
            Forms::new(rise, fall, None).ok_or(())
        };
        let table = FormTable::new(&knots, 2, |_, _, d| square(d)).unwrap();
        assert!(Sampler::new(&Basis::over(knots, 2, table).unwrap()).kernel().is_none());
    }
}
