//! Integer expressions, the names of integers, and the expansion of `each`.

use std::collections::BTreeSet;

use crate::error::Reason;

/// No integer of a certificate is larger: indices and degrees are small, and nothing can overflow.
const LARGEST: i64 = 1_000_000;
/// One section runs through its `each` so often at most.
const STEPS: usize = 1_000_000;

pub(crate) enum Int {
    Number(i64),
    Name(String),
    Sum(Vec<Int>),
    Product(Vec<Int>),
    Difference(Box<Int>, Box<Int>),
    Binomial(Box<Int>, Box<Int>),
}

/// An element of a list, or a part of the list that is repeated.
pub(crate) enum Item<T> {
    One(T),
    Each(String, Int, Int, Vec<Item<T>>),
}

/// The integers that have names here, and all names that mean something else already.
#[derive(Clone, Default)]
pub(crate) struct Scope {
    integers: Vec<(String, i64)>,
    taken: BTreeSet<String>,
    steps: usize,
}

impl Scope {
    pub(crate) fn take(&mut self, name: &str) -> Result<(), Reason> {
        if self.taken.insert(name.to_owned()) { Ok(()) } else { Err(Reason::Taken(name.to_owned())) }
    }

    pub(crate) fn push(&mut self, name: &str, value: i64) -> Result<(), Reason> {
        self.take(name)?;
        self.integers.push((name.to_owned(), value));
        Ok(())
    }

    /// The integer `k`.
    pub(crate) fn push_degree(&mut self, degree: usize) -> Result<(), Reason> {
        self.push("k", i64::try_from(degree).map_err(|_| Reason::TooLarge("a degree"))?)
    }

    pub(crate) fn pop(&mut self) {
        if let Some((name, _)) = self.integers.pop() {
            self.taken.remove(&name);
        }
    }

    pub(crate) fn step(&mut self) -> Result<(), Reason> {
        self.steps += 1;
        if self.steps > STEPS { Err(Reason::TooLarge("the expansion")) } else { Ok(()) }
    }

    pub(crate) fn value(&self, int: &Int) -> Result<i64, Reason> {
        let value = match int {
            Int::Number(number) => Some(*number),
            Int::Name(name) => match self.integers.iter().find(|(known, _)| known == name) {
                Some((_, value)) => Some(*value),
                None => return Err(Reason::Unknown(name.clone())),
            },
            Int::Sum(parts) => Some(parts.iter().try_fold(0, |sum, part| small(sum + self.value(part)?))?),
            Int::Product(parts) => {
                Some(parts.iter().try_fold(1, |all, part| small(all * self.value(part)?))?)
            }
            Int::Difference(a, b) => Some(self.value(a)? - self.value(b)?),
            Int::Binomial(n, m) => binomial(self.value(n)?, self.value(m)?)?,
        };
        small(value.unwrap_or(LARGEST + 1))
    }

    /// Calls `visit` for the elements of the list, with the integers that each of them sees.
    pub(crate) fn expand<'t, T>(
        &mut self,
        items: &'t [Item<T>],
        visit: &mut dyn FnMut(&'t T, &mut Scope) -> Result<(), Reason>,
    ) -> Result<(), Reason> {
        for item in items {
            self.step()?;
            match item {
                Item::One(one) => visit(one, self)?,
                Item::Each(name, low, high, inside) => {
                    let (low, high) = (self.value(low)?, self.value(high)?);
                    for value in low..=high {
                        self.step()?;
                        self.push(name, value)?;
                        self.expand(inside, visit)?;
                        self.pop();
                    }
                }
            }
        }
        Ok(())
    }
}

/// Two integers in the limits have a product that fits, so it is enough to look after every step.
fn small(value: i64) -> Result<i64, Reason> {
    if (-LARGEST..=LARGEST).contains(&value) { Ok(value) } else { Err(Reason::TooLarge("an integer")) }
}

/// The number of choices of m among n ≥ 0; 0 for m < 0 and for m > n. None if it is too large.
fn binomial(n: i64, m: i64) -> Result<Option<i64>, Reason> {
    if n < 0 {
        return Err(Reason::Binomial);
    }
    if m < 0 || m > n {
        return Ok(Some(0));
    }
    let mut value = 1_i64;
    for step in 1..=m.min(n - m) {
        // Every partial product is a binomial coefficient: the division leaves no rest.
        value = value * (n - step + 1) / step;
        if value > LARGEST {
            return Ok(None);
        }
    }
    Ok(Some(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn binomials_are_pascals() {
        for n in 0..12 {
            for m in -1..=n + 1 {
                let sum = binomial(n, m).unwrap().unwrap() + binomial(n, m + 1).unwrap().unwrap();
                assert_eq!(binomial(n + 1, m + 1), Ok(Some(sum)), "{n} {m}");
            }
        }
        assert_eq!(binomial(4, 2), Ok(Some(6)));
        assert_eq!(binomial(1_000_000, 500_000), Ok(None));
        assert_eq!(binomial(-1, 0), Err(Reason::Binomial));
    }

    #[test]
    fn lists_expand_in_rising_order_and_names_do_not_hide_each_other() {
        let each = |name: &str, low, high, inside| Item::Each(name.into(), low, high, inside);
        let number = Int::Number;
        let inner = each("j", Int::Name("i".into()), number(2), vec![Item::One(())]);
        let list = [
            Item::One(()),
            each("i", number(0), number(2), vec![inner]),
            each("i", number(1), number(0), vec![]),
        ];
        let (mut scope, mut seen) = (Scope::default(), Vec::new());
        let sum =
            Int::Sum(vec![Int::Product(vec![Int::Name("i".into()), number(10)]), Int::Name("j".into())]);
        scope
            .expand(&list, &mut |(), scope| {
                seen.push(scope.value(&sum).ok());
                Ok(())
            })
            .unwrap();
        assert_eq!(seen, [None, Some(0), Some(1), Some(2), Some(11), Some(12), Some(22)]);
        let hiding =
            [each("i", number(0), number(0), vec![each("i", number(0), number(0), vec![Item::One(())])])];
        assert_eq!(scope.expand(&hiding, &mut |(), _| Ok(())), Err(Reason::Taken("i".into())));
    }

    #[test]
    fn large_integers_and_endless_lists_are_given_up_on() {
        let mut scope = Scope::default();
        let large = || Int::Number(LARGEST);
        assert!(scope.value(&Int::Product(vec![large(), large()])).is_err());
        assert!(scope.value(&Int::Difference(Box::new(Int::Number(-1)), Box::new(large()))).is_err());
        let inner = Item::Each("j".into(), Int::Number(0), large(), vec![Item::One(())]);
        let outer = [Item::Each("i".into(), Int::Number(0), large(), vec![inner])];
        assert_eq!(scope.expand(&outer, &mut |(), _| Ok(())), Err(Reason::TooLarge("the expansion")));
    }
}
