//! Random candidates: each a function of the seed and its number.

use std::ops::Range;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::analysis::is_continuous;
use crate::scalar::BigRational;

use super::candidate::Candidate;
use super::space::{IndexSample, Sample, SpaceError, WIDEST_SPREAD};
use crate::spline::Index;

/// A random sample of one degree.
///
/// A gap is 0 with probability 1/8, and otherwise m·2^e with m from 256 to 511 and e from 0 to spread − 1, all equally
/// likely: so gaps differ by factors up to 2^spread, spread evenly over the logarithms. The ratio is m·2^e/2^h, with
/// h = 8 + ⌊spread/2⌋, so log-spread around 1. Gaps of a function that jumps are drawn again. What is
/// drawn for case c of a seed is the stream c of ChaCha8 with that seed; the case is the normal form. Where indices are
/// given, each ratio is one of theirs, all equally likely.
#[derive(Debug, Clone)]
pub struct Random {
    degree: usize,
    sample: Sample,
    /// (p, q) for the indices that are given, if any are.
    ratios: Vec<(u64, u64)>,
}

impl Random {
    /// Checks the numbers.
    ///
    /// # Errors
    /// [`SpaceError`], if the sample is empty, or its spread does not fit.
    pub(super) fn new(degree: usize, sample: &Sample) -> Result<Self, SpaceError> {
        if sample.count == 0 {
            return Err(SpaceError::NoCase);
        }
        if sample.spread == 0 || sample.spread > WIDEST_SPREAD {
            return Err(SpaceError::Spread(sample.spread));
        }
        Ok(Self { degree, sample: sample.clone(), ratios: Vec::new() })
    }

    /// The same with one of some indices in each case.
    ///
    /// # Errors
    /// [`SpaceError`], as for [`new`](Self::new), and for an index that is none.
    pub(super) fn with_indices(degree: usize, sample: &IndexSample) -> Result<Self, SpaceError> {
        let &IndexSample { ref alpha, count, seed, spread } = sample;
        let mut random = Self::new(degree, &Sample { count, seed, spread })?;
        let ratio = |alpha: &String| -> Option<(u64, u64)> {
            let index: Index = alpha.parse().ok()?;
            let short = |n: &num_bigint::BigInt| u32::try_from(n).ok().map(u64::from);
            Some((short(index.ratio().numer())?, short(index.ratio().denom())?))
        };
        random.ratios = alpha.iter().map(ratio).collect::<Option<_>>().ok_or(SpaceError::Index)?;
        if random.ratios.is_empty() { Err(SpaceError::Index) } else { Ok(random) }
    }

    /// The number of cases, and of positions.
    #[must_use]
    pub fn cases(&self) -> u64 {
        self.sample.count
    }

    /// The cases with numbers in a range.
    pub fn between(&self, range: Range<u64>) -> impl Iterator<Item = (u64, Candidate)> + use<'_> {
        (range.start..range.end.min(self.sample.count)).map(|number| (number, self.case(number)))
    }

    /// What case c is drawn from.
    pub(super) fn source(&self, number: u64) -> ChaCha8Rng {
        let mut source = ChaCha8Rng::seed_from_u64(self.sample.seed);
        source.set_stream(number);
        source
    }

    /// Gaps of a function that does not jump.
    pub(super) fn gaps(&self, source: &mut ChaCha8Rng) -> Vec<u64> {
        let mut gaps = vec![0; self.degree + 1];
        while !is_continuous(&gaps) {
            for gap in &mut gaps {
                let bits = source.next_u64();
                *gap = if bits.is_multiple_of(8) { 0 } else { self.spread_number(bits >> 3) };
            }
        }
        gaps
    }

    /// A number log-spread around 1, and a sign.
    pub(super) fn ratio(&self, source: &mut ChaCha8Rng) -> (BigRational, bool) {
        let bits = source.next_u64();
        let (p, q) = (self.spread_number(bits >> 3), self.unit());
        (BigRational::new(p.into(), q.into()), bits.is_multiple_of(2))
    }

    fn case(&self, number: u64) -> Candidate {
        let mut source = self.source(number);
        let gaps = self.gaps(&mut source);
        let bits = source.next_u64() >> 3;
        let ratio = match self.ratios.as_slice() {
            [] => (self.spread_number(bits), self.unit()),
            given => given[usize::try_from(bits % given.len() as u64).unwrap_or(0)],
        };
        match Candidate::new(gaps, ratio) {
            Ok(candidate) => candidate.normal_form(),
            Err(_) => unreachable!("at most 17 gaps and a ratio below 2^49"),
        }
    }

    /// 2^h.
    fn unit(&self) -> u64 {
        1 << (8 + self.sample.spread / 2)
    }

    /// (256 + m)·2^e by 61 random bits: m the lowest 8, e by the 32 above them, scaled to 0..spread.
    fn spread_number(&self, bits: u64) -> u64 {
        let exponent = (((bits >> 8) & 0xffff_ffff) * self.sample.spread) >> 32;
        (256 + (bits & 0xff)) << exponent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(seed: u64, spread: u64) -> Random {
        Random::new(3, &Sample { count: 2000, seed, spread }).unwrap()
    }

    #[test]
    fn a_case_depends_on_its_number_only() {
        let random = random(7, 9);
        let all: Vec<_> = random.between(0..2000).collect();
        assert!(random.between(500..510).eq(all[500..510].iter().cloned()));
        assert_eq!(random.between(1999..5000).count(), 1);
        assert!(all.iter().all(|(_, candidate)| candidate.is_normal()));
        // Fixed for good: another result for the same seed would need another version.
        let (_, first) = &all[0];
        assert_eq!((first.gaps(), first.ratio()), FIRST);
        let other = super::Random::new(3, &Sample { count: 1, seed: 8, spread: 9 }).unwrap();
        assert_ne!(other.case(0), all[0].1);
    }

    /// Case 0 of seed 7.
    const FIRST: (&[u64], (u64, u64)) = (&[44544, 211, 590, 1500], (256, 369));

    #[test]
    fn gaps_are_spread_and_some_are_empty() {
        let cases: Vec<_> = random(1, 9).between(0..2000).map(|(_, candidate)| candidate).collect();
        let empty = cases.iter().flat_map(Candidate::gaps).filter(|gap| **gap == 0).count();
        assert!((600..1400).contains(&empty), "{empty} of 8000");
        let wide = |c: &&Candidate| {
            c.gaps().iter().max() > c.gaps().iter().filter(|g| **g > 0).min().map(|g| g * 100).as_ref()
        };
        assert!((200..1500).contains(&cases.iter().filter(wide).count()));
        // Each normal form has r ≤ 1; half of them lie below 2^-2.
        let small = cases.iter().filter(|c| c.ratio().0 * 4 < c.ratio().1).count();
        assert!((700..1300).contains(&small), "{small}");
    }

    #[test]
    fn wrong_samples_are_refused() {
        let new = |count, spread| Random::new(3, &Sample { count, seed: 0, spread }).unwrap_err();
        assert_eq!(new(0, 9), SpaceError::NoCase);
        assert_eq!(new(1, 0), SpaceError::Spread(0));
        assert_eq!(new(1, 41), SpaceError::Spread(41));
    }

    #[test]
    fn given_indices_are_the_only_ones() {
        let sample = |alpha: &[&str]| IndexSample {
            alpha: alpha.iter().map(|&alpha| alpha.to_owned()).collect(),
            count: 300,
            seed: 1,
            spread: 9,
        };
        let random = super::Random::with_indices(3, &sample(&["-4", "3/2", "inf"])).unwrap();
        let met: std::collections::BTreeSet<_> =
            random.between(0..300).map(|(_, case)| case.index().to_string()).collect();
        // 3/2 by its conjugate.
        assert!(met.iter().eq(["-1/2", "-4", "inf"]), "{met:?}");
        for wrong in [&[][..], &["1/2"], &["x"], &["99999999999"]] {
            assert_eq!(super::Random::with_indices(3, &sample(wrong)).unwrap_err(), SpaceError::Index);
        }
    }
}
