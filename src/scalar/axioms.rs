//! The laws of the structures in [`ring`](super), as suites that any scalar can be put through.
//!
//! Each suite takes elements, best chosen for trouble, tries every law on every combination of them, and
//! returns the first equation that fails, written out. For a float the suites hold on elements on which no
//! operation rounds, and fail elsewhere: the tests show both.

use num_rational::BigRational;

use super::rational::{integer, rational};
use super::ring::{Field, OrderedField, RationalAlgebra, Ring};

/// A law that did not hold: its name and both sides.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{law} fails: {left} ≠ {right}")]
pub struct BrokenLaw {
    /// The law with the elements on which it was tried.
    pub law: String,
    /// The left side.
    pub left: String,
    /// The right side.
    pub right: String,
}

fn expect<S: PartialEq + std::fmt::Debug>(
    law: &str,
    on: &[&S],
    left: &S,
    right: &S,
) -> Result<(), BrokenLaw> {
    if left == right {
        return Ok(());
    }
    let law = format!("{law} on {on:?}");
    Err(BrokenLaw { law, left: format!("{left:?}"), right: format!("{right:?}") })
}

/// The laws of a commutative ring with 1.
///
/// # Errors
/// The first law that fails.
pub fn ring<S: Ring>(elements: &[S]) -> Result<(), BrokenLaw> {
    for a in elements {
        let (zero, one) = (a.zero(), a.one());
        expect("a + 0 = a", &[a], &a.plus(&zero), a)?;
        expect("a·1 = a", &[a], &a.times(&one), a)?;
        expect("a·0 = 0", &[a], &a.times(&zero), &zero)?;
        expect("a + (−a) = 0", &[a], &a.plus(&a.negate()), &zero)?;
        expect("a⁰ = 1", &[a], &a.power(0), &one)?;
        expect("a⁵ = a·a·a·a·a", &[a], &a.power(5), &a.times(a).times(a).times(a).times(a))?;
        if a.is_zero() != (*a == zero) {
            return Err(BrokenLaw {
                law: format!("is_zero(a) ⇔ a = 0 on {a:?}"),
                left: a.is_zero().to_string(),
                right: (*a == zero).to_string(),
            });
        }
        for b in elements {
            expect("a + b = b + a", &[a, b], &a.plus(b), &b.plus(a))?;
            expect("a·b = b·a", &[a, b], &a.times(b), &b.times(a))?;
            expect("a − b = a + (−b)", &[a, b], &a.minus(b), &a.plus(&b.negate()))?;
            for c in elements {
                let on = &[a, b, c];
                expect("(a + b) + c = a + (b + c)", on, &a.plus(b).plus(c), &a.plus(&b.plus(c)))?;
                expect("(a·b)·c = a·(b·c)", on, &a.times(b).times(c), &a.times(&b.times(c)))?;
                expect("a·(b + c) = a·b + a·c", on, &a.times(&b.plus(c)), &a.times(b).plus(&a.times(c)))?;
            }
        }
    }
    Ok(())
}

/// The laws of a ring; the rationals embed as a ring; what has a reciprocal is a unit.
///
/// # Errors
/// The first law that fails.
pub fn rational_algebra<S: RationalAlgebra>(elements: &[S]) -> Result<(), BrokenLaw> {
    ring(elements)?;
    let rationals: [BigRational; 5] = [integer(0), integer(1), integer(2), rational(-1, 2), rational(3, 4)];
    for a in elements {
        expect("embed(0) = 0", &[a], &a.embed(&integer(0)), &a.zero())?;
        expect("embed(1) = 1", &[a], &a.embed(&integer(1)), &a.one())?;
        for p in &rationals {
            for q in &rationals {
                let sum = a.embed(p).plus(&a.embed(q));
                expect("embed(p + q) = embed(p) + embed(q)", &[a], &a.embed(&(p + q)), &sum)?;
                let product = a.embed(p).times(&a.embed(q));
                expect("embed(p·q) = embed(p)·embed(q)", &[a], &a.embed(&(p * q)), &product)?;
            }
        }
        if let Some(inverse) = a.reciprocal() {
            expect("a·(1/a) = 1", &[a], &a.times(&inverse), &a.one())?;
            for b in elements {
                let quotient = b.over(a).unwrap_or_else(|| b.zero());
                expect("(b/a)·a = b", &[a, b], &quotient.times(a), b)?;
            }
        }
        for b in elements {
            if let Some((w, v)) = a.shares(b) {
                let sum = a.plus(b);
                expect("a/(a + b)·(a + b) = a", &[a, b], &w.times(&sum), a)?;
                expect("b/(a + b)·(a + b) = b", &[a, b], &v.times(&sum), b)?;
            }
        }
    }
    Ok(())
}

/// The laws of a [`rational_algebra`]; exactly the elements other than 0 have a reciprocal.
///
/// # Errors
/// The first law that fails.
pub fn field<S: Field>(elements: &[S]) -> Result<(), BrokenLaw> {
    rational_algebra(elements)?;
    for a in elements {
        if a.reciprocal().is_some() == a.is_zero() {
            return Err(BrokenLaw {
                law: format!("a has a reciprocal ⇔ a ≠ 0 on {a:?}"),
                left: a.reciprocal().is_some().to_string(),
                right: (!a.is_zero()).to_string(),
            });
        }
    }
    Ok(())
}

/// The laws of a [`field`] whose order agrees with + and ·.
///
/// # Errors
/// The first law that fails.
pub fn ordered_field<S: OrderedField>(elements: &[S]) -> Result<(), BrokenLaw> {
    field(elements)?;
    let positive = |a: &S| *a > a.zero();
    for a in elements {
        for b in elements {
            let law = |name: &str, holds: bool| {
                let law = format!("{name} on {a:?}, {b:?}");
                let broken = BrokenLaw { law, left: "false".into(), right: "true".into() };
                if holds { Ok(()) } else { Err(broken) }
            };
            law(
                "exactly one of a < b, a = b, a > b",
                [a < b, a == b, a > b].iter().filter(|x| **x).count() == 1,
            )?;
            law("a < b ⇔ b − a > 0", (a < b) == positive(&b.minus(a)))?;
            law("a > 0 and b > 0 ⇒ a + b > 0", !(positive(a) && positive(b)) || positive(&a.plus(b)))?;
            law("a > 0 and b > 0 ⇒ a·b > 0", !(positive(a) && positive(b)) || positive(&a.times(b)))?;
        }
    }
    Ok(())
}
