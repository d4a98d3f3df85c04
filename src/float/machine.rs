//! What the machine at hand can do, asked once: wide vectors and fused multiply–add change the speed, never a result.

use pulp::Arch;

use super::pair::{Fused, Products, Split};

/// Work that can be compiled for several instruction sets. `run` has to be `#[inline(always)]`, and so has all
/// that it calls.
pub(super) trait Kernel {
    /// What comes out.
    type Output;
    /// Does the work, with products found in the way of `M`.
    fn run<M: Products>(self) -> Self::Output;
}

/// The instruction set that kernels run on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Machine(Arch);

impl Machine {
    /// The best one that there is.
    pub(super) fn best() -> Self {
        Self(Arch::new())
    }

    /// The one that the program is compiled for.
    pub(super) fn portable() -> Self {
        Self(Arch::Scalar)
    }

    /// Runs the kernel, compiled for this machine.
    #[inline]
    pub(super) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Arch::V3(simd) => simd.vectorize(Compiled(kernel)),
            _ if cfg!(target_arch = "aarch64") => kernel.run::<Fused>(),
            _ => kernel.run::<Split>(),
        }
    }
}

#[cfg(target_arch = "x86_64")]
struct Compiled<K>(K);

#[cfg(target_arch = "x86_64")]
impl<K: Kernel> pulp::NullaryFnOnce for Compiled<K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.0.run::<Fused>()
    }
}
