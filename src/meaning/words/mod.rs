//! The deciders of words, one file a family of them. They know no claim.

mod curve;
mod free_weights;
mod linear;
mod regular;
mod shape;
mod spaces;
mod supremum;
mod trace;

use crate::analysis::Tie;
use crate::language::{Function, Int, Interval, Item, Member, Name, Real, Use, Word};

use super::reading::Reading;
use super::truth::{Stop, Truth};
use super::value::Value;

pub(super) use supremum::chain as chain_of_suprema;

/// What a word gives.
enum Said {
    Count(usize),
    Measure(Value),
    Truth(bool),
}

/// A function with the member of the family that it is taken for.
type OfMember<'a> = (&'a Function, Option<&'a Member>);
/// A term with its variable and an interval.
type Expression<'a> = (&'a Real, &'a Name, Option<&'a Interval>);

/// The one decider of each word.
fn say(own: &mut Reading<'_>, of: &Use) -> Result<Said, Stop> {
    let said = Of(of);
    Ok(match of.word {
        Word::Multiplicity => Said::Count(shape::multiplicity(own, said.real(0)?)?),
        Word::Maxima => Said::Count(shape::maxima(own, said.function(0)?)?),
        Word::Minima => Said::Count(shape::minima(own, said.function(0)?)?),
        Word::Maximisers => Said::Count(shape::maximisers(own, said.function(0)?)?),
        Word::Tied => Said::Truth(shape::tie(own, said.function(0)?)?.is_some()),
        Word::Continuous => Said::Truth(shape::continuous(own, said.function(0)?)?),
        Word::Changes => Said::Count(trace::changes(own, said.expression(0)?)?),
        Word::PolygonChanges => Said::Count(trace::polygon_changes(own, said.coefficients(0)?)?),
        Word::Rank => Said::Count(linear::rank_of(own, said.int(0)?)?),
        Word::Combination => Said::Truth(linear::combination(own, said.expression(0)?, said.int(1)?)?),
        Word::Defined => Said::Truth(regular::defined(own, said.real(0)?)?),
        Word::Rational => Said::Truth(regular::rational(own, said.expression(0)?)?),
        Word::Smooth => Said::Truth(regular::smooth(own, said.expression(0)?)?),
        Word::Stop => Said::Measure(shape::stop(own, said.int(0)?)?.into()),
        Word::Stops => Said::Count(own.knots()?.stop_knots().count()),
        Word::Supremum => Said::Measure(supremum::supremum(own, said.expression(0)?)?),
        Word::Strays => Said::Truth(curve::strays(own, said.plane()?, said.real(2)?)?),
        Word::ImplicitDegree => Said::Count(curve::implicit_degree(own, said.plane()?, said.int(2)?)?),
        Word::Valleys => Said::Count(trace::valleys(own, said.expression(0)?)?),
        Word::TotallyPositive => Said::Truth(spaces::totally_positive(own, said.int(0)?)?),
        Word::Nested => Said::Truth(spaces::nested(own, said.real(0)?)?),
        Word::Elevated => Said::Truth(spaces::elevated(own, said.int(0)?)?),
        Word::NurbsDegree => Said::Count(spaces::nurbs_degree(own, said.int(0)?)?),
        Word::FreeWeights => Said::Truth(free_weights::holds(own, said.int(0)?)?),
    })
}

/// What a word is said of, by place: a wrong sort, which `resolve` refuses, stops.
struct Of<'a>(&'a Use);

impl<'a> Of<'a> {
    fn item<T>(&self, at: usize, sort: impl FnOnce(&'a Item) -> Option<T>) -> Result<T, Stop> {
        let misused = || Stop::Unknown(format!("{} can't be said of this", self.0.word.name()));
        self.0.of.get(at).and_then(sort).ok_or_else(misused)
    }
    fn function(&self, at: usize) -> Result<OfMember<'a>, Stop> {
        self.item(
            at,
            |item| if let Item::Function(f, member) = item { Some((f, member.as_ref())) } else { None },
        )
    }
    /// The coordinates of a plane curve.
    fn plane(&self) -> Result<[OfMember<'a>; 2], Stop> {
        Ok([self.function(0)?, self.function(1)?])
    }
    fn expression(&self, at: usize) -> Result<Expression<'a>, Stop> {
        self.item(at, |item| match item {
            Item::Expression(t, name, interval) => Some((t, name, interval.as_ref())),
            _ => None,
        })
    }
    fn coefficients(&self, at: usize) -> Result<&'a Name, Stop> {
        self.item(at, |item| if let Item::Coefficients(name) = item { Some(name) } else { None })
    }
    fn real(&self, at: usize) -> Result<&'a Real, Stop> {
        self.item(at, |item| if let Item::Real(x) = item { Some(x) } else { None })
    }
    fn int(&self, at: usize) -> Result<&'a Int, Stop> {
        self.item(at, |item| if let Item::Int(i) = item { Some(i) } else { None })
    }
}

fn misplaced<T>(of: &Use) -> Result<T, Stop> {
    Err(Stop::Unknown(format!("{} in a place of another sort", of.word.name())))
}

/// What makes the word `tied` true.
pub fn tie(own: &mut Reading<'_>, of: &Use) -> Option<Tie> {
    let about = Of(of).function(0).ok().filter(|_| of.word == Word::Tied)?;
    shape::tie(own, about).ok()?
}

/// A word that counts.
pub(super) fn count(own: &mut Reading<'_>, of: &Use) -> Result<i64, Stop> {
    let Said::Count(count) = say(own, of)? else { return misplaced(of) };
    i64::try_from(count).map_err(|_| Stop::Unknown("a count that is too large".into()))
}

/// A word that is true or false.
pub(super) fn holds(own: &mut Reading<'_>, of: &Use) -> Truth {
    match say(own, of) {
        Ok(Said::Truth(truth)) => truth.into(),
        Ok(Said::Count(_) | Said::Measure(_)) => misplaced::<bool>(of).into(),
        Err(stop) => stop.into(),
    }
}

/// A word that measures, or counts.
pub(super) fn measure(own: &mut Reading<'_>, of: &Use) -> Result<Value, Stop> {
    if let Said::Measure(value) = say(own, of)? { Ok(value) } else { misplaced(of) }
}
