//! Long work: on a thread of its own, with the interpreter free, and stopped by Ctrl-C.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::error::Wrong;

/// The time between two looks for Ctrl-C.
pub(crate) const LOOK: Duration = Duration::from_millis(50);

/// What `job` returns; a panic in it is an error.
pub(crate) fn guarded<T>(job: impl FnOnce() -> Result<T, Wrong>) -> Result<T, Wrong> {
    catch_unwind(AssertUnwindSafe(job)).unwrap_or_else(|payload| Err(Wrong::panic(&*payload)))
}

/// Begins a thread.
pub(crate) fn spawn(job: impl FnOnce() + Send + 'static) -> Result<(), Wrong> {
    let thread = thread::Builder::new().name("knotproof".to_owned()).spawn(job);
    thread.map(drop).map_err(|error| Wrong::Request(format!("no thread can be begun: {error}")))
}

/// Waits for `job`: if it is quick, on this thread, as to begin another one would take longer.
pub(crate) fn wait_for<T: Send + 'static>(
    py: Python<'_>,
    is_slow: bool,
    job: impl FnOnce() -> Result<T, Wrong> + Send + 'static,
) -> PyResult<T> {
    if is_slow { wait(py, job) } else { Ok(py.detach(|| guarded(job))?) }
}

/// Waits for `job`. Ctrl-C raises here at once; the job then goes on to its end, unheard: exact arithmetic has no place
/// where it could be stopped.
pub(crate) fn wait<T: Send + 'static>(
    py: Python<'_>,
    job: impl FnOnce() -> Result<T, Wrong> + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = channel();
    spawn(move || _ = sender.send(guarded(job)))?;
    let receiver = Mutex::new(receiver);
    loop {
        match py.detach(|| receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(LOOK)) {
            Ok(result) => return Ok(result?),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(Wrong::Bug("internal error: a thread ended without a result".to_owned()).into());
            }
        }
    }
}
