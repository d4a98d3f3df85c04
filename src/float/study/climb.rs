//! The search for the worst case of a formula: it climbs towards larger errors by small changes.

use super::case::{Case, Source};
use super::formula::Formula;
use super::measure::estimate;

/// The worst case that was found from a start in so many steps: a change is kept if the error is not smaller after it.
/// With `fixed`, only x is changed.
pub(super) fn climb(formula: Formula, start: Case, source: &mut Source, steps: u64, fixed: bool) -> Case {
    let mut height = estimate(formula, &start);
    let mut case = start;
    for _ in 0..steps {
        if let Some(changed) = source.changed(&case, fixed) {
            let reached = estimate(formula, &changed);
            if reached >= height {
                (case, height) = (changed, reached);
            }
        }
    }
    case
}
