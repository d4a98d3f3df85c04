//! The checker of certificates as a module of the page: a statement and its proof go in, and what they prove comes out.

#![allow(
    unsafe_code,
    reason = "names that the page can call are unsafe attributes; there is no unsafe block"
)]

/// Between the statement and the proof of a question: a byte that occurs in neither.
const BETWEEN: char = '\0';

/// `accepted: …`, or `rejected: …` with the reason.
fn answered(question: &str) -> String {
    let (statement, proof) = question.split_once(BETWEEN).unwrap_or((question, ""));
    match knotproof_checker::check(statement, proof) {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => format!("rejected: {rejected}"),
    }
}

knotproof_abi::exports!(answered);
