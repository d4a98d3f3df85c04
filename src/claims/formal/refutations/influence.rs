//! Refutations of what section 5 says on the effect of α.

use crate::claims::formal::example::{Example, all, on_spans};
use crate::claims::formal::illustrated_curves::reparametrised;
use crate::claims::formal::influence::told_apart;
use crate::claims::influence::{BELOW, reversed};

use super::Refuted;
use super::found::Found;

pub(super) fn refutation(claim: &str, found: &Found<'_>) -> Refuted {
    let instance = || all(&[found.text("instance")?]).into_iter().find(|of| of.degree == found.k());
    Some(match claim {
        "Ill5.5.2.general" => {
            let place = BELOW.iter().position(|alpha| found.text("α") == Some(*alpha))?;
            (
                "The control points of C5 in the opposite order: on every span the squared distance from G_∞ for this α is less than a number, and for 1 − α it is greater than that number at one point.",
                told_apart(&reversed(&instance()?), place, true)?,
            )
        }
        "Ill5.8.remarkable" => {
            let instance = instance()?;
            let on = Example::new(&instance);
            let alpha = format!("(let r {})", found.basis.index().ratio());
            (
                "On every span the curve for α at u is G_∞ at r·u, and u ↦ r·u maps (0, ∞) onto itself: both have the same points.",
                on.section(&alpha, &on_spans(reparametrised)(&on)),
            )
        }
        _ => return None,
    })
}
