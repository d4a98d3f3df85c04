//! What the reasons in the paper's file of windows say besides the goals: that cases make up a whole, and how signs change.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::collections::{BTreeMap, BTreeSet};

use knotproof::analysis::{Pieces, Sign};
use knotproof::certificate::{Sexp, windows};
use knotproof::language::{Form, claims};
use knotproof::meaning::examples_named;
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::Basis;

/// What the reason of Remark 5.1 says about the signs is so: one change where a quotient is given.
#[test]
fn derivatives_change_their_sign_once() {
    for name in ["U0", "U4", "U12"] {
        for instance in examples_named(name).iter().filter(|instance| instance.degree > 0) {
            for index in instance.indices() {
                let basis = Basis::new(instance.knots.clone(), instance.degree, index.clone()).unwrap();
                let pieces = Pieces::of(&basis);
                for i in 0..=basis.n() {
                    let mut signs = Vec::new();
                    for span in pieces.spans().iter().filter(|span| span.functions.get(i).is_some()) {
                        let slope = span.derivative(&span.function(i));
                        let coefficients = slope.numerator().coefficients().iter();
                        let of_span: Vec<_> =
                            coefficients.map(Sign::of).filter(|sign| *sign != Sign::Zero).collect();
                        let changes = of_span.windows(2).filter(|pair| pair[0] != pair[1]).count();
                        assert!(changes <= 1, "{name}, {i}: {of_span:?}");
                        signs.extend([of_span[0], of_span[of_span.len() - 1]]);
                    }
                    signs.dedup();
                    assert!(signs.len() <= 2 && signs.is_sorted_by(|a, b| a >= b), "{name}, {i}: {signs:?}");
                }
            }
        }
    }
}

// Illustration 5.1, the effect of α on each function of U0 to U3: words as in its reason.

/// lo ≤ u ≤ hi, or all u ≥ lo.
type Part = (BigRational, Option<BigRational>);

/// The way that a function, or D, goes as z falls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Up,
    Down,
}

/// Which function, and on which side of r = 1: knots, k, i, and whether r < 1.
type Key = (Vec<BigRational>, usize, usize, bool);

/// D, or −D, on a part of a span is at most as large as at a point.
struct Bound {
    way: Way,
    at: (usize, BigRational, Way),
    on: (usize, Part),
}

/// A section.
struct Range {
    key: Key,
    from: BigRational,
    to: BigRational,
    /// Spans with the parts of them where the function goes one way.
    steady: Vec<(usize, Part, Way)>,
    bounds: Vec<Bound>,
}

fn items(form: &Sexp) -> &[Sexp] {
    form.as_form().unwrap_or_else(|| panic!("{form}")).1
}

fn number(sexp: &Sexp) -> BigRational {
    let Sexp::Number(value) = sexp else { panic!("{sexp}") };
    value.clone()
}

fn natural(sexp: &Sexp) -> usize {
    sexp.to_string().parse().unwrap()
}

fn contains((lo, hi): &Part, u: &BigRational) -> bool {
    lo <= u && hi.as_ref().is_none_or(|hi| u <= hi)
}

/// The value of a term for some p, and v = s = 0.
fn value(term: &Sexp, p: i64) -> BigRational {
    let Some((head, items)) = term.as_form() else {
        return match term {
            Sexp::Number(value) => value.clone(),
            Sexp::Name(name) if name == "p" => integer(p),
            _ => integer(0),
        };
    };
    let values = items.iter().map(|item| value(item, p));
    match head {
        "+" => values.sum(),
        "*" => values.product(),
        "/" => values.reduce(|a, b| a / b).unwrap(),
        _ => panic!("{term}"),
    }
}

/// The values of a term in v ≥ 0, ends included.
fn part(term: &Sexp) -> Part {
    match (term.as_form(), term) {
        (None, Sexp::Number(w)) => (w.clone(), Some(w.clone())),
        (Some(("+", [lo, _])), _) => (number(lo), None),
        (Some(("/", [Sexp::Number(hi), _])), _) => (integer(0), Some(hi.clone())),
        (Some(("/", [ends, _])), _) => (number(&items(ends)[0]), Some(number(&items(&items(ends)[1])[0]))),
        _ => panic!("{term}"),
    }
}

/// G_i on a part of a span, for an r.
#[derive(PartialEq, Eq)]
struct Value {
    function: (usize, usize),
    span: usize,
    part: Part,
}

/// A value and its r.
fn value_of(term: &Sexp) -> (Value, String) {
    let [Sexp::List(bindings), function] = items(term) else { panic!("{term}") };
    let bound = |name: &str| {
        let of_name = bindings.iter().find(|binding| binding.as_form().unwrap().0 == name)?;
        Some(&items(of_name)[0])
    };
    let [i, k, place] = items(function) else { panic!("{term}") };
    let part = bound("u").map_or((integer(0), None), part);
    let value = Value { function: (natural(k), natural(i)), span: natural(&items(place)[1]), part };
    (value, bound("r").unwrap().to_string())
}

/// A difference of two values at one place: from a to b, `(- b a)` is up and `(- a b)` down.
fn difference(term: &Sexp, a: &str) -> (Value, Way) {
    let [(left, of_left), (right, of_right)] = [0, 1].map(|place| value_of(&items(term)[place]));
    assert!(left == right && of_left != of_right && [&of_left, &of_right].iter().any(|r| *r == a), "{term}");
    (left, if of_right == a { Way::Up } else { Way::Down })
}

fn range(section: &Sexp) -> Range {
    let parts = items(section);
    let all = |head: &'static str| parts.iter().filter(move |part| part.as_form().unwrap().0 == head);
    let [near, far] = [0, 1].map(|place| &items(all("let").nth(place).unwrap())[1]);
    let below = value(near, 1) < value(near, 0);
    let z = |r: BigRational| if below { r } else { integer(1) / r };
    let to_zero = all("positive").next().is_some();
    let from = if to_zero { integer(0) } else { z(value(far, 0)) };
    let knots = items(all("knots").next().unwrap())[2..].iter().map(number).collect();
    let (mut steady, mut bounds, mut functions) = (Vec::new(), Vec::new(), BTreeSet::new());
    for goal in items(all("goals").next().unwrap()) {
        match goal.as_form().unwrap() {
            (">", [term, _]) if !term.to_string().contains("(to A") => {
                let (value, way) = difference(term, "near");
                functions.insert(value.function);
                steady.push((value.span, value.part, way));
            }
            (">=", [most, term]) => {
                let ((most, grows), (value, way)) = (difference(most, "1"), difference(term, "1"));
                functions.extend([most.function, value.function]);
                bounds.push(Bound { way, at: (most.span, most.part.0, grows), on: (value.span, value.part) });
            }
            _ => {}
        }
    }
    let functions: Vec<_> = functions.into_iter().collect();
    let [(k, i)] = functions[..] else { panic!("one function: {section}") };
    Range { key: (knots, k, i, below), from, to: z(value(near, 0)), steady, bounds }
}

/// Each function of each example, on both sides, with its section about all z and those about ranges.
fn effect() -> BTreeMap<Key, Vec<Range>> {
    let effect = claims().into_iter().find(|claim| claim.id() == "Ill5.1.effect").unwrap();
    let stated = windows(effect, Form::Printed, None).unwrap().unwrap();
    let mut all: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for section in Sexp::parse_all(&stated.argued.as_ref().unwrap().sections).unwrap() {
        let range = range(&section);
        all.entry(range.key.clone()).or_default().push(range);
    }
    all
}

/// The span on which a function turns: the one of its support that the section about all z leaves out.
fn turn((knots, k, i, _): &Key, everywhere: &Range) -> Option<usize> {
    let open = (*i..=i + k).filter(|span| knots[*span] < knots[span + 1]);
    let whole = |span: &usize| {
        everywhere.steady.iter().any(|(on, part, _)| on == span && *part == (integer(0), None))
    };
    let left: Vec<_> = open.filter(|span| !whole(span)).collect();
    assert!(left.len() <= 1, "{left:?}");
    left.first().copied()
}

impl Range {
    fn goes(&self, span: usize, u: &BigRational, way: Way) -> bool {
        self.steady.iter().any(|(on, part, goes)| *on == span && contains(part, u) && *goes == way)
    }
}

#[test]
fn every_function_of_the_examples_is_there_on_both_sides() {
    let mut wanted = BTreeSet::new();
    for name in ["U0", "U1", "U2", "U3"] {
        for instance in examples_named(name).iter().filter(|instance| (1..=3).contains(&instance.degree)) {
            let (knots, k) = (instance.knots.knots().to_vec(), instance.degree);
            let functions = 0..instance.knots.m() - k;
            wanted.extend(functions.flat_map(|i| [false, true].map(|below| (knots.clone(), k, i, below))));
        }
    }
    assert_eq!(effect().into_keys().collect::<BTreeSet<_>>(), wanted);
}

/// The ranges of z make up the whole of it; only a function without a span of its turn has none.
#[test]
fn ranges_follow_each_other() {
    for (key, sections) in effect() {
        let (everywhere, ranges) = sections.split_first().unwrap();
        assert_eq!((&everywhere.from, &everywhere.to), (&integer(0), &integer(1)), "{key:?}");
        assert_eq!(ranges.is_empty(), turn(&key, everywhere).is_none(), "{key:?}");
        let Some((first, last)) = ranges.first().zip(ranges.last()) else { continue };
        assert_eq!((&first.to, &last.from), (&integer(1), &integer(0)), "{key:?}");
        assert!(ranges.windows(2).all(|pair| pair[0].from == pair[1].to), "{key:?}");
        assert!(ranges.iter().all(|range| range.from < range.to), "{key:?}");
    }
}

/// At every u of the span of the turn, for every range: where D is positive it grows, or is bounded; and so for −D. At the
/// ends of all parts, between any two and beyond the last, as nothing changes elsewhere. What bounds it does grow.
#[test]
fn parts_make_up_the_span() {
    let mut tried = 0;
    for (key, sections) in effect() {
        let (everywhere, ranges) = sections.split_first().unwrap();
        let Some(turn) = turn(&key, everywhere) else { continue };
        let mut ends = BTreeSet::from([integer(0)]);
        for range in ranges {
            let parts = range.steady.iter().map(|(on, part, _)| (on, part));
            for (on, (lo, hi)) in parts.chain(range.bounds.iter().map(|bound| (&bound.on.0, &bound.on.1))) {
                assert_eq!(*on, turn, "{key:?}");
                ends.extend([Some(lo.clone()), hi.clone()].into_iter().flatten());
            }
        }
        let ends: Vec<_> = ends.into_iter().collect();
        let mut points: Vec<_> = ends.windows(2).map(|pair| (&pair[0] + &pair[1]) * rational(1, 2)).collect();
        points.push(&ends[ends.len() - 1] + integer(1));
        points.extend(ends.into_iter().skip(1));
        for (number, range) in ranges.iter().enumerate() {
            for bound in &range.bounds {
                let (span, w, way) = &bound.at;
                let grows = range.goes(*span, w, *way) || everywhere.goes(*span, w, *way);
                assert!(grows, "{key:?}, {w} on span {span}");
            }
            for (u, way) in points.iter().flat_map(|u| [(u, Way::Up), (u, Way::Down)]) {
                let other = if way == Way::Up { Way::Down } else { Way::Up };
                let bounded = range.bounds.iter().any(|bound| bound.way == way && contains(&bound.on.1, u));
                let never = ranges[..=number].iter().all(|range| range.goes(turn, u, other));
                assert!(
                    range.goes(turn, u, way) || bounded || never,
                    "{key:?}, range {number}, {way:?}, {u}"
                );
                tried += 1;
            }
        }
    }
    assert!(tried > 500, "only {tried} points");
}
