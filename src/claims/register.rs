//! The register of all claims.

use super::claim::Claim;

/// All claims, in the order of the paper, and then our questions.
#[must_use]
pub fn claims() -> Vec<Claim> {
    [
        super::classical::of_abstract(),
        super::weight::claims(),
        super::weight_effect::claims(),
        super::definitions::claims(),
        super::basis::claims(),
        super::curve_ends::limits(),
        super::regularity::claims(),
        super::maximum::claims(),
        super::independence::claims(),
        super::curve::claims(),
        super::curve_ends::tangents(),
        super::de_boor_range::claims(),
        super::illustrated_bases::claims(),
        super::illustrated_curves::claims(),
        super::influence::claims(),
        super::captions::claims(),
        super::symmetric_curves::claims(),
        super::influence::in_symmetric_curves(),
        super::classical::of_conclusion(),
        super::steps::claims(),
        super::proofs_steps::claims(),
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
