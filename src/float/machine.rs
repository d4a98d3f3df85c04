//! What the machine at hand can do, asked once: wide vectors and fused multiply–add change the speed, never a result.

#[cfg(target_arch = "x86_64")]
use pulp::x86::{V1, V3};

use super::vectors::Vectors;

/// Work that can be compiled for several instruction sets. `run` has to be `#[inline(always)]`, and so has all
/// that it calls.
pub(super) trait Kernel {
    /// What comes out.
    type Output;
    /// Does the work with the vectors of a machine.
    fn run<M: Vectors>(self, machine: M) -> Self::Output;
}

/// The instruction set that kernels run on.
#[derive(Debug, Clone, Copy)]
pub(super) enum Machine {
    #[cfg(target_arch = "x86_64")]
    Avx2(V3),
    #[cfg(target_arch = "x86_64")]
    Sse2(V1),
    /// One number at a time: what other machines have, and the tests.
    #[cfg(any(test, not(target_arch = "x86_64")))]
    Single,
}

impl Machine {
    /// All that there are here, for tests that hold them against each other.
    #[cfg(test)]
    pub(super) fn all() -> Vec<Self> {
        vec![Self::Single, Self::portable(), Self::best()]
    }

    /// The best one that there is.
    pub(super) fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(machine) = V3::try_new() {
            return Self::Avx2(machine);
        }
        Self::portable()
    }

    /// The one that the program is compiled for.
    #[cfg(target_arch = "x86_64")]
    pub(super) fn portable() -> Self {
        match V1::try_new() {
            Some(machine) => Self::Sse2(machine),
            None => unreachable!("SSE2 is part of x86-64"),
        }
    }

    /// The one that the program is compiled for.
    #[cfg(not(target_arch = "x86_64"))]
    pub(super) fn portable() -> Self {
        Self::Single
    }

    /// Runs the kernel, compiled for this machine.
    #[inline]
    pub(super) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(machine) => pulp::Simd::vectorize(machine, Compiled { kernel, machine }),
            #[cfg(target_arch = "x86_64")]
            Self::Sse2(machine) => kernel.run(machine),
            #[cfg(target_arch = "aarch64")]
            Self::Single => kernel.run(super::vectors::Fused),
            #[cfg(all(any(test, not(target_arch = "x86_64")), not(target_arch = "aarch64")))]
            Self::Single => kernel.run(super::vectors::Split),
        }
    }
}

#[cfg(target_arch = "x86_64")]
struct Compiled<K> {
    kernel: K,
    machine: V3,
}

#[cfg(target_arch = "x86_64")]
impl<K: Kernel> pulp::NullaryFnOnce for Compiled<K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.kernel.run(self.machine)
    }
}
