//! The panel of the page as a module: what is typed goes in, what `eval` and `shape` say of it comes out, and the numbers that
//! a drawing takes.

#![allow(
    unsafe_code,
    reason = "a name that the page can call is an unsafe attribute; there is no unsafe block"
)]

mod drawing;
mod families;
mod shapes;
mod values;

use knotproof::typed::{Asked, TypedError};
use serde::Deserialize;
use serde_json::{Value, json};

/// What the page asks.
#[derive(Deserialize)]
struct Question {
    ask: Ask,
    #[serde(flatten)]
    on: Asked,
    /// The point x.
    #[serde(default)]
    x: String,
    /// A slope ratio.
    #[serde(default)]
    ratio: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Ask {
    /// Values, slopes and the point of the curve at x.
    Values,
    /// Local maxima and jumps of all functions.
    Shapes,
    /// Functions and curve in floats.
    Drawing,
    /// The families that there are.
    Families,
    /// Parameters of a family to begin with.
    Member,
    /// The index of a slope ratio.
    Index,
}

fn answered(question: &str) -> String {
    let asked: Question = match serde_json::from_str(question) {
        Ok(asked) => asked,
        Err(error) => return refused(&format!("internal error: {error}"), None),
    };
    let answer = match asked.ask {
        Ask::Values => values::at(&asked.on, &asked.x),
        Ask::Shapes => shapes::of(&asked.on),
        Ask::Drawing => drawing::of(&asked.on),
        Ask::Families => Ok(families::all()),
        Ask::Member => families::member(&asked.on),
        Ask::Index => families::index(&asked.ratio),
    };
    answer.map_or_else(
        |error| refused(&error.to_string(), Some(error.argument())),
        |answer: Value| answer.to_string(),
    )
}

/// As the program's own errors are, in JSON.
fn refused(message: &str, argument: Option<&str>) -> String {
    json!({ "error": { "message": message, "argument": argument } }).to_string()
}

/// Exact numbers, as the program writes them.
fn exact<T: ToString>(numbers: impl IntoIterator<Item = T>) -> Vec<String> {
    numbers.into_iter().map(|number| number.to_string()).collect()
}

type Answer = Result<Value, TypedError>;

knotproof_abi::exports!(answered);
