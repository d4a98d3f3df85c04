//! One expanded section: its parameters as variables with signs, its abbreviations and knot vectors.

use std::collections::BTreeMap;
use std::rc::Rc;

use dashu_int::IBig;

use crate::error::Reason;
use crate::fraction::Fraction;
use crate::integer::{Item, Scope};
use crate::number::{Ratio, multiply};
use crate::poly::{Poly, Sign};
use crate::syntax::{GapText, Knots, Parameter, SectionText, Term};
use crate::terms::{Evaluator, Mode};

/// The variable of `u`; `r` is the next one.
pub(crate) const U: usize = 0;
const R: usize = 1;

/// What is declared: the same for all formulas of the section.
pub(crate) struct Section<'a> {
    pub(crate) scope: Scope,
    pub(crate) signs: Vec<Sign>,
    variables: BTreeMap<(String, Vec<i64>), usize>,
    lets: &'a [(String, Term)],
    windows: Vec<Declared<'a>>,
}

struct Declared<'a> {
    name: String,
    first: i64,
    gaps: Vec<Gap<'a>>,
}

enum Gap<'a> {
    Variable(usize),
    Term(&'a Term, Scope),
    Number(Ratio),
}

/// What the names stand for. `at` changes `u` and `r` and nothing else.
#[derive(Clone)]
pub(crate) struct Values {
    pub(crate) u: Fraction,
    pub(crate) r: Fraction,
    lets: Rc<BTreeMap<String, Fraction>>,
    windows: Rc<Vec<Window>>,
    /// One for all windows, so that equal weights in two windows are the same polynomials.
    pub(crate) scale: IBig,
}

/// The known part of a knot vector.
#[derive(Clone)]
pub(crate) struct Window {
    pub(crate) name: String,
    first: i64,
    /// Measured from the first one, times the scale.
    knots: Vec<Poly>,
}

impl Window {
    pub(crate) fn knot(&self, index: i64) -> Result<&Poly, Reason> {
        let outside = || Reason::NotDetermined(self.name.clone(), index);
        usize::try_from(index - self.first).ok().and_then(|at| self.knots.get(at)).ok_or_else(outside)
    }
}

impl<'a> Section<'a> {
    /// Reads the declarations, with the integers that `scope` has.
    pub(crate) fn new(text: &'a SectionText, scope: Scope) -> Result<Self, Reason> {
        let (signs, variables) = (Vec::new(), BTreeMap::new());
        let mut section = Section { scope, signs, variables, lets: &text.lets, windows: Vec::new() };
        for name in ["u", "r"] {
            section.scope.take(name)?;
            section.variable(name.to_owned(), Vec::new(), Sign::Positive)?;
        }
        section.parameters(&text.real, Sign::Real)?;
        section.parameters(&text.nonnegative, Sign::Nonnegative)?;
        section.parameters(&text.positive, Sign::Positive)?;
        for (name, _) in &text.lets {
            // r is there already, and gets another value.
            if name != "r" {
                section.scope.take(name)?;
            }
        }
        for window in &text.windows {
            section.scope.take(&window.name)?;
            let first = section.scope.value(&window.first)?;
            let gaps = section.gaps(&window.name, first, &window.knots)?;
            section.windows.push(Declared { name: window.name.clone(), first, gaps });
        }
        Ok(section)
    }

    fn variable(&mut self, name: String, indices: Vec<i64>, sign: Sign) -> Result<usize, Reason> {
        let index = self.signs.len();
        self.signs.push(sign);
        match self.variables.insert((name.clone(), indices), index) {
            None => Ok(index),
            Some(_) => Err(Reason::Taken(name)),
        }
    }

    fn parameters(&mut self, list: &[Item<Parameter>], sign: Sign) -> Result<(), Reason> {
        let mut found = Vec::new();
        self.scope.expand(list, &mut |Parameter(name, indices), scope| {
            let indices = indices.iter().map(|index| scope.value(index)).collect::<Result<Vec<_>, _>>()?;
            found.push((name.clone(), indices));
            Ok(())
        })?;
        for (name, indices) in found {
            // An indexed name may come back with other indices, but not as the name of something else.
            let again = !indices.is_empty()
                && self.variables.keys().any(|(known, i)| *known == name && !i.is_empty());
            if !again {
                self.scope.take(&name)?;
            }
            if matches!(name.as_str(), "any" | "some") {
                return Err(Reason::Taken(name));
            }
            self.variable(name, indices, sign)?;
        }
        Ok(())
    }

    fn gaps(&mut self, name: &str, first: i64, knots: &'a Knots) -> Result<Vec<Gap<'a>>, Reason> {
        let mut gaps = Vec::new();
        match knots {
            Knots::Numbers(numbers) => {
                for (left, right) in numbers.iter().zip(numbers.iter().skip(1)) {
                    let gap = right.minus(left)?;
                    if !gap.is_positive() && !gap.is_zero() {
                        return Err(Reason::Falling(name.to_owned()));
                    }
                    gaps.push(Gap::Number(gap));
                }
            }
            Knots::Gaps(items) => {
                let mut found = Vec::new();
                self.scope.expand(items, &mut |gap, scope| {
                    found.push((gap, scope.clone()));
                    Ok(())
                })?;
                for (index, (gap, scope)) in (first..).zip(found) {
                    gaps.push(match gap {
                        GapText::Term(term) => Gap::Term(term, scope),
                        GapText::Any => {
                            Gap::Variable(self.variable(name.to_owned(), vec![index], Sign::Nonnegative)?)
                        }
                        GapText::Some => {
                            Gap::Variable(self.variable(name.to_owned(), vec![index], Sign::Positive)?)
                        }
                    });
                }
            }
        }
        Ok(gaps)
    }

    /// The variable of a parameter.
    pub(crate) fn find(&self, Parameter(name, indices): &Parameter, scope: &Scope) -> Result<usize, Reason> {
        let indices = indices.iter().map(|index| scope.value(index)).collect::<Result<Vec<_>, _>>()?;
        self.index(name, indices)
    }

    pub(crate) fn index(&self, name: &str, indices: Vec<i64>) -> Result<usize, Reason> {
        let key = (name.to_owned(), indices);
        self.variables.get(&key).copied().ok_or(Reason::Unknown(key.0))
    }

    /// What the abbreviations and windows are.
    pub(crate) fn values(&self) -> Result<Values, Reason> {
        let mut evaluator = Evaluator::new(self, Mode::default());
        let mut values = Values {
            u: Poly::variable(U).into(),
            r: Poly::variable(R).into(),
            lets: Rc::default(),
            windows: Rc::default(),
            scale: IBig::ONE,
        };
        for (name, term) in self.lets {
            let value = evaluator.term(term, &mut self.scope.clone(), &values)?;
            if name == "r" {
                values.r = value.positive(name, &self.signs)?;
            } else {
                Rc::make_mut(&mut values.lets).insert(name.clone(), value);
            }
        }
        for Declared { name, first, gaps } in &self.windows {
            let mut knots = vec![Poly::zero()];
            for (index, gap) in (*first..).zip(gaps) {
                let size = match gap {
                    Gap::Variable(variable) => Poly::variable(*variable).into(),
                    Gap::Number(number) => Fraction::number(number),
                    Gap::Term(term, scope) => evaluator.term(term, &mut scope.clone(), &values)?,
                };
                let bad = || Reason::Gap(name.clone(), index);
                // u moves the place in a knot vector that stays.
                if size.sign(&self.signs) == Sign::Real || size.num.mentions(U) {
                    return Err(bad());
                }
                let den = size.denominator()?.as_constant().ok_or_else(bad)?;
                if &values.scale % &den != IBig::ZERO {
                    values.rescale(&den, &mut knots)?;
                }
                let last = knots.last().cloned().unwrap_or_default();
                knots.push(last.plus(&size.num.scaled(&(&values.scale / &den))?));
            }
            Rc::make_mut(&mut values.windows).push(Window { name: name.clone(), first: *first, knots });
        }
        Ok(values)
    }

    /// What a name without an index stands for.
    pub(crate) fn name(&self, name: &str, values: &Values) -> Result<Fraction, Reason> {
        match (name, values.lets.get(name)) {
            ("u", _) => Ok(values.u.clone()),
            ("r", _) => Ok(values.r.clone()),
            (_, Some(value)) => Ok(value.clone()),
            (_, None) => Ok(Poly::variable(self.index(name, Vec::new())?).into()),
        }
    }
}

impl Values {
    pub(crate) fn window(&self, name: &str) -> Result<&Window, Reason> {
        self.windows.iter().find(|window| window.name == name).ok_or_else(|| Reason::Unknown(name.to_owned()))
    }

    /// What `at` may replace.
    pub(crate) fn replaceable(&mut self, name: &str) -> Result<&mut Fraction, Reason> {
        match name {
            "u" => Ok(&mut self.u),
            "r" => Ok(&mut self.r),
            _ => Err(Reason::Fixed(name.to_owned())),
        }
    }

    fn rescale(&mut self, by: &IBig, unfinished: &mut [Poly]) -> Result<(), Reason> {
        self.scale = multiply(&self.scale, by)?;
        let finished = Rc::make_mut(&mut self.windows).iter_mut().flat_map(|window| window.knots.iter_mut());
        for knot in finished.chain(unfinished) {
            *knot = knot.scaled(by)?;
        }
        Ok(())
    }
}
