//! What was read: the paper, and the version of it that the claims are taken from.

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

use crate::claims::ARXIV;

/// A paper and the version of it that was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Paper {
    /// The title.
    pub title: &'static str,
    /// The authors; empty if the version that was read does not name them.
    pub authors: &'static [&'static str],
    /// The number at arXiv.
    pub arxiv: &'static str,
    /// What the listing there says of its size.
    pub listed: &'static str,
    /// The version that was read.
    pub read: &'static str,
    /// What that version lacks.
    pub missing: &'static [&'static str],
    /// What it is close to.
    pub related: &'static str,
}

/// The paper of this program.
pub const PAPER: Paper = Paper {
    title: "A new class of rational B-splines",
    authors: &[],
    arxiv: ARXIV,
    listed: "72 pages, 32 figures",
    read: "a scan, from the abstract to the conclusion (section 6), with 33 figures",
    missing: &[
        "the title page with the names of the authors",
        "the list of references",
        "the appendix with the formal expressions of the basis functions: none of them is judged",
        "the values of α in Fig. 1 to 3 and in some panels of Fig. 23 and 24, which can't be read: ours are drawn there",
    ],
    related: "I. Juhász and Á. Róth, “A class of generalized B-spline curves”, Computer Aided Geometric Design 30 (2013), put a nonlinear core function, increasing and continuously differentiable, into each interval of the recursion of Cox and de Boor. The paper's f_α is such a function, so that its basis has the form of theirs with one core function for each α; non-negativity, local support, partition of unity and end points are shown there for all of them.",
};

/// One paragraph.
impl fmt::Display for Paper {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "“{}”", self.title)?;
        if !self.authors.is_empty() {
            write!(f, " by {}", self.authors.join(", "))?;
        }
        write!(f, ", arXiv {} ({} in the listing). Version read: {}. ", self.arxiv, self.listed, self.read)?;
        write!(f, "Missing from it: {}.", self.missing.join("; "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paragraph_says_what_was_read_and_what_is_missing() {
        let text = PAPER.to_string();
        for part in [PAPER.title, PAPER.arxiv, PAPER.listed, PAPER.read] {
            assert!(text.contains(part), "{part}");
        }
        assert!(PAPER.missing.iter().all(|missing| text.contains(missing)) && text.contains("appendix"));
        assert!(!text.contains(" by "), "no authors are made up");
        let named = Paper { authors: &["A", "B"], ..PAPER };
        assert!(named.to_string().contains("” by A, B, arXiv"));
    }
}
