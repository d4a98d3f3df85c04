//! How much has been done: a count that moves while a long decision is on its way, for whoever waits for it.

use std::sync::atomic::{AtomicU64, Ordering};

/// Of this process, all threads together. Nothing that is computed depends on it.
static EFFORT: AtomicU64 = AtomicU64::new(0);

/// The number of small steps so far: greatest common divisors, signs that were decided, spans that were worked out.
#[must_use]
pub fn effort() -> u64 {
    EFFORT.load(Ordering::Relaxed)
}

/// One more.
pub(crate) fn spend() {
    EFFORT.fetch_add(1, Ordering::Relaxed);
}
