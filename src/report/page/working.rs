//! A witness worked out: the recursion at its points, every weight and every value as an exact fraction.

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::analysis::{Location, Pieces, Shape};
use crate::judge::Witness;
use crate::scalar::{BigRational, Jet, parse_rational};
use crate::spline::{Active, Basis, Index, PointWeights, Side, Span, Weights, triangle};

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

/// All that can be worked out of a witness: the recursion at every point, for every index, from every side that it looked at.
/// Where it looked at no points but counted turns, at the knots where the function turns.
pub(super) fn workings(witness: &Witness) -> Vec<Working> {
    let Some(basis) = witness.basis() else { return Vec::new() };
    let derivatives = witness.looked.iter().any(|look| look.order > 0);
    let mut places: Vec<(Index, BigRational, Side)> = Vec::new();
    for look in &witness.looked {
        let side = if look.left { Side::Left } else { Side::Right };
        let (Ok(index), Ok(x)) = (look.alpha.parse(), parse_rational(&look.x)) else { continue };
        let place = (index, x, side);
        if !places.contains(&place) {
            places.push(place);
        }
    }
    // More of them would hide what they show.
    const SHOWN: usize = 4;
    let at = |(index, x, side): &(Index, BigRational, Side)| {
        working(&basis.with_index(index.clone()), x, *side, derivatives)
    };
    if !places.is_empty() {
        return places.iter().take(SHOWN).filter_map(at).collect();
    }
    let Some(i) = function(witness).filter(|_| !witness.words.is_empty()) else { return Vec::new() };
    // Where the function turns from falling to rising, or jumps: there the count of maxima is decided.
    let shape = Shape::of(&Pieces::of(&basis), i);
    let minima = shape.local_minima().filter_map(|minimum| match &minimum.place {
        Location::Point(x) => Some(x.clone()),
        _ => None,
    });
    let places: Vec<_> = minima.chain(shape.jumps().iter().map(|jump| jump.at.clone())).take(2).collect();
    let both = |x: &BigRational| [Side::Left, Side::Right].map(|side| working(&basis, x, side, true));
    places.iter().flat_map(both).flatten().collect()
}

/// The index of the function that a witness is about, where it is about one.
pub(super) fn function(witness: &Witness) -> Option<usize> {
    let index = |name| witness.number(name)?.to_integer().to_usize();
    index("i").or_else(|| index("j")).filter(|i| witness.k.is_some_and(|k| i + k + 1 < witness.knots.len()))
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
