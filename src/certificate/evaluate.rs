//! Terms as quotients of polynomials in the parameters, by the library's own triangle.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

use num_traits::Signed;

use crate::analysis::determinant;
use crate::language::Name;
use crate::scalar::{Jet, Multivariate, Quotient, RationalAlgebra, Ring, integer};
use crate::spline::{Active, Span, Triangle, Weights, de_boor};

use super::error::{Evaluated, EvaluationError};
use super::interval::Interval;
use super::statement::{Gap, Section};
use super::term::{OfWeight, Place, Term, Where};
use super::weights::{Class, Weighted};

/// How far the definition is unfolded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Unfolding {
    /// Weights of this degree and above are unknowns.
    pub weights_from: Option<usize>,
    /// Functions up to this degree are unknowns.
    pub functions_to: Option<usize>,
    /// 1 − [p|q] is written as such: for equalities.
    pub related: bool,
}

/// What an unknown stands for.
#[derive(Debug, Clone, PartialEq)]
enum Unknown {
    /// p/(p + q).
    Share(Quotient, Quotient),
    /// A derivative of a weight, by its value.
    Slope(Quotient),
    /// Of any weights: 1 − w_i^d, w_i^d, or its derivative, at this x and unit.
    Weight(OfWeight, String, i64, usize, Quotient, Quotient),
    /// A parameter of the family, by its window and its indices.
    Parameter(String, String, Vec<i64>),
    /// G_i^d, or DG_i^d.
    Function(bool, i64, usize, Place),
}

/// The values that one section gives to names.
pub struct Evaluator<'a> {
    section: &'a Section,
    weighted: &'a Weighted,
    /// The member that a reflection leads to: the window with the parameters that there were before, and the index of t_m there.
    dual: Option<(String, i64)>,
    unfolding: Unfolding,
    knots: HashMap<&'a str, (i64, Vec<Quotient>)>,
    variables: RefCell<Vec<(Option<Unknown>, Class)>>,
    names: HashMap<String, Quotient>,
    /// What has been computed with these names: functions, and weights with their complements.
    functions: Known<Jet<Quotient>>,
    pairs: Known<(Jet<Quotient>, Jet<Quotient>)>,
}

/// By the place, i, d, and the order of derivatives.
type Known<T> = RefCell<BTreeMap<(Place, i64, usize, usize), T>>;

impl<'a> Evaluator<'a> {
    /// Prepares a section.
    ///
    /// # Errors
    /// [`EvaluationError`], if a name is not declared where it is used.
    pub fn new(section: &'a Section, weighted: &'a Weighted, unfolding: Unfolding) -> Evaluated<Self> {
        let mut evaluator = Self {
            section,
            weighted,
            dual: None,
            unfolding,
            knots: HashMap::new(),
            variables: RefCell::new(Vec::new()),
            names: HashMap::new(),
            functions: RefCell::default(),
            pairs: RefCell::default(),
        };
        for (name, class) in evaluator.parameters() {
            evaluator.declare(name, class)?;
        }
        for (name, value) in &section.lets {
            let value = evaluator.term(value)?;
            evaluator.names.insert(name.clone(), value);
        }
        for window in &section.windows {
            let mut knots = vec![evaluator.integer(0)];
            for (gap, index) in window.gaps.iter().zip(window.first..) {
                let gap = match gap {
                    Gap::Parameter(class) => {
                        let name = format!("({} {index})", window.name);
                        evaluator.declare(name, *class)?
                    }
                    Gap::Term(value) => evaluator.term(value)?,
                };
                knots.push(knots[knots.len() - 1].plus(&gap));
            }
            evaluator.knots.insert(&window.name, (window.first, knots));
        }
        Ok(evaluator)
    }

    /// What is declared in the section and before it, but for gaps and what belongs to windows.
    pub(super) fn parameters(&self) -> Vec<(String, Class)> {
        let single = self.weighted.single().into_iter().map(|(name, class)| (name.to_string(), class));
        let u = ("u".to_owned(), Class::Positive);
        std::iter::once(u).chain(single).chain(self.section.parameters.iter().cloned()).collect()
    }

    /// A parameter of the family; one with indices is a variable of the window's own.
    fn parameter(&self, window: &str, name: &str, indices: &[i64]) -> Evaluated {
        if indices.is_empty() {
            return self.names.get(name).cloned().ok_or_else(|| EvaluationError::Unknown(name.to_owned()));
        }
        let class = self.weighted.class(name).ok_or_else(|| EvaluationError::Unknown(name.to_owned()))?;
        self.unknown(Unknown::Parameter(window.to_owned(), name.to_owned(), indices.to_vec()), class)
    }

    /// The same of the member at hand.
    fn own_parameter(&self, window: &str, name: &Name, indices: &[i64]) -> Evaluated {
        let Weighted::Family(family) = self.weighted else {
            return Err(EvaluationError::Unknown(name.to_string()));
        };
        if let Some((before, m)) = &self.dual {
            let Some(dual) = &family.dual else { return Err(EvaluationError::Weight("its dual".into())) };
            if let Some((_, term)) = dual.iter().find(|(own, _)| own == name) {
                let parameter = family.parameters.iter().find(|own| own.name == *name);
                let at = |which: &str| {
                    let at = parameter?.indices.iter().position(|index| **index == *which)?;
                    indices.get(at).copied()
                };
                let unit = Jet::constant(self.integer(1), 0);
                let [x, a, b] = [(); 3].map(|()| unit.clone());
                let (i, d) = (at("i").unwrap_or(0), at("d").unwrap_or(0));
                let interval = Interval { x, a, b, unit, i, d, m: Some(*m) };
                return interval.number(term, &|name, indices| self.parameter(before, name, indices));
            }
        }
        self.parameter(window, name, indices)
    }

    fn declare(&mut self, name: String, class: Class) -> Evaluated {
        let value = self.fresh(None, class)?;
        self.names.insert(name, value.clone());
        Ok(value)
    }

    fn fresh(&self, unknown: Option<Unknown>, class: Class) -> Evaluated {
        let mut variables = self.variables.borrow_mut();
        if variables.len() == Multivariate::VARIABLES {
            return Err(EvaluationError::TooMany);
        }
        variables.push((unknown, class));
        Ok(Quotient::variable(variables.len() - 1))
    }

    fn integer(&self, value: i64) -> Quotient {
        Quotient::from_polynomial(Multivariate::constant(value))
    }

    /// How many variables there are: parameters, gaps, and unknowns so far.
    #[must_use]
    pub fn size(&self) -> usize {
        self.variables.borrow().len()
    }

    /// The number of the variable that a parameter is.
    #[must_use]
    pub fn variable_of(&self, parameter: &str) -> Option<usize> {
        let at = self.parameters().iter().position(|(name, _)| name == parameter);
        at.or_else(|| {
            let value = self.names.get(parameter)?;
            (0..self.variables.borrow().len()).find(|&at| *value == Quotient::variable(at))
        })
    }

    /// The sign of each variable.
    #[must_use]
    pub fn classes(&self) -> Vec<Class> {
        self.variables.borrow().iter().map(|(_, class)| *class).collect()
    }

    /// The value of a term.
    ///
    /// # Errors
    /// [`EvaluationError`].
    pub fn term(&self, term: &Term) -> Evaluated {
        let terms = |terms: &[Term]| -> Evaluated<Vec<Quotient>> {
            terms.iter().map(|term| self.term(term)).collect()
        };
        match term {
            Term::Number(value) => Ok(self.integer(0).embed(value)),
            Term::Named(name) => {
                self.names.get(name).cloned().ok_or_else(|| EvaluationError::Unknown(name.clone()))
            }
            Term::Sum(items) => Ok(terms(items)?.iter().fold(self.integer(0), |sum, item| sum.plus(item))),
            Term::Product(items) => {
                Ok(terms(items)?.iter().fold(self.integer(1), |product, item| product.times(item)))
            }
            Term::Difference(a, b) => Ok(self.term(a)?.minus(&self.term(b)?)),
            Term::Ratio(a, b) => {
                let divisor = self.term(b)?;
                self.definite(divisor.numerator())?;
                let quotient = self.term(a)?.over(&divisor);
                quotient.ok_or_else(|| EvaluationError::Division(format!("{b:?}")))
            }
            Term::Power(a, n) => Ok(self.term(a)?.power(*n)),
            Term::Knot(window, index) => self.knot(window, *index).cloned(),
            Term::Point(place) => self.point(place),
            Term::Weight(of, i, d, place) => {
                let order = usize::from(*of == OfWeight::Derivative);
                let weights = self.weights(place, *i, order)?;
                let (w, complement) = weights.pair_at(*i, *d)?;
                Ok(match of {
                    OfWeight::Weight => w.coefficients()[0].clone(),
                    OfWeight::Complement => complement.coefficients()[0].clone(),
                    OfWeight::Derivative => w.coefficients()[1].clone(),
                })
            }
            Term::Function { order, i, degree, place } => {
                let coefficient = self.function(place, *i, *degree, *order)?.coefficients()[*order].clone();
                let factorial = (1..=*order).fold(integer(1), |product, factor| product * integer(factor));
                Ok(coefficient.times(&coefficient.embed(&factorial)))
            }
            Term::DeBoor { i, level, degree, place } => {
                let first = place.span - to_i64(*degree);
                let weights = self.weights(place, first, 0)?;
                let point = |i: i64| {
                    let value = self.term(&Term::Named(format!("(d {i})")))?;
                    Ok(vec![Jet::constant(value, 0)])
                };
                let points: Evaluated<Vec<_>> = (first..=place.span).map(point).collect();
                let levels = de_boor(&weights, Span::assumed(*degree), &points?);
                weights.fault()?;
                let point =
                    usize::try_from(i - first).ok().and_then(|at| levels.as_ref()?.get(*level)?.get(at));
                let value = point.map(|point| point[0].coefficients()[0].clone());
                value.ok_or_else(|| EvaluationError::Unknown(format!("d_{i}^{level}")))
            }
            Term::At(replaced, body) => {
                let mut names = self.names.clone();
                for (name, value) in replaced {
                    if names.insert(name.clone(), self.term(value)?).is_none() {
                        return Err(EvaluationError::Unknown(name.clone()));
                    }
                }
                self.inside(names, self.dual.clone(), body)
            }
            Term::Dual(window, m, body) => self.inside(self.names.clone(), Some((window.clone(), *m)), body),
            Term::Parameter(window, name, indices) => self.parameter(window, name, indices),
            Term::Determinant(rows) => {
                let rows: Evaluated<Vec<_>> = rows.iter().map(|row| terms(row)).collect();
                Ok(determinant(&rows?, &self.integer(1)))
            }
        }
    }

    /// A term where names mean something else.
    fn inside(
        &self,
        names: HashMap<String, Quotient>,
        dual: Option<(String, i64)>,
        body: &Term,
    ) -> Evaluated {
        let inner = Self {
            section: self.section,
            weighted: self.weighted,
            dual,
            unfolding: self.unfolding,
            knots: self.knots.clone(),
            variables: RefCell::new(self.variables.take()),
            names,
            functions: RefCell::default(),
            pairs: RefCell::default(),
        };
        let value = inner.term(body);
        self.variables.replace(inner.variables.into_inner());
        value
    }

    /// G_i^d with derivatives up to the order.
    fn function(&self, place: &Place, i: i64, degree: usize, order: usize) -> Evaluated<Jet<Quotient>> {
        remembered(&self.functions, (place.clone(), i, degree, order), || {
            self.by_triangle(place, i, degree, order)
        })
    }

    /// The same by the triangle on its own d + 2 knots: no other is looked at.
    fn by_triangle(&self, place: &Place, i: i64, degree: usize, order: usize) -> Evaluated<Jet<Quotient>> {
        let zero = Jet::constant(self.integer(0), order);
        let Some(j) = usize::try_from(place.span - i).ok().filter(|j| *j <= degree) else { return Ok(zero) };
        let (weights, span, m) = (self.weights(place, i, order)?, Span::assumed(j), degree + 1);
        let lowest = self.unfolding.functions_to.map(|to| to.min(degree));
        let active = match lowest {
            None => Active::new(j, vec![weights.one()]),
            Some(d) => {
                let (first, last) = (j.saturating_sub(d), j.min(m - d - 1));
                let unknown = |at: usize| {
                    if order > 1 {
                        return Err(EvaluationError::Order);
                    }
                    let value = |derivative| {
                        let unknown = Unknown::Function(derivative, i + to_i64(at), d, place.clone());
                        self.unknown(unknown, Class::Real)
                    };
                    self.jet([value(false), value(true)], order)
                };
                let values: Evaluated<Vec<_>> = (first..=last).map(unknown).collect();
                Active::new(first, values?)
            }
        };
        let mut triangle = Triangle::starting_with(active, &weights.one());
        for d in lowest.unwrap_or(0) + 1..=degree {
            triangle.raise(&weights, span, d, m);
        }
        weights.fault()?;
        Ok(triangle.into_active().get(0).cloned().unwrap_or(zero))
    }

    fn jet(&self, coefficients: [Evaluated; 2], order: usize) -> Evaluated<Jet<Quotient>> {
        let [value, slope] = coefficients;
        let jet = Jet::constant(value?, order);
        if order == 0 {
            return Ok(jet);
        }
        let slope = Jet::constant(slope?, order);
        Ok(jet.plus(&slope.times(&Jet::variable(self.integer(0), order))))
    }

    fn knot(&self, window: &str, index: i64) -> Evaluated<&Quotient> {
        let (first, knots) =
            self.knots.get(window).ok_or_else(|| EvaluationError::Unknown(window.to_owned()))?;
        let knot = usize::try_from(index - first).ok().and_then(|at| knots.get(at));
        knot.ok_or_else(|| EvaluationError::OutsideWindow { window: window.to_owned(), index })
    }

    /// The factors of the two knots of the span in x − a, up to the common one: (1, u), (1, 0) or (0, 1).
    fn shares_of_ends(&self, place: &Place) -> Evaluated<[Quotient; 2]> {
        let gap = self.knot(&place.window, place.span + 1)?.minus(self.knot(&place.window, place.span)?);
        if !self.is_positive(&gap) {
            return Err(EvaluationError::EmptySpan { window: place.window.clone(), span: place.span });
        }
        Ok(match place.at {
            Where::In => [self.integer(1), self.names["u"].clone()],
            Where::From => [self.integer(1), self.integer(0)],
            Where::To => [self.integer(0), self.integer(1)],
        })
    }

    fn point(&self, place: &Place) -> Evaluated {
        let [near, far] = self.shares_of_ends(place)?;
        let (start, end) = (self.knot(&place.window, place.span)?, self.knot(&place.window, place.span + 1)?);
        let weighted = near.times(start).plus(&far.times(end));
        weighted.over(&near.plus(&far)).ok_or_else(|| EvaluationError::Division("1 + u".into()))
    }

    /// The weights at a place, for a triangle that counts the knots from t_first.
    fn weights(&self, place: &Place, first: i64, order: usize) -> Evaluated<PlaceWeights<'_, 'a>> {
        let ends = self.shares_of_ends(place)?;
        Ok(PlaceWeights {
            evaluator: self,
            place: place.clone(),
            ends,
            first,
            order,
            fault: RefCell::new(None),
        })
    }

    fn unknown(&self, unknown: Unknown, class: Class) -> Evaluated {
        let known = self.variables.borrow().iter().position(|(known, _)| known.as_ref() == Some(&unknown));
        match known {
            Some(at) => Ok(Quotient::variable(at)),
            None => self.fresh(Some(unknown), class),
        }
    }

    /// p/(p + q) as an unknown, or 1 minus the unknown q/(p + q).
    fn share(&self, p: &Quotient, q: &Quotient) -> Evaluated {
        if self.unfolding.related && q.numerator() < p.numerator() {
            return Ok(self.integer(1).minus(&self.share(q, p)?));
        }
        self.unknown(Unknown::Share(p.clone(), q.clone()), self.share_class(p, q))
    }

    /// The sign of p/(p + q).
    fn share_class(&self, p: &Quotient, q: &Quotient) -> Class {
        match (self.class_of(p), self.class_of(q)) {
            (Class::Positive, Class::Positive | Class::Nonnegative) => Class::Positive,
            (Class::Real, _) | (_, Class::Real) => Class::Real,
            _ => Class::Nonnegative,
        }
    }

    /// The sign of a polynomial as far as its coefficients show it.
    #[must_use]
    pub fn class_of(&self, value: &Quotient) -> Class {
        let classes = self.classes();
        sign(value.numerator(), &classes)
    }

    fn is_positive(&self, value: &Quotient) -> bool {
        self.class_of(value) == Class::Positive
    }

    /// Is the polynomial never 0, as its coefficients show?
    fn definite(&self, p: &Multivariate) -> Evaluated<()> {
        let classes = self.classes();
        if sign(p, &classes) == Class::Positive || sign(&p.negate(), &classes) == Class::Positive {
            Ok(())
        } else {
            Err(EvaluationError::Division(self.shown(p)))
        }
    }

    /// A polynomial for a reader: `x2 - 1, where x2 = a`.
    fn shown(&self, p: &Multivariate) -> String {
        let name = |v: usize| {
            let known = self.names.iter().filter(|(_, value)| **value == Quotient::variable(v));
            known.map(|(name, _)| name).min().map(|name| format!("x{v} = {name}"))
        };
        let names: Vec<_> = p.variables().filter_map(name).collect();
        if names.is_empty() { p.to_string() } else { format!("{p}, where {}", names.join(", ")) }
    }
}

/// The sign of a polynomial as far as its coefficients and the signs of its variables show it.
pub(super) fn sign(p: &Multivariate, classes: &[Class]) -> Class {
    let mut class = Class::Nonnegative;
    for (monomial, coefficient) in p.terms() {
        let occurring = || (0..classes.len()).filter(|&at| monomial.exponent(at) > 0);
        if coefficient.is_negative() || occurring().any(|at| classes[at] == Class::Real) {
            return Class::Real;
        }
        if occurring().all(|at| classes[at] == Class::Positive) {
            class = Class::Positive;
        }
    }
    class
}

fn to_i64(value: usize) -> i64 {
    i64::try_from(value).unwrap_or(i64::MAX)
}

/// What is known, or becomes known now.
fn remembered<T: Clone>(
    known: &Known<T>,
    key: (Place, i64, usize, usize),
    value: impl FnOnce() -> Evaluated<T>,
) -> Evaluated<T> {
    if let Some(value) = known.borrow().get(&key) {
        return Ok(value.clone());
    }
    let value = value()?;
    known.borrow_mut().insert(key, value.clone());
    Ok(value)
}

/// The weights at a place.
struct PlaceWeights<'e, 'a> {
    evaluator: &'e Evaluator<'a>,
    place: Place,
    ends: [Quotient; 2],
    /// The index in the window of what the triangle counts as 0.
    first: i64,
    order: usize,
    /// The first thing that went wrong: the triangle itself has no way to say so.
    fault: RefCell<Option<EvaluationError>>,
}

impl PlaceWeights<'_, '_> {
    fn fault(&self) -> Evaluated<()> {
        self.fault.borrow().clone().map_or(Ok(()), Err)
    }

    /// w_i^d and 1 − w_i^d, by the index in the window.
    fn pair_at(&self, i: i64, d: usize) -> Evaluated<(Jet<Quotient>, Jet<Quotient>)> {
        remembered(&self.evaluator.pairs, (self.place.clone(), i, d, self.order), || self.pair_of(i, d))
    }

    fn pair_of(&self, i: i64, d: usize) -> Evaluated<(Jet<Quotient>, Jet<Quotient>)> {
        let (evaluator, Place { window, span, .. }) = (self.evaluator, &self.place);
        let knot = |index| evaluator.knot(window, index);
        let outside = |index| EvaluationError::OutsideWindow { window: window.clone(), index };
        if i > *span || i + to_i64(d) <= *span {
            return Err(outside(i));
        }
        let (a, b, start, end) = (knot(i)?, knot(i + to_i64(d))?, knot(*span)?, knot(span + 1)?);
        let [near, far] = &self.ends;
        let measure = near.plus(far);
        let at_x = |a: &Quotient| near.times(&start.minus(a)).plus(&far.times(&end.minus(a)));
        let (order, jet) = (self.order, |of| evaluator.jet(of, self.order));
        let zero = || evaluator.integer(0);
        // All lengths are measured from a, in this unit.
        let x = jet([Ok(at_x(a)), Ok(measure.clone())])?;
        let b = Jet::constant(b.minus(a).times(&measure), order);
        let [rise, fall] = match evaluator.weighted {
            Weighted::Any => [x.clone(), b.minus(&x)],
            Weighted::Family(family) => {
                let (a, unit) = (Jet::constant(zero(), order), Jet::constant(measure.clone(), order));
                let interval = Interval { x, a, b, unit, i, d: to_i64(d), m: None };
                interval.shares(family, &|name, indices| evaluator.own_parameter(window, name, indices))?
            }
        };
        let (p, q) = (rise.coefficients()[0].clone(), fall.coefficients()[0].clone());
        let whole = p.plus(&q);
        evaluator.definite(whole.numerator())?;
        let is_end = p.is_zero() || q.is_zero();
        if *evaluator.weighted == Weighted::Any {
            if order > 1 {
                return Err(EvaluationError::Order);
            }
            return self.of_any(i, d, [p, q], [at_x(&zero()), measure]);
        }
        if evaluator.unfolding.weights_from.is_some_and(|from| d >= from) && !is_end {
            if order > 1 {
                return Err(EvaluationError::Order);
            }
            let (p, q) = integral(&p, &q);
            let value = || {
                let [rising, falling] = [&rise, &fall].map(|share| share.coefficients()[1].clone());
                let [p, q] = [&rise, &fall].map(|share| share.coefficients()[0].clone());
                let change = rising.times(&q).minus(&p.times(&falling));
                let value = change.over(&whole).and_then(|value| value.over(&whole));
                value.ok_or_else(|| EvaluationError::Division("(p + q)²".into()))
            };
            let slope = |sign: i64| match order {
                0 => Ok(zero()),
                _ => Ok(evaluator
                    .unknown(Unknown::Slope(value()?), Class::Real)?
                    .times(&evaluator.integer(sign))),
            };
            let w = jet([evaluator.share(&p, &q), slope(1)])?;
            return Ok((w, jet([evaluator.share(&q, &p), slope(-1)])?));
        }
        rise.shares(&fall).ok_or_else(|| EvaluationError::Division("p + q".into()))
    }

    /// Of weights that are known by their zeros alone: p = x − a, q = b − x.
    fn of_any(
        &self,
        i: i64,
        d: usize,
        [p, q]: [Quotient; 2],
        [x, unit]: [Quotient; 2],
    ) -> Evaluated<(Jet<Quotient>, Jet<Quotient>)> {
        let evaluator = self.evaluator;
        let unknown = |which, class| {
            let window = self.place.window.clone();
            evaluator.unknown(Unknown::Weight(which, window, i, d, x.clone(), unit.clone()), class)
        };
        let one = evaluator.integer(1);
        let w = match (p.is_zero(), q.is_zero()) {
            (true, _) => evaluator.integer(0),
            (_, true) => one.clone(),
            _ => unknown(OfWeight::Weight, evaluator.share_class(&p, &q))?,
        };
        let v = match evaluator.unfolding.related || p.is_zero() || q.is_zero() {
            true => one.minus(&w),
            false => unknown(OfWeight::Complement, evaluator.share_class(&q, &p))?,
        };
        let slope = match self.order {
            0 => evaluator.integer(0),
            _ => unknown(OfWeight::Derivative, Class::Real)?,
        };
        let jet = |of| evaluator.jet(of, self.order);
        Ok((jet([Ok(w), Ok(slope.clone())])?, jet([Ok(v), Ok(slope.negate())])?))
    }
}

impl Weights for PlaceWeights<'_, '_> {
    type Scalar = Jet<Quotient>;

    fn one(&self) -> Jet<Quotient> {
        Jet::constant(self.evaluator.integer(1), self.order)
    }

    fn pair(&self, i: usize, d: usize) -> (Jet<Quotient>, Jet<Quotient>) {
        match self.pair_at(to_i64(i) + self.first, d) {
            Ok(pair) => pair,
            Err(error) => {
                self.fault.borrow_mut().get_or_insert(error);
                (self.one().zero(), self.one())
            }
        }
    }
}

/// p and q, both multiplied by the denominators of the two.
fn integral(p: &Quotient, q: &Quotient) -> (Quotient, Quotient) {
    let clear = |value: &Quotient, by: &Quotient| {
        let (own, other) =
            (Quotient::from_polynomial(value.denominator()), Quotient::from_polynomial(by.denominator()));
        if own == other {
            Quotient::from_polynomial(value.numerator().clone())
        } else {
            value.times(&own).times(&other)
        }
    };
    (clear(p, q), clear(q, p))
}
