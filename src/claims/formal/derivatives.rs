//! Section 3: derivatives at the ends, smoothness, and what is lost at a knot.

use std::ops::RangeInclusive;

use super::Formal;
use super::basis::{CONTINUITY, STARTS_WITH_A_JUMP};

const FIRST: &str = "(window A 0 (each s 1 k 0) some (each s 1 k any))";
const LAST: &str = "(window A (- 0 k) (each s 1 k any) some (each s 1 k 0))";

/// D⁺G at t_0 and, with index 0 for n, D⁻G at t_m.
fn ends(first: &str, last: &str) -> String {
    format!("(section {FIRST} (goals {first}))(section {LAST} (goals {last}))")
}

const AT_FIRST: &str = "(= (DG 0 k (from A k)) (- (/ (* (integer k) r) (A k)))) (= (DG 1 k (from A k)) (/ (* (integer k) r) (A k))) \
    (each i 2 k (= (DG i k (from A k)) 0))";
const AT_LAST: &str = "(= (DG 0 k (to A 0)) (/ (integer k) (* r (A 0)))) (= (DG -1 k (to A 0)) (- (/ (integer k) (* r (A 0))))) \
    (each i (- 0 k) -2 (= (DG i k (to A 0)) 0))";

/// r and its inverse in terms of α.
const RATIO: &str = "(section (positive s) (let alpha (- s)) (let r (/ alpha (- alpha 1))) (goals \
    (= r (/ alpha (- alpha 1))) (= (/ 1 r) (/ (- alpha 1) alpha)))) \
    (section (positive s) (let alpha (+ 1 s)) (let r (/ alpha (- alpha 1))) (goals \
    (= r (/ alpha (- alpha 1))) (= (/ 1 r) (/ (- alpha 1) alpha))))";

/// The jump of DG_{−1} at the simple knot t_0, the second one of the function.
const JUMP: &str = "(section (window A (- -1 k) (each s 1 k any) some some (each s 1 k any)) (goals \
    (= (- (DG -1 k (from A 0)) (DG -1 k (to A -1))) \
    (* (/ (- r 1) (+ (* r (A -1)) (A 0))) (each d 3 k (w -1 d (from A 0))))) \
    (each d 3 k (> (w -1 d (from A 0)) 0))))";

/// The jumps of DG at a knot t_0 = … = t_{p−1}, for the two functions that have one more knot on one side.
const JUMPS_AT_MULTIPLE_KNOT: &str = "(section (each p 1 (- k 1)) (window A (- -1 k) (each s 1 k any) some (each s 1 (- p 1) 0) some \
    (each s 1 k any)) (goals \
    (= (- (DG -1 k (from A (- p 1))) (DG -1 k (to A -1))) \
    (* (/ (* (integer p) (- r 1)) (+ (* r (A -1)) (A (- p 1)))) (each d (+ p 2) k (w -1 d (from A (- p 1)))))) \
    (= (- (DG (- (- p 1) k) k (from A (- p 1))) (DG (- (- p 1) k) k (to A -1))) \
    (* (/ (* (integer p) (- 1 r)) (+ (* r (A -1)) (A (- p 1)))) (each d (+ p 2) k (v (- p d) d (from A (- p 1)))))) \
    (each d (+ p 2) k (> (w -1 d (from A (- p 1))) 0) (> (v (- p d) d (from A (- p 1))) 0))))";

/// For r = 1: D G_i^d = d·(Dw_i^d·G_i^{d−1} − Dw_{i+1}^d·G_{i+1}^{d−1}) on the span 0, where a function that does not live
/// there is left out.
fn derivative_formula(i: i64, d: i64) -> String {
    let share = |j: i64| format!("(* (Dw {j} {d} (in A 0)) (G {j} {} (in A 0)))", d - 1);
    let difference = match i {
        0 => share(0),
        i if i == -d => format!("(- {})", share(i + 1)),
        i => format!("(- {} {})", share(i), share(i + 1)),
    };
    format!("(= (DG {i} {d} (in A 0)) (* {d} {difference}))")
}

/// For r = 1: equations between the weights w_i^d, w_i^{d−1}, w_{i+1}^{d−1} and their derivatives.
struct Neighbours;

impl Neighbours {
    fn of(what: &str, i: i64, d: i64) -> String {
        format!("({what} {i} {d} (in A 0))")
    }

    /// Dw_i^d·w_i^{d−1} = w_i^d·Dw_i^{d−1}.
    fn rising(i: i64, d: i64) -> String {
        let of = Self::of;
        format!(
            "(= (* {} {}) (* {} {}))",
            of("Dw", i, d),
            of("w", i, d - 1),
            of("w", i, d),
            of("Dw", i, d - 1)
        )
    }

    /// Dw_i^d·(1 − w_{i+1}^{d−1}) = (1 − w_i^d)·Dw_{i+1}^{d−1}.
    fn falling(i: i64, d: i64) -> String {
        let of = Self::of;
        format!(
            "(= (* {} {}) (* {} {}))",
            of("Dw", i, d),
            of("v", i + 1, d - 1),
            of("v", i, d),
            of("Dw", i + 1, d - 1)
        )
    }
}

/// The formula for the degrees up to `highest`, and how it follows from degree to degree: by the product rule, what is
/// left when the formulas for degree d − 1 are put in is a combination of functions of degree d − 2, whose factors are
/// 0 by the equations between neighbouring weights.
fn classical_derivatives(highest: i64) -> String {
    let section = |k: i64| {
        let goals: String = (-k..=0).map(|i| derivative_formula(i, k)).collect();
        let mut constant = String::new();
        for i in 1 - k..=0 {
            let (a, b) = (i, i + k);
            constant += &format!("(= (Dw {i} {k} (in A 0)) (/ 1 (- (t A {b}) (t A {a}))))");
        }
        let hints: String = (1..=k).map(hints).collect();
        format!(
            "(section (each a {k} k) (each b k {k}) (let r 1) (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) \
             (goals {goals}{constant}) (hints {hints}))"
        )
    };
    (1..=highest).map(section).collect()
}

/// The lemmas of one degree.
fn hints(d: i64) -> String {
    let mut hints = String::new();
    let mut prove = |formula: &str, using: &str| {
        hints += &format!("(prove {formula} (functions {}) (using {using}))", (d - 2).max(0));
    };
    // Which of the equations make sense: both intervals have to contain the span.
    let contains = |i: i64, d: i64| i <= 0 && i + d >= 1;
    let rising = |i: i64| contains(i, d) && contains(i, d - 1);
    let falling = |i: i64| contains(i, d) && contains(i + 1, d - 1);
    for i in -d..=0 {
        if d > 1 && rising(i) {
            prove(&Neighbours::rising(i, d), "");
        }
        if d > 1 && falling(i) {
            prove(&Neighbours::falling(i, d), "");
        }
    }
    for i in -d..=0 {
        let mut using = String::new();
        if d > 1 {
            let lower = |j: i64| format!("(G {j} {} (in A 0))", d - 2);
            let mut with = |lemma: String, factor: String| using += &format!("({lemma} {factor})");
            if i > -d {
                with(derivative_formula(i, d - 1), format!("(w {i} {d} (in A 0))"));
            }
            if i < 0 {
                with(derivative_formula(i + 1, d - 1), format!("(v {} {d} (in A 0))", i + 1));
            }
            // (1 − d)·Dw_i^d·G_i^{d−1}, with G_i^{d−1} in terms of degree d − 2, against what the lower formulas give.
            if rising(i) {
                with(Neighbours::rising(i, d), format!("(* {} {})", 1 - d, lower(i)));
            }
            if falling(i) {
                with(Neighbours::falling(i, d), format!("(* {} {})", 1 - d, lower(i + 1)));
            }
            if rising(i + 1) {
                with(Neighbours::rising(i + 1, d), format!("(* {} {})", d - 1, lower(i + 1)));
            }
            if falling(i + 1) {
                with(Neighbours::falling(i + 1, d), format!("(* {} {})", d - 1, lower(i + 2)));
            }
        }
        prove(&derivative_formula(i, d), &using);
    }
    hints
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    let statement = |degrees: RangeInclusive<usize>, because: &str, sections: &[&str]| {
        Some(Formal::on_all_knots(degrees, because, sections))
    };
    let alpha = "The first two sections: r = α/(α − 1) and 1/r = (α − 1)/α, for α < 0 and for α > 1.";
    match (claim, amended) {
        ("L3.8", true) => statement(
            1..=8,
            "t_0 = … = t_k < t_{k+1}. Functions that do not live on the first span are 0 there.",
            &[&format!(
                "(section (each q 0 (- k 1)) {FIRST} (goals \
                 (= (DG q (- k q) (from A k)) (- (DG (+ q 1) (- (- k q) 1) (from A k)) (Dw (+ q 1) (- k q) (from A k)))) \
                 (= (DG (+ q 1) (- k q) (from A k)) (+ (DG (+ q 2) (- (- k q) 1) (from A k)) (Dw (+ q 1) (- k q) (from A k)))) \
                 (each i 2 (+ k 1) (= (DG (+ q i) (- k q) (from A k)) (DG (+ q (+ i 1)) (- (- k q) 1) (from A k))))))"
            )],
        ),
        ("L3.9", true) => statement(
            1..=8,
            "Index 0 stands for n; the last knot occurs k + 1 + e times. First section: e = 0. Second section: for e = 2 and 3 all derivatives in the equations are 0; the interval of w_n is empty, so that its derivative is 0 too; and for more copies the functions do not live on the last span any more.",
            &[
                &format!(
                    "(section (each q 0 (- k 1)) {LAST} (goals \
                     (= (DG 0 (- k q) (to A 0)) (+ (DG 0 (- (- k q) 1) (to A 0)) (Dw 0 (- k q) (to A 0)))) \
                     (= (DG -1 (- k q) (to A 0)) (- (DG -1 (- (- k q) 1) (to A 0)) (Dw 0 (- k q) (to A 0))))))"
                ),
                "(section (each e 2 3) (each q 0 (- k 1)) (window A (- 0 (+ k e)) (each s 1 k any) some (each s 1 (+ k e) 0)) (goals \
                 (each i -1 0 (= (DG i (- k q) (to A (- 0 e))) 0) (= (DG i (- (- k q) 1) (to A (- 0 e))) 0))))",
            ],
        ),
        ("L3.10", true) => statement(
            2..=8,
            "Index 0 stands for n. Functions that do not live on the last span are 0 there.",
            &[&format!("(section {LAST} (goals (each i (- 0 k) -2 (= (DG i k (to A 0)) 0))))")],
        ),
        ("T3.11.1", false) => statement(
            0..=8,
            "On the open span every function is a sum of products of weights, each of which is a quotient of polynomials whose denominator does not vanish there.",
            &[
                "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 0 k) 0 (defined (G i k (in A 0))))))",
            ],
        ),
        ("T3.11.2", true) => statement(
            1..=8,
            "On the closed span every function is a quotient of polynomials whose denominator does not vanish, so its derivative has limits at both ends. At a knot of multiplicity ≤ k the function is continuous (second section), at t_0 and t_m the limit is the value: there the limits are the one-sided derivatives. At a knot inside of multiplicity > k the function whose first k + 1 knots are copies of it is 1 from there on (last sections), and 0 before, where it does not live.",
            &[
                "(section (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 k any)) (goals (each i (- 0 k) 0 (defined (DG i k (from A 0))) (defined (DG i k (to A 0))))))",
                CONTINUITY,
                STARTS_WITH_A_JUMP,
            ],
        ),
        ("T3.11.3a", true) => statement(
            1..=8,
            &format!(
                "{alpha} t_0 = … = t_k < t_{{k+1}}, and t_{{k+1}} − t_0 is the gap (A k). Functions that do not live on the first span are 0 there."
            ),
            &[RATIO, &format!("(section {FIRST} (goals {AT_FIRST}))")],
        ),
        ("T3.11.3b", true) => statement(
            1..=8,
            &format!(
                "{alpha} Index 0 stands for n; t_m − t_n is the gap (A 0). Functions that do not live on the last span are 0 there."
            ),
            &[RATIO, &format!("(section {LAST} (goals {AT_LAST}))")],
        ),
        ("P4.2.2", true) => statement(
            1..=8,
            &format!(
                "{alpha} First t_0 = … = t_k < t_{{k+1}}, then, with index 0 for n, t_n < t_{{n+1}} = … = t_m. The curve is Σ d_i G_i."
            ),
            &[
                RATIO,
                &format!(
                    "(section (real (each i 0 k (d i))) {FIRST} (goals (= (+ (each i 0 k (* (d i) (DG i k (from A k))))) \
                     (* (/ (* (integer k) r) (A k)) (- (d 1) (d 0))))))"
                ),
                &format!(
                    "(section (real (each i (- 0 k) 0 (d i))) {LAST} (goals (= (+ (each i (- 0 k) 0 (* (d i) (DG i k (to A 0))))) \
                     (* (/ (integer k) (* r (A 0))) (- (d 0) (d -1))))))"
                ),
                &ends(AT_FIRST, AT_LAST),
            ],
        ),
        ("abstract.regularity", false) => statement(
            1..=6,
            "t_0 = … = t_{p−1} is a knot of multiplicity p < k with the gaps h_0 before it and h_1 after it. First section: for the function that begins at the knot before it, the right minus the left derivative is p(r−1)/(r·h_0 + h_1) times a product of weights, which are positive; for the function that ends at the knot after it, −p(r−1)/(r·h_0 + h_1) times a product of complements. One of the two functions exists, since m ≥ 2k. So for r ≠ 1 a derivative of order 1 ≤ k − p jumps. Second section: for p ≤ k nothing jumps itself, and for p = k that is all that is claimed. Third section: at r = 1 the derivative of a function is a combination of functions of degree k − 1 on the same knots, with the constant factors ±k/(t_{i+k} − t_i); so a derivative of order s is one of functions of degree k − s, which for k − s ≥ p are continuous at the knot by the second section, for that degree. The jumps are quotients in r without a pole at 1, so they tend to those for r = 1, which are 0.",
            &[JUMPS_AT_MULTIPLE_KNOT, CONTINUITY, &classical_derivatives(6)],
        ),
        ("Rem3.1", false) => statement(
            2..=8,
            "Index −1 stands for i, so that t_0 is the second knot of G_i, simple and inside of its support; all other knots may be anywhere. The right minus the left derivative there is (r−1)/(r·h_0 + h_1) times a product of weights, with the gaps h_0 and h_1 left and right of the knot. The weights are positive, and r = 1 only for α = ∞.",
            &[JUMP],
        ),
        _ => None,
    }
}
