//! What functions are at an argument: a number, or a function of the coordinate of the cell.

use std::sync::Arc;

use crate::analysis::{Piece, Sign, constant};
use crate::language::{Argument, Definition, Function, Int, Name, Pattern, Side};
use crate::scalar::{BigRational, Jet, Polynomial, RationalAlgebra, Ring, integer};
use crate::spline::{self, FormTable, Forms};

use super::cell::{Cell, Focus, Frame};
use super::reading::{Known, Look, Reading, Spot, place};
use super::truth::Stop;
use super::value::{Fraction, Plain, Value};

/// Where an argument lies among the knots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Where {
    /// Before t_0 or after t_m.
    Outside,
    /// At a knot.
    Knot(BigRational),
    /// Inside a span.
    Span(usize),
}

/// A recursion of definitions that falls on no literal.
const DEEPEST: usize = 60;

/// The derivative of an order by x of a function of u, x = (a + bu)/(1 + u), at a or at b, the left or the right end of an interval
/// of this width; `None`, if it is not finite there.
///
/// By Taylor's series: at a, u = s/(h − s) for s = x − a and h = b − a; at b, 1/u is the same of s = b − x.
fn limit_at(f: &Fraction, width: &BigRational, end: Side, order: usize) -> Option<BigRational> {
    let (p, q) = f.parts();
    let n = p.degree().max(q.degree());
    let [p, q] = [p, q].map(|polynomial| match end {
        Side::Left => polynomial.clone(),
        Side::Right => polynomial.reversed(n),
    });
    // A power of u or 1/u that both have cancels.
    let common = q.coefficients().iter().take_while(|c| Ring::is_zero(*c)).count();
    if p.coefficients().iter().take(common).any(|c| !Ring::is_zero(c)) {
        return None;
    }
    let s = Jet::variable(integer(0), order);
    let u = s.over(&s.embed(width).minus(&s))?;
    let [p, q] = [p, q].map(|polynomial| {
        let rest = polynomial.coefficients().iter().skip(common).rev();
        rest.fold(s.zero(), |sum, c| sum.times(&u).plus(&s.embed(c)))
    });
    let derivative = p.over(&q)?.derivatives().pop()?;
    Some(if end == Side::Right && order % 2 == 1 { -derivative } else { derivative })
}

impl Reading<'_> {
    pub(super) fn apply(&mut self, f: &Function, argument: &Argument) -> Result<Value, Stop> {
        let x = self.real(&argument.at)?;
        let (base, order) = self.base_of(f)?;
        match &argument.member {
            None => self.function(base, order, &x, argument.side),
            Some(member) => {
                let weights = self.member(member)?;
                self.with_weights(weights, |own| own.function(base, order, &x, argument.side))
            }
        }
    }

    /// The function that derivatives are taken of, and their order.
    pub(super) fn base_of<'f>(&mut self, mut f: &'f Function) -> Result<(&'f Function, usize), Stop> {
        let mut order = 0;
        while let Function::Derivative(inner, more) = f {
            let more = self.int(more)?;
            order += usize::try_from(more)
                .map_err(|_| Stop::Undefined(format!("a derivative of order {more}")))?;
            f = inner;
        }
        Ok((f, order))
    }

    /// The derivative of an order of a function at an argument.
    pub(super) fn function(
        &mut self,
        f: &Function,
        order: usize,
        x: &Value,
        side: Option<Side>,
    ) -> Result<Value, Stop> {
        if let Some(x) = x.number() {
            return self.at_number(f, order, &x.clone(), side);
        }
        if order == 0 {
            return self.along(f, x);
        }
        let (Plain::Piece(argument), None) = (&x.plain, &x.root) else {
            return Err(Stop::Unknown("a derivative at an irrational number".into()));
        };
        if let (Function::Basis { i, degree }, Some(frame)) = (f, &self.frame)
            && let (Some(j), true) = (frame.span, frame.is_variable(x))
        {
            let id = self.existing(i, degree.as_ref())?;
            let piece = self.on.piece(&self.weights, id, j, order);
            return Ok(piece.map_or_else(|| 0.into(), Value::from));
        }
        let value = self.along(f, x)?;
        let (Value { plain, root: None }, slope) = (value, argument.piece().derivative()) else {
            return Err(Stop::Unknown("a derivative of a square root".into()));
        };
        let derivative = |f: Piece| f.derivative().over(&slope);
        let piece = (0..order).try_fold((*plain.piece()).clone(), |f, _| derivative(f));
        piece.map(Value::from).ok_or_else(|| Stop::Unknown("a derivative at a constant argument".into()))
    }

    /// (i, d) of a G_i^d that exists.
    pub(super) fn existing(&mut self, i: &Int, degree: Option<&Int>) -> Result<(usize, usize), Stop> {
        let (k, m, i) = (self.degree()?, self.knots()?.m(), self.int(i)?);
        let d = degree.map_or(Ok(None), |d| self.int(d).map(Some))?;
        let missing = || match d {
            Some(d) => format!("G[{i},{d}] does not exist"),
            None => format!("G[{i}] does not exist"),
        };
        let d = d.map_or(Ok(k), |d| place(d, k + 1, missing))?;
        Ok((place(i, m - d, missing)?, d))
    }

    /// The derivative of an order of G_i^d at x; recorded, where what is looked at is.
    pub(super) fn look(
        &mut self,
        (i, degree): (usize, usize),
        x: &BigRational,
        side: spline::Side,
        order: usize,
    ) -> BigRational {
        if let Some(looked) = &mut self.looked {
            let look = Look { i, degree, order, x: x.clone(), side, weights: self.weights.clone() };
            if !looked.contains(&look) {
                looked.push(look);
            }
        }
        self.on.value(&self.weights, (i, degree), x, side, order)
    }

    fn at_number(
        &mut self,
        f: &Function,
        order: usize,
        x: &BigRational,
        side: Option<Side>,
    ) -> Result<Value, Stop> {
        // Behind t_m there is no span; only the value there is that of the last one.
        let behind = side == Some(Side::Right) && self.on.knots().is_some_and(|knots| x == knots.last());
        match (f, order, side) {
            (Function::Basis { i, degree }, ..) => {
                let id = self.existing(i, degree.as_ref())?;
                Ok(if behind { integer(0).into() } else { self.look(id, x, of(side), order).into() })
            }
            (Function::Weight { i, degree }, 0, _) => {
                let span = self.knots()?.span_at(x, of(side)).filter(|_| !behind).map(spline::Span::index);
                self.weight(i, degree, &x.clone().into(), span)
            }
            (Function::Phi { cut: false, .. } | Function::Defined(..), 0, None) => {
                self.along(f, &x.clone().into())
            }
            (Function::Phi { cut: true, from, to }, 0, _) => {
                let (from, to) = (self.real(from)?, self.real(to)?);
                self.phi(&x.clone().into(), &from, &to, side)
            }
            _ => self.limit(f, order, x, side),
        }
    }

    /// The limit of a derivative at x: that of its piece on a cell beside it.
    fn limit(
        &mut self,
        f: &Function,
        order: usize,
        x: &BigRational,
        side: Option<Side>,
    ) -> Result<Value, Stop> {
        /// Halvings of the cell, until no cut of a definition lies in it.
        const NARROWEST: usize = 60;
        let knots = self.on.knots().filter(|_| !matches!(f, Function::Phi { .. }));
        let at_end = knots.is_some_and(|knots| x == knots.last());
        let left = side == Some(Side::Left) || (at_end && side.is_none());
        let beyond = knots.and_then(|knots| {
            let mut stops = knots.stop_knots().map(|(t, _)| t);
            if left { stops.filter(|t| *t < x).last() } else { stops.find(|t| *t > x) }
        });
        let step = if left { -integer(1) } else { integer(1) };
        let mut beyond = beyond.cloned().unwrap_or_else(|| x + step);
        for _ in 0..NARROWEST {
            let (from, to) = if left { (&beyond, x) } else { (x, &beyond) };
            let cell = Cell::Open(Some(from.clone()), Some(to.clone()));
            let value = self.within(&Name::from(""), &cell, |own| {
                let coordinate = Value::from(cell.coordinate());
                own.function(f, 0, &coordinate, None)
            });
            match value {
                Err(Stop::Cut) => beyond = (x + beyond) / integer(2),
                Err(stop) => return Err(stop),
                Ok(Value { plain: Plain::Number(q), root: None }) => {
                    return Ok(if order == 0 { q.into() } else { 0.into() });
                }
                Ok(Value { plain: Plain::Piece(f), root: None }) => {
                    let end = if left { Side::Right } else { Side::Left };
                    return limit_at(&f, &(to - from), end, order)
                        .map(Value::from)
                        .ok_or_else(|| Stop::Undefined(format!("there is no finite limit at {x}")));
                }
                Ok(_) => return Err(Stop::Unknown("the limit of a square root".into())),
            }
        }
        Err(Stop::Unknown(format!("no cell beside {x} on which a definition is one function")))
    }

    /// The function itself at an argument that is no rational number, or at one of a function without jumps.
    fn along(&mut self, f: &Function, x: &Value) -> Result<Value, Stop> {
        match f {
            Function::Basis { i, degree } => {
                let id = self.existing(i, degree.as_ref())?;
                match self.place(x)? {
                    Where::Outside => Ok(0.into()),
                    Where::Knot(t) => self.at_number(f, 0, &t, None),
                    Where::Span(j) => {
                        let Some(piece) = self.on.piece(&self.weights, id, j, 0) else { return Ok(0.into()) };
                        let Value { plain: Plain::Piece(argument), root: None } = x else {
                            return Err(Stop::Unknown("a basis function at an irrational number".into()));
                        };
                        let own = self.is_coordinate(j, x);
                        let (from, to) = (self.knots()?.t(j), self.knots()?.t(j + 1));
                        Ok(if own {
                            piece.into()
                        } else {
                            Value::from(Arc::new(composed(&piece, argument.piece(), from, to)))
                        })
                    }
                }
            }
            Function::Weight { i, degree } => {
                let span = match self.place(x)? {
                    Where::Span(j) => Some(j),
                    Where::Knot(t) => return self.at_number(f, 0, &t, None),
                    Where::Outside => None,
                };
                self.weight(i, degree, x, span)
            }
            Function::Phi { cut, from, to } => {
                let (from, to) = (self.real(from)?, self.real(to)?);
                if *cut { self.phi(x, &from, &to, None) } else { self.moebius(x, &from, &to) }
            }
            Function::Defined(name, of) => self.defined(name, of, Some(x)),
            Function::Derivative(..) => {
                let (base, order) = self.base_of(f)?;
                self.function(base, order, x, None)
            }
        }
    }

    /// Is it the variable of the cell, which is span j?
    fn is_coordinate(&self, j: usize, x: &Value) -> bool {
        self.frame.as_ref().is_some_and(|frame| frame.span == Some(j) && frame.is_variable(x))
    }

    /// w_i^d(x) for an x in the limit on a span: φ where [t_i, t_{i+d}) contains that, else 0.
    fn weight(&mut self, i: &Int, d: &Int, x: &Value, span: Option<usize>) -> Result<Value, Stop> {
        let (i, d, knots) = (self.int(i)?, self.int(d)?, self.knots()?);
        let missing = || format!("w[{i},{d}] does not exist");
        let from = place(i, knots.m() + 1, missing)?;
        let to = place(if d < 0 { d } else { i + d }, knots.m() + 1, missing)?;
        match span {
            Some(j) if from <= j && j < to => {
                if self.is_coordinate(j, x)
                    && let Some(known) = self.on.weight(&self.weights, (from, to), j)
                {
                    return Ok(known.into());
                }
                let (a, b) = (knots.t(from), knots.t(to));
                if let Some(table) = self.table()? {
                    let missing = || Stop::Undefined(format!("w[{i},{d}] has no value on span {j}"));
                    return self.by_forms(x, a, b, table.get(j, from, to - from).ok_or_else(missing)?);
                }
                self.moebius(x, &a.clone().into(), &b.clone().into())
            }
            _ => Ok(0.into()),
        }
    }

    /// φ(x, a, b) of D2.3, or its limit from the left.
    fn phi(&mut self, x: &Value, a: &Value, b: &Value, side: Option<Side>) -> Result<Value, Stop> {
        let outside = |sign: Sign, closed: bool| sign == Sign::Negative || (sign == Sign::Zero && !closed);
        let left = side == Some(Side::Left);
        let nowhere = self.sign_between(b, a)? != Sign::Positive
            || outside(self.sign_between(x, a)?, !left)
            || outside(self.sign_between(b, x)?, left);
        if nowhere { Ok(0.into()) } else { self.moebius(x, a, b) }
    }

    /// The weights of another family than that of an index.
    fn table(&self) -> Result<Option<FormTable>, Stop> {
        self.on.table(&self.weights).map_err(|error| Stop::Undefined(error.to_string()))
    }

    /// The weight of an interval by its forms.
    fn by_forms(
        &mut self,
        x: &Value,
        a: &BigRational,
        b: &BigRational,
        forms: &Forms,
    ) -> Result<Value, Stop> {
        let Value { plain, root: None } = x else {
            return Err(Stop::Unknown("a weight at an irrational number".into()));
        };
        let x = plain.piece();
        let (p, q) = (x.minus(&x.embed(a)), x.embed(b).minus(&x));
        let [rise, _, over] = forms.values(&p, &q, |c| x.embed(c));
        self.quotient(&rise.into(), &over.into())
    }

    /// f(x, a, b) = r(x − a)/(r(x − a) + (b − x)), or what a family has in its place.
    fn moebius(&mut self, x: &Value, a: &Value, b: &Value) -> Result<Value, Stop> {
        if let Some(member) = self.weights.member() {
            if !member.family().is_by_ends() {
                let name = &member.family().name;
                return Err(Stop::Unknown(format!(
                    "a weight of the family {name} depends on more than two ends"
                )));
            }
            let (Some(a), Some(b)) = (a.number(), b.number()) else {
                return Err(Stop::Unknown("a weight between ends that are no rational numbers".into()));
            };
            let forms = member.between(a, b).map_err(Stop::Undefined)?;
            return self.by_forms(x, &a.clone(), &b.clone(), &forms);
        }
        let rise = x.minus(a)?.times(&self.own_index()?.ratio().clone().into())?;
        let both = rise.plus(&b.minus(x)?)?;
        self.quotient(&rise, &both)
    }

    /// A definition of the file for some indices, at an argument if it has a variable.
    pub(super) fn defined(&mut self, name: &Name, of: &[Int], x: Option<&Value>) -> Result<Value, Stop> {
        let of = of.iter().map(|i| self.int(i)).collect::<Result<Vec<_>, _>>()?;
        let fits = |definition: &&Definition| {
            let mut indices = definition.indices.iter().zip(&of);
            definition.name == *name
                && definition.indices.len() == of.len()
                && indices.all(|(pattern, i)| !matches!(pattern, Pattern::Number(n) if n != i))
        };
        let found = self.names.definitions.iter().find(fits);
        let definition = found.ok_or_else(|| Stop::Unbound(name.to_string()))?;
        if self.depth > DEEPEST {
            return Err(Stop::Unknown(format!("{name} calls itself without an end")));
        }
        let argument = x.cloned().unwrap_or_else(|| 0.into());
        let spot = match (argument.number(), &self.frame) {
            (Some(x), _) => Spot::Number(x.clone()),
            (None, Some(Frame { span: Some(j), .. })) => Spot::Span(*j),
            (None, _) => Spot::Elsewhere,
        };
        let key = (name.clone(), of, self.weights.clone(), spot);
        let known = self.memo.known.get(&key);
        if let Some(known) = known.and_then(|all| all.iter().find(|known| known.argument == argument)) {
            self.seen.join(&known.seen);
            return Ok(known.value.clone());
        }
        let before = (self.bound.integers.len(), self.bound.reals.len());
        for (pattern, i) in definition.indices.iter().zip(&key.1) {
            if let Pattern::Any(name) = pattern {
                self.bound.integers.push((name.clone(), *i));
            }
        }
        if let (Some(variable), Some(x)) = (&definition.variable, x) {
            let id = self.frame.as_ref().map_or(0, |frame| frame.id);
            self.bound.reals.push((variable.clone(), x.clone(), id));
        }
        let outside = std::mem::replace(&mut self.memo.outermost, before);
        let seen_outside = std::mem::take(&mut self.seen);
        self.depth += 1;
        let value = self.real(&definition.body);
        self.depth -= 1;
        self.bound.integers.truncate(before.0);
        self.bound.reals.truncate(before.1);
        let own = self.memo.outermost;
        self.memo.outermost = (outside.0.min(own.0), outside.1.min(own.1));
        if let (true, true, Ok(value)) = (own == before, self.looked.is_none(), &value) {
            let known = Known { argument, value: value.clone(), seen: self.seen.clone() };
            self.memo.known.entry(key).or_default().push(known);
        }
        self.seen.join(&seen_outside);
        value
    }

    /// Where an argument lies on the part that is looked at.
    pub(super) fn place(&mut self, x: &Value) -> Result<Where, Stop> {
        let knots = self.knots()?;
        if let Some(x) = x.number() {
            let span = knots.span_at(x, spline::Side::Right);
            return Ok(match span {
                _ if knots.multiplicity(x) > 0 => Where::Knot(x.clone()),
                Some(span) => Where::Span(span.index()),
                None => Where::Outside,
            });
        }
        if let Some(frame) = &self.frame
            && let (Some(j), true) = (frame.span, frame.is_variable(x))
        {
            return Ok(Where::Span(j));
        }
        if let Some(j) = self.span_of_sample(x) {
            let (from, to) = (knots.t(j).clone().into(), knots.t(j + 1).clone().into());
            let signs = (self.sign_between(x, &from), self.sign_between(x, &to));
            if signs == (Ok(Sign::Positive), Ok(Sign::Negative)) {
                return Ok(Where::Span(j));
            }
        }
        // All knots before `below` lie under x on the whole part, and those from `above` on over it.
        let list = knots.knots();
        let (mut below, mut above) = (0, list.len());
        while below < above {
            let t = &list[(below + above) / 2];
            match self.sign_between(x, &t.clone().into())? {
                Sign::Zero => return Ok(Where::Knot(t.clone())),
                Sign::Negative => above = list.partition_point(|s| s < t),
                Sign::Positive => below = list.partition_point(|s| s <= t),
            }
        }
        let inside = below.checked_sub(1).filter(|_| below < list.len());
        Ok(inside.map_or(Where::Outside, Where::Span))
    }

    /// The span in which an argument lies at some number of the part that is looked at.
    fn span_of_sample(&self, x: &Value) -> Option<usize> {
        let (Value { plain: Plain::Piece(f), root: None }, Some(frame)) = (x, &self.frame) else {
            return None;
        };
        let value = match &frame.focus {
            Focus::Whole => f.piece().evaluate(&integer(1)),
            Focus::Between(u) => f.piece().evaluate(u),
            Focus::At(_) => None,
        };
        let span = self.on.knots()?.span_at(&value?, spline::Side::Right)?;
        Some(span.index())
    }
}

/// From the right where nothing is said.
pub(super) fn of(side: Option<Side>) -> spline::Side {
    if side == Some(Side::Left) { spline::Side::Left } else { spline::Side::Right }
}

/// The function on [a, b] at another argument: P/Q at (X − a)/(b − X), with both brought to the degree of Q if that is the
/// larger one, so that what is over one denominator stays so.
fn composed(f: &Fraction, x: &Piece, a: &BigRational, b: &BigRational) -> Fraction {
    let inner = x.minus(&constant(a.clone())).over(&constant(b.clone()).minus(x));
    let Some(inner) = inner else { unreachable!("an argument inside the span is not its end") };
    let (n, d) = (inner.numerator(), inner.denominator());
    let (p, q) = f.parts();
    let degree = p.degree().max(q.degree());
    let powers = |p: &Polynomial<BigRational>| {
        let mut powers = vec![p.one()];
        (0..degree).for_each(|e| powers.push(powers[e].times(p)));
        powers
    };
    let (n, d) = (powers(n), powers(d));
    let form = |p: &Polynomial<BigRational>| {
        let terms = p.coefficients().iter().enumerate();
        terms.fold(p.zero(), |sum, (e, c)| sum.plus(&n[e].times(&d[degree - e]).scaled(c)))
    };
    let (p, q) = (form(p), form(q));
    match q.leading().reciprocal() {
        Some(inverse) => Fraction::sum(p.scaled(&inverse), &Arc::new(q.scaled(&inverse))),
        None => unreachable!("a denominator without zeros stays one"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::rational;

    fn polynomial(coefficients: &[i64]) -> Polynomial<BigRational> {
        Polynomial::new(integer(coefficients[0]), coefficients[1..].iter().map(|c| integer(*c)))
    }

    /// The derivative for every x, in lowest terms, and then its value at the end.
    fn slowly(f: &Fraction, slope: &Piece, end: Side, order: usize) -> Option<BigRational> {
        let derivative = |f: Piece| f.derivative().over(slope);
        let f = (0..order).try_fold((**f.piece()).clone(), |f, _| derivative(f))?;
        if end == Side::Right { f.at_infinity() } else { f.evaluate(&integer(0)) }
    }

    #[test]
    fn limits_of_derivatives_are_those_of_the_derivatives() {
        let (a, b) = (rational(-1, 3), rational(5, 2));
        let slope = Cell::Open(Some(a.clone()), Some(b.clone())).coordinate().derivative();
        let mut poles = 0;
        for (p, q) in [
            (&[3, -1, 4][..], &[1, 5, 9, 2][..]),
            (&[2, 7, 1, 8], &[2, 8]),
            (&[0, 0, 3, 1], &[0, 2, 5]),
            (&[1, 2], &[0, 3, 1]),
            (&[0, 1, 1], &[1, 2, 1]),
            (&[5], &[1, 1, 0, 4]),
        ] {
            let f = Fraction::sum(polynomial(p), &Arc::new(polynomial(q)));
            for end in [Side::Left, Side::Right] {
                for order in 0..5 {
                    let found = limit_at(&f, &(&b - &a), end, order);
                    assert_eq!(found, slowly(&f, &slope, end, order), "{p:?}/{q:?} at {end:?}, {order}");
                    poles += usize::from(found.is_none());
                }
            }
        }
        assert!(poles >= 10, "{poles}");
    }
}
