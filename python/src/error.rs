//! What goes wrong, as exceptions of Python.

use std::any::Any;
use std::fmt::Display;

use knotproof::cli::{CliError, Exit};
use knotproof::settle::SettleError;
use knotproof::typed::TypedError;
use pyo3::PyErr;
use pyo3::exceptions::{PyRuntimeError, PyValueError};

/// Why a request was not carried out.
#[derive(Debug)]
pub(crate) enum Wrong {
    /// The request is to blame: `ValueError`.
    Request(String),
    /// This program has a bug: `RuntimeError`.
    Bug(String),
}

impl Wrong {
    /// What is wrong with an argument.
    pub(crate) fn with(argument: &str, error: impl Display) -> Self {
        Self::Request(in_keywords(&format!("{argument}: {error}")))
    }

    /// A panic that was caught.
    pub(crate) fn panic(payload: &(dyn Any + Send)) -> Self {
        let message = payload.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("no message");
        Self::Bug(format!("internal error: {message}; please report this bug with what was called"))
    }
}

/// The command line's text: an option is an argument here, and a setting a keyword; a command between backticks stays one.
fn in_keywords(text: &str) -> String {
    let (argument, rest) = match text.split_once(": ") {
        Some((option, rest)) if option.starts_with("--") => (option.replace('-', "_") + ": ", rest),
        _ => (String::new(), text),
    };
    let parts = rest.split('`').enumerate().map(|(at, part)| match at % 2 {
        0 => part.replace("--set ", "").replace("--", ""),
        _ => part.to_owned(),
    });
    argument.trim_start_matches('_').to_owned() + &parts.collect::<Vec<_>>().join("`")
}

impl From<CliError> for Wrong {
    fn from(error: CliError) -> Self {
        if error.exit() == Exit::Internal {
            return Self::Bug(error.to_string());
        }
        let text = in_keywords(&error.to_string());
        Self::Request(match error.excerpt() {
            Some(excerpt) => format!("{text}\n{excerpt}"),
            None => text,
        })
    }
}

impl From<TypedError> for Wrong {
    fn from(error: TypedError) -> Self {
        CliError::from(error).into()
    }
}

impl From<SettleError> for Wrong {
    fn from(error: SettleError) -> Self {
        CliError::from(error).into()
    }
}

impl From<Wrong> for PyErr {
    fn from(wrong: Wrong) -> Self {
        match wrong {
            Wrong::Request(text) => PyValueError::new_err(text),
            Wrong::Bug(text) => PyRuntimeError::new_err(text),
        }
    }
}
