//! Which paper it is all about.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The number of the paper at arXiv.
pub const ARXIV: &str = "1805.04433";

/// The paper, in results that say something of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PaperNumber {
    /// Its number at arXiv.
    pub arxiv: String,
}

impl Default for PaperNumber {
    fn default() -> Self {
        Self { arxiv: ARXIV.to_owned() }
    }
}
