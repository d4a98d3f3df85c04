//! How the page of a report speaks to its two modules: a text goes in, a text comes out.
//!
//! A module exports four functions. `question(n)` makes room for n bytes of UTF-8 and says where; `answer()` answers what was
//! written there and returns the length of the answer, which lies at `text()`. A module is built to abort on a panic: what it
//! said is kept before that, and `fault()` is its length, from then on at `text()` as well; 0 where there was none.

#![forbid(unsafe_code)]

use std::sync::{Mutex, MutexGuard, Once, PoisonError};

static QUESTION: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static TEXT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static FAULT: Mutex<usize> = Mutex::new(0);

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Room for a question of so many bytes.
#[must_use]
pub fn question(length: usize) -> *mut u8 {
    let mut question = held(&QUESTION);
    question.clear();
    question.resize(length, 0);
    question.as_mut_ptr()
}

/// Answers the question, and returns the length of the answer.
pub fn answer(of: impl FnOnce(&str) -> String) -> usize {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| std::panic::set_hook(Box::new(|panic| *held(&FAULT) = told(panic.to_string()))));
    let question = String::from_utf8_lossy(&held(&QUESTION)).into_owned();
    told(of(&question))
}

/// Where the answer is, or what a panic said.
#[must_use]
pub fn text() -> *const u8 {
    held(&TEXT).as_ptr()
}

/// The length of what a panic said; 0 if there was none.
#[must_use]
pub fn fault() -> usize {
    *held(&FAULT)
}

fn told(text: String) -> usize {
    let mut place = held(&TEXT);
    *place = text.into_bytes();
    place.len()
}

/// Exports the four functions for a module whose answers the function `$answer` gives.
#[macro_export]
macro_rules! exports {
    ($answer:ident) => {
        mod exported {
            #[unsafe(no_mangle)]
            extern "C" fn question(length: usize) -> *mut u8 {
                $crate::question(length)
            }
            #[unsafe(no_mangle)]
            extern "C" fn answer() -> usize {
                $crate::answer(super::$answer)
            }
            #[unsafe(no_mangle)]
            extern "C" fn text() -> *const u8 {
                $crate::text()
            }
            #[unsafe(no_mangle)]
            extern "C" fn fault() -> usize {
                $crate::fault()
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_panic_says_is_kept() {
        assert_eq!((answer(|question| format!("“{question}”")), fault()), (6, 0));
        assert!(std::panic::catch_unwind(|| answer(|_| unreachable!("a bug, on purpose"))).is_err());
        let said = String::from_utf8_lossy(&held(&TEXT)).into_owned();
        assert!(said.contains("a bug, on purpose") && fault() == said.len(), "{said}");
    }
}
