//! Integers and numbers in Coq: sums without a minus, and what stands next to what.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::super::syntax::{Int, Real, Relation};

/// How tightly what stands around binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Top,
    /// The right of a minus, or a summand next to one.
    Term,
    /// Next to · and /.
    Factor,
    /// An argument.
    Atom,
}

pub(super) fn within(inner: bool, text: String) -> String {
    if inner { format!("({text})") } else { text }
}

/// A sum of names and of a number, on both sides of a minus.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Linear {
    pub(super) plus: Vec<String>,
    pub(super) minus: Vec<String>,
    pub(super) constant: i64,
}

impl Linear {
    pub(super) fn number(constant: i64) -> Self {
        Self { constant, ..Self::default() }
    }

    pub(super) fn name(name: &str) -> Self {
        Self { plus: vec![name.to_owned()], ..Self::default() }
    }

    pub(super) fn added(mut self, other: &Self) -> Self {
        for name in &other.plus {
            match self.minus.iter().position(|own| own == name) {
                Some(at) => _ = self.minus.remove(at),
                None => self.plus.push(name.clone()),
            }
        }
        for name in &other.minus {
            match self.plus.iter().position(|own| own == name) {
                Some(at) => _ = self.plus.remove(at),
                None => self.minus.push(name.clone()),
            }
        }
        self.constant += other.constant;
        self
    }

    pub(super) fn negated(&self) -> Self {
        Self { plus: self.minus.clone(), minus: self.plus.clone(), constant: -self.constant }
    }

    /// The two sides of `a <= b` as natural numbers, for `b - a`.
    pub(super) fn sides(&self) -> (String, String) {
        (side(&self.minus, -self.constant), side(&self.plus, self.constant))
    }
}

/// A sum of natural numbers, with a number only if that is positive: `(i + k).+1`.
pub(super) fn side(names: &[String], constant: i64) -> String {
    let sum = names.join(" + ");
    if constant == 1 && (sum == "n + k" || sum == "k + n") {
        return "m".to_owned();
    }
    match (names.len(), constant) {
        (0, constant) => constant.max(0).to_string(),
        (_, ..=0) => sum,
        (1, 1..=4) => format!("{sum}.+{constant}"),
        (_, 1..=4) => format!("({sum}).+{constant}"),
        (_, _) => format!("{sum} + {constant}"),
    }
}

/// A number that is not below 0.
pub(super) fn natural(of: &Linear) -> String {
    match of {
        of if of.minus.is_empty() && of.constant >= 0 => side(&of.plus, of.constant),
        _ => truncated(of),
    }
}

/// A difference of natural numbers, 0 if it is below that.
pub(super) fn truncated(of: &Linear) -> String {
    let (low, high) = of.sides();
    match (low.as_str(), of.minus.len()) {
        ("0", _) => high,
        (_, 0..=1) if !low.contains(' ') => format!("{high} - {low}"),
        _ => format!("{high} - ({low})"),
    }
}

/// A natural number as an argument, where the scope is that of reals.
pub(super) fn argument(natural: &str) -> String {
    let is_name = |text: &str| text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
    let (stem, successor) = natural.split_once(".+").unwrap_or((natural, "1"));
    if natural.chars().all(|c| c.is_ascii_digit()) {
        format!("{natural}%N")
    } else if is_name(stem) && is_name(successor) {
        natural.to_owned()
    } else {
        format!("({natural})%N")
    }
}

/// An integer as a real: `k%:R - 1`.
pub(super) fn whole(of: &Linear, level: Level) -> String {
    let real =
        |name: &String| format!("{}%:R", if name.contains(' ') { format!("({name})") } else { name.clone() });
    let literal = |number: u64| if number < 2 { number.to_string() } else { format!("{number}%:R") };
    let number = literal(of.constant.unsigned_abs());
    let mut sum: Vec<String> = of.plus.iter().map(real).collect();
    if of.constant > 0 || sum.is_empty() && of.minus.is_empty() && of.constant == 0 {
        sum.push(number.clone());
    }
    let mut text = sum.join(" + ");
    let mut taken: Vec<String> = of.minus.iter().map(real).collect();
    if of.constant < 0 {
        taken.push(number);
    }
    for one in &taken {
        text += &if text.is_empty() { format!("- {one}") } else { format!(" - {one}") };
    }
    let atoms = sum.len() + taken.len();
    within(level > Level::Top && (atoms > 1 || !taken.is_empty()), text)
}

pub(super) fn number(value: &BigRational, level: Level) -> String {
    let literal = |number: &num_bigint::BigInt| {
        if number.is_zero() || number.is_one() { number.to_string() } else { format!("{number}%:R") }
    };
    let text = match value.denom().is_one() {
        true => literal(&value.numer().abs()),
        false => format!("{} / {}", literal(&value.numer().abs()), literal(value.denom())),
    };
    match value.is_negative() {
        true => within(level > Level::Top, format!("- ({text})")),
        false => within(level > Level::Term && text.contains(' '), text),
    }
}

pub(super) fn is_one(of: &Real) -> bool {
    matches!(of, Real::Whole(Int::Number(1)))
}

pub(super) fn inverse(ratio: &str) -> String {
    format!("{ratio}^-1")
}

pub(super) fn sign_of(sign: Relation) -> &'static str {
    match sign {
        Relation::Equal => "=",
        Relation::Unequal => "!=",
        Relation::Less | Relation::Greater => "<",
        Relation::AtMost | Relation::AtLeast => "<=",
    }
}

/// > and ≥ are read from the right.
pub(super) fn relation(sign: Relation, a: &str, b: &str) -> String {
    match sign {
        Relation::Greater | Relation::AtLeast => format!("{b} {} {a}", sign_of(sign)),
        _ => format!("{a} {} {b}", sign_of(sign)),
    }
}

/// Two integers, each side without a minus.
pub(super) fn compared(sign: Relation, a: &Linear, b: &Linear) -> String {
    let (a, b) = match sign {
        Relation::Greater | Relation::AtLeast => (b, a),
        _ => (a, b),
    };
    let (low, high) = b.clone().added(&a.negated()).sides();
    format!("({low} {} {high})%N", sign_of(sign))
}
