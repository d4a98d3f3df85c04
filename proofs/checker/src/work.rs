//! How much is computed: counted, not timed, so that a certificate is too long on every machine or on none.

use std::cell::Cell;

use crate::error::{Reason, Result};

/// What a term costs that is kept in memory: so the work bounds that too.
const KEPT: usize = 10;

thread_local! {
    /// What is left for the certificate that this thread is reading.
    static LEFT: Cell<usize> = const { Cell::new(0) };
}

/// For a new certificate.
pub(crate) fn begin(limit: usize) {
    LEFT.set(limit);
}

/// What is left.
pub(crate) fn left() -> usize {
    LEFT.get()
}

/// So many products of two terms, or as much of something else that is done term by term.
pub(crate) fn spend(products: usize) -> Result<()> {
    LEFT.set(LEFT.get().checked_sub(products).ok_or(Reason::Limits("the work"))?);
    Ok(())
}

/// So many terms that are kept.
pub(crate) fn keep(terms: usize) -> Result<()> {
    spend(terms.saturating_mul(KEPT))
}
