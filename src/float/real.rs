//! The two float types that a basis can be computed in.

use num_traits::Float;

/// `f32` or `f64`. Sealed: what is proved of the results is proved for these two.
pub trait Real:
    Float + std::fmt::Debug + std::fmt::LowerExp + Send + Sync + sealed::Sealed + 'static
{
    /// The least positive number.
    const LEAST: Self;
    /// Numbers up to 2 to this power are safe from overflow, with a product or two to come.
    const HIGHEST_EXPONENT: i32;
    /// The product of all denominators of the fast path stays below 2 to this power: then its quotients are positive
    /// where no point is next to a knot.
    const FAST_EXPONENT: i32;

    /// The same number in `f64`: exact.
    fn widen(self) -> f64;
    /// The nearest number of this type.
    fn nearest(value: f64) -> Self;
}

impl Real for f64 {
    const LEAST: Self = 5e-324;
    const HIGHEST_EXPONENT: i32 = 1000;
    const FAST_EXPONENT: i32 = 400;

    #[inline(always)]
    fn widen(self) -> f64 {
        self
    }
    #[inline(always)]
    fn nearest(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    const LEAST: Self = 1e-45;
    const HIGHEST_EXPONENT: i32 = 120;
    const FAST_EXPONENT: i32 = 40;

    #[inline(always)]
    fn widen(self) -> f64 {
        self.into()
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "rounding to the narrower type is what is asked for")]
    fn nearest(value: f64) -> Self {
        value as Self
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}
