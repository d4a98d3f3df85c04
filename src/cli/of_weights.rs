//! Whose weights an answer is about.

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::OfFamily;
use crate::meaning::Weighting;

/// α, or the member of another family.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub(super) struct OfWeights {
    /// α: `inf`, or an exact number; `symbolic` where it is a letter; nothing for another family.
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<String>,
    /// The member of another family.
    #[serde(skip_serializing_if = "Option::is_none")]
    family: Option<OfFamily>,
    #[serde(skip)]
    shown: String,
}

impl OfWeights {
    /// Those of an index, or of a member of another family.
    pub(super) fn of(weights: &Weighting) -> Self {
        let kind = if weights.index().is_some() { "α =" } else { "family" };
        Self {
            alpha: weights.index().map(ToString::to_string),
            family: OfFamily::of(weights),
            shown: format!("{kind} {weights}"),
        }
    }

    /// Those of every index at once.
    pub(super) fn symbolic() -> Self {
        Self { alpha: Some("symbolic".to_owned()), family: None, shown: "α a symbol".to_owned() }
    }

    /// Those of another family than that of an index: its options.
    pub(super) fn family(&self) -> Option<&OfFamily> {
        self.family.as_ref()
    }
}

/// `α = 5`, or `family lupas, q = 1/2`.
impl fmt::Display for OfWeights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.shown)
    }
}
