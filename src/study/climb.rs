//! The search for the worst case of a formula: it climbs towards larger errors by small changes.

use super::measure::estimate;
use super::method::Method;
use super::probe::{Probe, Source};

/// The worst case that was found from a start in so many steps: a change is kept if the error is not smaller after it.
/// With `fixed`, only x is changed. A search that starts where the formula's bound is proved stays there: outside of
/// that range it would only find how the numbers overflow.
pub(super) fn climb(formula: Method, start: Probe, source: &mut Source, steps: u64, fixed: bool) -> Probe {
    let mut height = estimate(formula, &start);
    let mut case = start;
    let inside = formula.bound_applies(&case);
    for _ in 0..steps {
        let changed = source.changed(&case, fixed).filter(|case| !inside || formula.bound_applies(case));
        if let Some(changed) = changed {
            let reached = estimate(formula, &changed);
            if reached >= height {
                (case, height) = (changed, reached);
            }
        }
    }
    case
}
