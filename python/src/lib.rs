//! The Python package `knotproof`: what of it is computed in Rust.
//!
//! The package itself, `python/knotproof`, is written in Python: it takes numbers apart, keeps the dataclasses and says what each
//! thing means. Here are its calls of the library, each with plain values on both sides: fractions, texts, tuples. Whatever may take
//! long runs on a thread of its own with the interpreter free ([`work`]); what is wrong is an exception with the command line's text
//! ([`error`]).

mod basis;
mod check;
mod curve;
mod error;
mod floats;
mod instance;
mod judging;
mod measure;
mod searching;
mod work;

use pyo3::prelude::*;

/// What `knotproof` is made of.
#[pymodule]
mod _native {
    use knotproof::scalar::{BigRational, parse_rational};
    use pyo3::exceptions::PyValueError;
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::basis::Basis;
    #[pymodule_export]
    use super::curve::Curve;
    #[pymodule_export]
    use super::instance::{families, instance};
    #[pymodule_export]
    use super::judging::Judging;
    #[pymodule_export]
    use super::searching::Searching;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }

    /// The number that a text says, as on the command line.
    #[pyfunction]
    fn parse(text: &str) -> PyResult<BigRational> {
        parse_rational(text).map_err(|error| PyValueError::new_err(error.to_string()))
    }
}
