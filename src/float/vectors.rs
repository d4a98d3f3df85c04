//! Several `f64` at once: the arithmetic of one machine, lane by lane.

use std::array::from_fn;

/// Vectors of floats. Sums, differences, products and quotients are those of IEEE 754 and [`Self::two_product`] is exact, so
/// no result depends on the machine, nor on the number of lanes. Loops over arrays would be no substitute: the compiler leaves most of
/// a long one in single numbers.
pub(crate) trait Vectors: Copy {
    /// [`Self::LANES`] floats.
    type Vector: Copy;
    const LANES: usize;

    /// The same machine, one number at a time.
    type Single: Vectors<Vector = f64>;
    fn single(self) -> Self::Single;

    /// The vector of `lane`(0), `lane`(1), …
    fn load(self, lane: impl Fn(usize) -> f64) -> Self::Vector;
    /// Hands out lane after lane.
    fn store(self, vector: Self::Vector, lane: impl FnMut(usize, f64));

    fn add(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    fn sub(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    fn mul(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;
    fn div(self, a: Self::Vector, b: Self::Vector) -> Self::Vector;

    /// (p, e) with p the rounded product and p + e the product itself, barring underflow.
    fn two_product(self, a: Self::Vector, b: Self::Vector) -> (Self::Vector, Self::Vector);

    /// The same number in every lane.
    #[inline(always)]
    fn splat(self, value: f64) -> Self::Vector {
        self.load(|_| value)
    }
}

/// Half of the last bit of the first 26, and those 26 with sign and exponent: rounds a float to 26 bits, and at most 26 with a sign are left.
const HALF: u64 = 1 << 26;
const HEAD: u64 = !((1 << 27) - 1);

/// Dekker's product (1971), on any machine: all products of halves are exact. `head`(x) is x rounded to 26 bits.
#[inline(always)]
fn two_product_by_halves<M: Vectors>(
    m: M,
    a: M::Vector,
    b: M::Vector,
    head: impl Fn(M::Vector) -> M::Vector,
) -> (M::Vector, M::Vector) {
    let (a1, b1) = (head(a), head(b));
    let (a2, b2) = (m.sub(a, a1), m.sub(b, b1));
    let p = m.mul(a, b);
    let rest = m.add(m.sub(m.mul(a1, b1), p), m.mul(a1, b2));
    (p, m.add(m.add(rest, m.mul(a2, b1)), m.mul(a2, b2)))
}

/// One number at a time, exact products by splitting.
#[derive(Clone, Copy)]
pub(crate) struct Split;

/// One number at a time, exact products by fused multiply–add, where the machine has one.
#[derive(Clone, Copy)]
pub(crate) struct Fused;

/// The lanes and the four operations of a vector that is one float.
macro_rules! one_lane {
    () => {
        type Vector = f64;
        const LANES: usize = 1;
        type Single = Self;

        #[inline(always)]
        fn single(self) -> Self {
            self
        }
        #[inline(always)]
        fn load(self, lane: impl Fn(usize) -> f64) -> f64 {
            lane(0)
        }
        #[inline(always)]
        fn store(self, vector: f64, mut lane: impl FnMut(usize, f64)) {
            lane(0, vector);
        }
        #[inline(always)]
        fn add(self, a: f64, b: f64) -> f64 {
            a + b
        }
        #[inline(always)]
        fn sub(self, a: f64, b: f64) -> f64 {
            a - b
        }
        #[inline(always)]
        fn mul(self, a: f64, b: f64) -> f64 {
            a * b
        }
        #[inline(always)]
        fn div(self, a: f64, b: f64) -> f64 {
            a / b
        }
    };
}

impl Vectors for Split {
    one_lane!();

    #[inline(always)]
    fn two_product(self, a: f64, b: f64) -> (f64, f64) {
        two_product_by_halves(self, a, b, |x| f64::from_bits(x.to_bits().wrapping_add(HALF) & HEAD))
    }
}

impl Vectors for Fused {
    one_lane!();

    #[inline(always)]
    fn two_product(self, a: f64, b: f64) -> (f64, f64) {
        let p = a * b;
        (p, a.mul_add(b, -p))
    }
}

/// The lanes and the four operations of vectors of `pulp`.
#[cfg(target_arch = "x86_64")]
macro_rules! lanes {
    ($lanes:literal, $vector:ty, $single:ident, $add:ident $sub:ident $mul:ident $div:ident) => {
        type Vector = $vector;
        const LANES: usize = $lanes;
        type Single = $single;

        #[inline(always)]
        fn single(self) -> $single {
            $single
        }
        #[inline(always)]
        fn load(self, lane: impl Fn(usize) -> f64) -> $vector {
            pulp::cast(from_fn::<f64, $lanes, _>(lane))
        }
        #[inline(always)]
        fn store(self, vector: $vector, mut lane: impl FnMut(usize, f64)) {
            let lanes: [f64; $lanes] = pulp::cast(vector);
            for (l, value) in lanes.into_iter().enumerate() {
                lane(l, value);
            }
        }
        #[inline(always)]
        fn add(self, a: $vector, b: $vector) -> $vector {
            self.$add(a, b)
        }
        #[inline(always)]
        fn sub(self, a: $vector, b: $vector) -> $vector {
            self.$sub(a, b)
        }
        #[inline(always)]
        fn mul(self, a: $vector, b: $vector) -> $vector {
            self.$mul(a, b)
        }
        #[inline(always)]
        fn div(self, a: $vector, b: $vector) -> $vector {
            self.$div(a, b)
        }
    };
}

/// What every x86-64 has: SSE2.
#[cfg(target_arch = "x86_64")]
impl Vectors for pulp::x86::V1 {
    lanes!(2, pulp::f64x2, Split, add_f64x2 sub_f64x2 mul_f64x2 div_f64x2);

    #[inline(always)]
    fn two_product(self, a: pulp::f64x2, b: pulp::f64x2) -> (pulp::f64x2, pulp::f64x2) {
        let (half, head) = (self.splat_u64x2(HALF), self.splat_u64x2(HEAD));
        two_product_by_halves(self, a, b, |x| {
            pulp::cast(self.and_u64x2(self.wrapping_add_u64x2(pulp::cast(x), half), head))
        })
    }
}

/// AVX2 and fused multiply–add.
#[cfg(target_arch = "x86_64")]
impl Vectors for pulp::x86::V3 {
    lanes!(4, pulp::f64x4, Fused, add_f64x4 sub_f64x4 mul_f64x4 div_f64x4);

    #[inline(always)]
    fn two_product(self, a: pulp::f64x4, b: pulp::f64x4) -> (pulp::f64x4, pulp::f64x4) {
        let p = self.mul(a, b);
        (p, pulp::cast(self.fma._mm256_fmsub_pd(pulp::cast(a), pulp::cast(b), pulp::cast(p))))
    }
}
