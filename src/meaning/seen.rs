//! Which control values the branches of a sentence look at: where others change, the same comes of a branch.

use std::collections::BTreeSet;
use std::rc::Rc;

/// The places of control values that were looked at.
#[derive(Debug, Clone, Default)]
pub(super) struct Seen(BTreeSet<usize>);

impl Seen {
    pub(super) fn has(&self, place: usize) -> bool {
        self.0.contains(&place)
    }

    pub(super) fn add(&mut self, places: impl IntoIterator<Item = usize>) {
        self.0.extend(places);
    }

    pub(super) fn join(&mut self, other: &Self) {
        self.add(other.0.iter().copied());
    }
}

/// What came of a branch with all control values 0.
#[derive(Debug, Default)]
pub(super) struct Branch {
    /// Looked at in the branch itself.
    pub(super) own: Seen,
    /// Looked at there or in a branch of it.
    pub(super) all: Seen,
    pub(super) facts: usize,
    pub(super) branches: Vec<Rc<Branch>>,
}

/// What a walk makes of its branches.
#[derive(Debug, Default)]
pub(super) enum Course {
    /// Nothing.
    #[default]
    Alone,
    /// All control values are 0, and it is written down what is looked at.
    Written(Branch),
    /// One control value is not 0.
    Beside {
        /// The place of that one.
        unit: usize,
        /// What came of it with 0.
        zero: Rc<Branch>,
        /// How many of its branches are behind.
        next: usize,
    },
}

impl Course {
    /// The next course: first all control values are 0, then all but one.
    pub(super) fn with_unit(self, unit: Option<usize>) -> Self {
        match (self, unit) {
            (_, None) => Self::Written(Branch::default()),
            (Self::Written(zero), Some(unit)) => Self::Beside { unit, zero: Rc::new(zero), next: 0 },
            (Self::Beside { zero, .. }, Some(unit)) => Self::Beside { unit, zero, next: 0 },
            (Self::Alone, Some(_)) => Self::Alone,
        }
    }
}
