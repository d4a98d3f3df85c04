//! A part of a search, by its number.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use thiserror::Error;

/// Part I of N, I from 0: positions ⌊I·P/N⌋ to ⌊(I + 1)·P/N⌋ of P.
///
/// ```
/// use knotproof::search::Shard;
///
/// let shard: Shard = "1/3".parse()?;
/// assert_eq!(shard.range(10)?, 3..6);
/// assert!("3/3".parse::<Shard>().is_err());
/// # Ok::<(), knotproof::search::ShardError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    of: u64,
}

/// Why something is no shard.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ShardError {
    /// Not two whole numbers.
    #[error("`{0}` is no shard: write I/N with whole numbers, such as 0/3, 1/3 and 2/3 for three shards")]
    Malformed(String),
    /// N = 0.
    #[error("`{0}`: no search can be cut into 0 shards: write I/N with N from 1 up")]
    None(String),
    /// I ≥ N.
    #[error("`{index}/{of}`: there is no shard {index} of {of}: they are numbered from 0 to {}", of - 1)]
    Beyond {
        /// I.
        index: u64,
        /// N.
        of: u64,
    },
    /// More shards than positions: some would be empty.
    #[error("{of} shards are too many: the space has {positions} positions, so at most as many shards")]
    TooMany {
        /// N.
        of: u64,
        /// P.
        positions: u64,
    },
}

impl Shard {
    /// The search as a whole.
    pub const WHOLE: Self = Self { index: 0, of: 1 };

    /// Is this the search as a whole?
    #[must_use]
    pub fn is_whole(self) -> bool {
        self == Self::WHOLE
    }

    /// Its positions, of so many.
    ///
    /// # Errors
    /// [`ShardError::TooMany`], if there are more shards than positions.
    pub fn range(self, positions: u64) -> Result<Range<u64>, ShardError> {
        if self.of > positions {
            return Err(ShardError::TooMany { of: self.of, positions });
        }
        let cut = |i: u64| {
            let place = u128::from(i) * u128::from(positions) / u128::from(self.of);
            u64::try_from(place).unwrap_or(positions)
        };
        Ok(cut(self.index)..cut(self.index + 1))
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let number = |part: &str| {
            let digits = !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
            digits.then(|| part.parse::<u64>().ok()).flatten()
        };
        let parts = text.split_once('/').and_then(|(index, of)| Some((number(index)?, number(of)?)));
        match parts {
            None => Err(ShardError::Malformed(text.to_owned())),
            Some((_, 0)) => Err(ShardError::None(text.to_owned())),
            Some((index, of)) if index >= of => Err(ShardError::Beyond { index, of }),
            Some((index, of)) => Ok(Self { index, of }),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_add_up_to_the_whole() {
        for positions in [1, 2, 7, 100, u64::MAX >> 1] {
            for of in (1..=7).filter(|&of| of <= positions) {
                let ranges: Vec<_> =
                    (0..of).map(|index| Shard { index, of }.range(positions).unwrap()).collect();
                assert_eq!((ranges[0].start, ranges[ranges.len() - 1].end), (0, positions));
                assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start));
                assert!(ranges.iter().all(|range| !range.is_empty()));
            }
        }
        assert!(matches!(Shard { index: 0, of: 8 }.range(7), Err(ShardError::TooMany { .. })));
    }

    #[test]
    fn what_is_no_shard() {
        for text in
            ["", "1", "/", "1/", "/2", "-1/2", "+1/2", "1/2/3", "a/b", "0.5/2", "1/99999999999999999999"]
        {
            assert!(matches!(text.parse::<Shard>(), Err(ShardError::Malformed(_))), "{text}");
        }
        assert!(matches!("0/0".parse::<Shard>(), Err(ShardError::None(_))));
        assert!(matches!("2/2".parse::<Shard>(), Err(ShardError::Beyond { .. })));
    }
}
