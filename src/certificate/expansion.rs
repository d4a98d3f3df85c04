//! Integer expressions, and lists that say `each`.

use std::ops::RangeInclusive;

use num_traits::ToPrimitive;

use super::error::StatementError;
use super::sexp::Sexp;

/// The integers that have a name at some place of a statement.
#[derive(Debug, Clone, Default)]
pub(super) struct Integers {
    known: Vec<(String, i64)>,
}

/// `NAME LO HI ITEM…`.
pub(super) struct Range<'a> {
    pub(super) name: &'a str,
    pub(super) values: RangeInclusive<i64>,
    pub(super) items: &'a [Sexp],
}

/// The largest number of items that one list may expand to.
const LARGEST: i64 = 100_000;

impl Integers {
    /// These, and one more.
    pub(super) fn with(&self, name: &str, value: i64) -> Self {
        let mut known = self.known.clone();
        known.push((name.to_owned(), value));
        Self { known }
    }

    /// The value of an integer expression.
    pub(super) fn value(&self, sexp: &Sexp) -> Result<i64, StatementError> {
        let not_an_integer = || StatementError::Integer(sexp.to_string());
        if let Sexp::Number(number) = sexp {
            let value = number.is_integer().then(|| number.numer().to_i64()).flatten();
            return value.ok_or_else(not_an_integer);
        }
        if let Sexp::Name(name) = sexp {
            let known = self.known.iter().rev().find(|(known, _)| known == name);
            return known.map(|(_, value)| *value).ok_or_else(not_an_integer);
        }
        let Some((head, items)) = sexp.as_form() else { return Err(not_an_integer()) };
        let values: Vec<i64> = items.iter().map(|item| self.value(item)).collect::<Result<_, _>>()?;
        let result = match (head, values.as_slice()) {
            ("+", [_, ..]) => values.iter().try_fold(0_i64, |sum, v| sum.checked_add(*v)),
            ("*", [_, ..]) => values.iter().try_fold(1_i64, |product, v| product.checked_mul(*v)),
            ("-", [a, b]) => a.checked_sub(*b),
            ("binomial", [n, k]) => binomial(*n, *k),
            _ => None,
        };
        result.ok_or_else(not_an_integer)
    }

    /// The text with every named integer in it replaced by its value.
    pub(super) fn worked_out(&self, sexp: &Sexp) -> Result<Sexp, StatementError> {
        Ok(match sexp {
            Sexp::Name(name) if self.known.iter().any(|(known, _)| known == name) => {
                Sexp::int(self.value(sexp)?)
            }
            Sexp::List(items) => {
                Sexp::List(items.iter().map(|item| self.worked_out(item)).collect::<Result<_, _>>()?)
            }
            other => other.clone(),
        })
    }

    /// The value of an integer expression that has to be ≥ 0.
    pub(super) fn natural(&self, sexp: &Sexp) -> Result<usize, StatementError> {
        let value = self.value(sexp)?;
        usize::try_from(value).map_err(|_| StatementError::Integer(sexp.to_string()))
    }

    /// Reads what stands in an `each`.
    pub(super) fn range<'a>(&self, items: &'a [Sexp]) -> Result<Option<Range<'a>>, StatementError> {
        let [Sexp::Name(name), low, high, rest @ ..] = items else { return Ok(None) };
        let (low, high) = (self.value(low)?, self.value(high)?);
        if high.saturating_sub(low) > LARGEST {
            return Err(StatementError::Range(name.clone()));
        }
        Ok(Some(Range { name, values: low..=high, items: rest }))
    }

    /// The items of a list, `each` unrolled, read by `read`.
    pub(super) fn items<T>(
        &self,
        items: &[Sexp],
        read: &dyn Fn(&Sexp, &Self) -> Result<T, StatementError>,
    ) -> Result<Vec<T>, StatementError> {
        let mut all = Vec::new();
        for item in items {
            match item.as_form() {
                Some(("each", each)) => {
                    let range = self.range(each)?;
                    let range = range.ok_or_else(|| StatementError::Form(item.to_string()))?;
                    for value in range.values {
                        all.extend(self.with(range.name, value).items(range.items, read)?);
                    }
                }
                _ => all.push(read(item, self)?),
            }
        }
        Ok(all)
    }
}

/// C(n, k), 0 for k outside of 0..=n; `None` if it is too large.
fn binomial(n: i64, k: i64) -> Option<i64> {
    if k < 0 || k > n {
        return (n >= 0).then_some(0);
    }
    (0..k).try_fold(1_i64, |c, i| Some(c.checked_mul(n - i)? / (i + 1)))
}
