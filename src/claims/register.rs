//! The register of all claims.

use super::claim::Claim;

/// All claims, in the order of the paper, and then our questions.
#[must_use]
pub fn claims() -> Vec<Claim> {
    [
        super::weight::claims(),
        super::basis::claims(),
        super::regularity::claims(),
        super::maximum::claims(),
        super::independence::claims(),
        super::curve::claims(),
        super::illustrated_bases::claims(),
        super::illustrated_curves::claims(),
        super::symmetric_curves::claims(),
        super::steps::claims(),
        super::questions::claims(),
        super::two_maxima::claims(),
        super::closeness::claims(),
        super::limits::claims(),
        super::approximation::claims(),
        super::free_weights::claims(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
