//! Random functions by their own knots: gaps and slope ratio log-spread over e^±3, as integers.

use knotproof::analysis::{LocalKnots, LocalKnotsError};
use num_bigint::BigInt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The seed of every run, so that runs are comparable.
pub(crate) const SEED: u64 = 3;

/// The gaps of one function, and (p, q) for its slope ratio.
pub(crate) type Case = (Vec<u64>, (u64, u64));

/// Random functions of one degree.
pub(crate) fn cases(degree: usize, count: usize) -> Vec<Case> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut log_spread = || {
        // A float draws the case and takes no part in deciding it.
        let unit = random.next_u32() as f64 / f64::from(u32::MAX);
        (1000.0 * (6.0 * unit - 3.0).exp()).round().to_string().parse().unwrap_or(1)
    };
    (0..count).map(|_| ((0..=degree).map(|_| log_spread()).collect(), (log_spread(), 1000))).collect()
}

/// The function of a case.
pub(crate) fn function((gaps, (p, q)): &Case) -> Result<LocalKnots<BigInt>, LocalKnotsError> {
    LocalKnots::new(gaps.iter().map(|&gap| gap.into()).collect(), ((*p).into(), (*q).into()))
}
