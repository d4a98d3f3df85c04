//! The judge as a module of the page: a sentence on a basis that is typed goes in, a verdict about every x comes out, as
//! `knotproof check --claim` gives it.

#![allow(
    unsafe_code,
    reason = "a name that the page can call is an unsafe attribute; there is no unsafe block"
)]

use knotproof::judge::{Cases, Verdict, judge};
use knotproof::language::{Complaint, Known, text};
use knotproof::meaning::{Instance, Names};
use knotproof::spline::Basis;
use knotproof::typed::{Asked, Case, TypedError};
use serde::Deserialize;
use serde_json::{Value, json};

/// What the page asks.
#[derive(Deserialize)]
struct Question {
    #[serde(flatten)]
    on: Asked,
    /// In the claim language, in one line.
    sentence: String,
    /// What the sentence may name: heads, each with its body.
    #[serde(default)]
    definitions: Vec<(String, String)>,
}

/// Why there is no verdict.
enum Refused {
    Typed(TypedError),
    Sentence(Complaint),
    /// A bug of the program.
    Fault(String),
}

fn answered(question: &str) -> String {
    let asked: Result<Question, _> = serde_json::from_str(question);
    let answer = asked.map_err(|error| Refused::Fault(error.to_string())).and_then(|asked| verdict(&asked));
    answer.unwrap_or_else(|refused| refused.told()).to_string()
}

fn verdict(asked: &Question) -> Result<Value, Refused> {
    let Case { weights, basis, curve } = asked.on.case()?;
    let wrong = |error| TypedError::Member { argument: "--family", error };
    let on: Basis<_> = basis.with(weights);
    let on = Instance::on(on).map_err(wrong)?.with_points(curve.map(|curve| curve.points().to_vec()));
    let definitions: Vec<_> =
        asked.definitions.iter().map(|(head, body)| (head.as_str(), body.as_str())).collect();
    let mut known = Known::defining(&definitions)?;
    if let Some(chosen) = asked.on.family()? {
        known = known.about(&chosen.family);
    }
    let sentence = known.one_line_on_knots(&asked.sentence)?;
    let cases = Cases::only(on);
    let verdict = match cases.foreign(&sentence) {
        Some(binder) => {
            let what = text(binder);
            let what = what.strip_prefix("every ").unwrap_or(&what);
            Verdict::NotApplicable(format!("said only of {what}"))
        }
        None => {
            let names = Names { definitions: known.definitions(), library: &() };
            judge(&sentence, names, &cases.of(&sentence, None))
                .map_err(|fault| Refused::Fault(fault.to_string()))?
        }
    };
    let mut told = json!({ "statement": text(&sentence), "status": verdict.status() });
    match verdict {
        Verdict::Proved { scope, reach } => {
            told["scope"] = json!(scope.name());
            told["facts"] = json!(reach.facts);
        }
        Verdict::Refuted(witness) => {
            told["at"] = json!(
                witness.given.iter().map(|bound| (&bound.name, bound.value.to_string())).collect::<Vec<_>>()
            );
            told["claimed"] = json!(witness.claimed);
            told["found"] = json!(witness.found());
            told["witness"] = json!(witness);
        }
        Verdict::Undecided(reason) | Verdict::NotFormal(reason) | Verdict::NotApplicable(reason) => {
            told["reason"] = json!(reason);
        }
    }
    Ok(told)
}

impl From<TypedError> for Refused {
    fn from(error: TypedError) -> Self {
        Self::Typed(error)
    }
}

impl From<Complaint> for Refused {
    fn from(complaint: Complaint) -> Self {
        Self::Sentence(complaint)
    }
}

impl Refused {
    /// As the program's own errors are, in JSON.
    fn told(&self) -> Value {
        let (message, argument) = match self {
            Self::Typed(error) => (error.to_string(), Some(error.argument())),
            Self::Sentence(complaint) => (format!("--claim: {}", complaint.message()), Some("--claim")),
            Self::Fault(why) => (format!("internal error: {why}"), None),
        };
        json!({ "error": { "message": message, "argument": argument } })
    }
}

knotproof_abi::exports!(answered);
