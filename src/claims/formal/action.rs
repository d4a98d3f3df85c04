//! How α acts on a curve: how far at most, in which direction, and to which end.

use std::ops::RangeInclusive;

use super::Formal;
use super::basis::{POSITIVE_INSIDE, SPAN, SUM_IS_ONE};

/// The largest distance of a weight from the classical one, for r = s²: v is the product of s and of (x − a)/(b − x).
fn weights_are_close() -> String {
    let at = |v: &str| {
        format!("(at ((u (/ {v} s))) (w 0 1 (in A 0))) (at ((u (/ {v} s)) (r 1)) (w 0 1 (in A 0)))")
    };
    let section = |s: &str, greater: bool| {
        let difference = |v| match greater {
            true => format!("(- {})", at(v)),
            false => format!("(- (- {}))", at(v)),
        };
        let delta = if greater { "(/ (- s 1) (+ s 1))" } else { "(/ (- 1 s) (+ 1 s))" };
        let (any, one) = (difference("v"), difference("1"));
        format!(
            "(section (nonnegative p) (positive v) (let s {s}) (let r (^ s 2)) (window A 0 some) \
             (goals (>= {any} 0) (>= {delta} {any}) (= {one} {delta})))"
        )
    };
    section("(+ 1 p)", true) + &section("(/ 1 (+ 1 p))", false)
}

/// How the points of two runs of de Boor's algorithm, for r and for 1, differ on one level and on the next.
fn levels() -> String {
    let point = |i: &str, q: &str| format!("(de-boor {i} {q} k (in A 0))");
    let classical = |term: &str| format!("(at ((r 1)) {term})");
    let apart = |i: &str, q: &str| format!("(- {} {})", point(i, q), classical(&point(i, q)));
    let step = |i: &str, before: &str, q: &str| format!("(- {} {})", point(i, q), point(before, q));
    let (w, v) = ("(w i (- k q) (in A 0))", "(v i (- k q) (in A 0))");
    let between = format!(
        "(each q 0 (- k 1) (each i (- (+ q 1) k) 0 (= {} (+ (* {w} {}) (* {v} {}) (* (- {w} {}) {})))))",
        apart("i", "(+ q 1)"),
        apart("i", "q"),
        apart("(- i 1)", "q"),
        classical(w),
        classical(&step("i", "(- i 1)", "q")),
    );
    let along = format!(
        "(each q 0 (- k 2) (each i (- (+ q 2) k) 0 (= {} (+ (* {w} {}) (* (v (- i 1) (- k q) (in A 0)) {}))) \
         (>= (w (- i 1) (- k q) (in A 0)) {w})))",
        step("i", "(- i 1)", "(+ q 1)"),
        step("i", "(- i 1)", "q"),
        step("(- i 1)", "(- i 2)", "q"),
    );
    let result = format!("(= {} (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0))))))", point("0", "k"));
    format!("(section (real (each i (- 0 k) 0 (d i))) {SPAN} (goals {between} {along} {result}))")
}

/// Without interior knots, d_i = i: at one point the distance is kδ.
fn attained() -> String {
    let section = |s: &str, [above, below]: [&str; 2]| {
        let g = "(G i k (in A k))";
        let distance = format!(
            "(+ (each i 0 k (* (integer i) (- (at ((u (/ 1 s)) (r {above})) {g}) (at ((u (/ 1 s)) (r {below})) {g})))))"
        );
        let delta = if above == "1" { "(/ (- 1 s) (+ 1 s))" } else { "(/ (- s 1) (+ s 1))" };
        format!(
            "(section (positive h) (nonnegative p) (let s {s}) (let r (^ s 2)) (window A 0 (each z 1 k 0) h (each z 1 k 0)) \
             (goals (= {distance} (* (integer k) {delta}))))"
        )
    };
    section("(+ 1 p)", ["r", "1"]) + &section("(/ 1 (+ 1 p))", ["1", "r"])
}

const CLOSE: &str = "r = s², for s ≥ 1 and for s ≤ 1. For a < x < b let v/s be (x − a)/(b − x): so the first two sections say that |φ_α(x,a,b) − φ_∞(x,a,b)| ≤ δ = |s − 1|/(s + 1), attained at v = 1. The third one is about a span, the control points (d i) that live there, one coordinate of each, and de Boor's algorithm, whose last point is that of the curve (last goal). Let M be the largest distance of neighbouring points of a level. (1) From one level to the next M does not grow: the second equation writes a difference on the next level as a combination of two on this one, with factors ≥ 0 and the sum w_i + 1 − w_{i−1} ≤ 1, by the inequality. (2) From one level to the next the distance between the points for r and those for 1 grows by δM at most: the first equation writes it as a convex combination of two such distances, and a difference of neighbours times that of two weights, which is at most δ. Before the first level it is 0, so that after k levels it is kδM at most; for points in place of coordinates the same by the triangle inequality. At the knots it holds by continuity from one side. The last two sections: d_i = i without interior knots, at the x with v = 1.";

/// G_i + … + G_0 of degree d on the span; G_1 is 0 there.
fn upper(i: &str, d: &str) -> String {
    format!("(+ (each l {i} 1 (G l {d} (in A 0))))")
}

/// The sums for the ratios r and r + p, from degree d − 1 to d.
fn sums_rise() -> String {
    let other = |term: &str| format!("(at ((r (+ r p))) {term})");
    let difference = |i: &str, d: &str| format!("(- {} {})", other(&upper(i, d)), upper(i, d));
    let (w, v) = ("(w i d (in A 0))", "(v i d (in A 0))");
    format!(
        "(section (positive p) (window A 0 some) (goals (> {other_w} (w 0 1 (in A 0)))))\
         (section (positive p) {SPAN} (goals (each d 1 k (each i (- 1 d) 0 (= {whole} (+ (* {next_w} {same}) (* {next_v} {after}) \
         (* (- {next_w} {w}) (G i (- d 1) (in A 0))))) (> (G i (- d 1) (in A 0)) 0)))))",
        other_w = other("(w 0 1 (in A 0))"),
        whole = difference("i", "d"),
        next_w = other(w),
        next_v = other(v),
        same = difference("i", "(- d 1)"),
        after = difference("(+ i 1)", "(- d 1)"),
    )
}

const ORDER: &str = "The first section: φ rises strictly with r inside of its interval. The second one is about the span j = 0; T_i is the sum of the functions with an index ≥ i, and T′_i the one for r + p, which is any greater ratio. By the equation, T′_i − T_i of degree d is a combination of such differences of degree d − 1 with factors ≥ 0 and of G_i^{d−1} > 0 with a positive factor. For d = 0 they are 0: so by induction over d they are positive for −d < i ≤ 0. As all functions that live on the span have the sum 1, G_{−k} + … + G_j = 1 − T_{j+1} falls strictly as r rises, for −k ≤ j < 0; for other j it is 0 or 1. At a knot it falls or is constant, by continuity from one side.";

const POINTWISE: &str = "(goals (= (G (- 0 k) k (in A 0)) (* (each d 1 k (v (- 1 d) d (in A 0))))) (= (G 0 k (in A 0)) (* (each d 1 k (w 0 d (in A 0))))) \
    (each d 1 k (>= (* r (/ (- (x (in A 0)) (t A (- 1 d))) (- (t A 1) (x (in A 0))))) (w (- 1 d) d (in A 0))) \
    (>= (/ (- (t A d) (x (in A 0))) (* r (- (x (in A 0)) (t A 0)))) (v 0 d (in A 0)))))";

const LIMIT: &str = "The span j = 0. G_{−k} is a product of k numbers 1 − w, where 0 ≤ w ≤ r(x − t_i)/(t_1 − x) for i = 0, …, 1 − k; and a product of numbers 1 − w in [0, 1] is at least 1 − Σw. G_0 is a product of k numbers w = 1 − v, where 0 ≤ v ≤ (t_i − x)/(r(x − t_0)) for i = 1, …, k. r → 0 is α → 0⁻, and r → ∞ is α → 1⁺. The sum of all functions of the span is 1, so that the other points have factors that tend to 0.";

/// Near a knot t_1 = … = t_p, or t_{1−p} = … = t_0, of multiplicity p < k.
fn near_knots() -> String {
    // G_{−d} + … + G_i, with the function before it, which is 0 there.
    let lower = |i: &str, d: &str| format!("(+ (each l (- -1 {d}) {i} (G l {d} (in A 0))))");
    format!(
        "(section (each p 1 (- k 1)) (window A (- 0 k) (each s (- 0 k) -1 any) some (each s 1 (- p 1) 0) some (each s (+ p 1) k any)) \
         (goals (each d (+ p 1) k (= {} (+ (* (w (- (+ p 1) d) d (in A 0)) {}) (* (v (- (+ p 1) d) d (in A 0)) {}))) \
         (>= (* r (/ (- (t A 1) (t A (- (+ p 1) d))) (- (t A (+ p 1)) (t A 1)))) (w (- (+ p 1) d) d (in A 0))))))\
         (section (each p 1 (- k 1)) (window A (- 0 k) (each s (- 0 k) (- -1 p) any) some (each s (- 1 p) -1 0) some (each s 1 k any)) \
         (goals (each d (+ p 1) k (= {} (+ (* (w (- 0 p) d (in A 0)) {}) (* (v (- 0 p) d (in A 0)) {}))) \
         (>= (/ (- (t A (- d p)) (t A 0)) (* r (- (t A 0) (t A (- 0 p))))) (v (- 0 p) d (in A 0))))))",
        upper("(- (+ p 1) d)", "d"),
        upper("(- (+ p 1) d)", "(- d 1)"),
        upper("(- (+ p 2) d)", "(- d 1)"),
        lower("(- -1 p)", "d"),
        lower("(- -1 p)", "(- d 1)"),
        lower("(- 0 p)", "(- d 1)"),
    )
}

const TRACE: &str = "The span j = 0. If p ≥ k the sum is that of all functions of the span, which is 1 (first section). Otherwise let t_1 = … = t_p < t_{p+1}, and T_i^d be the sum of the functions of degree d with an index ≥ i. By the equation, and because sums of functions are between 0 and 1 and so are weights, T_{p+1−d}^d ≤ w_{p+1−d}^d + T_{p+2−d}^{d−1}. For d = p + 1 the last one is T_1^p = 0: so T_{p+1−k}^k, which is 1 less the sum in question, is at most the sum of the w_{p+1−d}^d for p < d ≤ k, and each of these is bounded by the inequality. The last sections are the mirror image, with sums from below, for a knot t_{−p} < t_{1−p} = … = t_0.";

const ARC_AT_LAST: &str = "(section (positive h) (let y (/ (* r (+ 1 u)) h)) \
    (window A (- 0 k) (each s (- 0 k) -1 any) h (each s 1 k 0)) (goals (= y (/ r (- (t A 1) (x (in A 0))))) \
    (each d 1 k (each i (- 1 d) 0 \
    (>= (/ (* y (- (t A 1) (t A i))) (+ 1 (* y (- (t A 1) (t A i))))) (w i d (in A 0))) \
    (>= r (- (/ (* y (- (t A 1) (t A i))) (+ 1 (* y (- (t A 1) (t A i))))) (w i d (in A 0)))))) \
    (each i (- 2 k) 0 (>= (/ (* y (- (t A 1) (t A (- i 1)))) (+ 1 (* y (- (t A 1) (t A (- i 1)))))) \
    (/ (* y (- (t A 1) (t A i))) (+ 1 (* y (- (t A 1) (t A i)))))))))";

const ARC_AT_FIRST: &str = "(section (positive h) (let y (/ (+ 1 u) (* r u h))) \
    (window A (- 0 k) (each s 1 k 0) h (each s 1 k any)) (goals (= y (/ 1 (* r (- (x (in A 0)) (t A 0))))) \
    (each d 1 k (each i (- 1 d) 0 \
    (>= (/ (* y (- (t A (+ i d)) (t A 0))) (+ 1 (* y (- (t A (+ i d)) (t A 0))))) (v i d (in A 0))) \
    (>= (/ 1 r) (- (/ (* y (- (t A (+ i d)) (t A 0))) (+ 1 (* y (- (t A (+ i d)) (t A 0))))) (v i d (in A 0)))))) \
    (each i 2 k (>= (/ (* y (- (t A i) (t A 0))) (+ 1 (* y (- (t A i) (t A 0))))) \
    (/ (* y (- (t A (- i 1)) (t A 0))) (+ 1 (* y (- (t A (- i 1)) (t A 0)))))))))";

const ARC: &str = "On the last span, j = 0 and t_1 = … = t_{k+1}, the weights of the arc A(y) for y = r/(t_1 − x) differ from those of the curve by at most r, and they do not rise with i. So by the argument of X.close (differences of neighbouring points do not grow from level to level of de Boor's algorithm, and each level adds at most r times such a difference) the points differ by at most kr·max |d_i − d_{i−1}|. On the first span the same of the complements and 1/r. At the ends of the spans by continuity. The third section says that the last point of the algorithm is that of the curve.";

/// Up to which degree, why, and what is to be proved.
fn parts(question: &str) -> Option<(RangeInclusive<usize>, &'static str, Vec<String>)> {
    let point = format!(
        "(section (real (each i (- 0 k) 0 (d i))) {SPAN} (goals (= (de-boor 0 k k (in A 0)) (+ (each i (- 0 k) 0 (* (d i) (G i k (in A 0))))))))"
    );
    Some(match question {
        "X.close" => (1..=6, CLOSE, vec![weights_are_close(), levels(), attained()]),
        "X.order" => (1..=6, ORDER, vec![sums_rise(), SUM_IS_ONE.into()]),
        "X.limit" => (1..=8, LIMIT, vec![format!("(section {SPAN} {POINTWISE})"), SUM_IS_ONE.into()]),
        "X.limit.trace" => (1..=8, TRACE, vec![SUM_IS_ONE.into(), POSITIVE_INSIDE.into(), near_knots()]),
        "X.limit.arc" => (1..=8, ARC, vec![ARC_AT_LAST.into(), ARC_AT_FIRST.into(), point]),
        _ => return None,
    })
}

/// What is proved for all degrees at once.
pub(super) fn formal_for_all(question: &str, amended: bool) -> Option<Formal> {
    let (degrees, because, sections) = parts(question).filter(|_| !amended)?;
    Some(Formal::on_all_knots(degrees, because, &[&sections.concat()]))
}

/// What is proved for one degree.
pub(super) fn formal(question: &str, k: usize) -> Option<Formal> {
    let (degrees, because, sections) = parts(question)?;
    degrees.contains(&k).then(|| Formal::on_all_knots(k..=k, because, &[&sections.concat()]))
}
