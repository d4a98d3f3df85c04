//! Where x can be among the knots (lemma 3 of FORMAT.md), and what that says of the span's index s and of n.

use std::collections::BTreeMap;
use std::fmt;

use crate::env::small;
use crate::error::Result;
use crate::work::spend;

/// How often a knot occurs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Copies {
    Exactly(i64),
    AtLeast(i64),
}

impl Copies {
    pub(crate) fn least(self) -> i64 {
        let (Copies::Exactly(q) | Copies::AtLeast(q)) = self;
        q
    }
}

/// Of every x and every knot vector exactly one fine place holds, and exactly one coarse one. t_s < t_{s+1} is the span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// x < t_0: all functions are 0.
    Before,
    /// t_s < x < t_{s+1}.
    Inside,
    /// x = t_s < t_m: coarse, in place of `First` and `Knot`.
    Start,
    /// x = t_0, its copies are t_0, …, t_s.
    First(Copies),
    /// t_0 < x = t_s, the copies are t_{s−q+1}, …, t_s.
    Knot(Copies),
    /// x = t_{s+1} = t_m: coarse, in place of `Last`.
    End,
    /// x = t_m, its copies are t_{s+1}, …, t_m.
    Last(Copies),
    /// x > t_m: all functions are 0.
    After,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (at, copies) = match self {
            Place::Before => ("x < t_0", None),
            Place::Inside => ("t_s < x < t_{s+1}", None),
            Place::Start => ("x = t_s < t_m", None),
            Place::First(copies) => ("x = t_0", Some(copies)),
            Place::Knot(copies) => ("t_0 < x = t_s < t_m", Some(copies)),
            Place::End => ("x = t_m", None),
            Place::Last(copies) => ("x = t_m", Some(copies)),
            Place::After => ("x > t_m", None),
        };
        match copies {
            None => f.write_str(at),
            Some(Copies::Exactly(q)) => write!(f, "{at}, a knot {q} times"),
            Some(Copies::AtLeast(q)) => write!(f, "{at}, a knot {q} times or more"),
        }
    }
}

/// The fine places of one kind: copies below Q exactly, and Q or more.
pub(crate) fn fine(kind: fn(Copies) -> Place, k: i64) -> impl Iterator<Item = Place> {
    let most = k + 3;
    (1..most).map(Copies::Exactly).chain([Copies::AtLeast(most)]).map(kind)
}

/// A gap of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Gap {
    Zero,
    Any,
    Some,
}

impl Place {
    /// The first and the last knot that the window shows, as e of t_{s+e}: limits from the left live on the span before
    /// the copies.
    pub(crate) fn shown(self, k: i64) -> (i64, i64) {
        match self {
            Place::Knot(Copies::Exactly(q)) => (-k - q, k + 1),
            _ => (-k, k + 1),
        }
    }

    /// How a place on the span is written, and nothing where there is none.
    pub(crate) fn on_span(self) -> Option<&'static str> {
        match self {
            Place::Before | Place::After => None,
            Place::Inside => Some("in"),
            Place::Start | Place::First(_) | Place::Knot(_) => Some("from"),
            Place::End | Place::Last(_) => Some("to"),
        }
    }

    /// What is known of t_{s+e+1} − t_{s+e}.
    pub(crate) fn gap(self, e: i64) -> Gap {
        match self {
            _ if e == 0 => Gap::Some,
            // Whatever is beyond t_0 or t_m may be continued by copies of them.
            Place::First(_) if e < 0 => Gap::Zero,
            Place::End | Place::Last(_) if e > 0 => Gap::Zero,
            Place::Knot(copies) if -copies.least() < e && e < 0 => Gap::Zero,
            Place::Knot(Copies::Exactly(q)) if e == -q => Gap::Some,
            _ => Gap::Any,
        }
    }
}

/// s·S + n·N + c, and whole numbers ≥ 0 of which nothing else is known, with factors.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Form {
    pub(crate) s: i64,
    pub(crate) n: i64,
    pub(crate) c: i64,
    pub(crate) far: BTreeMap<usize, i64>,
}

impl Form {
    pub(crate) fn number(c: i64) -> Self {
        Form { c, ..Form::default() }
    }

    /// s + e.
    pub(crate) fn near(e: i64) -> Self {
        Form { s: 1, c: e, ..Form::default() }
    }

    /// n + e.
    pub(crate) fn last(e: i64) -> Self {
        Form { n: 1, c: e, ..Form::default() }
    }

    /// s·S + n·N by two of s, n − s and n, in three ways.
    fn ways(&self) -> [[i64; 3]; 3] {
        [[self.s + self.n, self.n, 0], [self.s, 0, self.n], [0, -self.s, self.s + self.n]]
    }

    /// This form and a multiple of another.
    pub(crate) fn plus(&self, factor: i64, other: &Self) -> Result<Self> {
        let add = |a: i64, b: i64| small(a + small(factor * b)?);
        let mut far = self.far.clone();
        for (index, value) in &other.far {
            let sum = far.entry(*index).or_insert(0);
            *sum = add(*sum, *value)?;
        }
        far.retain(|_, value| *value != 0);
        Ok(Form { s: add(self.s, other.s)?, n: add(self.n, other.n)?, c: add(self.c, other.c)?, far })
    }
}

/// Least and greatest value, as far as they are known.
type Bounds = (Option<i64>, Option<i64>);

/// What is known of s, n − s and n, and forms that are known to be ≥ 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Facts {
    bounds: [Bounds; 3],
    assumed: Vec<Form>,
}

/// The bounds of factor·v.
fn scaled(factor: i64, (least, most): Bounds) -> Bounds {
    let times = |bound: Option<i64>| bound.map(|bound| bound * factor);
    match factor {
        0 => (Some(0), Some(0)),
        1.. => (times(least), times(most)),
        _ => (times(most), times(least)),
    }
}

fn sum(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    Some(a? + b?)
}

fn smaller(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    a.into_iter().chain(b).min()
}

impl Facts {
    /// 0 ≤ s < m and 0 ≤ n, and what the copies say.
    pub(crate) fn at(place: Place, k: i64) -> Self {
        let exactly = |copies: Copies, from: i64| match copies {
            Copies::Exactly(q) => (Some(q + from), Some(q + from)),
            Copies::AtLeast(q) => (Some(q + from), None),
        };
        let (mut s, mut rest) = ((Some(0), None), (Some(-k), None));
        match place {
            Place::First(copies) => s = exactly(copies, -1),
            Place::Knot(copies) => s.0 = Some(copies.least()),
            Place::Last(copies) => rest = exactly(copies, -k - 1),
            Place::Before | Place::Inside | Place::Start | Place::End | Place::After => {}
        }
        let mut facts = Facts { bounds: [s, rest, (Some(0), None)], assumed: Vec::new() };
        facts.settle();
        facts
    }

    /// Both are numbers.
    pub(crate) fn known(s: i64, n: i64) -> Self {
        let exactly = |value| (Some(value), Some(value));
        Facts { bounds: [exactly(s), exactly(n - s), exactly(n)], assumed: Vec::new() }
    }

    /// The best bounds of the three ways to write a form by two of s, n − s and n.
    pub(crate) fn bounds(&self, form: &Form) -> Bounds {
        let far = form.far.values().map(|factor| scaled(*factor, (Some(0), None)));
        let way = |way: [i64; 3]| {
            let parts = way.into_iter().zip(self.bounds).map(|(factor, bounds)| scaled(factor, bounds));
            let all = parts.chain(far.clone());
            all.fold((Some(form.c), Some(form.c)), |all, part| (sum(all.0, part.0), sum(all.1, part.1)))
        };
        let [a, b, c] = form.ways().map(way);
        (a.0.max(b.0).max(c.0), smaller(a.1, smaller(b.1, c.1)))
    }

    /// The value, if the bounds leave one.
    pub(crate) fn value(&self, form: &Form) -> Option<i64> {
        match self.bounds(form) {
            (Some(least), Some(most)) if least == most => Some(least),
            _ => None,
        }
    }

    /// Whether a form is ≥ 0, if that is known: by its bounds, or by those of what it is more than one or two assumed ones.
    pub(crate) fn is_nonnegative(&self, form: &Form) -> Result<Option<bool>> {
        let negative = Form::number(-1).plus(-1, form)?;
        Ok(match () {
            () if self.surely(form)? => Some(true),
            () if self.surely(&negative)? => Some(false),
            () => None,
        })
    }

    fn surely(&self, form: &Form) -> Result<bool> {
        let low = |form: &Form| self.bounds(form).0.is_some_and(|least| least >= 0);
        if low(form) {
            return Ok(true);
        }
        spend(1 + self.assumed.len() * self.assumed.len())?;
        for first in &self.assumed {
            let rest = form.plus(-1, first)?;
            if low(&rest) {
                return Ok(true);
            }
            for second in &self.assumed {
                if low(&rest.plus(-1, second)?) {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    /// With form ≥ 0 besides; `false` if that cannot be.
    pub(crate) fn assume(&mut self, form: &Form) -> Result<bool> {
        if let Some(known) = self.is_nonnegative(form)? {
            return Ok(known);
        }
        self.assumed.push(form.clone());
        let far = if form.far.values().any(|factor| *factor > 0) { None } else { Some(0) };
        for way in form.ways() {
            for (at, factor) in way.into_iter().enumerate() {
                // factor·v ≥ −(all others), which is at least minus their greatest value.
                let others = way.into_iter().zip(self.bounds).enumerate().filter(|(other, _)| *other != at);
                let most = others.map(|(_, (factor, bounds))| scaled(factor, bounds).1);
                let most = most.chain([far]).fold(Some(form.c), sum);
                match (factor, most, self.bounds.get_mut(at)) {
                    (1, Some(most), Some(bounds)) => bounds.0 = bounds.0.max(Some(-most)),
                    (-1, most @ Some(_), Some(bounds)) => bounds.1 = smaller(bounds.1, most),
                    _ => {}
                }
            }
        }
        Ok(self.settle())
    }

    /// s + (n − s) = n, until no bound gets better; `false` if they cross.
    fn settle(&mut self) -> bool {
        loop {
            let before = self.bounds;
            let [s, rest, n] = before;
            let minus = |a: Option<i64>, b: Option<i64>| Some(a? - b?);
            self.bounds = [
                (s.0.max(minus(n.0, rest.1)), smaller(s.1, minus(n.1, rest.0))),
                (rest.0.max(minus(n.0, s.1)), smaller(rest.1, minus(n.1, s.0))),
                (n.0.max(sum(s.0, rest.0)), smaller(n.1, sum(s.1, rest.1))),
            ];
            if self.bounds.iter().any(|bounds| matches!(bounds, (Some(least), Some(most)) if least > most)) {
                return false;
            }
            if self.bounds == before {
                return true;
            }
        }
    }
}
