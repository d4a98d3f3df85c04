//! The paper that is judged, and what of it was read.

use serde::Serialize;

/// A paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Paper {
    /// Its title.
    pub title: &'static str,
    /// Those who wrote it, as far as what was read says so.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub authors: &'static [&'static str],
    /// Its number on arXiv.
    pub arxiv: &'static str,
    /// What was read: in which form, and what is missing there.
    pub read: &'static str,
    /// What it is close to.
    pub related: &'static str,
}

/// The paper whose claims are in [`claims`](crate::claims::claims).
pub const PAPER: Paper = Paper {
    title: "A new class of rational B-splines",
    authors: &[],
    arxiv: "1805.04433",
    read: "a scan with 33 figures, which names no authors and lacks the appendix of formal expressions (arXiv lists 72 pages and 32 figures)",
    related: "I. Juhász and Á. Róth, “A class of generalized B-spline curves”, Computer Aided Geometric Design 30 (2013), put a nonlinear core function, increasing and continuously differentiable, into each interval of the recursion of Cox and de Boor. The paper's f_α is such a function, so that its basis has the form of theirs with one core function for each α; non-negativity, local support, partition of unity and end points are shown there for all of them.",
};
