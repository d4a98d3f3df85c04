//! What sentences are read on: an index, and where there are any a degree, knots and control points.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::analysis::{
    Greatest, OneDenominator, Piece, Pieces, Tie, coordinate_between, positive_coordinate,
};
use crate::language::Name;
use crate::scalar::{BigInt, BigRational, Jet, Polynomial, RationalAlgebra, Ring, integer};
use crate::spline::{Active, Basis, Evaluator, Index, KnotVector, Point, Side, by_definition, weight};

use super::value::Fraction;

/// An index, with or without a degree on knots. What is computed on the knots is kept, for all sentences that are judged on
/// it, and on the same knots with another index.
#[derive(Debug)]
pub struct Instance {
    /// α.
    pub index: Index,
    /// The degree and U.
    pub basis: Option<Basis>,
    /// Its name, if the paper gives it one.
    pub name: Option<Name>,
    /// Control points, if it has some.
    pub points: Option<Vec<Point>>,
    /// The indices that it is shown for.
    pub shown: Vec<Index>,
    known: Arc<Known>,
    definition: OnceLock<Vec<Vec<Vec<Piece>>>>,
    compared: Kept<usize, ()>,
    fault: OnceLock<String>,
    /// Are values computed by the definition, word for word?
    reference: bool,
}

/// What was computed on knots, for any index.
#[derive(Debug, Default)]
struct Known {
    pieces: Kept<(Index, usize), Pieces>,
    over_one: Kept<(Index, usize, usize), OverOne>,
    weights: Kept<(Index, usize, usize, usize), Fraction>,
    derivatives: Kept<(Index, usize, usize, usize, usize), Fraction>,
    jets: Kept<JetsKey, Option<Jets>>,
    ties: Kept<(Index, usize, usize), Option<Tie>>,
    suprema: Kept<(Parts, Parts, bool), Option<Greatest>>,
}

/// The coefficients of a polynomial as integers, which have a hash that costs little.
type Parts = Vec<(BigInt, BigInt)>;

/// α, the degree, x, whether from the left, the order, and whether by the definition.
type JetsKey = (Index, usize, BigRational, bool, usize, bool);

/// The numerators of all functions of a degree on a span over one denominator.
type OverOne = (Arc<Polynomial<BigRational>>, Active<Polynomial<BigRational>>);
/// All functions of a degree that live at a point.
type Jets = Active<Jet<BigRational>>;

/// Computed when first asked for.
#[derive(Debug)]
struct Kept<K, V>(Mutex<HashMap<K, Arc<V>>>);

impl<K, V> Default for Kept<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash, V> Kept<K, V> {
    fn get(&self, key: K, make: impl FnOnce(&K) -> V) -> Arc<V> {
        let lock = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().get(&key) {
            return Arc::clone(known);
        }
        // Not under the lock: others may ask for something else meanwhile.
        let made = Arc::new(make(&key));
        Arc::clone(lock().entry(key).or_insert(made))
    }
}

impl Instance {
    /// An index alone, for sentences about weights.
    #[must_use]
    pub fn index(index: Index) -> Self {
        Self {
            index,
            basis: None,
            name: None,
            points: None,
            shown: Vec::new(),
            known: Arc::default(),
            definition: OnceLock::new(),
            compared: Kept::default(),
            fault: OnceLock::new(),
            reference: false,
        }
    }

    /// A degree and an index on knots.
    #[must_use]
    pub fn of(basis: Basis) -> Self {
        Self { basis: Some(basis.clone()), ..Self::index(basis.index().clone()) }
    }

    /// With a name, and perhaps control points.
    #[must_use]
    pub fn named(self, name: &str, points: Option<Vec<Point>>) -> Self {
        Self { name: Some(name.into()), points, ..self }
    }

    /// With control points.
    #[must_use]
    pub fn with_points(self, points: Option<Vec<Point>>) -> Self {
        Self { points, ..self }
    }

    /// The same for another index.
    #[must_use]
    pub fn with_index(&self, index: Index) -> Self {
        let basis = self.basis.as_ref().map(|basis| basis.with_index(index.clone()));
        let (name, points, shown) = (self.name.clone(), self.points.clone(), self.shown.clone());
        Self { basis, name, points, shown, known: Arc::clone(&self.known), ..Self::index(index) }
    }

    /// The same with values by the definition: the slow reference, which a witness is read on once more.
    #[must_use]
    pub fn by_definition(&self) -> Self {
        Self { reference: true, ..self.with_index(self.index.clone()) }
    }

    /// k.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.basis.as_ref().map(Basis::degree)
    }

    /// U.
    #[must_use]
    pub fn knots(&self) -> Option<&KnotVector> {
        self.basis.as_ref().map(Basis::knots)
    }

    /// Two computations that disagreed: a bug of this program.
    #[must_use]
    pub fn fault(&self) -> Option<&str> {
        self.fault.get().map(String::as_str)
    }

    /// What is found wrong with another one is wrong here.
    pub(super) fn share_fault(&self, other: &Self) {
        if let Some(fault) = other.fault() {
            _ = self.fault.set(fault.to_owned());
        }
    }

    /// The basis of a degree ≤ k and an index on the same knots.
    #[must_use]
    pub fn basis_of(&self, index: &Index, degree: usize) -> Option<Basis> {
        Basis::new(self.knots()?.clone(), degree, index.clone()).ok()
    }

    /// The pieces of a degree ≤ k and an index; those of the own index are compared once with what the definition gives over
    /// the variable u.
    #[must_use]
    pub fn pieces(&self, index: &Index, degree: usize) -> Option<Arc<Pieces>> {
        let basis = self.basis_of(index, degree)?;
        let pieces = self.known.pieces.get((index.clone(), degree), |_| Pieces::of(&basis));
        if *index == self.index {
            self.compared.get(degree, |_| self.compare(&pieces, degree));
        }
        Some(pieces)
    }

    fn compare(&self, pieces: &Pieces, degree: usize) {
        let defined = self.definition.get_or_init(|| self.by_variable());
        for (span, table) in pieces.spans().iter().zip(defined) {
            let differs =
                |(i, g): (usize, &Piece)| span.functions.get(i).map_or(!g.is_zero(), |own| own != g);
            let row = table.get(degree).into_iter().flatten();
            if let Some(i) = row.enumerate().position(differs) {
                let (j, knots) = (span.span.index(), pieces.basis().knots());
                let fault =
                    format!("two pieces of G_{i}^{degree} on span {j} of U = {knots}, α = {}", self.index);
                _ = self.fault.set(fault);
            }
        }
    }

    /// G_i^d on every span by the definition.
    fn by_variable(&self) -> Vec<Vec<Vec<Piece>>> {
        let Some(basis) = &self.basis else { return Vec::new() };
        let coordinate = |span| positive_coordinate(basis.knots(), span).ok();
        basis.knots().spans().filter_map(|span| by_definition(basis, span, &coordinate(span)?).ok()).collect()
    }

    /// φ(x, t_a, t_b) on span j between these knots, in its coordinate.
    #[must_use]
    pub fn weight(&self, index: &Index, (a, b): (usize, usize), j: usize) -> Option<Arc<Fraction>> {
        let knots = self.knots()?;
        Some(self.known.weights.get((index.clone(), a, b, j), |_| {
            let x = coordinate_between(knots.t(j), knots.t(j + 1));
            weight(&x.embed(index.ratio()), &x, knots.t(a), knots.t(b)).0.into()
        }))
    }

    /// The supremum of a function of the coordinate, or of its absolute value; `None` if it has a pole.
    #[must_use]
    pub fn greatest(&self, f: &Piece, absolute: bool) -> Option<Greatest> {
        let parts = |p: &Polynomial<BigRational>| {
            p.coefficients().iter().map(|c| (c.numer().clone(), c.denom().clone())).collect()
        };
        let key = (parts(f.numerator()), parts(f.denominator()), absolute);
        let of = if absolute { Greatest::of_modulus } else { Greatest::of_function };
        (*self.known.suprema.get(key, |_| of(f))).clone()
    }

    /// What ties the largest values of G_i^d for an index close by, as far as it is found.
    #[must_use]
    pub fn tie(&self, index: &Index, (i, d): (usize, usize)) -> Option<Tie> {
        let basis = self.basis_of(index, d)?;
        (*self.known.ties.get((index.clone(), d, i), |_| Tie::near(&basis, i))).clone()
    }

    /// The derivative of an order of G_i^d on span j in its coordinate; `None` where it is 0.
    #[must_use]
    pub fn piece(
        &self,
        index: &Index,
        (i, d): (usize, usize),
        j: usize,
        order: usize,
    ) -> Option<Arc<Fraction>> {
        if !(i..=i + d).contains(&j) {
            return None;
        }
        let pieces = self.pieces(index, d)?;
        let span = self.knots()?.span(j)?;
        let on = pieces.on(span)?;
        let own = on.functions.get(i)?;
        let derivative = |order| (0..order).fold(own.clone(), |f, _| on.derivative(&f));
        Some(self.known.derivatives.get((index.clone(), d, j, i, order), |_| {
            if order > 0 {
                return derivative(order).into();
            }
            let key = (index.clone(), d, j);
            let over = self.known.over_one.get(key, |_| {
                let one = OneDenominator::of(pieces.basis(), span);
                (Arc::new(one.denominator()), one.numerators)
            });
            match over.1.get(i) {
                Some(numerator) => Fraction::shared(own.clone(), numerator, &over.0),
                None => own.clone().into(),
            }
        }))
    }

    /// The derivative of an order of G_i^d at x from a side.
    #[must_use]
    pub fn value(
        &self,
        index: &Index,
        (i, d): (usize, usize),
        x: &BigRational,
        side: Side,
        order: usize,
    ) -> BigRational {
        let key = (index.clone(), d, x.clone(), side == Side::Left, order, self.reference);
        let jets = self.known.jets.get(key, |_| {
            let basis = self.basis_of(index, d)?;
            if self.reference {
                let span = basis.knots().span_at(x, side)?;
                let table = by_definition(&basis, span, &Jet::variable(x.clone(), order)).ok()?.pop()?;
                return Some(Active::new(0, table));
            }
            Evaluator::new(&basis).jets(x, side, order)
        });
        let jet = (*jets).as_ref().and_then(|jets| jets.get(i));
        jet.and_then(|jet| jet.derivatives().pop()).unwrap_or_else(|| integer(0))
    }
}
