//! Terms to quotients of polynomials.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

use crate::env::{Env, Meaning};
use crate::error::{Reason, Result};
use crate::fraction::Fraction;
use crate::poly::{Poly, Sign};
use crate::token::{Kind, Node};
use crate::work::spend;

/// Higher derivatives are not computed.
const ORDER: i64 = 20;
/// Larger exponents are not computed.
const EXPONENT: u16 = 1_000;
/// Parameters and unknowns of one formula.
const VARIABLES: usize = 500;
/// Larger matrices are not expanded.
const ROWS: usize = 8;

/// How far the definition is unfolded, and what the formula is.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Mode {
    /// Weights of this degree and above stay unknowns.
    pub(crate) weights: Option<i64>,
    /// Functions up to this degree stay unknowns.
    pub(crate) functions: Option<i64>,
    /// The two unknowns of a weight add up to 1 instead of having signs.
    pub(crate) equation: bool,
}

/// What is computed once, or not unfolded. Two that have the same key have the same value.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Key {
    /// [p|q].
    Weight(Poly, Poly),
    /// p, q, and the numerator over the square of their sum.
    Slope(Poly, Poly, Poly),
    /// A weight that is known by its name alone, or its derivative: i and d; the window; x and its unit.
    Any(&'static str, [i64; 2], String, [Poly; 2]),
    /// G, DG or de-boor with its integers; the window and the span; the dual; u and the parameters of the family.
    Function(&'static str, [i64; 3], (String, i64), Option<(String, i64)>, Vec<(Poly, Poly)>),
}

/// Evaluates the terms of one formula. What is known of a key does not change on the way.
pub(crate) struct Evaluator {
    pub(crate) mode: Mode,
    /// Of the parameters, and behind them of the unknowns.
    pub(crate) signs: Vec<Sign>,
    pub(crate) known: BTreeMap<Key, Fraction>,
}

impl Evaluator {
    pub(crate) fn new(signs: &[Sign], mode: Mode) -> Self {
        Evaluator { mode, signs: signs.to_vec(), known: BTreeMap::new() }
    }

    /// The variable for something that is not unfolded.
    pub(crate) fn unknown(&mut self, key: Key, sign: Sign) -> Result<Fraction> {
        let next = self.signs.len();
        match self.known.entry(key) {
            Entry::Occupied(known) => Ok(known.get().clone()),
            Entry::Vacant(_) if next == VARIABLES => Err(Reason::Limits("the number of unknowns")),
            Entry::Vacant(place) => {
                self.signs.push(sign);
                Ok(place.insert(Poly::variable(next).into()).clone())
            }
        }
    }

    pub(crate) fn term<'t>(&mut self, node: &Node<'t>, env: &Env<'t>) -> Result<Fraction> {
        let value = self.unfolded(node, env)?;
        spend(1 + value.size()).map(|()| value)
    }

    fn unfolded<'t>(&mut self, node: &Node<'t>, env: &Env<'t>) -> Result<Fraction> {
        match &node.kind {
            Kind::Number(..) => return Fraction::number(node),
            Kind::Name(_) => return env.value(node.name()?, Vec::new()),
            _ => {}
        }
        match node.headed("a term")? {
            (head @ ("+" | "*"), items @ [_, ..]) => {
                let mut value = Fraction::integer(i64::from(head == "*"));
                for (item, env) in env.expand(items)? {
                    let item = self.term(item, &env)?;
                    value = if head == "+" { value.plus(&item)? } else { value.times(&item)? };
                }
                Ok(value)
            }
            ("-", [a]) => Ok(self.term(a, env)?.negated()),
            ("-", [a, b]) => self.difference(a, b, env),
            ("/", [a, b]) => self.term(a, env)?.over(&self.term(b, env)?, &self.signs),
            ("^", [base, power]) => match u16::try_from(env.integer(power)?) {
                Ok(power) if power <= EXPONENT => self.term(base, env)?.to_power(power),
                _ => Err(Reason::Limits("an exponent")),
            },
            ("integer", [integer]) => Ok(Fraction::integer(env.integer(integer)?)),
            ("t", [window, index]) => {
                let window = env.window(window)?;
                Fraction::new(window.knot(env.integer(index)?)?.clone(), window.scale.clone(), &self.signs)
            }
            ("parameter", [window, name, indices @ ..]) => {
                env.window(window)?.parameter(name.name()?, &env.integers(indices)?)
            }
            ("x", [place]) => self.spot(place, env)?.x(&self.signs),
            ("w", [i, d, place]) => {
                let [rise, _] = self.weight(env.integer(i)?, env.integer(d)?, &self.spot(place, env)?)?;
                Ok(rise)
            }
            ("v", [i, d, place]) => {
                let [_, fall] = self.weight(env.integer(i)?, env.integer(d)?, &self.spot(place, env)?)?;
                Ok(fall)
            }
            ("Dw", [i, d, place]) => self.slope(env.integer(i)?, env.integer(d)?, &self.spot(place, env)?, 1),
            (of @ ("G" | "DG"), [i, d, place]) => {
                self.basis(env.integer(i)?, env.integer(d)?, &self.spot(place, env)?, i64::from(of == "DG"))
            }
            ("DG", [i, d, place, order]) => match env.integer(order)? {
                order @ 0..=ORDER => {
                    self.basis(env.integer(i)?, env.integer(d)?, &self.spot(place, env)?, order)
                }
                _ => Err(Reason::Limits("the order of a derivative")),
            },
            ("de-boor", [i, q, k, place]) => {
                let of = [env.integer(i)?, env.integer(q)?, env.integer(k)?];
                self.de_boor(of, &self.spot(place, env)?, env)
            }
            ("at", [pairs, inner]) => {
                let inside = self.replaced(pairs.list("a replacement")?, env)?;
                self.term(inner, &inside)
            }
            ("det", rows @ [_, ..]) => {
                let mut entries =
                    |row: &Node<'t>| row.list("a row")?.iter().map(|entry| self.term(entry, env)).collect();
                let matrix: Vec<Vec<_>> = rows.iter().map(&mut entries).collect::<Result<_>>()?;
                let square = rows.len() <= ROWS && matrix.iter().all(|row| row.len() == rows.len());
                if square {
                    determinant(&matrix.iter().map(|row| row.iter().collect()).collect::<Vec<_>>())
                } else {
                    node.wrong("a square matrix with 8 rows at most")
                }
            }
            (_, [_, ..]) => {
                let (name, indices) = node.indexed()?;
                env.value(name, env.integers(indices)?)
            }
            _ => node.wrong("a term"),
        }
    }

    pub(crate) fn difference<'t>(&mut self, a: &Node<'t>, b: &Node<'t>, env: &Env<'t>) -> Result<Fraction> {
        self.term(a, env)?.minus(&self.term(b, env)?)
    }

    /// The names inside of `at`. The values are those outside: all are replaced at once.
    fn replaced<'t>(&mut self, pairs: &[Node<'t>], env: &Env<'t>) -> Result<Env<'t>> {
        let mut inside = env.clone();
        for (at, pair) in pairs.iter().enumerate() {
            if let Ok([window, m]) = pair.part("dual") {
                env.window(window)?;
                inside.dual = Some((window.name()?, env.integer(m)?));
                continue;
            }
            let [name, value] = pair.group("a replacement")?;
            let again =
                pairs.iter().take(at).any(|other| other.group::<2>("").is_ok_and(|[own, _]| own == name));
            let sign = match (name.name()?, env.family.unindexed(name.name()?)) {
                _ if again => return name.wrong("u or a parameter of the family, each once"),
                ("u", _) => Sign::Positive,
                (_, Some(own)) => own.sign,
                _ => return name.wrong("u or a parameter of the family, each once"),
            };
            let (name, value) = (name.name()?, self.term(value, env)?);
            inside.set(
                name,
                Vec::new(),
                Meaning::Value(Rc::new(value.at_least(sign, name, &self.signs)?)),
            )?;
        }
        Ok(inside)
    }
}

/// Along the first row; the determinant of the empty matrix is 1.
fn determinant<'f>(matrix: &[Vec<&'f Fraction>]) -> Result<Fraction> {
    let Some((first, rest)) = matrix.split_first() else { return Ok(Fraction::integer(1)) };
    let mut sum = Fraction::integer(0);
    for (column, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
        let without = |row: &Vec<&'f Fraction>| {
            row.iter().enumerate().filter(|(at, _)| *at != column).map(|(_, entry)| *entry).collect()
        };
        let minor: Vec<Vec<&Fraction>> = rest.iter().map(without).collect();
        let part = entry.times(&determinant(&minor)?)?;
        sum = if column % 2 == 0 { sum.plus(&part)? } else { sum.minus(&part)? };
    }
    Ok(sum)
}
