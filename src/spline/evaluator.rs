//! Exact values at many points of one basis, without a division on the way.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::scalar::{Fixed, Jet, Natural, Ring, ScaleBy, gcd, integer, over_one_denominator};

use super::basis::Basis;
use super::factors::Factors;
use super::fraction_free::FractionFree;
use super::kind::HasWeights;
use super::knots::{Side, Span};
use super::linear_weights::LinearWeights;
use super::reducer::Reducer;
use super::triangle::{Active, Triangle, triangle};
use super::weight::Weights;

/// Exact values of the G_i^k of one basis at any number of points.
///
/// With t_i = T_i/D, r = p/q and x = X/ξ, all of them integers, the [factors](Factors) on a span times Dξ are
///
/// rise_a = p(DX − ξT_a),  fall_b = q(ξT_b − DX),
///
/// with p and q of each weight where linear weights have no common ratio. The [recursion without a division](FractionFree) runs over their products. Numbers are machine words, of 64 and
/// of 128 bits, as far as a bound that is computed first says that they fit, and integers of any size beyond; what
/// comes out does not depend on that. The cost of a point is that of its span: the search for it is logarithmic
/// in the number of knots, and nothing else depends on it.
///
/// ```
/// use knotproof::scalar::{integer, rational};
/// use knotproof::spline::{Basis, Evaluator, Index, KnotVector, Side};
///
/// let knots = KnotVector::new([0, 0, 0, 1, 1, 1].map(integer).to_vec())?;
/// let basis = Basis::new(knots, 2, "-1".parse::<Index>()?)?;
/// let mut evaluator = Evaluator::new(&basis);
/// for x in [rational(1, 3), rational(1, 2)] {
///     let mut unreduced = evaluator.at(&x, Side::Right).expect("x is inside");
///     assert!(unreduced.sum_is_one());
///     assert_eq!(unreduced.reduced().values(), basis.values(&x, Side::Right));
/// }
/// assert!(evaluator.at(&integer(2), Side::Right).is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Evaluator {
    degree: usize,
    /// D.
    scale: BigInt,
    /// T_0, …, T_m.
    knots: Vec<BigInt>,
    /// (p, q).
    slopes: LinearWeights<BigInt>,
    /// The same in machine words, if all of it fits.
    words: Option<InWords>,
    short: Room<u64, Fixed>,
    long: Room<u64, Natural>,
    big: Room<BigInt, BigInt>,
    reducer: Reducer,
}

/// D, T_i, p and q as machine words.
#[derive(Debug, Clone)]
struct InWords {
    scale: i64,
    knots: Vec<i64>,
    slopes: LinearWeights<u64>,
}

/// From this degree on the triangle over fractions may be the faster one.
const HIGH: usize = 96;

/// The weights with these factors, in lowest terms.
struct Shares<'a>(&'a Factors<u64>);

impl Weights for Shares<'_> {
    type Scalar = BigRational;

    fn one(&self) -> BigRational {
        integer(1)
    }

    fn pair(&self, i: usize, d: usize) -> (BigRational, BigRational) {
        let (rise, fall) = self.0.shares(i, d);
        let whole = BigInt::from(*rise) + fall;
        let share = |part: &u64| BigRational::new((*part).into(), whole.clone());
        (share(rise), share(fall))
    }
}

/// What one run of the recursion writes to.
#[derive(Debug, Clone)]
struct Room<F, S> {
    factors: Factors<F>,
    one: S,
    triangle: Triangle<S>,
}

impl<F: Clone, S: ScaleBy<F>> Room<F, S> {
    fn new(degree: usize, one: S) -> Self {
        Self { factors: Factors::empty(degree), triangle: Triangle::new(one.clone()), one }
    }

    fn run(&mut self, m: usize) -> (&Factors<F>, &Triangle<S>) {
        let Self { factors, one, triangle } = self;
        triangle.run(&FractionFree::new(factors, one), factors.span(), factors.degree(), m);
        (factors, triangle)
    }
}

impl Evaluator {
    /// Brings the knots of a basis to a common denominator.
    #[must_use]
    pub fn new(basis: &Basis) -> Self {
        match Self::of(basis) {
            Some(evaluator) => evaluator,
            None => unreachable!("the weights of an index are linear"),
        }
    }

    /// The same for any weights; `None` unless all of them are linear.
    #[must_use]
    pub fn of<W: HasWeights>(basis: &Basis<W>) -> Option<Self> {
        let (slopes, degree) = (LinearWeights::of(basis)?, basis.degree());
        let (knots, scale) = over_one_denominator(basis.knots().knots());
        Some(Self {
            degree,
            words: InWords::of(&scale, &knots, &slopes),
            scale,
            knots,
            slopes,
            short: Room::new(degree, Fixed::new(1_i128)),
            long: Room::new(degree, Natural::from(1)),
            big: Room::new(degree, BigInt::from(1)),
            reducer: Reducer::default(),
        })
    }

    /// The functions that live at x, as limits from the given side; `None` where all are 0, that is, outside of
    /// [t_0, t_m], on the left of t_0 and, as limits from there, on the right of t_m.
    pub fn at(&mut self, x: &BigRational, side: Side) -> Option<Unreduced<'_>> {
        let m = self.knots.len() - 1;
        let in_words = self.words.as_ref().and_then(|words| words.place(x));
        let span = match &in_words {
            Some((words, dx, xi)) => words.span(side, *dx, *xi)?,
            None => {
                let (dx, xi) = (&self.scale * x.numer(), x.denom());
                span(m, side, |i| (&self.knots[i] * xi).cmp(&dx))?
            }
        };
        if let Some((words, dx, xi)) = in_words
            && let Some(bits) = words.factors(&mut self.long.factors, span, dx, xi)
        {
            // The largest denominator has (s + 1)(w + 1) − 1 factors, s + w = k, and no number exceeds it.
            let factors = (self.degree / 2 + 1) * self.degree.div_ceil(2).saturating_add(1) - 1;
            if bits.saturating_mul(factors) < 128 {
                std::mem::swap(&mut self.short.factors, &mut self.long.factors);
                let (factors, triangle) = self.short.run(m);
                return Some(Unreduced {
                    parts: Parts::Short(factors, triangle),
                    reducer: &mut self.reducer,
                });
            }
            let (factors, triangle) = self.long.run(m);
            return Some(Unreduced { parts: Parts::Long(factors, triangle), reducer: &mut self.reducer });
        }
        self.big_factors(span, x);
        let (factors, triangle) = self.big.run(m);
        Some(Unreduced { parts: Parts::Big(factors, triangle), reducer: &mut self.reducer })
    }

    /// The values at x in lowest terms: [`at`](Self::at), [`Unreduced::reduced`].
    pub fn values(&mut self, x: &BigRational, side: Side) -> Option<Active<BigRational>> {
        self.by_fractions(x, side).or_else(|| self.at(x, side).map(|mut unreduced| unreduced.reduced()))
    }

    /// The same by the triangle over fractions in lowest terms, where these stay short: in high degrees, if most factors are equal.
    /// Between equidistant knots there are some 3k of them on k²/2 places, and nearly all of a numerator cancels.
    fn by_fractions(&mut self, x: &BigRational, side: Side) -> Option<Active<BigRational>> {
        if self.degree < HIGH {
            return None;
        }
        let m = self.knots.len() - 1;
        let (words, dx, xi) = self.words.as_ref()?.place(x)?;
        let span = words.span(side, dx, xi)?;
        words.factors(&mut self.long.factors, span, dx, xi)?;
        let mut factors = self.long.factors.places().to_vec();
        let places = factors.len();
        factors.sort_unstable();
        factors.dedup();
        // k gcds of fractions as long as all different factors for each of k numerators, or exact divisions of all by all.
        let are_few = factors.len().pow(2).saturating_mul(self.degree) < places.pow(2);
        are_few.then(|| triangle(&Shares(&self.long.factors), span, self.degree, m))
    }

    /// The functions that live at x as jets of the given order, in lowest terms: values and one-sided derivatives;
    /// `None` where all are 0, as in [`at`](Self::at).
    ///
    /// The factors on the span are linear in x, so in ε = Dξ·(x′ − x) they are rise + pε and fall − qε. The recursion
    /// without a division gives numerator N and denominator Q as jets with integer coefficients. Those of N/Q are
    /// h_d/Q_0^(d+1), where
    ///
    /// h_d = N_d Q_0^d − Σ_{l=1..d} Q_l Q_0^(l−1) h_{d−l}.
    pub fn jets(&mut self, x: &BigRational, side: Side, order: usize) -> Option<Active<Jet<BigRational>>> {
        if order == 0 {
            return self.values(x, side).map(|values| values.map(|value| Jet::constant(value.clone(), 0)));
        }
        self.jets_at(x, side, order).map(|unreduced| unreduced.reduced())
    }

    /// The same before they are in lowest terms.
    pub(super) fn jets_at(&mut self, x: &BigRational, side: Side, order: usize) -> Option<UnreducedJets> {
        let m = self.knots.len() - 1;
        let (dx, xi) = (&self.scale * x.numer(), x.denom());
        let span = span(m, side, |i| (&self.knots[i] * xi).cmp(&dx))?;
        let (one, minus_one) = (BigInt::from(1), BigInt::from(-1));
        let [before, after] = self.distances(span, x);
        let mut factors = Factors::empty(self.degree);
        let filled = factors.fill(
            span,
            self.slopes.on(span.index()),
            before.map(|distance| Some((distance, &one))),
            after.map(|distance| Some((distance, &minus_one))),
            |slope, (distance, sign)| Some((slope * distance, slope * *sign)),
            |a, b| Some((&a.0 + &b.0, &a.1 + &b.1)),
        );
        debug_assert!(filled.is_some());
        let one = Jet::constant(BigInt::from(1), order);
        let numerators = triangle(&FractionFree::new(&factors, &one), span, self.degree, m);
        let unit = &self.scale * xi;
        Some(UnreducedJets { factors, one, numerators, unit })
    }

    /// The factors on a span at x of the closed span.
    pub(super) fn factors_at(&mut self, span: Span, x: &BigRational) -> &Factors<BigInt> {
        self.big_factors(span, x);
        &self.big.factors
    }

    fn big_factors(&mut self, span: Span, x: &BigRational) {
        let mut factors = std::mem::replace(&mut self.big.factors, Factors::empty(0));
        let [before, after] = self.distances(span, x);
        let slopes = self.slopes.on(span.index());
        // Integers of any size always fit.
        let times = |slope: &BigInt, distance: &BigInt| Some(slope * distance);
        let filled = factors
            .fill(span, slopes, before.map(Some), after.map(Some), times, |rise, fall| Some(rise + fall));
        debug_assert!(filled.is_some());
        self.big.factors = factors;
    }

    /// Dξ(x − t_j), Dξ(x − t_{j−1}), … and Dξ(t_{j+1} − x), Dξ(t_{j+2} − x), …
    fn distances(&self, span: Span, x: &BigRational) -> [impl Iterator<Item = BigInt> + use<>; 2] {
        let (j, m) = (span.index(), self.knots.len() - 1);
        let (dx, xi) = (&self.scale * x.numer(), x.denom());
        let steps = self.degree.max(1);
        let before: Vec<_> = (0..steps.min(j + 1)).map(|s| &dx - xi * &self.knots[j - s]).collect();
        let after: Vec<_> = (0..steps.min(m - j)).map(|w| xi * &self.knots[j + 1 + w] - &dx).collect();
        [before.into_iter(), after.into_iter()]
    }
}

impl InWords {
    fn of(scale: &BigInt, knots: &[BigInt], slopes: &LinearWeights<BigInt>) -> Option<Self> {
        let word = |number: &BigInt| i64::try_from(number).ok();
        let knots: Option<Vec<_>> = knots.iter().map(word).collect();
        let slopes = slopes.map(|slope| u64::try_from(slope).ok())?;
        Some(Self { scale: word(scale)?, knots: knots?, slopes })
    }

    /// (DX, ξ) of x = X/ξ.
    fn place(&self, x: &BigRational) -> Option<(&Self, i128, i64)> {
        let (numerator, denominator) = (i64::try_from(x.numer()).ok()?, i64::try_from(x.denom()).ok()?);
        Some((self, i128::from(self.scale) * i128::from(numerator), denominator))
    }

    fn span(&self, side: Side, dx: i128, xi: i64) -> Option<Span> {
        span(self.knots.len() - 1, side, |i| (i128::from(self.knots[i]) * i128::from(xi)).cmp(&dx))
    }

    /// Fills in the factors on a span, if all of them fit; with the bits of the largest.
    fn factors(&self, factors: &mut Factors<u64>, span: Span, dx: i128, xi: i64) -> Option<usize> {
        let (j, m) = (span.index(), self.knots.len() - 1);
        let steps = factors.degree().max(1);
        let at = |i: usize| i128::from(self.knots[i]) * i128::from(xi);
        let before = (0..steps.min(j + 1)).map(|s| u64::try_from(dx - at(j - s)).ok());
        let after = (0..steps.min(m - j)).map(|w| u64::try_from(at(j + 1 + w) - dx).ok());
        let times = |slope: &u64, distance: &u64| slope.checked_mul(*distance);
        let sum = |rise: &u64, fall: &u64| rise.checked_add(*fall);
        factors.fill(span, self.slopes.on(j), before, after, times, sum)?;
        let all_bits = factors.all().fold(0, |bits, factor| bits | factor);
        Some(64 - all_bits.leading_zeros() as usize)
    }
}

/// The span of the limit at x from the side, where `compare` says how knot i compares with x: as
/// [`KnotVector::span_at`](super::KnotVector::span_at).
fn span(m: usize, side: Side, compare: impl Fn(usize) -> std::cmp::Ordering) -> Option<Span> {
    let from_left = side == Side::Left || compare(m).is_eq();
    let (mut low, mut high) = (0, m + 1);
    while low < high {
        let middle = usize::midpoint(low, high);
        let ordering = compare(middle);
        let below = if from_left { ordering.is_lt() } else { ordering.is_le() };
        (low, high) = if below { (middle + 1, high) } else { (low, middle) };
    }
    (1..=m).contains(&low).then(|| Span::assumed(low - 1))
}

/// The functions that live at a point, as fractions that are not in lowest terms: numerators, and denominators as
/// the [factors](Factors::denominator) that they are products of.
///
/// Signs, sums and equalities can be read from them; [`reduced`](Self::reduced) gives the values themselves.
#[derive(Debug)]
pub struct Unreduced<'a> {
    parts: Parts<'a>,
    reducer: &'a mut Reducer,
}

#[derive(Debug)]
enum Parts<'a> {
    Short(&'a Factors<u64>, &'a Triangle<Fixed>),
    Long(&'a Factors<u64>, &'a Triangle<Natural>),
    Big(&'a Factors<BigInt>, &'a Triangle<BigInt>),
}

impl Unreduced<'_> {
    /// The index of the first function that lives at the point.
    #[must_use]
    pub fn first(&self) -> usize {
        match &self.parts {
            Parts::Short(_, triangle) => triangle.first(),
            Parts::Long(_, triangle) => triangle.first(),
            Parts::Big(_, triangle) => triangle.first(),
        }
    }

    /// The numerators ≥ 0, by rising index.
    #[must_use]
    pub fn numerators(&self) -> Vec<BigInt> {
        match &self.parts {
            Parts::Short(_, triangle) => triangle.values().iter().map(|n| BigInt::from(*n)).collect(),
            Parts::Long(_, triangle) => {
                let mut half_digits = Vec::new();
                triangle.values().iter().map(|n| n.to_integer(&mut half_digits)).collect()
            }
            Parts::Big(_, triangle) => triangle.values().to_vec(),
        }
    }

    /// The denominators > 0, multiplied out, by rising index.
    #[must_use]
    pub fn denominators(&self) -> Vec<BigInt> {
        let first = self.first();
        let denominator = |i| self.scaled(BigInt::from(1), Which::Denominator(i));
        (first..first + self.count()).map(denominator).collect()
    }

    /// Do the functions add up to 1 here (T3.5.3)?
    ///
    /// With all the L that occur up to degree k as the common denominator, that is Σ N_i·∏(L that denominator i
    /// lacks) = ∏ L.
    #[must_use]
    pub fn sum_is_one(&self) -> bool {
        let (numerators, denominator) = self.over_common_denominator();
        numerators.into_iter().sum::<BigInt>() == denominator
    }

    /// The numerators over all the L that occur up to degree k, and the product of these.
    pub(super) fn over_common_denominator(&self) -> (Vec<BigInt>, BigInt) {
        let terms = (self.first()..).zip(self.numerators());
        let numerators = terms.map(|(i, numerator)| self.scaled(numerator, Which::Cofactor(i))).collect();
        (numerators, self.scaled(BigInt::from(1), Which::All))
    }

    /// The values in lowest terms.
    ///
    /// Every common divisor of a numerator and its denominator comes from one with a factor of it, so gcds are taken
    /// with those only.
    #[must_use]
    pub fn reduced(&mut self) -> Active<BigRational> {
        let first = self.first();
        match &self.parts {
            Parts::Short(factors, triangle) => {
                let copy = |from: &Fixed, to: &mut Natural| to.set(from.value().unsigned_abs());
                self.reducer.reduce(first, triangle.values(), factors, copy)
            }
            Parts::Long(factors, triangle) => {
                self.reducer.reduce(first, triangle.values(), factors, |from, to| to.clone_from(from))
            }
            Parts::Big(factors, triangle) => {
                let values = (first..).zip(triangle.values());
                Active::new(
                    first,
                    values.map(|(i, n)| lowest_terms(n.clone(), factors.denominator(i))).collect(),
                )
            }
        }
    }

    fn count(&self) -> usize {
        match &self.parts {
            Parts::Short(_, triangle) => triangle.values().len(),
            Parts::Long(_, triangle) => triangle.values().len(),
            Parts::Big(_, triangle) => triangle.values().len(),
        }
    }

    fn scaled(&self, mut number: BigInt, which: Which) -> BigInt {
        match &self.parts {
            Parts::Short(factors, _) | Parts::Long(factors, _) => which.scale(&mut number, factors),
            Parts::Big(factors, _) => which.scale(&mut number, factors),
        }
        number
    }
}

/// The functions that live at a point as jets in ε = unit·(x′ − x): numerators, and the factors of their denominators.
pub(super) struct UnreducedJets {
    factors: Factors<(BigInt, BigInt)>,
    /// The jet of 1.
    one: Jet<BigInt>,
    numerators: Active<Jet<BigInt>>,
    unit: BigInt,
}

impl UnreducedJets {
    fn reduced(&self) -> Active<Jet<BigRational>> {
        let quotient = |(i, numerator): (usize, &Jet<BigInt>)| {
            let mut denominator = self.one.clone();
            denominator.scale_by(self.factors.denominator(i));
            let places = || self.factors.denominator(i).map(|(constant, _)| constant);
            quotient(numerator, &denominator, &self.unit, |d| {
                std::iter::repeat_n((), d + 1).flat_map(|()| places())
            })
        };
        Active::new(self.numerators.first(), self.numerators.iter().map(quotient).collect())
    }

    /// Σ d_i G_i for the points d_i = D_i/Δ, one jet a coordinate: over the common denominator of all functions, and brought to
    /// lowest terms once.
    pub(super) fn combine(&self, points: &[Vec<BigInt>], scale: &BigInt) -> Vec<Jet<BigRational>> {
        let common = |(i, numerator): (usize, &Jet<BigInt>)| {
            let mut numerator = numerator.clone();
            numerator.scale_by(self.factors.cofactor(i));
            numerator
        };
        let numerators: Vec<_> = self.numerators.iter().map(common).collect();
        let mut denominator = self.one.clone();
        denominator.scale_by(self.factors.all());
        let points = &points[self.numerators.first()..][..numerators.len()];
        let places = || self.factors.all().map(|(constant, _)| constant);
        let coordinate = |c: usize| {
            let of_order = |e: usize| {
                let terms = numerators.iter().zip(points);
                terms.map(|(g, d)| &g.coefficients()[e] * &d[c]).sum::<BigInt>()
            };
            let sum = Jet::from_coefficients((0..=self.one.order()).map(of_order).collect());
            quotient(&sum, &denominator, &self.unit, |d| {
                std::iter::repeat_n((), d + 1).flat_map(|()| places()).chain(std::iter::once(scale))
            })
        };
        (0..points.first().map_or(0, Vec::len)).map(coordinate).collect()
    }
}

/// Some of the factors.
#[derive(Clone, Copy)]
enum Which {
    Denominator(usize),
    Cofactor(usize),
    All,
}

impl Which {
    fn scale<F: Clone>(self, number: &mut BigInt, factors: &Factors<F>)
    where
        BigInt: ScaleBy<F>,
    {
        match self {
            Self::Denominator(i) => number.scale_by(factors.denominator(i)),
            Self::Cofactor(i) => number.scale_by(factors.cofactor(i)),
            Self::All => number.scale_by(factors.all()),
        }
    }
}

/// N/Q as a jet in x, for jets in ε = unit·x; Q_0^(d+1) is the product of `factors(d)`.
fn quotient<'a, I: Iterator<Item = &'a BigInt>>(
    numerator: &Jet<BigInt>,
    denominator: &Jet<BigInt>,
    unit: &BigInt,
    factors: impl Fn(usize) -> I,
) -> Jet<BigRational> {
    let (n, q) = (numerator.coefficients(), denominator.coefficients());
    let mut powers = vec![BigInt::from(1)];
    let mut h: Vec<BigInt> = Vec::with_capacity(n.len());
    for d in 0..n.len() {
        let known = (1..=d).map(|l| &q[l] * &powers[l - 1] * &h[d - l]).sum::<BigInt>();
        h.push(&n[d] * &powers[d] - known);
        powers.push(&powers[d] * &q[0]);
    }
    let mut scale = BigInt::from(1);
    let coefficients = h.into_iter().enumerate().map(|(d, h)| {
        let value = lowest_terms(h, factors(d)).times(&BigRational::from_integer(scale.clone()));
        scale *= unit;
        value
    });
    Jet::from_coefficients(coefficients.collect())
}

/// numerator/∏ factors in lowest terms, for factors of any size.
fn lowest_terms<'a>(mut numerator: BigInt, factors: impl Iterator<Item = &'a BigInt>) -> BigRational {
    if numerator == BigInt::ZERO {
        return integer(0);
    }
    let mut denominator = BigInt::from(1);
    for factor in factors {
        let common = gcd(&numerator, factor);
        if common == BigInt::from(1) {
            denominator *= factor;
            continue;
        }
        numerator /= &common;
        denominator *= factor / common;
    }
    BigRational::new_raw(numerator, denominator)
}
