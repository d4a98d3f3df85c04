//! What refutes a claim, as goals about the witness that the engine found.

use std::fmt::Write as _;

use crate::analysis::{Pieces, Sign, is_combination, sign_pattern};
use crate::claims::verdict::{Scope, Witness};
use crate::scalar::{BigRational, RationalAlgebra, Ring, integer, parse_rational};
use crate::spline::{Basis, Index, KnotVector, Side};

use super::Formal;
use super::illustrations;

/// The basis of a witness, and the numbers that come with it.
struct Found<'a> {
    witness: &'a Witness,
    basis: Basis,
}

/// A list of numbers in parentheses.
fn numbers(text: &str) -> Option<Vec<BigRational>> {
    let inner = text.strip_prefix('(')?.strip_suffix(')')?;
    inner.split(", ").map(|number| parse_rational(number).ok()).collect()
}

impl<'a> Found<'a> {
    fn new(witness: &'a Witness) -> Option<Self> {
        let get = |name| text_of(witness, name);
        let knots = KnotVector::new(numbers(get("U")?)?).ok()?;
        // A statement about several indices has none of its own: the classical one does for its numbers.
        let index = get("α").map_or(Ok(Index::infinity()), str::parse).ok()?;
        let basis = Basis::new(knots, get("k")?.parse().ok()?, index).ok()?;
        Some(Self { witness, basis })
    }

    fn text(&self, name: &str) -> Option<&'a str> {
        text_of(self.witness, name)
    }

    fn natural(&self, name: &str) -> Option<usize> {
        self.text(name)?.parse().ok()
    }

    fn number(&self, name: &str) -> Option<BigRational> {
        parse_rational(self.text(name)?).ok()
    }

    fn k(&self) -> usize {
        self.basis.degree()
    }

    fn knots(&self) -> &KnotVector {
        self.basis.knots()
    }

    /// A term at a point: FUNCTION with the place put in for PLACE, from the given side. At t_m it is the limit from the
    /// left.
    fn at(&self, x: &BigRational, side: Side, function: &str) -> Option<String> {
        let knots = self.knots();
        let side = if x == knots.last() { Side::Left } else { side };
        let span = knots.span_at(x, side)?;
        let (start, end) = knots.ends(span);
        let place = |at: &str| function.replace("PLACE", &format!("({at} A {})", span.index()));
        Some(if x == start {
            place("from")
        } else if x == end {
            place("to")
        } else {
            let u = (x - start).over(&(end - x))?;
            format!("(at ((u {u})) {})", place("in"))
        })
    }

    fn function(&self, i: usize) -> String {
        format!("(G {i} {} PLACE)", self.k())
    }

    fn derivative(&self, i: usize) -> String {
        format!("(DG {i} {} PLACE)", self.k())
    }

    fn section(&self, goals: &str) -> String {
        self.section_with("", goals)
    }

    fn section_with(&self, more: &str, goals: &str) -> String {
        let list = |knots: &KnotVector| -> String { knots.knots().iter().map(|t| format!(" {t}")).collect() };
        let (ratio, knots) = (self.basis.index().ratio(), list(self.knots()));
        format!("(section (let r {ratio}) (knots A 0{knots}) {more} (goals {goals}))")
    }

    /// left ≠ right, as (left − right)² > 0.
    fn differ(left: &str, right: &str) -> String {
        format!("(> (^ (- {left} {right}) 2) 0)")
    }

    /// The functions that live on a span, by index.
    fn living(&self, span: usize, degree: usize) -> std::ops::RangeInclusive<usize> {
        span.saturating_sub(degree)..=span.min(self.knots().m() - degree - 1)
    }

    /// The span whose ends are written [a, b).
    fn span(&self) -> Option<usize> {
        let (start, _) = self.text("span")?.trim_matches(['[', ')', ']']).split_once(", ")?;
        self.knots().span_at(&parse_rational(start).ok()?, Side::Right).map(|span| span.index())
    }

    /// The term is no combination of the functions of the degree that live on the span.
    fn outside(&self, span: usize, term: &str, degree: usize) -> String {
        let others: Vec<_> =
            self.living(span, degree).map(|i| format!("(G {i} {degree} (in A {span}))")).collect();
        format!("(outside (in A {span}) {term} ({}))", others.join(" "))
    }
}

fn text_of<'a>(witness: &'a Witness, name: &str) -> Option<&'a str> {
    witness.given.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
}

/// What refutes the claim: the reason and the sections.
type Refuted = Option<(&'static str, String)>;

pub(super) fn refutation(claim: &str, witness: &Witness) -> Option<Formal> {
    let found = Found::new(witness);
    let (because, sections) = match (claim, &found) {
        ("P2.1.3" | "C2.4", _) => weight(claim, witness)?,
        (_, Some(found)) => of_basis(claim, found)?,
        _ => return None,
    };
    let degree = found.as_ref().map_or(1, Found::k);
    let because = because.split_whitespace().collect::<Vec<_>>().join(" ");
    Some(Formal { scope: Scope::Instance, degrees: vec![degree], because, sections })
}

/// Both claims fail where x is the first knot of an interval and its image the last: φ is 0 there by definition, while
/// 1 − φ is 1 at the first one.
fn weight(claim: &str, witness: &Witness) -> Refuted {
    let number = |name: &str| parse_rational(text_of(witness, name)?).ok();
    let (a, b, x) = (number("a")?, number("b")?, number("x")?);
    let (first, last) = match claim {
        "C2.4" => (&a + &b - number("t2")?, &a + &b - number("t1")?),
        _ => (a, b),
    };
    if x != first {
        return None;
    }
    let goals = format!("(section (knots A 0 {first} {last}) (goals (= (v 0 1 (from A 0)) 1)))");
    Some((
        "x is the first knot of the interval on the right side, where φ = 0 and 1 − φ = 1, for every index. Its image is the last knot of the interval on the left side, where φ is 0 by definition (a ≤ x < b does not hold).",
        goals,
    ))
}

fn of_basis(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, knots, n) = (found.k(), found.knots(), found.basis.n());
    let t_0 = knots.first();
    let x = || found.number("x");
    let i = || found.natural("i").or_else(|| found.natural("j"));
    Some(match claim {
        "T3.5.1" | "proof.P4.1.1.iff" | "P4.1.1" => {
            let value = found.at(&x()?, Side::Right, &found.function(i()?))?;
            (
                "x is not in the interval of the claim, and the function is positive there.",
                found.section(&format!("(> {value} 0)")),
            )
        }
        "T3.5.3" => {
            let span = knots.span_at(&x()?, Side::Right)?.index();
            let functions: Vec<_> = found.living(span, k).map(|i| found.function(i)).collect();
            let sum = found.at(&x()?, Side::Right, &format!("(+ {})", functions.join(" ")))?;
            (
                "All functions that exist and live on the span of x have a sum less than 1.",
                found.section(&format!("(< {sum} 1)")),
            )
        }
        "T3.5.4" | "P4.3" => {
            let (x, i) = (x()?, i()?);
            let left = found.at(&knots.mirror(&x), Side::Right, &found.function(i))?;
            let right = found.at(&x, Side::Right, &found.function(n - i))?;
            let right = format!("(at ((r (/ 1 r))) {right})");
            (
                "Left and right side of the claim for i at x, with 1/r for the index 1 − α.",
                found.section(&Found::differ(&left, &right)),
            )
        }
        "P3.1.3" | "P4.2.1" => {
            let (x, i) = (x()?, i()?);
            let wanted = usize::from(if x == *t_0 { i == 0 } else { i == n });
            let value = found.at(&x, Side::Right, &found.function(i))?;
            (
                "The value of the function at the end of the knots is not the one of the claim.",
                found.section(&Found::differ(&value, &wanted.to_string())),
            )
        }
        "abstract.regularity" => {
            let goal = |i| {
                let value = |side| found.at(&x()?, side, &found.function(i));
                Some(format!("(= {} {})", value(Side::Left)?, value(Side::Right)?))
            };
            if found.natural("p")? != k {
                return None;
            }
            let goals: Option<String> = (0..=n).map(goal).collect();
            (
                "The knot has multiplicity k, so that derivatives of order ≤ 0 are meant: and no function jumps there.",
                found.section(&goals?),
            )
        }
        "L3.8" | "L3.9" => end_relations(claim, found)?,
        "L3.10" | "T3.11.3a" | "T3.11.3b" => {
            let side = if x()? == *t_0 { Side::Right } else { Side::Left };
            let value = found.at(&x()?, side, &found.derivative(i()?))?;
            ("The claim says that this derivative is 0.", found.section(&Found::differ(&value, "0")))
        }
        "T3.11.2" => {
            let value = |side| found.at(&x()?, side, &found.function(i()?));
            (
                "The limit from the left is not the value: the difference quotients from the left diverge.",
                found.section(&Found::differ(&value(Side::Left)?, &value(Side::Right)?)),
            )
        }
        "P4.2.2" => {
            let (low, high) = if x()? == *t_0 { (0, k + 1) } else { (n, knots.m()) };
            (
                "The formula of the claim divides by the difference of these two knots, which is 0.",
                found.section(&format!("(= (t A {low}) (t A {high}))")),
            )
        }
        "Conj3.1.strong" | "Conj3.1.weak" | "Rem5.1.conj" => rises_and_drops(found, i()?)?,
        "Conj3.1.strong.continuous" => two_maxima(found, i()?)?,
        "Ill5.1.fig7" => {
            let value = found.at(&x()?, Side::Right, &found.function(i()?))?;
            let other: Index = found.witness.claimed.rsplit_once("α = ")?.1.parse().ok()?;
            let other = format!("(at ((r {})) {value})", other.ratio());
            (
                "The function has another value at x for the other index.",
                found.section(&Found::differ(&value, &other)),
            )
        }
        "Ill5.7.local" => {
            let last = knots.spans().next_back()?.index();
            (
                "The moved control point is d_4: its factor is positive on the whole last span, so nothing unmoved follows.",
                found.section(&format!("(> (G 4 {k} (in A {last})) 0)")),
            )
        }
        "Ill5.8.symmetry" => {
            let points = illustrations::points(found.text("instance")?, k)?;
            let goals: String =
                points.first()?.iter().zip(points.last()?).map(|(a, b)| format!("(= {a} {b})")).collect();
            (
                "The coordinates of the first and of the last control point are the same: they have no perpendicular bisector.",
                format!("(section (goals {goals}))"),
            )
        }
        "Ill5.8.double" => {
            let goals = illustrations::off_double_point(found.text("instance")?, k)?;
            (
                "The squared distance of the curve from its double control point is positive everywhere.",
                found.section(&goals),
            )
        }
        "proof.T3.5.2.cover" => {
            let (i, x) = (i()?, x()?);
            let moved = &x - t_0;
            (
                "x is the end of the one interval and the beginning of the other, and lies between t_i and t_{i+k+1}.",
                found.section(&format!(
                    "(= (t A {}) {moved}) (= (t A {}) {moved}) (< (t A {i}) {moved}) (> (t A {}) {moved})",
                    i + k,
                    i + 1,
                    i + k + 1
                )),
            )
        }
        "proof.P3.2.induction" => {
            let span = knots.spans().next()?.index();
            let (g, h) = (format!("(G 0 {k} (in A {span}))"), format!("(G 1 {k} (in A {span}))"));
            let orders: String =
                found.living(span, k).map(|i| format!("(order {i} {k} (in A {span}) {i})")).collect();
            (
                "On the only span the functions have the orders 0, 1, … at its first knot, and so are independent; with c_0 = G_1 and c_1 = −G_0 the sum is 0, and c_0 is positive where G_0 is.",
                found.section(&format!("{orders} (= (+ (* {h} {g}) (* (- {g}) {h})) 0) (> {h} 0) (> {g} 0)")),
            )
        }
        "X.G1" => {
            let (p, rest) = found.text("d")?.strip_prefix("0 but for d_")?.split_once(" = (1, 0) and d_")?;
            let q = rest.strip_suffix(" = (0, 1)")?;
            let slope = |side, i: &str| found.at(&x()?, side, &found.derivative(i.parse().ok()?));
            let rows = [Side::Left, Side::Right]
                .map(|side| Some(format!("({} {})", slope(side, p)?, slope(side, q)?)));
            let [left, right] = rows;
            (
                "The derivatives of the curve from the left and from the right are not parallel.",
                found.section(&Found::differ(&format!("(det {} {})", left?, right?), "0")),
            )
        }
        "X.totalpositivity" => {
            let list = found.text("functions")?.trim_matches(['(', ')']);
            let functions: Option<Vec<String>> = list
                .split(", ")
                .map(|name| Some(found.function(name.strip_prefix("G_")?.split_once('^')?.0.parse().ok()?)))
                .collect();
            let functions = functions?;
            let row = |x: &BigRational| {
                let row: Option<Vec<_>> = functions.iter().map(|f| found.at(x, Side::Right, f)).collect();
                Some(format!("({})", row?.join(" ")))
            };
            let rows: Option<Vec<_>> = numbers(found.text("points")?)?.iter().map(row).collect();
            (
                "The minor of these functions at these points is negative.",
                found.section(&format!("(< (det {}) 0)", rows?.join(" "))),
            )
        }
        "X.variation" => too_many_crossings(found)?,
        "X.linear" => {
            let span = found.span()?;
            (
                "Already on this span x is no combination of the functions that live there.",
                found.section(&found.outside(span, &format!("(x (in A {span}))"), k)),
            )
        }
        "X.derivative" => {
            let (span, i) = (found.span()?, i()?);
            (
                "On this span the derivative is no combination of the functions of degree k − 1 that live there.",
                found.section(&found.outside(span, &format!("(DG {i} {k} (in A {span}))"), k - 1)),
            )
        }
        "X.nested" => not_nested(found, i()?)?,
        _ => return None,
    })
}

/// One of the equations of L3.8 or L3.9 fails: the sum of the squares of the differences is positive.
fn end_relations(claim: &str, found: &Found<'_>) -> Refuted {
    let (k, n, q, x) = (found.k(), found.basis.n(), found.natural("r")?, found.number("x")?);
    let side = if claim == "L3.8" { Side::Right } else { Side::Left };
    let slope = |i: usize, d: usize| found.at(&x, side, &format!("(DG {i} {d} PLACE)"));
    let weight = |i: usize, d: usize| {
        // The weight of an empty interval is 0 by D2.3, and so is its derivative.
        let empty = found.knots().t(i) == found.knots().t(i + d);
        if empty { Some("0".to_owned()) } else { found.at(&x, side, &format!("(Dw {i} {d} PLACE)")) }
    };
    let (d, e) = (k - q, k - q - 1);
    let square = |left: String, lower: String, sign: &str, weight: String| {
        format!("(^ (- {left} ({sign} {lower} {weight})) 2)")
    };
    let squares = if claim == "L3.8" {
        let w = weight(q + 1, d)?;
        [
            square(slope(q, d)?, slope(q + 1, e)?, "-", w.clone()),
            square(slope(q + 1, d)?, slope(q + 2, e)?, "+", w),
        ]
    } else {
        let w = weight(n, d)?;
        [
            square(slope(n, d)?, slope(n, e)?, "+", w.clone()),
            square(slope(n - 1, d)?, slope(n - 1, e)?, "-", w),
        ]
    };
    Some((
        "The two equations of the claim for this r do not both hold: the sum of the squares of their differences is positive. The weight of an empty interval is 0, and so is its derivative.",
        found.section(&format!("(> (+ {}) 0)", squares.join(" "))),
    ))
}

/// G_i rises on all of its support, to the limit 1 at the end, and is 0 from there on: it has no maximum.
fn rises_and_drops(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knots) = (found.k(), found.knots());
    let (low, high) = found.basis.support(i);
    let mut goals = String::new();
    for span in knots.spans() {
        let (start, end) = knots.ends(span);
        if low <= start && end <= high {
            let s = span.index();
            let _ = write!(goals, "(> (DG {i} {k} (in A {s})) 0)");
            if start != low {
                let before = found.at(start, Side::Left, &found.function(i))?;
                let _ = write!(goals, "(= {before} {})", found.at(start, Side::Right, &found.function(i))?);
            }
        }
    }
    let (limit, value) =
        (found.at(high, Side::Left, &found.function(i))?, found.at(high, Side::Right, &found.function(i))?);
    let _ = write!(goals, "(= {limit} 1) (= {value} 0)");
    Some((
        "The function is continuous and rises on all of its support, tends to 1 at the end of it, and is 0 there and beyond: its supremum is not attained, and it has no local maximum.",
        found.section(&goals),
    ))
}

/// A knot where the continuous function falls before and rises after, while it is positive there and 0 at both ends.
fn two_maxima(found: &Found<'_>, i: usize) -> Refuted {
    let knots = found.knots();
    let slope = |x: &BigRational, side| found.basis.jets(x, side, 1)[i].coefficients()[1].clone();
    let valley = knots
        .inner_stop_knots()
        .map(|(x, _)| x)
        .find(|x| slope(x, Side::Left) < integer(0) && integer(0) < slope(x, Side::Right))?;
    let mut goals = format!(
        "(< {} 0) (> {} 0) (> {} 0)",
        found.at(valley, Side::Left, &found.derivative(i))?,
        found.at(valley, Side::Right, &found.derivative(i))?,
        found.at(valley, Side::Right, &found.function(i))?
    );
    for (x, _) in knots.inner_stop_knots() {
        let value = |side| found.at(x, side, &found.function(i));
        let _ = write!(goals, "(= {} {})", value(Side::Left)?, value(Side::Right)?);
    }
    Some((
        "The function is continuous, positive at the knot where it falls from the left and rises to the right, and it tends to 0 at the ends of its support or has its limits there: so there is a local maximum on either side of that knot.",
        found.section(&goals),
    ))
}

/// The curve with these ordinates changes its sign more often than its control polygon.
fn too_many_crossings(found: &Found<'_>) -> Refuted {
    let ordinates = numbers(found.text("ordinates of the control points")?)?;
    let pieces = Pieces::of(&found.basis);
    let mut signs: Vec<(Sign, String)> = Vec::new();
    for span in pieces.spans() {
        let terms = span.functions.iter().map(|(i, g)| g.times(&g.embed(&ordinates[i])));
        let sum = terms.fold(pieces.zero(), |sum, term| sum.plus(&term));
        let s = span.span.index();
        let term: String = found
            .living(s, found.k())
            .map(|i| format!(" (* {} (G {i} {} (in A {s})))", ordinates[i], found.k()))
            .collect();
        for (u, sign) in sign_pattern(&sum.numerator().times(sum.denominator())).between() {
            if *sign != Sign::Zero && signs.last().is_none_or(|(last, _)| last != sign) {
                signs.push((*sign, format!("(at ((u {u})) (+{term}))")));
            }
        }
    }
    let goals: String = signs
        .iter()
        .map(|(sign, value)| format!("({} {value} 0)", if *sign == Sign::Positive { ">" } else { "<" }))
        .collect();
    Some((
        "The ordinate of the curve with these control points has these signs, alternating, at points from left to right; the ordinates of the control points themselves change their sign less often.",
        found.section(&goals),
    ))
}

/// G_i is no combination of the functions of the refined knots, on some span of these.
fn not_nested(found: &Found<'_>, i: usize) -> Refuted {
    let (k, knot) = (found.k(), found.number("new knot")?);
    let refined = found.knots().with_knot(&knot);
    let fine = Basis::new(refined.clone(), k, found.basis.index().clone()).ok()?;
    let pieces = Pieces::of(&fine);
    for span in pieces.spans() {
        let (start, _) = refined.ends(span.span);
        let old = found.knots().span_at(start, Side::Right)?;
        let (a, b) = found.knots().ends(old);
        // The old function at the points of the new span.
        let active = found.basis.active(old, &span.x);
        let Some(value) = active.get(i) else { continue };
        if is_combination(span.functions.values(), value) {
            continue;
        }
        let (s, t) = (span.span.index(), old.index());
        let first = found.knots().first();
        let (a, b) = (a - first, b - first);
        let point = format!("(x (in B {s}))");
        let term = format!("(at ((u (/ (- {point} {a}) (- {b} {point})))) (G {i} {k} (in A {t})))");
        let m = refined.m();
        let others: Vec<_> =
            (s.saturating_sub(k)..=s.min(m - k - 1)).map(|j| format!("(G {j} {k} (in B {s}))")).collect();
        let window: String = refined.knots().iter().map(|t| format!(" {t}")).collect();
        let goal = format!("(outside (in B {s}) {term} ({}))", others.join(" "));
        return Some((
            "B has the refined knots. On this span of B the function for A, at the point of A that has the same x, is no combination of the functions for B that live there.",
            found.section_with(&format!("(knots B 0{window})"), &goal),
        ));
    }
    None
}
