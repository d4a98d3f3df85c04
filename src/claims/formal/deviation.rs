//! Remark 5.1: how far the functions for α = 5 are from those for α = ∞.

use std::fmt::Write as _;

use crate::claims::verdict::Scope;

use super::Formal;
use super::example::{Example, of_degree};
use super::place::Place;

/// |G_i − the same for ∞| < 1/15 on every closed span.
fn near(on: &Example<'_>) -> String {
    let mut goals = String::new();
    for span in on.spans() {
        for i in on.living(span) {
            for place in Place::closed(span) {
                let g = on.function(i, place);
                let _ = write!(goals, "(> 1/15 (- {g} (at ((r 1)) {g}))) (> 1/15 (- (at ((r 1)) {g}) {g}))");
            }
        }
    }
    goals
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    const EXAMPLES: [&str; 14] =
        ["U0", "U1", "U2", "U3", "U4", "U5", "U6", "U7", "U8", "U9", "U10", "U11", "U12", "U13"];
    if claim != "Rem5.1.approx" || amended {
        return None;
    }
    let section = |instance| {
        let on = Example::new(instance);
        on.section("(let r 5/4)", &near(&on))
    };
    let most: String = of_degree(&EXAMPLES, &[2]).iter().map(section).collect();
    let farthest = |instance| {
        let on = Example::new(instance);
        let g = on.function(2, Place::inside(2));
        on.section("(let r 5/4)", &format!("(> (at ((u 9/5)) (- {g} (at ((r 1)) {g}))) 33/500)"))
    };
    let least: String = of_degree(&["U1"], &[2]).iter().map(farthest).collect();
    Some(Formal {
        scope: Scope::Instance,
        degrees: vec![2],
        because: "α = 5 is r = 5/4. On every closed span every function differs from the one for r = 1 by less than 1/15, which is less than 1/10. The last section shows that there is not much to be gained: on U1, G_2 differs by more than 33/500 at x = 37/14.".to_owned(),
        sections: most + &least,
    })
}
