//! Members of families: parameters as numbers, and the weights that these give on knots.

use std::collections::hash_map::DefaultHasher;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use thiserror::Error;

use crate::analysis::sign_pattern;
use crate::language::{Family, Function, Int, Name, Parameter, Pattern, Real};
use crate::scalar::{BigRational, Polynomial, RationalAlgebra, RationalFunction, Ring, integer};
use crate::spline::{AnyWeights, FormTable, Forms, Index, KnotVector};

use super::adjectives::has;
use super::truth::Stop;
use super::value::combined;

/// Which weights the recursion has: those of an index, for which there are fast kernels, or of a member of another family.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Weighting {
    /// α.
    Index(Index),
    /// Parameters of a family.
    Family(Arc<FamilyMember>),
}

/// The numbers of a parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Values {
    /// Without an index.
    One(BigRational),
    /// By i from 0, or by d from 1.
    List(Vec<BigRational>),
    /// By i and d: a row for each d from 1, in it a number for each i from 0.
    Rows(Vec<Vec<BigRational>>),
}

/// A family with numbers for its parameters.
#[derive(Debug)]
pub struct FamilyMember {
    family: Arc<Family>,
    /// In the order of the family.
    values: Vec<Values>,
    /// Comparing all numbers costs much more.
    fingerprint: u64,
}

impl PartialEq for FamilyMember {
    fn eq(&self, other: &Self) -> bool {
        self.fingerprint == other.fingerprint && self.family == other.family && self.values == other.values
    }
}

impl Eq for FamilyMember {}

impl Hash for FamilyMember {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.fingerprint.hash(state);
    }
}

/// Why numbers are no parameters of a family, or give no weights on some knots.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum MemberError {
    /// A name that the family does not have.
    #[error("the family {family} has no `{name}`: it has {has}")]
    Unknown {
        /// The family.
        family: String,
        /// What was given.
        name: String,
        /// Its parameters.
        has: String,
    },
    /// A parameter without a number.
    #[error("the family {family} needs `{head}`: give it, such as --set {example}")]
    Missing {
        /// The family.
        family: String,
        /// The parameter.
        head: String,
        /// How it is given.
        example: String,
    },
    /// One number for a list, or the like.
    #[error("`{head}` of the family {family} is {kind}: write --set {example}")]
    Kind {
        /// The family.
        family: String,
        /// The parameter.
        head: String,
        /// What it has to be.
        kind: &'static str,
        /// How it is given.
        example: String,
    },
    /// A number out of bounds.
    #[error("`{head}` of the family {family} can't be {value}: {says}")]
    Bound {
        /// The family.
        family: String,
        /// The parameter.
        head: String,
        /// The number.
        value: BigRational,
        /// What it has to satisfy.
        says: String,
    },
    /// A number from which a parameter can't be computed.
    #[error("`{head}` can't be read from {name} = {value}: {why}")]
    Read {
        /// The parameter.
        head: String,
        /// What was given.
        name: String,
        /// Its value.
        value: BigRational,
        /// What goes wrong.
        why: String,
    },
    /// The family is for other knots.
    #[error("the family {family} is for knots that are {knots}")]
    Knots {
        /// The family.
        family: String,
        /// The adjectives.
        knots: String,
    },
    /// A weight that has no value.
    #[error("the weight w[{i},{d}] of the family {family} on [t_{j}, t_{}]: {why}", j + 1)]
    Weight {
        /// The family.
        family: String,
        /// i.
        i: usize,
        /// d.
        d: usize,
        /// The span.
        j: usize,
        /// What is wrong.
        why: String,
    },
}

/// `omega=1,2,1/2`, `q=1/3`, `rho=1,2;3`.
#[must_use]
pub fn setting(parameter: &Parameter) -> String {
    let example = match parameter.indices.as_slice() {
        [] => "1/3",
        [_] => "1,2,1/2",
        _ => "\"1,2,1/2;1,3\"",
    };
    format!("{}={example}", parameter.name)
}

impl Values {
    /// All numbers.
    pub fn all(&self) -> impl Iterator<Item = &BigRational> {
        let (one, lists): (Option<&BigRational>, &[Vec<BigRational>]) = match self {
            Self::One(value) => (Some(value), &[]),
            Self::List(list) => (None, std::slice::from_ref(list)),
            Self::Rows(rows) => (None, rows),
        };
        one.into_iter().chain(lists.iter().flatten())
    }

    /// Rows of numbers in the shape of what a family calls so: a parameter, or what one is read from.
    #[must_use]
    pub fn shaped(mut rows: Vec<Vec<BigRational>>, family: &Family, name: &str) -> Self {
        let of = |name: &str| family.parameters.iter().find(|own| *own.name == *name);
        let read = || {
            let (_, of_read) = family.reads.iter().find(|(other, _)| **other == *name)?;
            of(&of_read.first()?.0)
        };
        let indices = of(name).or_else(read).map_or(0, |own| own.indices.len());
        match (indices, rows.as_mut_slice()) {
            (2, _) | (_, [] | [_, _, ..]) => Self::Rows(rows),
            (0, [row]) if row.len() == 1 => Self::One(row.swap_remove(0)),
            (_, [row]) => Self::List(std::mem::take(row)),
        }
    }

    /// As behind `--set NAME=`, each number in a notation.
    #[must_use]
    pub fn written(&self, number: impl Fn(&BigRational) -> String) -> String {
        let list = |list: &[BigRational]| list.iter().map(&number).collect::<Vec<_>>().join(",");
        match self {
            Self::One(value) => number(value),
            Self::List(values) => list(values),
            Self::Rows(rows) => rows.iter().map(|row| list(row)).collect::<Vec<_>>().join(";"),
        }
    }

    fn map<E>(&self, mut f: impl FnMut(&BigRational) -> Result<BigRational, E>) -> Result<Self, E> {
        Ok(match self {
            Self::One(value) => Self::One(f(value)?),
            Self::List(list) => Self::List(list.iter().map(f).collect::<Result<_, _>>()?),
            Self::Rows(rows) => Self::Rows(
                rows.iter()
                    .map(|row| row.iter().map(&mut f).collect::<Result<_, _>>())
                    .collect::<Result<_, _>>()?,
            ),
        })
    }

    fn fits(&self, parameter: &Parameter) -> bool {
        matches!((self, parameter.indices.len()), (Self::One(_), 0) | (Self::List(_), 1) | (Self::Rows(_), 2))
    }
}

/// As it is written behind `--set NAME=`.
impl fmt::Display for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written(ToString::to_string))
    }
}

impl Weighting {
    /// The member with these numbers, under the names of its parameters or of what the family reads.
    ///
    /// # Errors
    /// [`MemberError`]: a name, a number or a shape that the family does not have.
    pub fn of(family: &Arc<Family>, given: &[(String, Values)]) -> Result<Self, MemberError> {
        let mut values: Vec<Option<Values>> = vec![None; family.parameters.len()];
        for (name, value) in given {
            let place = family.parameters.iter().position(|own| *own.name == **name);
            if let Some(place) = place {
                values[place] = Some(value.clone());
                continue;
            }
            let read = family.reads.iter().find(|(other, _)| **other == **name);
            let unknown = || MemberError::Unknown {
                family: family.name.clone(),
                name: name.clone(),
                has: heads(family),
            };
            for (own, term) in &read.ok_or_else(unknown)?.1 {
                let Some(place) = family.parameters.iter().position(|other| other.name == *own) else {
                    continue;
                };
                let number = |number: &BigRational| {
                    let head = family.parameters[place].head();
                    let error = |why| MemberError::Read {
                        head: head.clone(),
                        name: name.clone(),
                        value: number.clone(),
                        why,
                    };
                    let mut terms = Terms::alone(family, &[]);
                    terms.numbers.push((Name::from(name.as_str()), number.clone()));
                    terms.real(term).map_err(error)
                };
                values[place] = Some(value.map(number)?);
            }
        }
        let mut all = Vec::with_capacity(values.len());
        for (parameter, value) in family.parameters.iter().zip(values) {
            let (name, head) = (family.name.clone(), parameter.head());
            let example = setting(parameter);
            let Some(value) = value else {
                return Err(MemberError::Missing { family: name, head, example });
            };
            if !value.fits(parameter) {
                let kind = match parameter.indices.len() {
                    0 => "one number",
                    1 => "a list of numbers",
                    _ => "a list of numbers for each d, separated by `;`",
                };
                return Err(MemberError::Kind { family: name, head, kind, example });
            }
            if let Some(value) = value.all().find(|value| !parameter.admits(value)) {
                let (value, says) = (value.clone(), parameter.says.clone());
                return Err(MemberError::Bound { family: name, head, value, says });
            }
            all.push(value);
        }
        // What is an index has the kernels of one.
        let index = match (family.moebius(), all.first()) {
            (Some(None), _) => Some(Index::infinity()),
            (Some(Some(_)), Some(Values::One(ratio))) => Index::from_ratio(ratio.clone()).ok(),
            _ => None,
        };
        Ok(index.map_or_else(|| Self::Family(FamilyMember::new(family, all)), Self::Index))
    }

    /// α, if it is the member of an index.
    #[must_use]
    pub fn index(&self) -> Option<&Index> {
        match self {
            Self::Index(index) => Some(index),
            Self::Family(_) => None,
        }
    }

    /// The member of another family.
    #[must_use]
    pub fn member(&self) -> Option<&Arc<FamilyMember>> {
        match self {
            Self::Index(_) => None,
            Self::Family(member) => Some(member),
        }
    }

    /// The weights on knots, as forms; also those of an index.
    ///
    /// # Errors
    /// As [`FamilyMember::table`].
    pub fn table(&self, knots: &KnotVector, degree: usize) -> Result<FormTable, MemberError> {
        match self {
            Self::Family(member) => member.table(knots, degree),
            Self::Index(index) => {
                let ratio = Values::One(index.ratio().clone());
                FamilyMember::new(Family::of_index(), vec![ratio]).table(knots, degree)
            }
        }
    }

    /// The weights on knots: an index as it is, for its kernels, and of another member the forms.
    ///
    /// # Errors
    /// As [`FamilyMember::table`].
    pub fn on_knots(&self, knots: &KnotVector, degree: usize) -> Result<AnyWeights, MemberError> {
        match self {
            Self::Index(index) => Ok(AnyWeights::Index(index.clone())),
            Self::Family(member) => member.table(knots, degree).map(AnyWeights::Forms),
        }
    }

    /// The member with other numbers for all that its parameters hold; an index as it is.
    ///
    /// # Errors
    /// [`MemberError::Bound`] for a number that is out of bounds, or what `image` fails with.
    pub fn map_numbers<E: From<MemberError>>(
        &self,
        mut image: impl FnMut(&BigRational) -> Result<BigRational, E>,
    ) -> Result<Self, E> {
        let Self::Family(member) = self else { return Ok(self.clone()) };
        let given = member.named().map(|(name, values)| Ok((name.to_string(), values.map(&mut image)?)));
        Ok(Self::of(&member.family, &given.collect::<Result<Vec<_>, E>>()?)?)
    }

    /// With another number for a parameter that has no index.
    pub(super) fn with(&self, name: &Name, value: BigRational) -> Result<Self, Stop> {
        let Self::Family(member) = self else { return Err(Stop::Unbound(name.to_string())) };
        let given = member.family.parameters.iter().zip(&member.values).map(|(own, old)| {
            let value = if own.name == *name { Values::One(value.clone()) } else { old.clone() };
            (own.name.to_string(), value)
        });
        Self::of(&member.family, &given.collect::<Vec<_>>())
            .map_err(|error| Stop::Undefined(error.to_string()))
    }
}

/// α, or `lupas, q = 1/2`.
impl fmt::Display for Weighting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Index(index) => write!(f, "{index}"),
            Self::Family(member) => {
                f.write_str(&member.family.name)?;
                member.named().try_for_each(|(name, value)| write!(f, ", {name} = {value}"))
            }
        }
    }
}

fn heads(family: &Family) -> String {
    let all: Vec<_> = family.parameters.iter().map(Parameter::head).collect();
    let reads = family.reads.iter().map(|(name, _)| name.to_string());
    let all: Vec<_> = all.into_iter().chain(reads).collect();
    if all.is_empty() { "no parameter".to_owned() } else { all.join(", ") }
}

impl FamilyMember {
    fn new(family: &Arc<Family>, values: Vec<Values>) -> Arc<Self> {
        let mut hasher = DefaultHasher::new();
        family.name.hash(&mut hasher);
        for value in &values {
            value.all().for_each(|number| (number.numer(), number.denom()).hash(&mut hasher));
            u8::MAX.hash(&mut hasher);
        }
        Arc::new(Self { family: Arc::clone(family), values, fingerprint: hasher.finish() })
    }

    /// The family.
    #[must_use]
    pub fn family(&self) -> &Arc<Family> {
        &self.family
    }

    /// The parameters by name.
    pub fn named(&self) -> impl Iterator<Item = (&Name, &Values)> {
        self.family.parameters.iter().map(|own| &own.name).zip(&self.values)
    }

    /// A parameter with its indices.
    pub(super) fn parameter(&self, name: &Name, of: &[i64]) -> Result<&BigRational, String> {
        parameter(&self.family, &self.values, name, of)
    }

    /// The one that reflection leads to, on knots of these m and k.
    ///
    /// # Errors
    /// [`Stop`], if the family has none.
    pub(super) fn dual(&self, m: usize, k: usize) -> Result<Weighting, Stop> {
        let Some(dual) = &self.family.dual else {
            let name = &self.family.name;
            return Err(Stop::Unknown(format!(
                "the family {name} has no dual: say what `[dual]` is in its file"
            )));
        };
        let mut given = Vec::new();
        for (own, old) in self.family.parameters.iter().zip(&self.values) {
            let Some((_, term)) = dual.iter().find(|(name, _)| *name == own.name) else {
                given.push((own.name.to_string(), old.clone()));
                continue;
            };
            let at = |of: &[(&Name, usize)]| {
                let mut terms = Terms { sizes: Some((m, k)), ..Terms::alone(&self.family, &self.values) };
                let signed = |i: usize| i64::try_from(i).unwrap_or(i64::MAX);
                terms.ints = of.iter().map(|(name, i)| ((*name).clone(), signed(*i))).collect();
                terms.real(term)
            };
            // Of what is given more than is needed, the rest has no mirror image.
            let value = match (old, own.indices.as_slice()) {
                (Values::One(_), _) => Values::One(at(&[]).map_err(Stop::Undefined)?),
                (Values::List(list), [i]) => {
                    let first = usize::from(**i == *"d");
                    Values::List(
                        (first..list.len() + first).map_while(|at_i| at(&[(i, at_i)]).ok()).collect(),
                    )
                }
                (Values::Rows(rows), [i, d]) => {
                    let row = |(place, row): (usize, &Vec<BigRational>)| {
                        (0..row.len()).map_while(|at_i| at(&[(i, at_i), (d, place + 1)]).ok()).collect()
                    };
                    Values::Rows(rows.iter().enumerate().map(row).collect())
                }
                _ => old.clone(),
            };
            given.push((own.name.to_string(), value));
        }
        Weighting::of(&self.family, &given).map_err(|error| Stop::Undefined(error.to_string()))
    }

    /// The weights on knots, up to degree k.
    ///
    /// # Errors
    /// [`MemberError::Knots`] for knots that the family is not for; [`MemberError::Weight`] where a weight can't be computed, or has
    /// a pole on a closed span.
    pub fn table(&self, knots: &KnotVector, degree: usize) -> Result<FormTable, MemberError> {
        let family = &self.family;
        if let Some(adjective) = family.knots.iter().find(|adjective| !has(**adjective, knots, degree)) {
            let knots = adjective.name().to_owned();
            return Err(MemberError::Knots { family: family.name.clone(), knots });
        }
        FormTable::new(knots, degree, |j, i, d| {
            let forms = self.forms((j, i, d), knots, degree).and_then(|forms| {
                if forms.obligations().is_err()
                    && has_pole(&forms, (knots.t(i), knots.t(i + d)), (knots.t(j), knots.t(j + 1)))
                {
                    return Err("its denominator is 0 at some x there; choose other parameters".to_owned());
                }
                Ok(forms)
            });
            forms.map_err(|why| MemberError::Weight { family: family.name.clone(), i, d, j, why })
        })
    }

    /// rise and fall on [t_i, t_{i+d}], for span j: with x = a + (b − a)ξ they are polynomials Σ c_l ξ^l, and
    /// ξ = p/(p + q) makes them forms.
    fn forms(&self, (j, i, d): (usize, usize, usize), knots: &KnotVector, k: usize) -> Result<Forms, String> {
        let family = &self.family;
        let (a, b) = (knots.t(i), knots.t(i + d));
        let xi = RationalFunction::variable(&integer(1));
        let x = xi.times(&xi.embed(&(b - a))).plus(&xi.embed(a));
        let mut terms = self.on((j, i, d), knots, k, &x);
        let mut polynomial = |term: &Real| {
            let value = terms.real(term)?;
            let (p, q) = (value.numerator().clone(), value.denominator());
            if q.degree() > 0 {
                return Err("it divides by what depends on x".to_owned());
            }
            Ok(p.scaled(&q.leading().recip()))
        };
        let (rise, fall) = (polynomial(&family.rise)?, polynomial(&family.fall)?);
        let over = family.over.as_ref().map(polynomial).transpose()?;
        let degrees = [Some(&rise), Some(&fall), over.as_ref()];
        let n = degrees.into_iter().flatten().map(Polynomial::degree).max().unwrap_or(0);
        // (p + q)^N = (b − a)^N: so the forms have the values of the terms, and simple coefficients where those have.
        let unit = (b - a).power(n).recip();
        let form = |polynomial: &Polynomial<BigRational>| homogeneous(&polynomial.scaled(&unit), n);
        Forms::new(form(&rise), form(&fall), over.as_ref().map(form))
            .ok_or_else(|| "its forms have no common degree".to_owned())
    }

    /// The two shares by the terms of the family themselves, at any scalar: the other way to what the forms say.
    pub(super) fn shares<S: RationalAlgebra>(
        &self,
        place: (usize, usize, usize),
        knots: &KnotVector,
        k: usize,
        x: &S,
    ) -> Option<(S, S)> {
        let mut terms = self.on(place, knots, k, x);
        let (rise, fall) = (terms.real(&self.family.rise).ok()?, terms.real(&self.family.fall).ok()?);
        let over = match &self.family.over {
            Some(over) => terms.real(over).ok()?,
            None => rise.plus(&fall),
        };
        Some((rise.over(&over)?, fall.over(&over)?))
    }

    /// The forms on an interval of numbers, for a family of which the weights are given by its ends.
    pub(super) fn between(&self, a: &BigRational, b: &BigRational) -> Result<Forms, String> {
        let knots = KnotVector::new(vec![a.clone(), b.clone()]).map_err(|error| error.to_string())?;
        self.forms((0, 0, 1), &knots, 1)
    }

    fn on<'t, S: RationalAlgebra>(
        &'t self,
        (j, i, d): (usize, usize, usize),
        knots: &'t KnotVector,
        k: usize,
        x: &S,
    ) -> Terms<'t, S> {
        let signed = |i: usize| i64::try_from(i).unwrap_or(i64::MAX);
        let ints = [("i", signed(i)), ("d", signed(d)), ("s", signed(i + d) - signed(j))];
        Terms {
            family: &self.family,
            values: &self.values,
            knots: Some(knots),
            sizes: Some((knots.m(), k)),
            like: x.clone(),
            reals: vec![("x".into(), x.clone())],
            numbers: vec![("a".into(), knots.t(i).clone()), ("b".into(), knots.t(i + d).clone())],
            ints: ints.into_iter().map(|(name, value)| (name.into(), value)).collect(),
            depth: 0,
            known: Vec::new(),
        }
    }
}

fn parameter<'v>(
    family: &Family,
    values: &'v [Values],
    name: &Name,
    of: &[i64],
) -> Result<&'v BigRational, String> {
    let known = family.parameters.iter().zip(values).find(|(own, _)| own.name == *name);
    let (own, values) = known.ok_or_else(|| format!("there is no {name}"))?;
    let from = |first: i64, i: i64| i.checked_sub(first).and_then(|i| usize::try_from(i).ok());
    let found = match (values, of) {
        (Values::One(value), []) => Some(value),
        (Values::List(list), [i]) => from(i64::from(*own.indices[0] == *"d"), *i).and_then(|i| list.get(i)),
        (Values::Rows(rows), [i, d]) => {
            from(1, *d).and_then(|d| rows.get(d)).zip(from(0, *i)).and_then(|(row, i)| row.get(i))
        }
        _ => None,
    };
    let of: Vec<_> = of.iter().map(ToString::to_string).collect();
    found.ok_or_else(|| format!("{name}[{}] is not given: give more numbers", of.join(",")))
}

/// Σ c_l ξ^l as a form of degree N: Σ c_l p^l (p + q)^(N−l).
fn homogeneous(polynomial: &Polynomial<BigRational>, n: usize) -> Vec<BigRational> {
    let c = polynomial.coefficients();
    let coefficient = |to: usize| {
        let terms = c.iter().enumerate().take(to + 1);
        terms
            .map(|(l, c)| c * crate::spline::binomial(n - l, to - l))
            .fold(integer(0), |sum, term| sum + term)
    };
    (0..=n).map(coefficient).collect()
}

/// Has `over` a zero on the closed span?
fn has_pole(
    forms: &Forms,
    (a, b): (&BigRational, &BigRational),
    (from, to): (&BigRational, &BigRational),
) -> bool {
    let linear = |at_start: BigRational, at_end: BigRational| Polynomial::new(at_start, [at_end]);
    let (p, q) = (linear(from - a, to - a), linear(b - from, b - to));
    let [_, _, over] = forms.values(&p, &q, |c| Polynomial::constant(c.clone()));
    let [at_start, at_end] = [from, to].map(|x| forms.values(&(x - a), &(b - x), Clone::clone)[2].clone());
    over.is_zero() || at_start.is_zero() || at_end.is_zero() || !sign_pattern(&over).roots().is_empty()
}

/// A recursion of definitions that falls on no literal.
const DEEPEST: usize = 60;

/// The terms of a family at numbers, over a scalar for x.
struct Terms<'a, S> {
    family: &'a Family,
    values: &'a [Values],
    knots: Option<&'a KnotVector>,
    /// m and k.
    sizes: Option<(usize, usize)>,
    like: S,
    reals: Vec<(Name, S)>,
    numbers: Vec<(Name, BigRational)>,
    ints: Vec<(Name, i64)>,
    depth: usize,
    /// Values of definitions, by indices and argument: a definition sees nothing else.
    known: Vec<(Name, Vec<i64>, Option<S>, S)>,
}

impl<'a> Terms<'a, BigRational> {
    /// Without knots.
    fn alone(family: &'a Family, values: &'a [Values]) -> Self {
        Self {
            family,
            values,
            knots: None,
            sizes: None,
            like: integer(1),
            reals: Vec::new(),
            numbers: Vec::new(),
            ints: Vec::new(),
            depth: 0,
            known: Vec::new(),
        }
    }
}

fn too_large() -> String {
    "an integer is too large".to_owned()
}

impl<S: RationalAlgebra> Terms<'_, S> {
    fn int(&self, t: &Int) -> Result<i64, String> {
        let two = |a: &Int, b: &Int| Ok::<_, String>((self.int(a)?, self.int(b)?));
        let size = |of: fn((usize, usize)) -> Option<usize>| {
            let size = self.sizes.and_then(of).and_then(|size| i64::try_from(size).ok());
            size.ok_or_else(|| "there are no knots".to_owned())
        };
        match t {
            Int::Number(n) => Ok(*n),
            Int::Bound(name) => {
                let found = self.ints.iter().rev().find(|(known, _)| known == name);
                found.map(|(_, value)| *value).ok_or_else(|| format!("there is no {name}"))
            }
            Int::Degree => size(|(_, k)| Some(k)),
            Int::M => size(|(m, _)| Some(m)),
            Int::Last => size(|(m, k)| m.checked_sub(k + 1)),
            Int::Plus(a, b)
            | Int::Minus(a, b)
            | Int::Times(a, b)
            | Int::Least(a, b)
            | Int::Greatest(a, b)
            | Int::Binomial(a, b) => {
                let (a, b) = two(a, b)?;
                combined(t, a, b).ok_or_else(too_large)
            }
            Int::Word(_) => Err("a word is no part of a weight".to_owned()),
        }
    }

    fn real(&mut self, t: &Real) -> Result<S, String> {
        /// A higher power is no weight that anybody means.
        const HIGHEST: u64 = 1000;
        const LONGEST: i64 = 10_000;
        let zero = || "it divides by 0".to_owned();
        match t {
            Real::Number(q) => Ok(self.like.embed(q)),
            Real::Whole(i) => Ok(self.like.embed(&BigRational::from_integer(self.int(i)?.into()))),
            Real::Bound(name) | Real::Index(name) => {
                if let Some((_, value)) = self.reals.iter().rev().find(|(known, _)| known == name) {
                    return Ok(value.clone());
                }
                let number = self.numbers.iter().find(|(known, _)| known == name);
                number.map(|(_, q)| self.like.embed(q)).ok_or_else(|| format!("there is no {name}"))
            }
            Real::Knot(i) => {
                let i = self.int(i)?;
                let at = usize::try_from(i).ok();
                let knot = self.knots.zip(at).and_then(|(knots, at)| knots.knots().get(at));
                knot.map(|t| self.like.embed(t)).ok_or_else(|| format!("t[{i}] does not exist"))
            }
            Real::Parameter(name, of) => {
                let of = of.iter().map(|i| self.int(i)).collect::<Result<Vec<_>, _>>()?;
                parameter(self.family, self.values, name, &of).map(|value| self.like.embed(value))
            }
            Real::Plus(a, b) => Ok(self.real(a)?.plus(&self.real(b)?)),
            Real::Minus(a, b) => Ok(self.real(a)?.minus(&self.real(b)?)),
            Real::Times(a, b) => Ok(self.real(a)?.times(&self.real(b)?)),
            Real::Over(a, b) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                a.over(&b).ok_or_else(zero)
            }
            Real::Negated(a) => Ok(self.real(a)?.negate()),
            Real::Power(a, e) => {
                let (base, e) = (self.real(a)?, self.int(e)?);
                if e.unsigned_abs() > HIGHEST {
                    return Err(too_large());
                }
                let power = base.power(usize::try_from(e.unsigned_abs()).map_err(|_| too_large())?);
                if e < 0 { power.reciprocal().ok_or_else(zero) } else { Ok(power) }
            }
            Real::Fold(fold, range, body) => {
                use crate::language::Fold::{Product, Sum};
                let (from, to) = (self.int(&range.from)?, self.int(&range.to)?);
                let mut all = match fold {
                    Sum => self.like.zero(),
                    Product => self.like.one(),
                    _ => return Err("only sums and products are in a weight".to_owned()),
                };
                if to.saturating_sub(from) > LONGEST {
                    return Err("a sum or a product is too long".to_owned());
                }
                for i in from..=to {
                    self.ints.push((range.name.clone(), i));
                    let next = self.real(body);
                    self.ints.pop();
                    all = if *fold == Sum { all.plus(&next?) } else { all.times(&next?) };
                }
                Ok(all)
            }
            Real::Defined(name, of) => self.defined(name, of, None),
            Real::Value(f, argument) => match &**f {
                Function::Defined(name, of) => {
                    let x = self.real(&argument.at)?;
                    self.defined(name, of, Some(x))
                }
                _ => Err("only definitions are functions in a weight".to_owned()),
            },
            Real::Ratio
            | Real::Infinity
            | Real::Coefficient(..)
            | Real::Absolute(_)
            | Real::Root(_)
            | Real::Least(..)
            | Real::Greatest(..)
            | Real::Word(_) => Err("this is no part of a weight".to_owned()),
        }
    }

    fn defined(&mut self, name: &Name, of: &[Int], x: Option<S>) -> Result<S, String> {
        let of = of.iter().map(|i| self.int(i)).collect::<Result<Vec<_>, _>>()?;
        let family = self.family;
        let definition = family.definitions.iter().find(|definition| {
            let mut indices = definition.indices.iter().zip(&of);
            definition.name == *name && indices.all(|(own, i)| !matches!(own, Pattern::Number(n) if n != i))
        });
        let definition = definition.ok_or_else(|| format!("there is no {name}"))?;
        let known = self.known.iter().find(|(own, i, at, _)| own == name && *i == of && *at == x);
        if let Some((.., value)) = known {
            return Ok(value.clone());
        }
        if self.depth > DEEPEST {
            return Err(format!("{name} calls itself without an end"));
        }
        // A definition sees its own names only.
        let ints = definition.indices.iter().zip(&of).filter_map(|(own, i)| match own {
            Pattern::Any(name) => Some((name.clone(), *i)),
            Pattern::Number(_) => None,
        });
        let ints = std::mem::replace(&mut self.ints, ints.collect());
        let reals = definition.variable.iter().cloned().zip(x.clone()).collect();
        let reals = std::mem::replace(&mut self.reals, reals);
        self.depth += 1;
        let value = self.real(&definition.body);
        self.depth -= 1;
        (self.ints, self.reals) = (ints, reals);
        let value = value?;
        self.known.push((name.clone(), of, x, value.clone()));
        Ok(value)
    }
}
