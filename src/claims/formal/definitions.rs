//! Definitions 3.1 and 3.2.

use crate::claims::definitions::examples;
use crate::claims::verdict::Scope;

use super::Formal;
use super::example::Example;

/// k gaps, one of which is positive, or none.
const END_KNOTS: &str = "(section (each j 0 (- k 1)) (window A 0 (each s 1 j any) some (each s (+ j 2) k any)) (goals \
    (< (t A 0) (t A k))))\
    (section (window A 0 (each s 1 k 0)) (goals (each j 0 (- k 1) (= (t A j) (t A k)))))";

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    match (claim, amended) {
        ("D3.1.interval", true) => Some(Formal::on_all_knots(
            1..=8,
            "The window has the knots t_0, …, t_k, or t_{m−k}, …, t_m. If two of them differ, the first is less than the last: then t_0 < a, or t_m > b, and U leaves [a, b]. If none differ, all are a, or all are b; and the knots between t_k and t_{m−k} lie in [a, b], for U does not fall.",
            &[END_KNOTS],
        )),
        ("D3.2.examples", true) => {
            let section = |instance: &_| {
                let on = Example::new(instance);
                let m = on.n + on.k + 1;
                on.section("", &format!("(>= {m} {}) (< (t A {}) (t A {}))", 2 * on.k, on.k, m - on.k))
            };
            let instances = examples(true).into_iter().flat_map(|illustration| illustration.instances);
            let sections: String = instances.map(|instance| section(&instance)).collect();
            let because = "For every knot vector and degree of the illustrations but U0 with k = 3.";
            Some(Formal::new(Scope::Instance, (0..=5).collect(), because, sections))
        }
        _ => None,
    }
}
