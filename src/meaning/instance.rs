//! What sentences are read on: an index or another member of a family, and where there are any a degree, knots and control points.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::analysis::{
    Greatest, OneDenominator, Piece, Pieces, Tie, coordinate_between, over_common_denominator,
    positive_coordinate,
};
use crate::language::Name;
use crate::scalar::{BigInt, BigRational, Jet, Polynomial, RationalAlgebra, Ring, integer};
use crate::spline::{
    Active, AnyWeights, Basis, Evaluator, FormTable, Index, KnotVector, Obligation, Point, Sampler, Side,
    Span, SpanError, by_definition, by_weights, weight,
};

use super::family::{MemberError, Weighting};
use super::value::Fraction;

/// An index, or another member of a family, with or without a degree on knots. What is computed on the knots is kept, for all
/// sentences that are judged on it, and on the same knots with another index.
#[derive(Debug)]
pub struct Instance {
    /// α, or the parameters of another family.
    pub weights: Weighting,
    /// The degree and U.
    pub basis: Option<Basis<Weighting>>,
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
    tables: Kept<(Weighting, usize), Result<FormTable, MemberError>>,
    pieces: Kept<(Weighting, usize), Pieces>,
    over_one: Kept<(Weighting, usize, usize), OverOne>,
    weights: Kept<(Weighting, usize, usize, usize), Fraction>,
    derivatives: Kept<(Weighting, usize, usize, usize, usize), Fraction>,
    kernels: Kept<(Weighting, usize), Option<Kernel>>,
    jets: Kept<JetsKey, Option<Jets>>,
    ties: Kept<(Weighting, usize, usize), Option<Tie>>,
    suprema: Kept<(Parts, Parts, bool), Option<Greatest>>,
}

/// The coefficients of a polynomial as integers, which have a hash that costs little.
type Parts = Vec<(BigInt, BigInt)>;

/// The member, the degree, x, whether from the left, the order, and whether by the definition.
type JetsKey = (Weighting, usize, BigRational, bool, usize, bool);

/// The numerators of all functions of a degree on a span over one denominator.
type OverOne = (Arc<Polynomial<BigRational>>, Active<Polynomial<BigRational>>);
/// All functions of a degree that live at a point.
type Jets = Active<Jet<BigRational>>;

/// A basis with the fast kernel for its weights, if there is one.
#[derive(Debug)]
struct Kernel {
    basis: Basis<AnyWeights>,
    fast: Option<Mutex<Evaluator>>,
}

impl Kernel {
    fn of(basis: Basis<AnyWeights>) -> Self {
        Self { fast: Evaluator::of(&basis).map(Mutex::new), basis }
    }

    fn jets(&self, x: &BigRational, side: Side, order: usize) -> Option<Jets> {
        match &self.fast {
            Some(fast) => fast.lock().unwrap_or_else(PoisonError::into_inner).jets(x, side, order),
            None => Sampler::new(&self.basis).jets(x, side, order),
        }
    }
}

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
        Self::weights(Weighting::Index(index))
    }

    /// A member of any family alone, likewise.
    #[must_use]
    pub fn weights(weights: Weighting) -> Self {
        Self {
            weights,
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
        let weights = Weighting::Index(basis.index().clone());
        Self { basis: Some(basis.with(weights.clone())), ..Self::weights(weights) }
    }

    /// A degree and a member of any family on knots.
    ///
    /// # Errors
    /// [`MemberError`], if the member gives no weights on these knots.
    pub fn on(basis: Basis<Weighting>) -> Result<Self, MemberError> {
        let weights = basis.weights().clone();
        let on = Self { basis: Some(basis), ..Self::weights(weights.clone()) };
        on.table(&weights).map(|_| on)
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
        self.with(Weighting::Index(index))
    }

    pub(super) fn with(&self, weights: Weighting) -> Self {
        let basis = self.basis.as_ref().map(|basis| basis.with(weights.clone()));
        let (name, points, shown) = (self.name.clone(), self.points.clone(), self.shown.clone());
        Self { basis, name, points, shown, known: Arc::clone(&self.known), ..Self::weights(weights) }
    }

    /// The same with values by the definition: the slow reference, which a witness is read on once more.
    #[must_use]
    pub fn by_definition(&self) -> Self {
        Self { reference: true, ..self.with(self.weights.clone()) }
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

    /// The basis of a degree ≤ k and an index on the same knots; `None` for a member of another family too.
    #[must_use]
    pub fn basis_of(&self, weights: &Weighting, degree: usize) -> Option<Basis> {
        Basis::new(self.knots()?.clone(), degree, weights.index()?.clone()).ok()
    }

    /// The weights of a member of another family on the knots, for the degree k; `None` for an index, which needs no table.
    ///
    /// # Errors
    /// [`MemberError`], if it gives none.
    pub fn table(&self, weights: &Weighting) -> Result<Option<FormTable>, MemberError> {
        let (Some(member), Some(basis)) = (weights.member(), &self.basis) else { return Ok(None) };
        let key = (weights.clone(), basis.degree());
        let made = self.known.tables.get(key, |_| member.table(basis.knots(), basis.degree()));
        (*made).clone().map(Some)
    }

    /// The basis of a degree ≤ k and a member of any family on the same knots.
    #[must_use]
    pub fn any_basis_of(&self, weights: &Weighting, degree: usize) -> Option<Basis<AnyWeights>> {
        let weights = match weights {
            Weighting::Index(index) => AnyWeights::Index(index.clone()),
            Weighting::Family(_) => AnyWeights::Forms(self.table(weights).ok()??),
        };
        Basis::over(self.knots()?.clone(), degree, weights).ok()
    }

    /// The first condition that fails of those which make all functions ≥ 0: for w_i^d on span j, as (j, i, d). For an index
    /// none does.
    #[must_use]
    pub fn obligation(&self, weights: &Weighting) -> Option<((usize, usize, usize), Obligation)> {
        let table = self.table(weights).ok()??;
        table.iter().find_map(|(place, forms)| Some((place, forms.obligations().err()?)))
    }

    /// Is G_i^d nowhere negative? By the weights, or else by the signs of its pieces; `None` if there are no functions.
    #[must_use]
    pub fn is_nonnegative(&self, weights: &Weighting, (i, d): (usize, usize)) -> Option<bool> {
        if self.obligation(weights).is_none() {
            return Some(true);
        }
        Some(self.pieces(weights, d)?.is_nonnegative(i))
    }

    /// The pieces of a degree ≤ k and a member; those of the own one are compared once with what the definition gives over
    /// the variable u.
    #[must_use]
    pub fn pieces(&self, weights: &Weighting, degree: usize) -> Option<Arc<Pieces>> {
        let key = (weights.clone(), degree);
        let basis = self.any_basis_of(weights, degree)?;
        let pieces = self.known.pieces.get(key, |_| Pieces::of(&basis));
        if *weights == self.weights {
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
                    format!("two pieces of G_{i}^{degree} on span {j} of U = {knots}, α = {}", self.weights);
                _ = self.fault.set(fault);
            }
        }
    }

    /// G_i^d on every span by the definition.
    fn by_variable(&self) -> Vec<Vec<Vec<Piece>>> {
        let Some(basis) = &self.basis else { return Vec::new() };
        let coordinate = |span| positive_coordinate(basis.knots(), span).ok();
        let defined = |span| self.defined(&self.weights, basis.degree(), span, &coordinate(span)?)?.ok();
        basis.knots().spans().filter_map(defined).collect()
    }

    /// All functions of the degrees up to d by the recursion word for word: of a family with the terms of its file.
    fn defined<S: RationalAlgebra>(
        &self,
        weights: &Weighting,
        degree: usize,
        span: Span,
        x: &S,
    ) -> Option<Result<Vec<Vec<S>>, SpanError>> {
        let basis = self.basis.as_ref()?;
        Some(match weights.member() {
            None => by_definition(&self.basis_of(weights, degree)?, span, x),
            Some(member) => {
                let of_degree = Basis::over(basis.knots().clone(), degree, ()).ok()?;
                let shares = |i: usize, d: usize| {
                    let place = (span.index(), i, d);
                    // The table has seen to it that there is a value.
                    let shares = member.shares(place, basis.knots(), basis.degree(), x);
                    shares.unwrap_or_else(|| (x.zero(), x.one()))
                };
                by_weights(&of_degree, span, x, shares)
            }
        })
    }

    /// w_i^d on span j between the knots t_a = t_i and t_b = t_{i+d}, in its coordinate.
    #[must_use]
    pub fn weight(&self, weights: &Weighting, (a, b): (usize, usize), j: usize) -> Option<Arc<Fraction>> {
        let knots = self.knots()?;
        let table = self.table(weights).ok()?;
        Some(self.known.weights.get((weights.clone(), a, b, j), |_| {
            let x = coordinate_between(knots.t(j), knots.t(j + 1));
            let ends = (knots.t(a), knots.t(b));
            let share = match (weights, &table) {
                (Weighting::Index(index), _) => Some(weight(&x.embed(index.ratio()), &x, ends.0, ends.1).0),
                (_, Some(table)) => {
                    let forms = table.get(j, a, b - a).cloned();
                    forms.and_then(|forms| Some(forms.shares(&x, ends.0, ends.1)?.0))
                }
                (_, None) => None,
            };
            share.unwrap_or_else(|| x.zero()).into()
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
    pub fn tie(&self, weights: &Weighting, (i, d): (usize, usize)) -> Option<Tie> {
        let basis = self.basis_of(weights, d)?;
        (*self.known.ties.get((weights.clone(), d, i), |_| Tie::near(&basis, i))).clone()
    }

    /// The derivative of an order of G_i^d on span j in its coordinate; `None` where it is 0.
    #[must_use]
    pub fn piece(
        &self,
        weights: &Weighting,
        (i, d): (usize, usize),
        j: usize,
        order: usize,
    ) -> Option<Arc<Fraction>> {
        if !(i..=i + d).contains(&j) {
            return None;
        }
        let pieces = self.pieces(weights, d)?;
        let span = self.knots()?.span(j)?;
        let on = pieces.on(span)?;
        let own = on.functions.get(i)?;
        let derivative = |order| (0..order).fold(own.clone(), |f, _| on.derivative(&f));
        Some(self.known.derivatives.get((weights.clone(), d, j, i, order), |_| {
            if order > 0 {
                return derivative(order).into();
            }
            let key = (weights.clone(), d, j);
            let over = self.known.over_one.get(key, |_| match weights {
                Weighting::Index(index) => {
                    let one = OneDenominator::of(pieces.basis(), index, span);
                    (Arc::new(one.denominator()), one.numerators)
                }
                Weighting::Family(_) => {
                    let over = over_common_denominator(on.functions.values());
                    let (denominator, numerators) =
                        over.unwrap_or_else(|| (on.x.one().numerator().clone(), Vec::new()));
                    (Arc::new(denominator), Active::new(on.functions.first(), numerators))
                }
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
        weights: &Weighting,
        (i, d): (usize, usize),
        x: &BigRational,
        side: Side,
        order: usize,
    ) -> BigRational {
        // Sums over all functions ask for those that are 0 there, most of them.
        let ends = self.knots().and_then(|knots| knots.knots().get(i).zip(knots.knots().get(i + d + 1)));
        let away = ends.is_none_or(|(from, to)| x < from || to < x);
        if away && !self.reference {
            return integer(0);
        }
        let key = (weights.clone(), d, x.clone(), side == Side::Left, order, self.reference);
        let jets = self.known.jets.get(key, |_| {
            if self.reference {
                let span = self.knots()?.span_at(x, side)?;
                let table = self.defined(weights, d, span, &Jet::variable(x.clone(), order))?.ok()?.pop()?;
                return Some(Active::new(0, table));
            }
            let of_degree = (weights.clone(), d);
            let kernel = self.known.kernels.get(of_degree, |_| self.any_basis_of(weights, d).map(Kernel::of));
            (*kernel).as_ref()?.jets(x, side, order)
        });
        let jet = (*jets).as_ref().and_then(|jets| jets.get(i));
        jet.and_then(|jet| jet.derivatives().pop()).unwrap_or_else(|| integer(0))
    }
}
