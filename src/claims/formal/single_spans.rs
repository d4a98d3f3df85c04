//! What a function of degree 3 does inside one span: it rises and then falls, if both.

use std::fmt::Write as _;

use crate::analysis::LocalKnots;
use crate::scalar::{Multivariate, Polynomial, Ring};

/// The gaps of the local knots of G_0^3, and r, by number of variable.
const NAMES: [&str; 5] = ["f", "g", "h", "v", "r"];

/// (a, i, j, b) for a·p_i·e_j ≥ b·p_{i−1}·e_{j+1}: so if e_j is negative, e_{j+1} is not positive.
const STEPS: [(usize, usize, usize, usize); 6] =
    [(2, 2, 2, 1), (7, 3, 3, 4), (2, 4, 4, 1), (8, 4, 5, 7), (3, 4, 6, 5), (2, 5, 7, 3)];

/// On span s = 1 or 2 with G_0 = P/Q: P = Σ p_i u^i, Q = Σ q_i u^i, and N = P′Q − PQ′ = Σ e_j u^j. Span 2 is span 1 of the
/// reversed knots: there p, q and e are numbered from the other end, and −N is meant.
fn section(s: usize) -> String {
    let x = Multivariate::variable;
    let Ok(knots) = LocalKnots::new((0..4).map(x).collect(), (x(4), x(4).one())) else {
        return String::new();
    };
    let Some(quotient) = knots.on_span(s) else { return String::new() };
    let (p, q) = (&quotient.numerator, &quotient.denominator);
    let (degree, reversed) = (q.degree(), s == 2);
    let number = |i: usize, of: usize| if reversed { of - i } else { i };
    let mut text = format!("(section (nonnegative f {} v) (positive {}) ", NAMES[3 - s], NAMES[s]);
    for (name, polynomial) in [("p", p), ("q", q)] {
        for (i, c) in padded(polynomial, degree).iter().enumerate() {
            let _ = write!(text, "(let {name}{} {})", number(i, degree), term(c));
        }
    }
    // N has degree 2·deg Q − 2: its coefficient at 2·deg Q − 1 is 0.
    let top = 2 * degree - 2;
    for e in 0..=top {
        let _ = write!(text, "(let e{e} (+");
        for i in 0..=degree.min(e + 1) {
            let h = e + 1 - i;
            // The factor i − h is the same from the other end, where −N is meant.
            if h <= degree && i != h {
                let factor = i64::try_from(i).unwrap_or(0) - i64::try_from(h).unwrap_or(0);
                let _ = write!(text, " (* {factor} p{i} q{h})");
            }
        }
        text.push_str("))");
    }
    let sum: String = (0..=top).map(|e| format!(" (* e{} (^ u {e}))", number(e, top))).collect();
    let product: String = (0..=degree).map(|i| format!(" (* q{} (^ u {i}))", number(i, degree))).collect();
    let sign = if reversed { -1 } else { 1 };
    let _ = write!(
        text,
        "(window A 0 f g h v) (goals (= (DG 0 3 (in A {s})) (/ (* {sign} (+{sum}) (^ (+ 1 u) 2)) (* {} (^ (+{product}) 2)))) \
         (>= e0 0) (>= e1 0) (> p2 0) (> p3 0) (> p4 0) (>= p5 0)",
        NAMES[s]
    );
    for (a, i, j, b) in STEPS {
        let _ = write!(text, " (>= (* {a} p{i} e{j}) (* {b} p{} e{}))", i - 1, j + 1);
    }
    text.push_str("))");
    text
}

fn padded(p: &Polynomial<Multivariate>, degree: usize) -> Vec<Multivariate> {
    let mut list = p.coefficients().to_vec();
    list.resize(degree + 1, list[0].zero());
    list
}

/// A polynomial as a sum of products.
fn term(p: &Multivariate) -> String {
    let product = |(monomial, c): (&crate::scalar::Monomial, _)| {
        let powers = monomial.exponents().map(|(v, e)| match e {
            1 => format!(" {}", NAMES[v]),
            _ => format!(" (^ {} {e})", NAMES[v]),
        });
        format!(" (* {c}{})", powers.collect::<String>())
    };
    let sum: String = p.terms().map(product).collect();
    if sum.is_empty() { "0".to_owned() } else { format!("(+{sum})") }
}

/// The goals for both inner spans.
pub(super) fn cubic() -> String {
    section(1) + &section(2)
}

pub(super) const CUBIC: &str = "On its first span the function rises and on its last one it falls, if these are not empty (first section). On a span between, G_0 = P/Q with polynomials in u that have coefficients p_i and q_i ≥ 0, and its derivative has the sign of N = P′Q − PQ′ with coefficients e_0, …, e_8, of which the first two are not negative, and after a negative one none is positive (last goals, since p_2, p_3 and p_4 are positive): so the signs change once at most, from + to −, and by Descartes' rule so does N. The other span between is treated likewise from its other end.";
