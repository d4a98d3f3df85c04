//! The captions of Fig. 27 to 33.

use std::fmt::Write as _;

use crate::claims::captions::{CAPTIONS, Caption, axis, equal_points};
use crate::claims::verdict::Scope;

use super::Formal;
use super::example::{Example, all};

/// Open and uniform, or open and symmetric with one double node.
fn of_knots(on: &Example<'_>, caption: Caption) -> String {
    let (k, n, m) = (on.k, on.n, on.n + on.k + 1);
    let mut goals = format!("(= (t A 0) (t A {k})) (= (t A {}) (t A {m}))", n + 1);
    if caption.uniform {
        for i in k + 1..=n {
            let gap = |i: usize| format!("(- (t A {}) (t A {i}))", i + 1);
            let _ = write!(goals, "(= {} {})", gap(i), gap(k));
        }
        return goals;
    }
    for i in 0..=m / 2 {
        let _ = write!(goals, "(= (+ (t A {i}) (t A {})) (t A {m}))", m - i);
    }
    let knots = on.instance.knots.knots();
    for i in k..=n {
        let compare = if knots[i] == knots[i + 1] { '=' } else { '<' };
        let _ = write!(goals, "({compare} (t A {i}) (t A {}))", i + 1);
    }
    goals
}

/// The middle of d_i and d_{n−i} lies on the axis, and their difference is across it; and which points are the same.
fn of_points(on: &Example<'_>) -> String {
    let points = on.instance.points.as_deref().unwrap_or_default();
    let Some(reflection) = axis(on.instance) else { return String::new() };
    let (middle, normal) = reflection.axis();
    let mut goals = String::new();
    for (p, q) in points.iter().zip(points.iter().rev()) {
        let of = |c: usize| format!("(* {} (- (+ {} {}) (* 2 {})))", normal[c], p[c], q[c], middle[c]);
        let _ = write!(goals, "(= (+ {} {}) 0)", of(0), of(1));
        let difference = [0, 1].map(|c| format!("(- {} {})", q[c], p[c]));
        let [x, y] = difference;
        let _ = write!(goals, "(= (det ({x} {y}) ({} {})) 0)", normal[0], normal[1]);
    }
    let equal = equal_points(on.instance);
    for i in 0..points.len() {
        for j in i + 1..points.len() {
            let squares = [0, 1].map(|c| format!("(^ (- {} {}) 2)", points[i][c], points[j][c]));
            let compare = if equal.contains(&(i, j)) { '=' } else { '>' };
            let _ = write!(goals, "({compare} (+ {} {}) 0)", squares[0], squares[1]);
        }
    }
    goals
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    if claim != "Fig27-33" || amended {
        return None;
    }
    let mut sections = String::new();
    for caption in CAPTIONS {
        for instance in all(&[caption.name]) {
            let on = Example::new(&instance);
            sections += &on.section("", &(of_knots(&on, caption) + &of_points(&on)));
        }
    }
    let because = "For each figure: the first k + 1 knots are the same, and the last; the gaps between t_k and t_{m−k} are the same, or t_i + t_{m−i} = t_0 + t_m and one pair of knots inside is equal; the middle of d_i and d_{n−i} lies on the axis of the reflection and their difference is across it; of all pairs of control points one, or none, is equal.";
    Some(Formal::new(Scope::Instance, vec![3], because, sections))
}
