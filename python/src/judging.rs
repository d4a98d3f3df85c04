//! All claims of a paper, one after the other.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use knotproof::cli::{CliError, paper_of, settle_error};
use knotproof::judge::Cases;
use knotproof::language::{Claim, Paper};
use knotproof::report::Record;
use knotproof::settle::{Proving, settle};
use knotproof::typed::TypedError;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::check::Told;
use crate::error::Wrong;
use crate::work::{LOOK, guarded, spawn, wait};

/// What came of the claim at a place.
type Event = (usize, Result<String, Wrong>);

/// Behind `knotproof.judge`: works in threads of its own, and gives verdicts in the order of the paper.
#[pyclass(frozen, module = "knotproof._native")]
pub(crate) struct Judging {
    #[pyo3(get)]
    total: usize,
    shared: Arc<Shared>,
    queue: Mutex<Queue>,
}

/// What both sides see.
#[derive(Default)]
struct Shared {
    stop: AtomicBool,
    done: AtomicUsize,
}

/// What has come, and not yet been given.
struct Queue {
    events: Receiver<Event>,
    early: BTreeMap<usize, String>,
    next: usize,
}

#[pymethods]
impl Judging {
    #[new]
    fn new(
        py: Python<'_>,
        paper: String,
        claims: Vec<String>,
        degrees: Option<(usize, usize)>,
    ) -> PyResult<Self> {
        let ((folder, paper), places) = wait(py, move || {
            let folder = OsString::from(paper);
            let paper = paper_of("paper", &folder)?;
            let ids: Vec<_> = Claim::of(&paper).map(|claim| claim.id()).collect();
            if let Some(name) = claims.iter().find(|name| !ids.contains(&name.as_str())) {
                return Err(CliError::unknown_claim("claims", name, &ids).into());
            }
            let is_wanted = |id: &str| claims.is_empty() || claims.iter().any(|name| name == id);
            let places: Vec<_> = (0..ids.len()).filter(|&place| is_wanted(ids[place])).collect();
            Ok(((folder, paper), places))
        })?;
        let (total, shared) = (places.len(), Arc::new(Shared::default()));
        let (sender, events) = channel();
        let own = Arc::clone(&shared);
        spawn(move || work((&folder, &paper), &places, degrees, &own, &sender))?;
        let queue = Mutex::new(Queue { events, early: BTreeMap::new(), next: 0 });
        Ok(Self { total, shared, queue })
    }

    /// How many claims are judged, given or not.
    #[getter]
    fn done(&self) -> usize {
        self.shared.done.load(Ordering::Relaxed)
    }

    /// Begins no further claim.
    fn stop(&self) {
        self.shared.stop.store(true, Ordering::Relaxed);
    }

    /// The next one as JSON, once it is there; nothing at the end.
    fn next(&self, py: Python<'_>) -> PyResult<Option<String>> {
        loop {
            match py.detach(|| self.look()) {
                ControlFlow::Break(Ok(record)) => return Ok(record),
                ControlFlow::Break(Err(wrong)) => {
                    self.stop();
                    return Err(wrong.into());
                }
                ControlFlow::Continue(()) => py.check_signals().inspect_err(|_| self.stop())?,
            }
        }
    }
}

impl Drop for Judging {
    fn drop(&mut self) {
        self.stop();
    }
}

impl Judging {
    fn look(&self) -> ControlFlow<Result<Option<String>, Wrong>> {
        let mut queue = self.queue.lock().unwrap_or_else(PoisonError::into_inner);
        let next = queue.next;
        if let Some(record) = queue.early.remove(&next) {
            queue.next += 1;
            return ControlFlow::Break(Ok(Some(record)));
        }
        match queue.events.recv_timeout(LOOK) {
            Ok((place, Ok(record))) => _ = queue.early.insert(place, record),
            Ok((_, Err(wrong))) => return ControlFlow::Break(Err(wrong)),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return ControlFlow::Break(Ok(None)),
        }
        ControlFlow::Continue(())
    }
}

/// Judges in parallel; nobody hears what is sent after the end.
fn work(
    (folder, paper): (&OsStr, &Cow<'static, Paper>),
    places: &[usize],
    degrees: Option<(usize, usize)>,
    shared: &Shared,
    sender: &Sender<Event>,
) {
    let of_paper = guarded(|| {
        Ok(Cases::of_paper(paper).map_err(|error| TypedError::Member { argument: "paper", error })?)
    });
    let cases = match of_paper {
        Ok(cases) => cases,
        Err(wrong) => {
            _ = sender.send((0, Err(wrong)));
            return;
        }
    };
    // Certificates are about other degrees, too.
    let (cases, proving) = match degrees {
        Some((first, last)) => (cases.in_degrees(&(first..=last)), Proving::Nothing),
        None => (cases, Proving::Everything),
    };
    let all: Vec<_> = Claim::of(paper).collect();
    places.par_iter().enumerate().for_each_with(sender.clone(), |sender, (at, place)| {
        if shared.stop.load(Ordering::Relaxed) {
            return;
        }
        let told = guarded(|| {
            let outcome = settle(all[*place], &cases, proving);
            let outcome = outcome.map_err(|error| settle_error("paper", paper, folder, error))?;
            Told::of_record(all[*place], &Record::new(all[*place], &outcome)).json()
        });
        shared.done.fetch_add(1, Ordering::Relaxed);
        _ = sender.send((at, told));
    });
}
