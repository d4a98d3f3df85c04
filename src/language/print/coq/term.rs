//! Terms: integers, numbers, and functions at points.

use super::super::super::syntax::{
    Argument, Definition, Fold, Function, Int, Interval, Item, Member, Name, Pattern, Real, Side,
};
use super::super::super::words::Word;
use super::number::{Level, Linear, argument, inverse, is_one, natural, number, truncated, whole, within};
use super::walk::{NotInCoq, Text, Walk, not_in_coq};

impl<'a> Walk<'a> {
    pub(super) fn linear(&mut self, of: &Int) -> Result<Linear, NotInCoq> {
        Ok(match of {
            Int::Number(number) => Linear::number(*number),
            Int::Bound(name) => match self.integers.get(name) {
                Some(known) => known.clone(),
                None => return not_in_coq(format!("the integer {name}")),
            },
            Int::Degree => Linear::name("k"),
            Int::Last => Linear::name("n"),
            Int::M => Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 },
            Int::Plus(a, b) => self.linear(a)?.added(&self.linear(b)?),
            Int::Minus(a, b) => self.linear(a)?.added(&self.linear(b)?.negated()),
            Int::Times(a, b) => {
                let (a, b) = (self.natural(a)?, self.natural(b)?);
                Linear::name(&format!("({a} * {b})"))
            }
            Int::Binomial(a, b) => {
                let (a, b) = (self.natural(a)?, self.natural(b)?);
                Linear::name(&format!("'C({a}, {b})"))
            }
            Int::Least(a, b) => Linear::name(&format!("(minn {} {})", self.index(a)?, self.index(b)?)),
            Int::Greatest(a, b) => Linear::name(&format!("(maxn {} {})", self.index(a)?, self.index(b)?)),
            Int::Word(of) => match (of.word, of.of.as_slice()) {
                (Word::Multiplicity, [Item::Real(at)]) => {
                    let at = self.real(at, Level::Atom)?;
                    Linear::name(&format!("mult t m {at}"))
                }
                _ => return not_in_coq(format!("the word {}", of.word.name())),
            },
        })
    }

    /// An integer that is used as one, and so not below 0.
    pub(super) fn natural(&mut self, of: &Int) -> Text {
        let linear = self.linear(of)?;
        self.need_at_most(&Linear::default(), &linear);
        Ok(natural(&linear))
    }

    /// The same as an argument.
    pub(super) fn index(&mut self, of: &Int) -> Text {
        let natural = self.natural(of)?;
        Ok(argument(&natural))
    }

    pub(super) fn interval(&mut self, x: &str, of: &Interval) -> Text {
        let (from, to) = (self.real(&of.from, Level::Top)?, self.real(&of.to, Level::Top)?);
        let sign = |closed| if closed { "<=" } else { "<" };
        Ok(format!("{from} {} {x} {} {to}", sign(of.from_closed), sign(of.to_closed)))
    }

    pub(super) fn real(&mut self, of: &Real, level: Level) -> Text {
        Ok(match of {
            Real::Number(value) => number(value, level),
            Real::Whole(int) => {
                let linear = self.linear(int)?;
                whole(&linear, level)
            }
            // What stands for a name is an argument as it is.
            Real::Bound(name) => match self.reals.get(name) {
                Some(known) => known.clone(),
                None => return not_in_coq(format!("the number {name}")),
            },
            Real::Index(name) if &**name == "alpha" => {
                let r = self.ratio.clone();
                self.need(format!("{r} - 1 != 0"));
                within(level > Level::Term, format!("{r} / ({r} - 1)"))
            }
            Real::Index(_) | Real::Infinity => return not_in_coq("an index as a number"),
            Real::Ratio => self.ratio.clone(),
            Real::Knot(i) => {
                let (at, m) = (
                    self.linear(i)?,
                    Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 },
                );
                self.need_at_most(&at, &m);
                within(level == Level::Atom, format!("t {}", self.index(i)?))
            }
            Real::Coefficient(name, indices) => match (self.reals.get(name).cloned(), indices.as_slice()) {
                (Some(d), [i]) => {
                    let at = self.linear(i)?;
                    self.need_at_most(&at, &Linear::name("n"));
                    within(level == Level::Atom, format!("{d} {}", self.index(i)?))
                }
                _ => return not_in_coq("coordinates of points"),
            },
            Real::Parameter(..) => return not_in_coq("a parameter of a family"),
            Real::Plus(a, b) => {
                let (a, b) = (self.real(a, Level::Top)?, self.real(b, Level::Term)?);
                within(level > Level::Top, format!("{a} + {b}"))
            }
            Real::Minus(a, b) => {
                let (a, b) = (self.real(a, Level::Top)?, self.real(b, Level::Term)?);
                within(level > Level::Top, format!("{a} - {b}"))
            }
            Real::Times(a, b) => {
                let (a, b) = (self.real(a, Level::Term)?, self.real(b, Level::Factor)?);
                within(level > Level::Term, format!("{a} * {b}"))
            }
            Real::Over(a, b) => {
                let (a, b) = (self.real(a, Level::Term)?, self.real(b, Level::Factor)?);
                self.need(format!("{b} != 0 :> R"));
                within(level > Level::Term, format!("{a} / {b}"))
            }
            Real::Negated(a) => {
                let a = self.real(a, Level::Factor)?;
                within(level > Level::Top, format!("- {a}"))
            }
            Real::Power(a, e) => {
                let (a, e) = (self.real(a, Level::Atom)?, self.index(e)?);
                within(level > Level::Factor, format!("{a} ^+ {e}"))
            }
            Real::Absolute(a) => format!("`|{}|", self.real(a, Level::Top)?),
            Real::Root(_) => return not_in_coq("a root"),
            Real::Least(a, b) => {
                let (a, b) = (self.real(a, Level::Atom)?, self.real(b, Level::Atom)?);
                within(level == Level::Atom, format!("Num.min {a} {b}"))
            }
            Real::Greatest(a, b) => {
                let (a, b) = (self.real(a, Level::Atom)?, self.real(b, Level::Atom)?);
                within(level == Level::Atom, format!("Num.max {a} {b}"))
            }
            Real::Fold(fold, range, body) => {
                let sign = match fold {
                    Fold::Sum => "\\sum",
                    Fold::Product => "\\prod",
                    Fold::Least | Fold::Greatest => return not_in_coq("the greatest of a range"),
                };
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                let below = to.clone().added(&Linear::number(1));
                let first = self.natural(&range.from)?;
                let (name, body) = self.scoped(range, (&from, &to), |walk| walk.real(body, Level::Term))?;
                // Below its first number the range is empty, there as here.
                within(
                    level > Level::Top,
                    format!("{sign}_({first} <= {name} < {}) {body}", truncated(&below)),
                )
            }
            Real::Defined(name, indices) => self.defined(name, indices, None, level)?,
            Real::Value(function, argument) => self.value(function, argument, level)?,
            Real::Word(of) => return not_in_coq(format!("the word {}", of.word.name())),
        })
    }

    /// A definition of the file, with its indices and its argument put in.
    pub(super) fn defined(&mut self, name: &Name, indices: &[Int], at: Option<String>, level: Level) -> Text {
        if self.open.contains(name) {
            return not_in_coq(format!("the recursion of {name}"));
        }
        let values: Result<Vec<_>, _> = indices.iter().map(|index| self.linear(index)).collect();
        let values = values?;
        let fits = |definition: &&Definition| {
            definition.name == *name
                && definition.indices.iter().zip(&values).all(|(pattern, value)| match pattern {
                    Pattern::Any(_) => true,
                    Pattern::Number(number) => *value == Linear::number(*number),
                })
        };
        let definitions: &'a [Definition] = self.definitions;
        let several = definitions.iter().filter(|definition| definition.name == *name).count() > 1;
        let Some(definition) = definitions.iter().find(fits).filter(|_| !several) else {
            return not_in_coq(format!("the recursion of {name}"));
        };
        let (integers, reals) = (self.integers.clone(), self.reals.clone());
        for (pattern, value) in definition.indices.iter().zip(values) {
            if let Pattern::Any(own) = pattern {
                self.integers.insert(own.clone(), value);
            }
        }
        if let Some((variable, at)) = definition.variable.as_ref().zip(at) {
            self.reals.insert(variable.clone(), at);
        }
        self.open.push(name.clone());
        let body = self.real(&definition.body, level);
        self.open.pop();
        (self.integers, self.reals) = (integers, reals);
        body
    }

    pub(super) fn value(&mut self, function: &Function, argument: &Argument, level: Level) -> Text {
        let before = self.ratio.clone();
        let at = self.real(&argument.at, Level::Atom)?;
        if let Some(member) = &argument.member {
            self.ratio = self.member(member)?;
        }
        let text = self.at(function, &at, argument.side, level);
        self.ratio = before;
        text
    }

    /// The slope ratio of another index. α/(α − 1) of 1 − α is the inverse of that of α, 1 − ∞ = ∞ included.
    pub(super) fn member(&mut self, of: &Member) -> Text {
        match of {
            Member::Ratio(ratio) => self.real(ratio, Level::Atom),
            Member::Dual => Ok(inverse(&self.ratio)),
            Member::Index(Real::Infinity) => Ok("1".to_owned()),
            Member::Index(Real::Minus(one, alpha))
                if is_one(one) && matches!(&**alpha, Real::Index(name) if &**name == "alpha") =>
            {
                Ok(inverse(&self.ratio))
            }
            Member::Index(Real::Index(name)) if &**name == "alpha" => Ok(self.ratio.clone()),
            Member::Index(other) => {
                let alpha = self.real(other, Level::Atom)?;
                self.need(format!("{alpha} - 1 != 0"));
                Ok(format!("({alpha} / ({alpha} - 1))"))
            }
            Member::Parameter(..) => not_in_coq("a parameter of a family"),
        }
    }

    pub(super) fn at(&mut self, function: &Function, x: &str, side: Option<Side>, level: Level) -> Text {
        let r = self.ratio.clone();
        let text = match (function, side) {
            (Function::Basis { i, degree }, _) => {
                let name = match side {
                    None => "value",
                    Some(Side::Left) => "Gleft",
                    Some(Side::Right) => "Gright",
                };
                let (d, i) = self.basis(i, degree.as_ref())?;
                format!("{name} {r} t m {d} {i} {x}")
            }
            (Function::Weight { i, degree }, None) => {
                let (d, i) = self.weight(i, degree)?;
                format!("wt {r} t {d} {i} {x}")
            }
            (Function::Phi { cut, from, to }, None) => {
                let (a, b) = (self.real(from, Level::Atom)?, self.real(to, Level::Atom)?);
                if !cut {
                    self.need(format!("{r} * ({x} - {a}) + ({b} - {x}) != 0"));
                }
                format!("{} {r} {x} {a} {b}", if *cut { "phi" } else { "mob" })
            }
            (Function::Defined(name, indices), None) => {
                return self.defined(name, indices, Some(x.to_owned()), level);
            }
            (Function::Derivative(of, Int::Number(1)), Some(side)) => match &**of {
                Function::Basis { i, degree } => {
                    let name = if side == Side::Left { "DGleft" } else { "DGright" };
                    let (d, i) = self.basis(i, degree.as_ref())?;
                    format!("{name} {r} t m {d} {i} {x}")
                }
                Function::Weight { i, degree } => {
                    let name = if side == Side::Left { "wDleft" } else { "wDright" };
                    let (d, i) = self.weight(i, degree)?;
                    format!("{name} {r} t {d} {i} {x}")
                }
                Function::Defined(name, indices) => return self.slope(name, indices, x, side, level),
                _ => return not_in_coq("the derivative of a weight from D2.3"),
            },
            (Function::Derivative(..), _) => {
                return not_in_coq("a derivative that is not one of order 1 from one side");
            }
            (_, Some(_)) => return not_in_coq("the limit of a weight or of a curve"),
        };
        Ok(within(level == Level::Atom, text))
    }

    /// d and i of G_i^d, which exists for d ≤ k and i + d < m.
    pub(super) fn basis(&mut self, i: &Int, degree: Option<&Int>) -> Result<(String, String), NotInCoq> {
        let degree = degree.unwrap_or(&Int::Degree);
        let (d, at) = (self.linear(degree)?, self.linear(i)?);
        self.need_at_most(&d, &Linear::name("k"));
        self.need_at_most(&at.added(&d), &Linear { plus: vec!["n".into(), "k".into()], ..Linear::default() });
        Ok((self.index(degree)?, self.index(i)?))
    }

    /// d and i of w_i^d, which exists for 1 ≤ d ≤ k and i + d ≤ m.
    pub(super) fn weight(&mut self, i: &Int, degree: &Int) -> Result<(String, String), NotInCoq> {
        let (d, at) = (self.linear(degree)?, self.linear(i)?);
        self.need_at_most(&Linear::number(1), &d);
        self.need_at_most(&d, &Linear::name("k"));
        let m = Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 };
        self.need_at_most(&at.added(&d), &m);
        Ok((self.index(degree)?, self.index(i)?))
    }

    /// The derivative from one side of a definition of the file, which is linear in functions of the basis.
    pub(super) fn slope(&mut self, name: &Name, indices: &[Int], x: &str, side: Side, level: Level) -> Text {
        let definitions: &'a [Definition] = self.definitions;
        let mut own = definitions.iter().filter(|definition| definition.name == *name);
        let (Some(definition), None, []) = (own.next(), own.next(), indices) else {
            return not_in_coq("the derivative of a definition with indices");
        };
        let Some(variable) = &definition.variable else { return Ok("0".to_owned()) };
        self.linear_slope(&definition.body, variable, x, side, level)
    }

    pub(super) fn linear_slope(
        &mut self,
        of: &Real,
        variable: &Name,
        x: &str,
        side: Side,
        level: Level,
    ) -> Text {
        match of {
            Real::Fold(Fold::Sum, range, body) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                let below = to.clone().added(&Linear::number(1));
                let first = self.natural(&range.from)?;
                let slope = |walk: &mut Self| walk.linear_slope(body, variable, x, side, Level::Term);
                let (name, body) = self.scoped(range, (&from, &to), slope)?;
                let text = format!("\\sum_({first} <= {name} < {}) {body}", truncated(&below));
                Ok(within(level > Level::Top, text))
            }
            Real::Times(factor, of) if matches!(&**factor, Real::Coefficient(..)) => {
                let factor = self.real(factor, Level::Term)?;
                let slope = self.linear_slope(of, variable, x, side, Level::Factor)?;
                Ok(within(level > Level::Term, format!("{factor} * {slope}")))
            }
            Real::Value(function, at) if matches!(&**at, Argument { at: Real::Bound(name), side: None, member: None } if name == variable) =>
            {
                let slope = Function::Derivative(function.clone(), Int::Number(1));
                self.at(&slope, x, Some(side), level)
            }
            _ => not_in_coq("the derivative of this curve"),
        }
    }
}
