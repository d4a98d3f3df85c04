//! Where x can be among the knots (lemma 3 of FORMAT.md), and what that says of the span's index s and of n.

use std::collections::BTreeMap;
use std::fmt;

use crate::env::small;
use crate::error::{Reason, Result};
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
        let add = |a: i64, b: i64| {
            let sum = factor.checked_mul(b).and_then(|times| a.checked_add(times));
            small(sum.ok_or(Reason::Limits("an integer"))?)
        };
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

/// The bounds of factor·v; what does not fit is not known.
fn scaled(factor: i64, (least, most): Bounds) -> Bounds {
    let times = |bound: Option<i64>| bound?.checked_mul(factor);
    match factor {
        0 => (Some(0), Some(0)),
        1.. => (times(least), times(most)),
        _ => (times(most), times(least)),
    }
}

fn sum(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    a?.checked_add(b?)
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
        (self.least(1, form), self.least(-1, form).and_then(i64::checked_neg))
    }

    /// The greatest lower bound of factor·form, for a factor 1 or −1.
    fn least(&self, factor: i64, form: &Form) -> Option<i64> {
        if form.far.values().any(|far| far.signum() == -factor) {
            return None;
        }
        let way = |way: [i64; 3]| {
            let mut parts = way.into_iter().zip(self.bounds);
            parts.try_fold(form.c.checked_mul(factor)?, |all, (own, bounds)| {
                sum(Some(all), scaled(own.checked_mul(factor)?, bounds).0)
            })
        };
        form.ways().into_iter().filter_map(way).max()
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
        let low = |form: &Form| self.least(1, form).is_some_and(|least| least >= 0);
        if low(form) {
            return Ok(true);
        }
        spend(1 + self.assumed.len() * self.assumed.len())?;
        for (at, first) in self.assumed.iter().enumerate() {
            let rest = form.plus(-1, first)?;
            if low(&rest) {
                return Ok(true);
            }
            for second in self.assumed.iter().skip(at) {
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
                    (1, Some(most), Some(bounds)) => bounds.0 = bounds.0.max(most.checked_neg()),
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
            let minus = |a: Option<i64>, b: Option<i64>| a?.checked_sub(b?);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn copies(copies: Copies, q: i64) -> bool {
        match copies {
            Copies::Exactly(exactly) => q == exactly,
            Copies::AtLeast(least) => q >= least,
        }
    }

    /// All knot vectors with gaps 0 and 1 (here 2), all knots, the points between them and beyond: exactly one coarse
    /// place and one fine one is theirs, and all that it says is so: of s, n − s, the gaps, and what exists.
    #[test]
    fn every_x_has_one_place_that_tells_the_truth() -> Result<()> {
        crate::work::begin(1_000_000_000);
        let mut seen = [0; 2];
        for (k, m) in (0..4).flat_map(|k| (k + 1..=8).map(move |m| (k, m))) {
            for pattern in 1..1_u32 << m {
                let mut knots = vec![0];
                for gap in 0..m {
                    knots.push(knots.last().unwrap() + 2 * i64::from(pattern >> gap & 1));
                }
                let (at, last) = (
                    |i: i64| usize::try_from(i).ok().and_then(|i| knots.get(i)).copied(),
                    knots[knots.len() - 1],
                );
                for x in -1..=last + 1 {
                    let q = i64::try_from(knots.iter().filter(|t| **t == x).count()).unwrap();
                    let holds = |place: &Place| match *place {
                        Place::Before => x < 0,
                        Place::Inside => 0 < x && x < last && q == 0,
                        Place::Start => 0 <= x && x < last && q > 0,
                        Place::First(of) => x == 0 && copies(of, q),
                        Place::Knot(of) => 0 < x && x < last && q > 0 && copies(of, q),
                        Place::End => x == last,
                        Place::Last(of) => x == last && copies(of, q),
                        Place::After => x > last,
                    };
                    let coarse = [Place::Before, Place::Inside, Place::Start, Place::End, Place::After];
                    let ends = fine(Place::First, k).chain(fine(Place::Knot, k)).chain(fine(Place::Last, k));
                    let all: Vec<_> = coarse.into_iter().chain(ends).filter(holds).collect();
                    let refined = all.iter().filter(|place| !coarse.contains(place)).count();
                    let at_knot = matches!(all[0], Place::Start | Place::End);
                    assert_eq!((all.len() - refined, refined), (1, usize::from(at_knot)), "{knots:?}, {x}");
                    // The last span that begins at x or before; any, where x is outside.
                    let spans: Vec<_> = (0..m).filter(|s| at(*s) < at(s + 1)).collect();
                    let here =
                        spans.iter().rev().find(|s| at(**s) <= Some(x)).filter(|_| (0..=last).contains(&x));
                    for place in all {
                        for s in here.map_or(spans.clone(), |s| vec![*s]) {
                            let n = m - k - 1;
                            seen[usize::from(matches!(place, Place::Knot(_)))] += 1;
                            let facts = Facts::at(place, k);
                            let truth = Facts::known(s, n);
                            for (a, b, c) in
                                [(1, 0, 0), (-1, 0, 0), (-1, 1, 0), (1, -1, 0), (0, 1, 0), (2, -1, 1)]
                            {
                                let form = Form { s: a, n: b, c, ..Form::default() };
                                let value = truth.value(&form).unwrap();
                                let (least, most) = facts.bounds(&form);
                                assert!(
                                    least.is_none_or(|least| least <= value),
                                    "{knots:?}, {x}, {place}: {form:?}"
                                );
                                assert!(
                                    most.is_none_or(|most| value <= most),
                                    "{knots:?}, {x}, {place}: {form:?}"
                                );
                                let known = facts.is_nonnegative(&form)?;
                                assert!(known.is_none_or(|known| known == (value >= 0)));
                            }
                            // Functions and knots that exist for sure do, those that do not for sure do not.
                            for (e, d) in (-2 * k - 3..=2 * k + 3).flat_map(|e| (0..=k).map(move |d| (e, d)))
                            {
                                let (i, most) = (Form::near(e), Form::last(k - d));
                                let sure =
                                    [facts.is_nonnegative(&i)?, facts.is_nonnegative(&most.plus(-1, &i)?)?];
                                let exists = 0 <= s + e && s + e <= n + k - d;
                                assert!(
                                    sure != [Some(true); 2] || exists,
                                    "{knots:?}, {x}, {place}: G_(s+{e})^{d}"
                                );
                                assert!(!sure.contains(&Some(false)) || !exists, "{knots:?}, {x}, {place}");
                            }
                            let (first, end) = place.shown(k);
                            for e in first..end {
                                let (Some(a), Some(b)) = (at(s + e), at(s + e + 1)) else { continue };
                                match place.gap(e) {
                                    Gap::Zero => assert_eq!(a, b, "{knots:?}, {x}, {place}, gap {e}"),
                                    Gap::Some => assert!(a < b, "{knots:?}, {x}, {place}, gap {e}"),
                                    Gap::Any => {}
                                }
                            }
                            let on = match place.on_span() {
                                None => x < 0 || x > last,
                                Some("in") => at(s) < Some(x) && Some(x) < at(s + 1),
                                Some("from") => at(s) == Some(x),
                                _ => at(s + 1) == Some(x),
                            };
                            assert!(on, "{knots:?}, {x}, {place}");
                        }
                    }
                }
            }
        }
        assert!(seen[0] > 30_000 && seen[1] > 5_000, "{seen:?}");
        Ok(())
    }

    /// What is assumed and what follows from it is true wherever the assumption is.
    #[test]
    fn what_is_assumed_excludes_no_case() -> Result<()> {
        crate::work::begin(1_000_000_000);
        let forms: Vec<_> =
            (-2..=2).flat_map(|s| (-2..=2).flat_map(move |n| (-3..=3).map(move |c| (s, n, c)))).collect();
        let form = |(s, n, c): (i64, i64, i64)| Form { s, n, c, ..Form::default() };
        for (at, a) in forms.iter().enumerate() {
            for b in forms.iter().skip(at % 7).step_by(7) {
                for k in [0, 2] {
                    let mut facts = Facts::at(Place::Inside, k);
                    let possible = facts.assume(&form(*a))? && facts.assume(&form(*b))?;
                    for (s, n) in
                        (0..7).flat_map(|s| (0..7).map(move |n| (s, n))).filter(|(s, n)| n - s >= -k)
                    {
                        let value = |(x, y, c): &(i64, i64, i64)| x * s + y * n + c;
                        if value(a) < 0 || value(b) < 0 {
                            continue;
                        }
                        assert!(possible, "{a:?}, {b:?}: s = {s}, n = {n}");
                        for other in forms.iter().step_by(5) {
                            let known = facts.is_nonnegative(&form(*other))?;
                            assert!(
                                known.is_none_or(|known| known == (value(other) >= 0)),
                                "{a:?}, {b:?} ⇒ {other:?}"
                            );
                        }
                    }
                }
            }
        }
        Ok(())
    }
}
