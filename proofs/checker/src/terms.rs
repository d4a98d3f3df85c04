//! Terms to quotients of polynomials.

use std::collections::BTreeMap;

use dashu_int::IBig;

use crate::error::Reason;
use crate::fraction::Fraction;
use crate::integer::Scope;
use crate::poly::{Poly, Sign};
use crate::section::{Section, Values};
use crate::syntax::{Of, Term};

/// Larger exponents are not computed.
const EXPONENT: i64 = 1_000;
/// Larger matrices are not expanded.
const ROWS: usize = 8;

/// How far the definition is unfolded, and what the formula is.
#[derive(Clone, Copy, Default)]
pub(crate) struct Mode {
    /// Weights of this degree and above stay unknowns.
    pub(crate) weights: Option<i64>,
    /// Functions up to this degree stay unknowns.
    pub(crate) functions: Option<i64>,
    /// The two unknowns of a weight add up to 1 instead of having signs.
    pub(crate) equation: bool,
}

/// What is not unfolded. Two that have the same key have the same value.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Unknown {
    /// Rise and fall.
    Weight(Poly, Poly),
    /// Rise, fall, and the numerator over the square of their sum.
    Slope(Poly, Poly, Poly),
    /// Index, degree, span, whether it is the derivative; the window; u and r.
    Function([i64; 3], bool, String, [(Poly, Poly); 2]),
}

pub(crate) struct Evaluator<'a> {
    pub(crate) section: &'a Section<'a>,
    pub(crate) mode: Mode,
    /// Of the parameters, and behind them of the unknowns.
    pub(crate) signs: Vec<Sign>,
    unknowns: BTreeMap<Unknown, usize>,
}

impl<'a> Evaluator<'a> {
    pub(crate) fn new(section: &'a Section<'a>, mode: Mode) -> Self {
        Evaluator { section, mode, signs: section.signs.clone(), unknowns: BTreeMap::new() }
    }

    pub(crate) fn unknown(&mut self, key: Unknown, sign: Sign) -> Poly {
        let next = self.signs.len();
        let index = *self.unknowns.entry(key).or_insert(next);
        if index == next {
            self.signs.push(sign);
        }
        Poly::variable(index)
    }

    /// The value of a term. Its recursion ends where the brackets of the text do.
    pub(crate) fn term(
        &mut self,
        term: &Term,
        scope: &mut Scope,
        values: &Values,
    ) -> Result<Fraction, Reason> {
        match term {
            Term::Number(number) => Ok(Fraction::number(number)),
            Term::Parameter(parameter) if parameter.1.is_empty() => self.section.name(&parameter.0, values),
            Term::Parameter(parameter) => Ok(Poly::variable(self.section.find(parameter, scope)?).into()),
            Term::Integer(int) => Ok(Poly::constant(IBig::from(scope.value(int)?)).into()),
            Term::Sum(items) => {
                let mut sum = Fraction::zero();
                scope.expand(items, &mut |item, scope| {
                    sum = sum.plus(&self.term(item, scope, values)?)?;
                    Ok(())
                })?;
                Ok(sum)
            }
            Term::Product(items) => {
                let mut product = Fraction::one();
                scope.expand(items, &mut |item, scope| {
                    product = product.times(&self.term(item, scope, values)?)?;
                    Ok(())
                })?;
                Ok(product)
            }
            Term::Difference(a, b) => self.term(a, scope, values)?.minus(&self.term(b, scope, values)?),
            Term::Negative(a) => Ok(self.term(a, scope, values)?.negated()),
            Term::Quotient(a, b) => {
                let (a, b) = (self.term(a, scope, values)?, self.term(b, scope, values)?);
                a.over(&b, &self.signs)
            }
            Term::Power(base, exponent) => {
                let exponent = scope.value(exponent)?;
                if exponent > EXPONENT {
                    return Err(Reason::TooLarge("an exponent"));
                }
                let exponent = u16::try_from(exponent).map_err(|_| Reason::Negative("an exponent"))?;
                self.term(base, scope, values)?.to_power(exponent)
            }
            Term::Knot(window, index) => {
                let knot = values.window(window)?.knot(scope.value(index)?)?;
                Fraction::new(knot.clone(), Poly::constant(values.scale.clone()), &self.signs)
            }
            Term::Point(place) => self.spot(place, scope, values)?.x(values, &self.signs),
            Term::Function(of, i, d, place) => {
                let (i, d) = (scope.value(i)?, scope.value(d)?);
                let spot = self.spot(place, scope, values)?;
                match of {
                    Of::Rise => Ok(self.weight(i, d, &spot)?.rise),
                    Of::Fall => Ok(self.weight(i, d, &spot)?.fall),
                    Of::Slope => self.slope(i, d, &spot),
                    Of::Value => Ok(self.basis(i, d, &spot, false)?.0),
                    Of::Derivative => Ok(self.basis(i, d, &spot, true)?.1),
                }
            }
            Term::DeBoor(i, level, degree, place) => {
                let (i, level, degree) = (scope.value(i)?, scope.value(level)?, scope.value(degree)?);
                let spot = self.spot(place, scope, values)?;
                self.de_boor(i, level, degree, &spot)
            }
            Term::At(pairs, inner) => {
                let mut inside = values.clone();
                for (position, (name, value)) in pairs.iter().enumerate() {
                    if pairs.iter().take(position).any(|(before, _)| before == name) {
                        return Err(Reason::Taken(name.clone()));
                    }
                    // Evaluated outside of `at`: all are replaced at once.
                    let value = self.term(value, scope, values)?;
                    *inside.replaceable(name)? = value.positive(name, &self.signs)?;
                }
                self.term(inner, scope, &inside)
            }
            Term::Determinant(rows) => {
                let mut matrix = Vec::new();
                for row in rows {
                    let row = row.iter().map(|entry| self.term(entry, scope, values));
                    matrix.push(row.collect::<Result<Vec<_>, _>>()?);
                }
                if rows.len() > ROWS {
                    return Err(Reason::TooLarge("a matrix"));
                }
                if matrix.iter().any(|row| row.len() != matrix.len()) {
                    return Err(Reason::NotSquare);
                }
                determinant(&matrix)
            }
        }
    }
}

/// Along the first row; the determinant of the empty matrix is 1.
fn determinant(matrix: &[Vec<Fraction>]) -> Result<Fraction, Reason> {
    let Some((first, rest)) = matrix.split_first() else { return Ok(Fraction::one()) };
    let mut sum = Fraction::zero();
    for (column, entry) in first.iter().enumerate() {
        if entry.is_zero() {
            continue;
        }
        let without = |row: &Vec<Fraction>| {
            row.iter().enumerate().filter(|(at, _)| *at != column).map(|(_, entry)| entry.clone()).collect()
        };
        let minor: Vec<Vec<Fraction>> = rest.iter().map(without).collect();
        let part = entry.times(&determinant(&minor)?)?;
        sum = if column % 2 == 0 { sum.plus(&part)? } else { sum.minus(&part)? };
    }
    Ok(sum)
}
