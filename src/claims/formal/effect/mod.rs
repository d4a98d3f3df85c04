//! Illustrations 5.1 and 5.2: the effect of α on the functions of U0 to U3, for every α.
//!
//! Let z be r for r < 1, and 1/r for r > 1, and D be G_i less G_i for r = 1. That sup |D| grows as z falls from 1 to 0
//! follows, one range of z after the other, from goals of two kinds:
//!
//! - At most points of its support G_i itself goes one way as z falls. Where D has gone that way too, |D| grows.
//! - Elsewhere ±D is at most |D| at a point w that is one of these, for the same z.
//!
//! As z falls, the function goes from one end of its support towards the other: on the spans before a certain one it goes
//! one way, and the other way on those after it. [`CASES`] is about the span between, on which G_i turns. The numbers in it
//! were found by trial; whether they do is decided by the proofs of the goals, and, as far as parts have to make up the
//! whole span, by a test below.

mod cases;

use std::cmp::Ordering;
use std::fmt::Write as _;

use crate::claims::instances::instances_named;
use crate::claims::verdict::Scope;
use crate::scalar::BigRational;

use super::Formal;
use super::example::Example;
use super::place::Place;

use Side::{Above, Below};
use Way::{Down, Up};
use cases::{CASES, Case, Part, Range, Side, Way};

impl Way {
    /// The difference that is positive if it goes this way from a to b.
    fn of(self, a: &str, b: &str) -> String {
        match self {
            Up => format!("(- {b} {a})"),
            Down => format!("(- {a} {b})"),
        }
    }
}

impl Part {
    /// A term that takes all the values of the part, but for an upper end if there is a lower one as well.
    fn term(self) -> String {
        match self {
            Part("0", None) => "u".into(),
            Part("0", Some(hi)) => format!("(/ {hi} (+ 1 v))"),
            Part(lo, None) => format!("(+ {lo} v)"),
            Part(lo, Some(hi)) => format!("(/ (+ {lo} (* {hi} v)) (+ 1 v))"),
        }
    }

    fn ends(self) -> Option<(BigRational, Option<BigRational>)> {
        Some((self.0.parse().ok()?, self.1.map(str::parse).transpose().ok()?))
    }

    fn contains(self, u: &BigRational) -> bool {
        self.ends().is_some_and(|(lo, hi)| lo <= *u && hi.is_none_or(|hi| *u <= hi))
    }
}

impl Side {
    /// r, from the numerator and the denominator of z.
    fn ratio(self, [above, below]: [String; 2]) -> String {
        match self {
            Below => format!("(/ {above} {below})"),
            Above => format!("(/ {below} {above})"),
        }
    }
}

impl Range {
    /// All z of the range but its lower end, than which there is none smaller to compare it with.
    fn here(&self) -> [String; 2] {
        self.over("p")
    }

    /// The same with another term for p.
    fn over(&self, p: &str) -> [String; 2] {
        let above =
            if self.from == "0" { self.to.into() } else { format!("(+ {} (* {} {p}))", self.to, self.from) };
        [above, format!("(+ 1 {p})")]
    }

    /// The parameters with which `pair` takes all pairs, and v for a place on a span.
    fn parameters(&self) -> &'static str {
        if self.from == "0" { "(nonnegative v p) (positive s)" } else { "(nonnegative v p s)" }
    }

    /// All pairs of different z in the range, the greater one first.
    fn pair(&self) -> [[String; 2]; 2] {
        let (from, to) = (self.from, self.to);
        let below = "(* (+ 1 p) (+ 1 s))".to_owned();
        if from == "0" {
            return [self.here(), [to.into(), below]];
        }
        let far = format!("(+ {from} (* {to} s))");
        [[format!("(+ (* {to} (+ 1 s)) (* {far} p))"), below], [far, "(+ 1 s)".into()]]
    }
}

/// The range of all z.
const EVERYWHERE: Range = Range { from: "0", to: "1", steady: &[], bounds: &[] };

/// A function of a case.
struct Function<'a> {
    case: &'a Case,
    on: Example<'a>,
    i: usize,
}

impl Function<'_> {
    /// The spans of its support, counted from i.
    fn spans(&self) -> Vec<usize> {
        let spans = self.on.spans().into_iter().filter_map(|span| span.checked_sub(self.i));
        spans.filter(|span| *span <= self.case.degree).collect()
    }

    fn term(&self, place: impl Fn(usize) -> Place, span: usize) -> String {
        self.on.function(self.i, place(self.i + span))
    }

    /// G_i at a point of a span, for an r.
    fn value(&self, span: usize, u: &str, r: &str) -> String {
        let place = if u == "u" { String::new() } else { format!("(u {u}) ") };
        format!("(at ({place}(r {r})) {})", self.term(Place::inside, span))
    }

    /// The way that G_i goes as z falls on the spans before that of its turn, or after it.
    fn way(&self, span: usize) -> Option<Way> {
        let first = if self.case.side == Below { [Down, Up] } else { [Up, Down] };
        match span.cmp(&self.case.turn) {
            Ordering::Less => Some(first[0]),
            Ordering::Equal => None,
            Ordering::Greater => Some(first[1]),
        }
    }

    /// The way at a point of a span, in a range.
    fn way_at(&self, range: &Range, span: usize, u: &str) -> Option<Way> {
        let u = u.parse().ok()?;
        let steady = || range.steady.iter().find(|(part, _)| part.contains(&u)).map(|(_, way)| *way);
        self.way(span).or_else(steady)
    }

    fn section(&self, range: &Range, goals: &str) -> String {
        let [near, far] = range.pair().map(|z| self.case.side.ratio(z));
        let parameters = range.parameters();
        self.on.section(&format!("{parameters} (let near {near}) (let far {far})"), goals)
    }

    /// G_i goes one way strictly.
    fn goes(way: Way, value: impl Fn(&str) -> String) -> String {
        format!("(> {} 0)", way.of(&value("near"), &value("far")))
    }

    /// On whole spans, for all z; and at the knots, where G_i goes one way too, or does not depend on z.
    fn everywhere(&self) -> String {
        let spans = self.spans();
        let mut goals = String::new();
        for &span in &spans {
            if let Some(way) = self.way(span) {
                goals += &Self::goes(way, |r| self.value(span, "u", r));
            }
        }
        let knots = &self.on.instance.knots;
        for pair in spans.windows(2) {
            let (left, right) = (self.term(Place::end, pair[0]), self.term(Place::start, pair[1]));
            let _ = write!(goals, "(= {left} {right})");
            let constant = knots.multiplicity(knots.t(self.i + pair[1])) >= self.case.degree;
            match self.way(pair[0]).or_else(|| self.way(pair[1])) {
                Some(way) if !constant => goals += &Self::goes(way, |r| format!("(at ((r {r})) {left})")),
                _ => {
                    let _ = write!(goals, "(= {left} 1)");
                }
            }
        }
        if let [first, .., last] = spans[..] {
            let _ = write!(
                goals,
                "(= {} 0) (= {} 0)",
                self.term(Place::start, first),
                self.term(Place::end, last)
            );
        }
        self.section(&EVERYWHERE, &goals)
    }

    /// On the span of the turn, for the z of a range.
    fn within(&self, range: &Range) -> Option<String> {
        let (turn, side) = (self.case.turn, self.case.side);
        let mut goals = String::new();
        for (part, way) in range.steady {
            goals += &Self::goes(*way, |r| self.value(turn, &part.term(), r));
        }
        for bound in range.bounds {
            let u = bound.part.term();
            let r = side.ratio(match (bound.bent, side) {
                (false, _) => range.here(),
                (true, Below) => range.over(&format!("(* p {u})")),
                (true, Above) => range.over(&format!("(/ p {u})")),
            });
            let d = |way: Way, span, u: &str| way.of(&self.value(span, u, "1"), &self.value(span, u, &r));
            let (span, w) = bound.at;
            let most = d(self.way_at(range, span, w)?, span, w);
            let _ = write!(goals, "(>= {most} {})", d(bound.way, turn, &u));
        }
        Some(self.section(range, &goals))
    }
}

const BECAUSE: &str = "As α rises from −∞ to 0, r falls from 1 to 0; as α falls from ∞ to 1, r rises from 1 to ∞. Let z be r in the one case and 1/r in the other, and let D be G_i less G_i for r = 1, a function of x for every z, which is 0 for z = 1. For each function, and for z = r and for z = 1/r, there is a section about all z, and one for every range of z. In a section, near is r for some z of its range and far is r for a smaller one; its parameters lead to every such pair. The first section: as z falls, G_i goes one way strictly at every point of the open spans of its support, but for one of them at most; so it does at the knots inside, at which it is continuous, but for those at which it is always 1; and it is 0 at both ends. The other sections are about the span left out. First, with >: there are parts of it, ends included, where G_i goes one way strictly as z falls within the range. Then, with >=: there are intervals of u, ends included by continuity, on which D, or −D, is at most D(w), or −D(w), for the same z, which is any but the lowest of the range. Here w is a fixed point at which this D, or −D, grows strictly as z falls within the range, by goals with >. Now take two different z < 1 of a range, the greater one first. For it |D| has a largest value, at some x, because G_i is continuous; and D(x) is not 0, because D is not 0 on the first span of the support. Say D(x) > 0; for D(x) < 0 read −D for D. Then x is neither an end of the support nor a knot at which G_i is always 1. If D(x) grows as z falls within the range, then the smaller z has a greater D(x). If x lies in an interval on which D is bounded, then the largest value is at most D(w), or −D(w), which is greater for the smaller z. There is no third possibility: at all other points G_i falls as z falls in this range and in those before it, from 1 on, so that D(x) would not be positive. So sup |D| is greater for the smaller z. Every range begins where the one before ends, the first one at 1, the last one ends at 0: sup |D| grows strictly as z falls in (0, 1).";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    if claim != "Ill5.1.effect" || amended {
        return None;
    }
    let mut sections = String::new();
    for case in CASES {
        for (name, indices) in case.functions {
            let instance =
                instances_named(name).into_iter().find(|instance| instance.degree == case.degree)?;
            for &i in *indices {
                let function = Function { case, on: Example::new(&instance), i };
                sections += &function.everywhere();
                for range in case.ranges {
                    sections += &function.within(range)?;
                }
            }
        }
    }
    Some(Formal { scope: Scope::Alpha, degrees: vec![1, 2, 3], because: BECAUSE.into(), sections })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::claims::formal::example::of_degree;
    use crate::scalar::{integer, rational};

    /// Every function of every example, on both sides, once.
    #[test]
    fn all_functions_are_there() {
        let mut wanted = Vec::new();
        for instance in of_degree(&["U0", "U1", "U2", "U3"], &[1, 2, 3]) {
            let n = instance.knots.m() - instance.degree - 1;
            wanted.extend((0..=n).map(|i| (instance.name, instance.degree, i)));
        }
        wanted.sort_unstable();
        for side in [Below, Above] {
            let mut found = Vec::new();
            for case in CASES.iter().filter(|case| case.side == side) {
                for (name, indices) in case.functions {
                    found.extend(indices.iter().map(|i| (*name, case.degree, *i)));
                }
            }
            found.sort_unstable();
            assert_eq!(found, wanted, "{side:?}");
        }
    }

    /// The ranges of z make up the whole of it; only a span that is empty has none.
    #[test]
    fn ranges_follow_each_other() {
        for case in CASES {
            for (name, indices) in case.functions {
                let instance = of_degree(&[name], &[case.degree]).remove(0);
                for i in *indices {
                    let turn = i + case.turn;
                    let empty = instance.knots.t(turn) == instance.knots.t(turn + 1);
                    assert_eq!(case.ranges.is_empty(), empty, "{name}, {i}");
                }
            }
            let Some((first, last)) = case.ranges.first().zip(case.ranges.last()) else { continue };
            assert_eq!((first.to, last.from), ("1", "0"));
            for pair in case.ranges.windows(2) {
                let ends = |range: &Range| Part(range.from, Some(range.to)).ends().unwrap();
                assert_eq!(pair[0].from, pair[1].to);
                assert!(pair.iter().map(ends).all(|(from, to)| from < to.unwrap()));
            }
        }
    }

    /// At every u of the span of the turn, for every range: where D is positive it grows, or is bounded; and so for −D. At the
    /// ends of all parts, between any two and beyond the last, as nothing changes elsewhere.
    #[test]
    fn parts_make_up_the_span() {
        for case in CASES {
            let mut ends = BTreeSet::from([integer(0)]);
            for range in case.ranges {
                let bounded = range.bounds.iter().map(|bound| bound.part);
                for part in range.steady.iter().map(|(part, _)| *part).chain(bounded) {
                    let (lo, hi) = part.ends().unwrap();
                    ends.extend([Some(lo), hi].into_iter().flatten());
                }
            }
            let ends: Vec<_> = ends.into_iter().collect();
            let mut points: Vec<_> =
                ends.windows(2).map(|pair| (&pair[0] + &pair[1]) * rational(1, 2)).collect();
            points.push(&ends[ends.len() - 1] + integer(1));
            points.extend(ends.into_iter().skip(1));
            let goes = |range: &Range, u: &BigRational, wanted: Way| {
                range.steady.iter().any(|(part, way)| *way == wanted && part.contains(u))
            };
            for (number, range) in case.ranges.iter().enumerate() {
                for u in &points {
                    for (way, other) in [(Up, Down), (Down, Up)] {
                        let grows = goes(range, u, way);
                        let bounded =
                            range.bounds.iter().any(|bound| bound.way == way && bound.part.contains(u));
                        let never = case.ranges[..=number].iter().all(|range| goes(range, u, other));
                        assert!(
                            grows || bounded || never,
                            "{:?} {:?}, {} ≤ z ≤ {}, {way:?}, u = {u}",
                            case.side,
                            case.functions,
                            range.from,
                            range.to
                        );
                    }
                }
            }
        }
    }
}
