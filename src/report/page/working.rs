//! A witness worked out: the recursion at its points, every weight and every value as an exact fraction.

use num_traits::{One, Signed, Zero};

use crate::analysis::{Location, Pieces, Shape};
use crate::claims::Witness;
use crate::scalar::{BigRational, Jet, parse_rational};
use crate::spline::{Active, Basis, Index, KnotVector, PointWeights, Side, Span, Weights, triangle, weight};

use super::formula;

/// The recursion at one point, for one index, in lines of HTML.
pub(super) struct Working {
    /// What is worked out.
    pub(super) title: String,
    /// The slope ratio and the span.
    pub(super) preparation: Vec<String>,
    /// From degree 0 to k.
    pub(super) levels: Vec<Level>,
}

/// The step to one degree.
pub(super) struct Level {
    /// d.
    pub(super) degree: usize,
    /// The weights, then the functions.
    pub(super) lines: Vec<String>,
}

/// The basis of a witness, and its α as it is written there.
pub(super) struct Setting {
    /// The basis.
    pub(super) basis: Basis,
    /// i, where there is one.
    pub(super) i: Option<usize>,
    /// x, where there is one.
    pub(super) x: Option<BigRational>,
}

/// What stands under a name.
fn given<'a>(witness: &'a Witness, name: &str) -> Option<&'a str> {
    witness.given.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
}

fn number(witness: &Witness, name: &str) -> Option<BigRational> {
    parse_rational(given(witness, name)?).ok()
}

/// The numbers of `(a, b, c)`.
fn list(text: &str) -> Option<Vec<BigRational>> {
    let inner = text.strip_prefix('(')?.strip_suffix(')')?;
    inner.split(", ").map(|number| parse_rational(number).ok()).collect()
}

impl Setting {
    /// The basis that the witness is about; `None` for one about the weight, or about no α in particular.
    pub(super) fn of(witness: &Witness) -> Option<Self> {
        let knots = KnotVector::new(list(given(witness, "U")?)?).ok()?;
        let degree = given(witness, "k")?.parse().ok()?;
        let index: Index = given(witness, "α")?.parse().ok()?;
        let basis = Basis::new(knots, degree, index).ok()?;
        let i = given(witness, "i").or(given(witness, "j")).and_then(|i| i.parse().ok());
        let i = i.filter(|&i| i <= basis.n());
        Some(Self { basis, i, x: number(witness, "x") })
    }
}

/// All that can be worked out of a witness; nothing where it is about more than values at points.
pub(super) fn workings(witness: &Witness) -> Vec<Working> {
    match Setting::of(witness) {
        Some(setting) => of_basis(witness, &setting),
        None => of_weight(witness).into_iter().collect(),
    }
}

fn of_basis(witness: &Witness, setting: &Setting) -> Vec<Working> {
    let Setting { basis, i, x } = setting;
    let text = format!("{} {}", witness.claimed, witness.found);
    let derivatives = ["DG", "derivative", "differentiable", "slope"].iter().any(|word| text.contains(word));
    let at = |x: &BigRational, side| working(basis, x, side, derivatives);
    if let Some(x) = x {
        // A symmetry is between two indices.
        if text.contains("1−α") {
            let mirrored = basis.knots().mirror(x);
            let conjugate = basis.with_index(basis.index().conjugate());
            let pair = [(basis, &mirrored), (&conjugate, x)];
            return pair
                .iter()
                .filter_map(|(basis, x)| working(basis, x, Side::Right, derivatives))
                .collect();
        }
        let left = text.contains("left limit") || text.contains("from the left");
        let sides: &[Side] = match (left, text.contains("one-sided") || text.contains("jumps")) {
            (true, _) => &[Side::Left],
            (_, true) => &[Side::Left, Side::Right],
            _ => &[Side::Right],
        };
        return sides.iter().filter_map(|side| at(x, *side)).collect();
    }
    if let Some(points) = given(witness, "points").and_then(list) {
        return points.iter().filter_map(|x| at(x, Side::Right)).collect();
    }
    let Some(i) = *i else { return Vec::new() };
    if !text.contains("maxim") && !text.contains("largest") {
        return Vec::new();
    }
    // Where the function turns from falling to rising, or jumps: there the count of maxima is decided.
    let shape = Shape::of(&Pieces::of(basis), i);
    let minima = shape.local_minima().filter_map(|minimum| match &minimum.place {
        Location::Point(x) => Some(x.clone()),
        _ => None,
    });
    let places: Vec<_> = minima.chain(shape.jumps().iter().map(|jump| jump.at.clone())).take(2).collect();
    let both = |x: &BigRational| [Side::Left, Side::Right].map(|side| working(basis, x, side, true));
    places.iter().flat_map(both).flatten().collect()
}

/// A number as a factor: in parentheses if it is negative.
fn factor(value: &BigRational) -> String {
    if value.is_negative() { format!("({value})") } else { value.to_string() }
}

fn difference(high: &BigRational, low: &BigRational) -> String {
    format!("({} − {})", factor(high), factor(low))
}

/// The triangle at x, seen from the side; `None` outside of [t_0, t_m], where there is nothing to compute.
pub(super) fn working(basis: &Basis, x: &BigRational, side: Side, derivatives: bool) -> Option<Working> {
    let (knots, k, m) = (basis.knots(), basis.degree(), basis.knots().m());
    let span = knots.span_at(x, side)?;
    let (j, (start, end)) = (span.index(), knots.ends(span).ok()?);
    let ratio = basis.index().ratio();
    let limit = if x == end {
        ", limits from the left"
    } else if knots.multiplicity(x) > 0 {
        ", limits from the right"
    } else {
        ""
    };
    let title = formula::html(&format!("At x = {x}, for α = {}{limit}", shown(basis.index())));
    let inside = if x == end { format!("{start} < x ≤ {end}") } else { format!("{start} ≤ x < {end}") };
    let preparation = vec![
        formula::html(&format!("Slope ratio: {}.", slope(basis.index()))),
        formula::html(&format!(
            "Span: j = {j}, that is t_{{{j}}} = {start} and t_{{{}}} = {end}, with {inside}.",
            j + 1
        )),
    ];
    let weights = PointWeights::new(knots, Jet::constant(ratio.clone(), 1), Jet::variable(x.clone(), 1));
    let mut levels = Vec::with_capacity(k + 1);
    let mut before = triangle(&weights, span, 0, m);
    levels
        .push(Level { degree: 0, lines: vec![formula::html(&format!("G_{{{j}}}^0 = 1, all others are 0"))] });
    for d in 1..=k {
        let here = triangle(&weights, span, d, m);
        let mut lines: Vec<String> = before
            .iter()
            .filter(|(i, _)| i + d <= m)
            .map(|(i, _)| weight_line(basis, &weights, x, i, d, derivatives))
            .collect();
        lines.extend(
            here.iter().map(|(i, value)| function_line(&weights, &before, span, (i, d), value, derivatives)),
        );
        levels.push(Level { degree: d, lines });
        before = here;
    }
    Some(Working { title, preparation, levels })
}

fn shown(index: &Index) -> String {
    index.alpha().map_or_else(|| "∞".to_owned(), |alpha| alpha.to_string())
}

/// The computation of r.
fn slope(index: &Index) -> String {
    match index.alpha() {
        Some(alpha) => {
            let alpha = factor(&alpha);
            format!("r = α/(α − 1) = ({alpha})/({alpha} − 1) = {}", index.ratio())
        }
        None => "r = 1, as α = ∞".to_owned(),
    }
}

fn value(jet: &Jet<BigRational>) -> BigRational {
    jet.coefficients().first().cloned().unwrap_or_else(BigRational::zero)
}

fn slope_at(jet: &Jet<BigRational>) -> BigRational {
    jet.coefficients().get(1).cloned().unwrap_or_else(BigRational::zero)
}

/// `w_i^d = r(x − t_i)/(r(x − t_i) + (t_{i+d} − x)) = …`.
fn weight_line(
    basis: &Basis,
    weights: &PointWeights<'_, Jet<BigRational>>,
    x: &BigRational,
    i: usize,
    d: usize,
    derivatives: bool,
) -> String {
    let (a, b) = (basis.knots().t(i), basis.knots().t(i + d));
    let (w, _) = weights.pair(i, d);
    let mut line = format!("w_{{{i}}}^{d} = {} = {}", quotient(basis.index().ratio(), x, a, b), value(&w));
    if derivatives {
        let r = factor(basis.index().ratio());
        line += &format!(
            ", Dw_{{{i}}}^{d} = ({r}·{})/({}·{} + {})^2 = {}",
            difference(b, a),
            r,
            difference(x, a),
            difference(b, x),
            slope_at(&w)
        );
    }
    formula::html(&line)
}

/// r(x − a)/(r(x − a) + (b − x)) with numbers put in.
fn quotient(ratio: &BigRational, x: &BigRational, a: &BigRational, b: &BigRational) -> String {
    let rise =
        if ratio.is_one() { difference(x, a) } else { format!("{}·{}", factor(ratio), difference(x, a)) };
    format!("({rise})/({rise} + {})", difference(b, x))
}

/// `G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1} = …`, without what is identically 0.
fn function_line(
    weights: &PointWeights<'_, Jet<BigRational>>,
    before: &Active<Jet<BigRational>>,
    span: Span,
    (i, d): (usize, usize),
    found: &Jet<BigRational>,
    derivatives: bool,
) -> String {
    let (mut symbols, mut numbers, mut products) = (Vec::new(), Vec::new(), Vec::new());
    let q = d - 1;
    if let (true, Some(own)) = (i <= span.index(), before.get(i)) {
        let (w, _) = weights.pair(i, d);
        symbols.push(format!("w_{{{i}}}^{d} G_{{{i}}}^{q}"));
        numbers.push(format!("{}·{}", value(&w), value(own)));
        products.push(product(&w, own));
    }
    if let Some(next) = before.get(i + 1) {
        let (w, rest) = weights.pair(i + 1, d);
        let i = i + 1;
        symbols.push(format!("(1 − w_{{{i}}}^{d}) G_{{{i}}}^{q}"));
        numbers.push(format!("(1 − {})·{}", value(&w), value(next)));
        products.push(product(&rest, next));
    }
    let mut line =
        format!("G_{{{i}}}^{d} = {} = {} = {}", symbols.join(" + "), numbers.join(" + "), value(found));
    if derivatives {
        line += &format!(", DG_{{{i}}}^{d} = {} = {}", products.join(" + "), slope_at(found));
    }
    formula::html(&line)
}

/// The product rule: (fg)′ = f′g + fg′.
fn product(f: &Jet<BigRational>, g: &Jet<BigRational>) -> String {
    format!("{}·{} + {}·{}", factor(&slope_at(f)), value(g), value(f), factor(&slope_at(g)))
}

/// The two sides of C2.4 and P2.1.3, which are about the weight alone.
fn of_weight(witness: &Witness) -> Option<Working> {
    let (a, b, x) = (number(witness, "a")?, number(witness, "b")?, number(witness, "x")?);
    let index: Index = given(witness, "α")?.parse().ok()?;
    let (left, right) = match (number(witness, "t1"), number(witness, "t2")) {
        (Some(t1), Some(t2)) => {
            let mirror = |y: &BigRational| &a + &b - y;
            ((mirror(&x), t1.clone(), t2.clone()), (x.clone(), mirror(&t2), mirror(&t1)))
        }
        _ => {
            let (slope, shift) = given(witness, "T")?.strip_prefix("x ↦ ")?.split_once("·x + ")?;
            let (slope, shift) = (parse_rational(slope).ok()?, parse_rational(shift).ok()?);
            let map = |y: &BigRational| &slope * y + &shift;
            ((map(&x), map(&b), map(&a)), (x.clone(), a, b))
        }
    };
    let line = |index: &Index, (x, a, b): &(BigRational, BigRational, BigRational), name: &str| {
        let arguments = format!("φ_{{{name}}}({x}, {a}, {b})");
        formula::html(&if a <= x && x < b {
            let found = weight(index.ratio(), x, a, b).0;
            format!("{arguments} = {} = {found}", quotient(index.ratio(), x, a, b))
        } else {
            format!("{arguments} = 0, because {x} is not in [{a}, {b})")
        })
    };
    let conjugate = index.conjugate();
    let phi = |index: &Index, (x, a, b): &(BigRational, BigRational, BigRational)| {
        if a <= x && x < b { weight(index.ratio(), x, a, b).0 } else { BigRational::zero() }
    };
    let (first, second) = (phi(&index, &left), phi(&conjugate, &right));
    let lines = vec![
        line(&index, &left, "α"),
        line(&conjugate, &right, "1−α"),
        formula::html(&format!(
            "The left side is {first} and the right side 1 − {second} = {}.",
            BigRational::one() - &second
        )),
    ];
    Some(Working {
        title: "The two sides".to_owned(),
        preparation: vec![formula::html(&format!(
            "Slope ratios: {} for α, and 1/r = {} for 1 − α = {}.",
            slope(&index),
            conjugate.ratio(),
            shown(&conjugate)
        ))],
        levels: vec![Level { degree: 0, lines }],
    })
}
