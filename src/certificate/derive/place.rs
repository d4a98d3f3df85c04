//! Where x can be against the knots (proofs/FORMAT.md, lemma 3), and what that says of s, n and the gaps.

use std::fmt;

use crate::certificate::term::Where;

use super::index::{Bounds, Contradiction, Facts};

/// How often a knot occurs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Copies {
    Exactly(i64),
    AtLeast(i64),
}

impl Copies {
    fn least(self) -> i64 {
        match self {
            Self::Exactly(q) | Self::AtLeast(q) => q,
        }
    }
}

/// The place of x, with the span s: t_s < t_{s+1}. Of the coarse ones exactly one is that of an x, and so of the fine ones,
/// which tell `Start` and `End` apart further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// x < t_0.
    Before,
    /// t_s < x < t_{s+1}.
    Inside,
    /// x = t_s < t_m; coarse.
    Start,
    /// x = t_0 = t_s: copies t_0, …, t_s.
    First(Copies),
    /// t_0 < x = t_s < t_m: copies t_{s−q+1}, …, t_s.
    Knot(Copies),
    /// x = t_m = t_{s+1}; coarse.
    End,
    /// x = t_m = t_{s+1}: copies t_{s+1}, …, t_m.
    Last(Copies),
    /// x > t_m.
    After,
}

/// A gap between knots that are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Size {
    Zero,
    Some,
    Any,
}

impl Place {
    /// The coarse ones, in the order of x.
    pub(super) const COARSE: [Self; 5] = [Self::Before, Self::Inside, Self::Start, Self::End, Self::After];

    /// Are there finer ones?
    pub(super) fn is_coarse(self) -> bool {
        matches!(self, Self::Start | Self::End)
    }

    /// The fine ones in the place of a coarse one: copies are told apart below `most`.
    pub(super) fn finer(self, most: i64) -> Vec<Self> {
        let copies = || (1..most).map(Copies::Exactly).chain([Copies::AtLeast(most)]);
        match self {
            Self::Start => copies().map(Self::First).chain(copies().map(Self::Knot)).collect(),
            Self::End => copies().map(Self::Last).collect(),
            _ => Vec::new(),
        }
    }

    /// How often x occurs at least, where that is told.
    pub(super) fn copies(self) -> Option<i64> {
        match self {
            Self::First(copies) | Self::Knot(copies) | Self::Last(copies) => Some(copies.least()),
            _ => None,
        }
    }

    /// What is known of s and n for degree k.
    pub(super) fn facts(self, k: i64) -> Result<Facts, Contradiction> {
        let exactly = |copies, from: i64| match copies {
            Copies::Exactly(q) => (Some(q + from), Some(q + from)),
            Copies::AtLeast(q) => (Some(q + from), None),
        };
        let (free, rest): (Bounds, Bounds) = ((Some(0), None), (Some(-k), None));
        match self {
            Self::Before | Self::After | Self::Inside | Self::Start | Self::End => Facts::new(free, rest),
            Self::First(copies) => Facts::new(exactly(copies, -1), rest),
            Self::Knot(copies) => Facts::new((Some(copies.least()), None), rest),
            Self::Last(copies) => Facts::new(free, exactly(copies, -k - 1)),
        }
    }

    /// The first and the last knot that the window shows, as e of t_{s+e}.
    pub(super) fn shown(self, k: i64) -> (i64, i64) {
        match self {
            Self::Knot(Copies::Exactly(q)) => (-k - q, k + 1),
            _ => (-k, k + 1),
        }
    }

    /// t_{s+e+1} − t_{s+e}.
    pub(super) fn gap(self, e: i64) -> Size {
        match self {
            _ if e == 0 => Size::Some,
            // Beyond t_0 and t_m the knots may be continued by any: by copies.
            Self::First(_) if e < 0 => Size::Zero,
            Self::End | Self::Last(_) if e > 0 => Size::Zero,
            Self::Knot(c) if -c.least() < e && e < 0 => Size::Zero,
            Self::Knot(Copies::Exactly(q)) if e == -q => Size::Some,
            _ => Size::Any,
        }
    }

    /// x on the span; `None` beyond all knots.
    pub(super) fn on_span(self) -> Option<Where> {
        match self {
            Self::Before | Self::After => None,
            Self::Inside => Some(Where::In),
            Self::Start | Self::First(_) | Self::Knot(_) => Some(Where::From),
            Self::End | Self::Last(_) => Some(Where::To),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let copies = |c: &Copies| match c {
            Copies::Exactly(1) => "once".to_owned(),
            Copies::Exactly(q) => format!("{q} times"),
            Copies::AtLeast(q) => format!("{q} times or more"),
        };
        match self {
            Self::Before => f.write_str("x < t_0"),
            Self::Inside => f.write_str("t_s < x < t_{s+1}"),
            Self::Start => f.write_str("x = t_s < t_m"),
            Self::First(c) => write!(f, "x = t_0, {}", copies(c)),
            Self::Knot(c) => write!(f, "x = t_s inside, {}", copies(c)),
            Self::End => f.write_str("x = t_m"),
            Self::Last(c) => write!(f, "x = t_m, {}", copies(c)),
            Self::After => f.write_str("x > t_m"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::derive::index::Index;

    /// All knot vectors with gaps 0 and 1, twice the knots and the points between and beyond: exactly one coarse place is
    /// theirs, and one fine one, and what it says of s, n and gaps is so.
    #[test]
    fn every_x_has_one_place_and_it_tells_the_truth() {
        let mut seen = 0;
        for (k, m) in (0..4).flat_map(|k| (k + 1..=8).map(move |m| (k, m))) {
            for code in 1..1_u32 << m {
                let mut knots = vec![0_i64];
                for g in 0..m {
                    knots.push(knots[knots.len() - 1] + 2 * i64::from(code >> g & 1));
                }
                let last = knots[knots.len() - 1];
                for x in -1..=last + 1 {
                    let q = i64::try_from(knots.iter().filter(|t| **t == x).count()).unwrap();
                    let is = |c: Copies| match c {
                        Copies::Exactly(n) => n == q,
                        Copies::AtLeast(n) => q >= n,
                    };
                    let fits = |place: &Place| match *place {
                        Place::Before => x < 0,
                        Place::After => x > last,
                        Place::Inside => 0 < x && x < last && q == 0,
                        Place::Start => 0 <= x && x < last && q > 0,
                        Place::First(c) => x == 0 && is(c),
                        Place::Knot(c) => 0 < x && x < last && q > 0 && is(c),
                        Place::End => x == last,
                        Place::Last(c) => x == last && is(c),
                    };
                    let coarse: Vec<_> = Place::COARSE.into_iter().filter(&fits).collect();
                    let [coarse] = coarse.as_slice() else { panic!("{knots:?}, {x}: {coarse:?}") };
                    let fine: Vec<_> = coarse.finer(k + 3).into_iter().filter(&fits).collect();
                    let places: Vec<Place> = match fine.as_slice() {
                        [] if !matches!(coarse, Place::Start | Place::End) => vec![*coarse],
                        [fine] => vec![*coarse, *fine],
                        _ => panic!("{knots:?}, {x}: {fine:?}"),
                    };
                    let spans = || (0..m).filter(|s| knots[at(*s)] < knots[at(s + 1)]);
                    let Some(s) = spans().rfind(|s| knots[at(*s)] <= x && x <= last && x >= 0) else {
                        continue;
                    };
                    for place in places {
                        seen += 1;
                        let mut facts = place.facts(k).unwrap();
                        let (span, n) = (Index::span(0), Index::last(0));
                        for (index, value) in [(&span, s), (&n, m - k - 1)] {
                            facts.assume(&index.plus(&Index::number(-value))).unwrap();
                            facts.assume(&Index::number(value).minus(index)).unwrap();
                        }
                        let (from, to) = place.shown(k);
                        for e in from..to {
                            let known = |e: i64| usize::try_from(s + e).ok().and_then(|i| knots.get(i));
                            let (Some(a), Some(b)) = (known(e), known(e + 1)) else { continue };
                            let so = match place.gap(e) {
                                Size::Zero => a == b,
                                Size::Some => a < b,
                                Size::Any => a <= b,
                            };
                            assert!(so, "{knots:?}, {x}, {place}, gap {e}");
                        }
                        let so = match place.on_span() {
                            None => false,
                            Some(Where::In) => knots[at(s)] < x && x < knots[at(s + 1)],
                            Some(Where::From) => knots[at(s)] == x,
                            Some(Where::To) => knots[at(s + 1)] == x,
                        };
                        assert!(so, "{knots:?}, {x}, {place}");
                    }
                }
            }
        }
        assert!(seen > 20_000, "{seen}");
    }

    fn at(i: i64) -> usize {
        usize::try_from(i).unwrap()
    }
}
