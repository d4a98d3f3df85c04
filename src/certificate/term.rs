//! Terms and formulas with all integers worked out (`proofs/FORMAT.md`, "Terms" and "Formulas").

use crate::scalar::{BigRational, integer};

use super::error::StatementError;
use super::expansion::Integers;
use super::sexp::Sexp;

/// Where on a span a function is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Where {
    /// Every x of the open span, by its positive coordinate u.
    In,
    /// The first knot, as the limit from the right.
    From,
    /// The last knot, as the limit from the left.
    To,
}

/// A place on the span [t_s, t_{s+1}) of a window.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Between the knots, or at one of them.
    pub at: Where,
    /// The window's name.
    pub window: String,
    /// s.
    pub span: i64,
}

/// What is taken of the weight w_i^d.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfWeight {
    /// w itself.
    Weight,
    /// 1 − w.
    Complement,
    /// Its derivative.
    Derivative,
}

/// A term without integer variables.
#[derive(Debug, Clone, PartialEq)]
pub enum Term {
    /// A number.
    Number(BigRational),
    /// A parameter or an abbreviation, by its text.
    Named(String),
    /// A sum.
    Sum(Vec<Term>),
    /// The first minus the second.
    Difference(Box<Term>, Box<Term>),
    /// A product.
    Product(Vec<Term>),
    /// The first over the second.
    Ratio(Box<Term>, Box<Term>),
    /// A power.
    Power(Box<Term>, usize),
    /// The knot t_i of a window.
    Knot(String, i64),
    /// x at a place.
    Point(Place),
    /// w_i^d, 1 − w_i^d or Dw_i^d.
    Weight(OfWeight, i64, usize, Place),
    /// G_i^d, or a derivative of it.
    Function {
        /// Of the derivative by x; 0 for the function itself.
        order: usize,
        /// i.
        i: i64,
        /// d.
        degree: usize,
        /// Where.
        place: Place,
    },
    /// d_i^q of de Boor's algorithm for the given degree.
    DeBoor {
        /// i.
        i: i64,
        /// q.
        level: usize,
        /// The degree.
        degree: usize,
        /// Where.
        place: Place,
    },
    /// The term with parameters replaced.
    At(Vec<(String, Term)>, Box<Term>),
    /// The term for the member of the family that a reflection leads to: the window with the parameters that there were before, and
    /// the index of t_m there.
    Dual(String, i64, Box<Term>),
    /// A parameter of the family that belongs to a window, with its indices.
    Parameter(String, String, Vec<i64>),
    /// The determinant of these rows.
    Determinant(Vec<Vec<Term>>),
}

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// Both are the same.
    Equal(Term, Term),
    /// The first is greater.
    Greater(Term, Term),
    /// The first is at least the second.
    AtLeast(Term, Term),
    /// No denominator ever vanishes.
    Defined(Term),
    /// The order of G_i^d at the first knot of the span.
    Order {
        /// i.
        i: i64,
        /// d.
        degree: usize,
        /// (in W s).
        place: Place,
        /// The order.
        order: usize,
    },
    /// The term is no linear combination of the others.
    Outside(Place, Term, Vec<Term>),
    /// One of the functions has a pole there.
    Pole(Place, Vec<Term>, BigRational),
}

/// What a form was expected to look like.
fn shape<T>(sexp: &Sexp) -> Result<T, StatementError> {
    Err(StatementError::Form(sexp.to_string()))
}

pub(super) fn place(sexp: &Sexp, ints: &Integers) -> Result<Place, StatementError> {
    let at = match sexp.as_form() {
        Some(("in", _)) => Where::In,
        Some(("from", _)) => Where::From,
        Some(("to", _)) => Where::To,
        _ => return shape(sexp),
    };
    match sexp.as_form() {
        Some((_, [Sexp::Name(window), span])) => {
            Ok(Place { at, window: window.clone(), span: ints.value(span)? })
        }
        _ => shape(sexp),
    }
}

/// The text by which a parameter is known: `NAME` or `(NAME INT…)` with the integers worked out.
pub(super) fn parameter(sexp: &Sexp, ints: &Integers) -> Result<String, StatementError> {
    match (sexp, sexp.as_form()) {
        (Sexp::Name(name), _) => Ok(name.clone()),
        (_, Some((head, indices))) if !indices.is_empty() => {
            let indices: Result<Vec<_>, _> = indices.iter().map(|index| ints.value(index)).collect();
            let indices: Vec<_> = indices?.into_iter().map(Sexp::int).collect();
            Ok(Sexp::form(head, indices).to_string())
        }
        _ => shape(sexp),
    }
}

/// Reads a term.
pub(super) fn term(sexp: &Sexp, ints: &Integers) -> Result<Term, StatementError> {
    let boxed = |sexp: &Sexp| term(sexp, ints).map(Box::new);
    let all = |items: &[Sexp]| -> Result<Vec<Term>, StatementError> {
        let items = ints.items(items, &|item, ints| term(item, ints))?;
        if items.is_empty() { shape(sexp) } else { Ok(items) }
    };
    let natural = |sexp: &Sexp| ints.natural(sexp);
    let (head, items) = match sexp {
        Sexp::Number(value) => return Ok(Term::Number(value.clone())),
        Sexp::Name(name) => return Ok(Term::Named(name.clone())),
        _ => match sexp.as_form() {
            Some(form) => form,
            None => return shape(sexp),
        },
    };
    Ok(match (head, items) {
        ("+", items) => Term::Sum(all(items)?),
        ("*", items) => Term::Product(all(items)?),
        ("-", [a]) => {
            let minus_one = Term::Number(BigRational::from_integer((-1).into()));
            Term::Product(vec![minus_one, term(a, ints)?])
        }
        ("-", [a, b]) => Term::Difference(boxed(a)?, boxed(b)?),
        ("/", [a, b]) => Term::Ratio(boxed(a)?, boxed(b)?),
        ("^", [a, n]) => Term::Power(boxed(a)?, natural(n)?),
        ("integer", [n]) => Term::Number(BigRational::from_integer(ints.value(n)?.into())),
        ("t", [Sexp::Name(window), i]) => Term::Knot(window.clone(), ints.value(i)?),
        ("x", [p]) => Term::Point(place(p, ints)?),
        ("w" | "v" | "Dw", [i, d, p]) => {
            let of = match head {
                "w" => OfWeight::Weight,
                "v" => OfWeight::Complement,
                _ => OfWeight::Derivative,
            };
            Term::Weight(of, ints.value(i)?, natural(d)?, place(p, ints)?)
        }
        ("G" | "DG", [i, d, p]) => Term::Function {
            order: usize::from(head == "DG"),
            i: ints.value(i)?,
            degree: natural(d)?,
            place: place(p, ints)?,
        },
        ("DG", [i, d, p, order]) => Term::Function {
            order: natural(order)?,
            i: ints.value(i)?,
            degree: natural(d)?,
            place: place(p, ints)?,
        },
        ("de-boor", [i, q, k, p]) => Term::DeBoor {
            i: ints.value(i)?,
            level: natural(q)?,
            degree: natural(k)?,
            place: place(p, ints)?,
        },
        ("parameter", [Sexp::Name(window), Sexp::Name(name), indices @ ..]) => {
            let indices = indices.iter().map(|index| ints.value(index)).collect::<Result<_, _>>()?;
            Term::Parameter(window.clone(), name.clone(), indices)
        }
        ("at", [Sexp::List(pairs), body]) => {
            let pair = |pair: &Sexp| match pair {
                Sexp::List(items) => match items.as_slice() {
                    [Sexp::Name(name), value] => Ok((name.clone(), term(value, ints)?)),
                    _ => shape(pair),
                },
                _ => shape(pair),
            };
            let pairs: Result<Vec<_>, _> = pairs.iter().map(pair).collect();
            Term::At(pairs?, boxed(body)?)
        }
        ("det", rows) => {
            let row = |row: &Sexp| match row {
                Sexp::List(items) => items.iter().map(|item| term(item, ints)).collect(),
                _ => shape(row),
            };
            let rows: Vec<Vec<Term>> = rows.iter().map(row).collect::<Result<_, _>>()?;
            if rows.is_empty() || rows.iter().any(|row| row.len() != rows.len()) {
                return shape(sexp);
            }
            Term::Determinant(rows)
        }
        _ => Term::Named(parameter(sexp, ints)?),
    })
}

/// Reads a formula.
pub(super) fn formula(sexp: &Sexp, ints: &Integers) -> Result<Formula, StatementError> {
    let term = |sexp: &Sexp| term(sexp, ints);
    let terms = |items: &Sexp| match items {
        Sexp::List(items) if !items.is_empty() => items.iter().map(term).collect::<Result<Vec<_>, _>>(),
        _ => shape(sexp),
    };
    Ok(match sexp.as_form() {
        Some(("=", [a, b])) => Formula::Equal(term(a)?, term(b)?),
        Some((">", [a, b])) => Formula::Greater(term(a)?, term(b)?),
        Some(("<", [a, b])) => Formula::Greater(term(b)?, term(a)?),
        Some((">=", [a, b])) => Formula::AtLeast(term(a)?, term(b)?),
        Some(("defined", [a])) => Formula::Defined(term(a)?),
        Some(("order", [i, d, p, e])) => Formula::Order {
            i: ints.value(i)?,
            degree: ints.natural(d)?,
            place: place(p, ints)?,
            order: ints.natural(e)?,
        },
        Some(("outside", [p, f, others])) => Formula::Outside(place(p, ints)?, term(f)?, terms(others)?),
        Some(("pole", [p, functions, Sexp::Number(u)])) => {
            Formula::Pole(place(p, ints)?, terms(functions)?, u.clone())
        }
        _ => return shape(sexp),
    })
}

impl Term {
    /// Does it speak of a parameter, or of a window?
    pub(super) fn names(&self, name: &str) -> bool {
        let at = |place: &Place| place.window == name;
        match self {
            Self::Number(_) => false,
            Self::Named(own) => own == name,
            Self::Sum(all) | Self::Product(all) => all.iter().any(|term| term.names(name)),
            Self::Difference(a, b) | Self::Ratio(a, b) => a.names(name) || b.names(name),
            Self::Power(a, _) => a.names(name),
            Self::Knot(window, _) => window == name,
            Self::Point(place) | Self::Weight(_, _, _, place) => at(place),
            Self::Function { place, .. } | Self::DeBoor { place, .. } => at(place),
            Self::Parameter(window, ..) => window == name,
            Self::Dual(window, _, body) => window == name || body.names(name),
            Self::At(replaced, body) => {
                body.names(name) || replaced.iter().any(|(_, value)| value.names(name))
            }
            Self::Determinant(rows) => rows.iter().flatten().any(|term| term.names(name)),
        }
    }

    /// With every place inside of a span at an end of it.
    pub(super) fn at_end(&self, at: Where) -> Self {
        let list = |all: &[Self]| all.iter().map(|term| term.at_end(at)).collect();
        let both = |a: &Self, b: &Self| (Box::new(a.at_end(at)), Box::new(b.at_end(at)));
        let mut moved = self.clone();
        match &mut moved {
            Self::Point(place)
            | Self::Weight(_, _, _, place)
            | Self::Function { place, .. }
            | Self::DeBoor { place, .. } => {
                if place.at == Where::In {
                    place.at = at;
                }
            }
            Self::Sum(all) | Self::Product(all) => *all = list(all),
            Self::Difference(a, b) | Self::Ratio(a, b) => (*a, *b) = both(a, b),
            Self::Power(a, _) | Self::At(_, a) | Self::Dual(_, _, a) => **a = a.at_end(at),
            Self::Determinant(rows) => rows.iter_mut().for_each(|row| *row = list(row)),
            Self::Number(_) | Self::Named(_) | Self::Knot(..) | Self::Parameter(..) => {}
        }
        moved
    }

    /// Is u something else in a part of it, and not only 1/u?
    pub(super) fn moves_u(&self) -> bool {
        let inverse = Self::Ratio(Box::new(Self::Number(integer(1))), Box::new(Self::Named("u".into())));
        match self {
            Self::At(replaced, body) => {
                replaced.iter().any(|(name, value)| name == "u" && *value != inverse) || body.moves_u()
            }
            Self::Sum(all) | Self::Product(all) => all.iter().any(Self::moves_u),
            Self::Difference(a, b) | Self::Ratio(a, b) => a.moves_u() || b.moves_u(),
            Self::Power(a, _) => a.moves_u(),
            Self::Determinant(rows) => rows.iter().flatten().any(Self::moves_u),
            _ => false,
        }
    }
}

impl Formula {
    /// Does it speak of a parameter, or of a window?
    pub(super) fn names(&self, name: &str) -> bool {
        match self {
            Self::Equal(a, b) | Self::Greater(a, b) | Self::AtLeast(a, b) => a.names(name) || b.names(name),
            Self::Defined(a) => a.names(name),
            Self::Order { place, .. } => place.window == name,
            Self::Outside(_, a, others) => a.names(name) || others.iter().any(|term| term.names(name)),
            Self::Pole(_, all, _) => all.iter().any(|term| term.names(name)),
        }
    }
}

/// `NAME`, or `(NAME INT…)`, as a parameter is known.
fn named(name: &str) -> Sexp {
    match name.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        None => Sexp::name(name),
        Some(inside) => {
            let mut parts = inside.split(' ');
            let head = Sexp::name(parts.next().unwrap_or_default());
            let numbers = parts.filter_map(|part| part.parse().ok()).map(Sexp::int);
            Sexp::List(std::iter::once(head).chain(numbers).collect())
        }
    }
}

fn natural(value: usize) -> Sexp {
    Sexp::Number(BigRational::from_integer(value.into()))
}

impl Place {
    fn to_sexp(&self) -> Sexp {
        let head = match self.at {
            Where::In => "in",
            Where::From => "from",
            Where::To => "to",
        };
        Sexp::form(head, [Sexp::name(&self.window), Sexp::int(self.span)])
    }
}

impl Term {
    /// As the language writes it.
    pub(super) fn to_sexp(&self) -> Sexp {
        let all = |terms: &[Self]| terms.iter().map(Self::to_sexp).collect::<Vec<_>>();
        match self {
            Self::Number(value) => Sexp::Number(value.clone()),
            Self::Named(name) => named(name),
            Self::Sum(terms) => Sexp::form("+", all(terms)),
            Self::Product(terms) => Sexp::form("*", all(terms)),
            Self::Difference(a, b) => Sexp::form("-", [a.to_sexp(), b.to_sexp()]),
            Self::Ratio(a, b) => Sexp::form("/", [a.to_sexp(), b.to_sexp()]),
            Self::Power(a, n) => Sexp::form("^", [a.to_sexp(), natural(*n)]),
            Self::Knot(window, i) => Sexp::form("t", [Sexp::name(window), Sexp::int(*i)]),
            Self::Point(place) => Sexp::form("x", [place.to_sexp()]),
            Self::Weight(of, i, d, place) => {
                let head = match of {
                    OfWeight::Weight => "w",
                    OfWeight::Complement => "v",
                    OfWeight::Derivative => "Dw",
                };
                Sexp::form(head, [Sexp::int(*i), natural(*d), place.to_sexp()])
            }
            Self::Function { order, i, degree, place } => {
                let head = if *order == 0 { "G" } else { "DG" };
                let further = (*order > 1).then(|| natural(*order));
                let fields = [Sexp::int(*i), natural(*degree), place.to_sexp()];
                Sexp::form(head, fields.into_iter().chain(further))
            }
            Self::DeBoor { i, level, degree, place } => {
                let parts = [Sexp::int(*i), natural(*level), natural(*degree), place.to_sexp()];
                Sexp::form("de-boor", parts)
            }
            Self::At(pairs, body) => {
                let pair =
                    |(name, value): &(String, Self)| Sexp::List(vec![Sexp::name(name), value.to_sexp()]);
                Sexp::form("at", [Sexp::List(pairs.iter().map(pair).collect()), body.to_sexp()])
            }
            Self::Dual(window, m, body) => {
                let dual = Sexp::form("dual", [Sexp::name(window), Sexp::int(*m)]);
                Sexp::form("at", [Sexp::List(vec![dual]), body.to_sexp()])
            }
            Self::Parameter(window, name, indices) => {
                let head = [Sexp::name(window), Sexp::name(name)];
                Sexp::form("parameter", head.into_iter().chain(indices.iter().copied().map(Sexp::int)))
            }
            Self::Determinant(rows) => Sexp::form("det", rows.iter().map(|row| Sexp::List(all(row)))),
        }
    }
}

impl Formula {
    /// As the language writes it.
    pub(super) fn to_sexp(&self) -> Sexp {
        let two = |head, a: &Term, b: &Term| Sexp::form(head, [a.to_sexp(), b.to_sexp()]);
        let list = |terms: &[Term]| Sexp::List(terms.iter().map(Term::to_sexp).collect());
        match self {
            Self::Equal(a, b) => two("=", a, b),
            Self::Greater(a, b) => two(">", a, b),
            Self::AtLeast(a, b) => two(">=", a, b),
            Self::Defined(a) => Sexp::form("defined", [a.to_sexp()]),
            Self::Order { i, degree, place, order } => {
                Sexp::form("order", [Sexp::int(*i), natural(*degree), place.to_sexp(), natural(*order)])
            }
            Self::Outside(place, term, others) => {
                Sexp::form("outside", [place.to_sexp(), term.to_sexp(), list(others)])
            }
            Self::Pole(place, all, u) => {
                Sexp::form("pole", [place.to_sexp(), list(all), Sexp::Number(u.clone())])
            }
        }
    }
}

/// A parameter, as it is declared.
pub(super) fn declared(name: &str) -> Sexp {
    named(name)
}
