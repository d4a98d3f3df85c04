//! A family of splines: what stands for rise : fall on an interval [a, b] = [t_i, t_{i+d}], by parameters with signs.

use std::cell::RefCell;

use crate::env::{binomial, small};
use crate::error::{Reason, Result};
use crate::fraction::{Factors, Fraction};
use crate::poly::{Poly, Sign};
use crate::token::{Kind, Node};

/// Larger exponents of a parameter are not computed.
const EXPONENT: i64 = 100;

/// x − a and b − x, where a weight is checked.
const P: usize = 0;
const Q: usize = 1;

/// A number, one for every knot, one for every degree of a weight, or both.
pub(crate) struct Parameter<'t> {
    pub(crate) name: &'t str,
    /// `i`, `d`, or both, in this order.
    pub(crate) indices: Vec<&'t str>,
    pub(crate) sign: Sign,
    /// (REL NUMBER).
    bounds: &'t [Node<'t>],
}

/// A family, or, without a weight, all of them at once.
#[derive(Default)]
pub(crate) struct Family<'t> {
    pub(crate) parameters: Vec<Parameter<'t>>,
    /// rise and fall.
    pub(crate) weight: Option<[&'t Node<'t>; 2]>,
    /// (NAME TERM): the parameters after a reflection, those that change.
    dual: Option<&'t [Node<'t>]>,
}

/// What is known where a weight is read: a length is so many times the unit, x, a and b are from one origin.
#[derive(Default)]
pub(crate) struct Interval<'s> {
    pub(crate) x: Poly,
    pub(crate) a: Poly,
    pub(crate) b: Poly,
    pub(crate) unit: Poly,
    pub(crate) i: i64,
    pub(crate) d: i64,
    /// For a dual: the index of t_m, if t_i is reflected to t_{m−i}.
    pub(crate) m: Option<i64>,
    pub(crate) signs: &'s [Sign],
}

/// Its derivatives by x from that of order 0 on, each over unit^LENGTHS. Those that are left out are 0.
struct Quantity {
    derivatives: Vec<Fraction>,
    lengths: u16,
}

/// rise and fall over what is common to both, with as many derivatives.
pub(crate) struct Shares {
    pub(crate) rise: Vec<Poly>,
    pub(crate) fall: Vec<Poly>,
}

impl Shares {
    /// Of an order, or 0.
    pub(crate) fn of(share: &[Poly], order: usize) -> Poly {
        share.get(order).cloned().unwrap_or_default()
    }

    /// rise'·fall − rise·fall', which has the sign of the derivative of the weight.
    pub(crate) fn rising(&self) -> Result<Poly> {
        let of = Shares::of;
        let falling = of(&self.rise, 0).times(&of(&self.fall, 1))?;
        Ok(of(&self.rise, 1).times(&of(&self.fall, 0))?.minus(&falling))
    }

    /// rise + fall, its derivative of an order.
    pub(crate) fn whole(&self, order: usize) -> Poly {
        Shares::of(&self.rise, order).plus(&Shares::of(&self.fall, order))
    }
}

type Known<'k> = dyn Fn(&str, &[i64]) -> Result<Fraction> + 'k;

impl Parameter<'_> {
    /// All indices on knots t_0, …, t_m for degree k, in the order in which numbers are given for them.
    pub(crate) fn all(&self, m: i64, k: i64) -> Vec<Vec<i64>> {
        let degrees = if self.indices.contains(&"d") { 1..=k } else { 0..=0 };
        let of = |d: i64| {
            let knots = if self.indices.contains(&"i") { 0..=m - d } else { 0..=0 };
            knots.map(move |i| self.indices.iter().map(|index| if *index == "i" { i } else { d }).collect())
        };
        degrees.flat_map(of).collect()
    }

    /// Whether it may be this number.
    pub(crate) fn admits(&self, number: &Node<'_>) -> Result<bool> {
        for bound in self.bounds {
            let (relation, fields) = bound.headed("a bound")?;
            let [limit] = fields else { return bound.wrong("a number") };
            let difference = Fraction::number(number)?.minus(&Fraction::number(limit)?)?;
            let (above, below) = (difference.num.sign(&[]), difference.num.negated().sign(&[]));
            let holds = match relation {
                "=" => difference.is_zero(),
                "/=" => !difference.is_zero(),
                "<" => below == Sign::Positive,
                "<=" => below >= Sign::Nonnegative,
                ">" => above == Sign::Positive,
                _ => above >= Sign::Nonnegative,
            };
            if !holds {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

impl Quantity {
    fn constant(value: Fraction) -> Self {
        Quantity { derivatives: vec![value], lengths: 0 }
    }

    fn length(value: Poly, slope: Poly) -> Self {
        Quantity { derivatives: vec![value.into(), slope.into()], lengths: 1 }
    }

    /// As so many lengths, at least as many as it has.
    fn of_lengths(self, lengths: u16, unit: &Poly) -> Result<Self> {
        if self.lengths == lengths {
            return Ok(self);
        }
        let by = Fraction::from(unit.to_power(lengths - self.lengths)?);
        let derivatives =
            self.derivatives.iter().map(|derivative| derivative.times(&by)).collect::<Result<_>>()?;
        Ok(Quantity { derivatives, lengths })
    }

    fn plus(self, other: Self, unit: &Poly) -> Result<Self> {
        let lengths = self.lengths.max(other.lengths);
        let (mut a, b) = (self.of_lengths(lengths, unit)?, other.of_lengths(lengths, unit)?);
        a.derivatives.resize(a.derivatives.len().max(b.derivatives.len()), Fraction::integer(0));
        for (sum, derivative) in a.derivatives.iter_mut().zip(&b.derivatives) {
            *sum = sum.plus(derivative)?;
        }
        Ok(a)
    }

    /// By the rule of Leibniz.
    fn times(&self, other: &Self) -> Result<Self> {
        let orders = self.derivatives.len() + other.derivatives.len() - 1;
        let lengths = self.lengths.checked_add(other.lengths).ok_or(Reason::Limits("an exponent"))?;
        let mut derivatives = vec![Fraction::integer(0); orders];
        for (i, a) in self.derivatives.iter().enumerate() {
            for (derivative, (j, b)) in
                derivatives.iter_mut().skip(i).zip(other.derivatives.iter().enumerate())
            {
                *derivative = derivative.plus(&Fraction::integer(choices(i + j, i)?).times(&a.times(b)?)?)?;
            }
        }
        Ok(Quantity { derivatives, lengths })
    }

    /// The value, if there is no x in it.
    fn value(&self) -> Option<&Fraction> {
        let (value, derivatives) = self.derivatives.split_first()?;
        derivatives.iter().all(Fraction::is_zero).then_some(value)
    }
}

/// The number of choices of i among n.
pub(crate) fn choices(n: usize, i: usize) -> Result<i64> {
    let number = |value: usize| i64::try_from(value).map_err(|_| Reason::Limits("the order of a derivative"));
    binomial(number(n)?, number(i)?)
}

impl<'t> Family<'t> {
    /// (family any), or (family "NAME" (parameter NAME (INDEX…) (REL NUMBER)…)… (rise TERM) (fall TERM)), with (dual (NAME TERM)…) after
    /// that where a reflection leads to another member.
    pub(crate) fn read(node: &'t Node<'t>) -> Result<Self> {
        let (name, parts) = match node.fields("family")? {
            [any] if any.is_word("any") => return Ok(Family::default()),
            [name, parts @ ..] => (name, parts),
            [] => return node.wrong("any, or a name and weights"),
        };
        name.text()?;
        let (parameters, rest) = parts.split_at(parts.iter().take_while(|part| part.is("parameter")).count());
        let (rise, fall, dual) = match rest {
            [rise, fall] => (rise, fall, None),
            [rise, fall, dual] => (rise, fall, Some(dual.fields("dual")?)),
            _ => return node.wrong("rise and fall, and perhaps a dual"),
        };
        let ([rise], [fall]) = (rise.part("rise")?, fall.part("fall")?);
        let mut family = Family { parameters: Vec::new(), weight: Some([rise, fall]), dual };
        for node in parameters {
            let [name, indices, bounds @ ..] = node.fields("parameter")? else {
                return node.wrong("a name and indices");
            };
            let Kind::List(indices) = &indices.kind else { return indices.wrong("indices") };
            let indices = indices.iter().map(Node::name).collect::<Result<Vec<_>>>()?;
            if !matches!(indices.as_slice(), [] | ["i"] | ["d"] | ["i", "d"]) {
                return node.wrong("the indices i, d, or both");
            }
            let (name, mut sign) = (name.name()?, Sign::Real);
            if family.parameter(name).is_some() {
                return Err(Reason::Taken(name.to_owned()));
            }
            for bound in bounds {
                let (relation, [number]) = bound.headed("a bound")? else { return bound.wrong("a bound") };
                let found = match (relation, number.ratio()?.0.sign(&[])) {
                    (">", Sign::Positive | Sign::Nonnegative) | (">=" | "=", Sign::Positive) => {
                        Sign::Positive
                    }
                    (">=" | "=", Sign::Nonnegative) => Sign::Nonnegative,
                    ("=" | "/=" | "<" | "<=" | ">" | ">=", _) => Sign::Real,
                    _ => return bound.wrong("a bound"),
                };
                sign = sign.max(found);
            }
            family.parameters.push(Parameter { name, indices, sign, bounds });
        }
        Ok(family)
    }

    pub(crate) fn parameter(&self, name: &str) -> Option<&Parameter<'t>> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// A parameter that is one number.
    pub(crate) fn unindexed(&self, name: &str) -> Option<&Parameter<'t>> {
        self.parameter(name).filter(|parameter| parameter.indices.is_empty())
    }

    /// The parameter, if it has so many indices.
    fn indexed(&self, name: &str, indices: &[i64]) -> Result<&Parameter<'t>> {
        let parameter = self.parameter(name).filter(|parameter| parameter.indices.len() == indices.len());
        parameter.ok_or_else(|| Reason::Unknown(name.to_owned()))
    }

    /// Whether this is all families at once.
    pub(crate) fn is_any(&self) -> bool {
        self.weight.is_none()
    }

    /// Whether weights are given by the ends of the interval, the same for all i and d.
    pub(crate) fn is_by_ends(&self) -> bool {
        let index = |node: &Node<'_>| node.is_word("i") || node.is_word("d");
        self.weight.is_some_and(|weight| !weight.iter().any(|node| node.any(&mut |node| index(node))))
    }

    /// Whether one positive r is all that its members differ by.
    pub(crate) fn is_by_ratio(&self) -> bool {
        matches!(self.parameters.as_slice(), [own] if own.name == "r" && own.indices.is_empty() && own.sign == Sign::Positive)
    }

    /// What the rest rests on, for the weights of degree d: as polynomials in x − a and b − x neither has a coefficient below 0; rise is
    /// 0 where x = a, and not where x = b, and fall the other way round.
    pub(crate) fn check(&self, d: i64) -> Result<()> {
        let (shares, signs) = self.between(d)?;
        for (part, own, other) in [(Shares::of(&shares.rise, 0), P, Q), (Shares::of(&shares.fall, 0), Q, P)] {
            if part.sign(&signs) == Sign::Real {
                return Err(Reason::Weight("has a coefficient below 0, or a without x or b", d));
            }
            if part.by_powers(own).contains_key(&0) {
                return Err(Reason::Weight("is not 0 at its own end of the interval", d));
            }
            if part.by_powers(other).get(&0).is_none_or(|rest| rest.sign(&signs) != Sign::Positive) {
                return Err(Reason::Weight("may be 0 at the other end of the interval", d));
            }
        }
        Ok(())
    }

    /// Whether the weights of degree d surely rise inside of their interval.
    pub(crate) fn rises(&self, d: i64) -> Result<bool> {
        let (shares, signs) = self.between(d)?;
        Ok(!self.is_any() && shares.rising()?.sign(&signs) == Sign::Positive)
    }

    /// The weights of degree d in P = x − a, Q = b − x and a, with the signs of these and of the parameters, which stand behind them.
    fn between(&self, d: i64) -> Result<(Shares, Vec<Sign>)> {
        let [p, q, a] = [P, Q, 2].map(Poly::variable);
        let (met, signs) = (RefCell::new(Vec::new()), [Sign::Positive, Sign::Positive, Sign::Real]);
        let known = |name: &str, indices: &[i64]| {
            let (mut met, of) = (met.borrow_mut(), (name.to_owned(), indices.to_vec()));
            let at = met.iter().position(|(known, _)| *known == of).unwrap_or(met.len());
            if at == met.len() {
                met.push((of, self.indexed(name, indices)?.sign));
            }
            Ok(Poly::variable(3 + at).into())
        };
        let x = a.clone().plus(&p);
        let at = Interval { b: x.clone().plus(&q), x, a, unit: Poly::constant(1), d, ..Interval::default() };
        let shares = self.shares(&at, &known)?;
        Ok((shares, signs.into_iter().chain(met.take().into_iter().map(|(_, sign)| sign)).collect()))
    }

    /// rise and fall; those of any family are known by their zeros alone.
    pub(crate) fn shares(&self, at: &Interval<'_>, known: &Known<'_>) -> Result<Shares> {
        let (from, to) = (at.x.clone().minus(&at.a), at.b.clone().minus(&at.x));
        let Some([rise, fall]) = self.weight else {
            return Ok(Shares { rise: vec![from], fall: vec![to] });
        };
        // No other parameters than those of the ends and of the degree: a weight is known where its interval is.
        let own = |name: &str, indices: &[i64]| {
            let parameter = self.indexed(name, indices)?;
            let is_own = |(kind, index): (&&str, &i64)| match *kind {
                "i" => [at.i, at.i + at.d].contains(index),
                _ => *index == at.d,
            };
            let all = parameter.indices.iter().zip(indices).all(is_own);
            if all {
                known(name, indices)
            } else {
                Err(Reason::NotShown("a weight looks beyond its interval"))
            }
        };
        let (rise, fall) = (at.quantity(rise, &own)?, at.quantity(fall, &own)?);
        let lengths = rise.lengths.max(fall.lengths);
        let (rise, fall) = (rise.of_lengths(lengths, &at.unit)?, fall.of_lengths(lengths, &at.unit)?);
        let mut common = Factors::new();
        rise.derivatives.iter().chain(&fall.derivatives).for_each(|part| part.widen(&mut common));
        let over = |share: Quantity| {
            let over = |part: &Fraction| Ok(part.over_common(&common)?.into_owned());
            share.derivatives.iter().map(over).collect::<Result<_>>()
        };
        Ok(Shares { rise: over(rise)?, fall: over(fall)? })
    }

    /// What a parameter is after a reflection, if it changes: `at` has its indices, `known` those that there were before.
    pub(crate) fn dual(&self, name: &str, at: &Interval<'_>, known: &Known<'_>) -> Result<Option<Fraction>> {
        let Some(dual) = self.dual else { return Err(Reason::NotShown("the family has no dual")) };
        for pair in dual {
            let (own, [term]) = pair.headed("a parameter and a term")? else { return pair.wrong("a term") };
            if own == name {
                let quantity = at.quantity(term, known)?;
                return match quantity.value() {
                    Some(value) if quantity.lengths == 0 => Ok(Some(value.clone())),
                    _ => term.wrong("a number, which no length is"),
                };
            }
        }
        Ok(None)
    }
}

impl Interval<'_> {
    fn quantity(&self, node: &Node<'_>, known: &Known<'_>) -> Result<Quantity> {
        let of = |node| self.quantity(node, known);
        match node.kind {
            Kind::Number(..) => return Fraction::number(node).map(Quantity::constant),
            Kind::Name(_) | Kind::Text(_) => return node.wrong("a term of a weight"),
            Kind::List(_) => {}
        }
        match node.headed("a term of a weight")? {
            ("var", [name]) => match name.word(&["x", "a", "b"], "x, a or b")? {
                "x" => Ok(Quantity::length(self.x.clone(), self.unit.clone())),
                "a" => Ok(Quantity::length(self.a.clone(), Poly::default())),
                _ => Ok(Quantity::length(self.b.clone(), Poly::default())),
            },
            ("int", [int]) => Ok(Quantity::constant(Fraction::integer(self.integer(int, false)?))),
            ("parameter", [name, indices @ ..]) => {
                let indices =
                    indices.iter().map(|index| self.integer(index, true)).collect::<Result<Vec<_>>>()?;
                Ok(Quantity::constant(known(name.name()?, &indices)?))
            }
            ("+", [a, b]) => of(a)?.plus(of(b)?, &self.unit),
            ("-", [a, b]) => {
                of(a)?.plus(of(b)?.times(&Quantity::constant(Fraction::integer(-1)))?, &self.unit)
            }
            ("neg", [a]) => of(a)?.times(&Quantity::constant(Fraction::integer(-1))),
            ("*", [a, b]) => of(a)?.times(&of(b)?),
            ("/", [a, b]) => match (of(a)?, of(b)?) {
                (a, b) if b.lengths == 0 => match b.value() {
                    Some(b) => a.times(&Quantity::constant(Fraction::integer(1).over(b, self.signs)?)),
                    None => node.wrong("a divisor without x, a and b"),
                },
                _ => node.wrong("a divisor without x, a and b"),
            },
            ("^", [a, power]) => match self.integer(power, false)? {
                power @ 0..=EXPONENT => {
                    let (base, one) = (of(a)?, Quantity::constant(Fraction::integer(1)));
                    (0..power).try_fold(one, |all, _| all.times(&base))
                }
                _ => Err(Reason::Limits("an exponent")),
            },
            _ => node.wrong("a term of a weight"),
        }
    }

    /// By d; the place among the knots is for indices only, as the same weights stand at other knots.
    fn integer(&self, node: &Node<'_>, index: bool) -> Result<i64> {
        let of = |node| self.integer(node, index);
        match node.headed("an integer") {
            Ok(("+", [a, b])) => small(of(a)? + of(b)?),
            Ok(("-", [a, b])) => small(of(a)? - of(b)?),
            Ok(("*", [a, b])) => small(of(a)? * of(b)?),
            _ => match node.kind {
                Kind::Name("i") if index => Ok(self.i),
                Kind::Name("d") => Ok(self.d),
                Kind::Name("m") if index => self.m.ok_or(Reason::Unknown("m".to_owned())),
                _ => small(node.whole()?),
            },
        }
    }
}
