//! The search for counterexamples, and how far it has come.

use std::collections::BTreeMap;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use knotproof::cli::search_error;
use knotproof::search::{
    DEFAULT_SIZE, DEFAULT_SIZE_OF_FAMILY, DEFAULT_SPREAD, FamilySpace, Goal, IndexSample, Limits,
    MemberSpace, Portion, Sample, Search, Shard, Space,
};
use knotproof::spline::Index;
use pyo3::prelude::*;
use serde::Deserialize;

use crate::basis::{Alpha, Settings, family};
use crate::error::Wrong;
use crate::work::{LOOK, guarded, spawn, wait};

/// How far it has come: positions done and in all; cases, those with several maxima, those not decided; the findings as JSON.
type State = ((u64, u64), (u64, u64, u64), Vec<String>);

/// Behind `knotproof.search`.
#[pyclass(frozen, module = "knotproof._native")]
pub(crate) struct Searching {
    #[pyo3(get)]
    total: u64,
    shared: Arc<Shared>,
}

#[derive(Default)]
struct Shared {
    news: Mutex<News>,
    /// There is some.
    told: Condvar,
}

/// The latest state that nobody has taken: who is slow misses those before it.
#[derive(Default)]
struct News {
    state: Option<Result<State, Wrong>>,
    over: bool,
    stop: bool,
}

impl Shared {
    fn news(&self) -> MutexGuard<'_, News> {
        self.news.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn tell(&self, state: Result<State, Wrong>) -> Result<(), ()> {
        let mut news = self.news();
        news.state = Some(state);
        self.told.notify_all();
        if news.stop { Err(()) } else { Ok(()) }
    }
}

#[pymethods]
impl Searching {
    #[new]
    #[expect(clippy::too_many_arguments, reason = "the options of a search")]
    fn new(
        py: Python<'_>,
        degree: usize,
        find: &str,
        limits: [Option<u64>; 3],
        sample: [Option<u64>; 3],
        alpha: Vec<Alpha>,
        of: Option<(String, Settings)>,
        shard: Option<String>,
    ) -> PyResult<Self> {
        let goal = serde_json::from_value::<GoalName>(find.into());
        let find = goal.map_err(|error| Wrong::with("find", error))?.0;
        let alpha = alpha.into_iter().map(Alpha::index).collect::<Result<Vec<_>, _>>()?;
        let of = of.map(|(name, settings)| of_family(&name, settings)).transpose()?.flatten();
        let space = space(limits, sample, &alpha, of);
        let part = wait(py, move || {
            let shard = shard.map_or(Ok(Shard::WHOLE), |text| text.parse::<Shard>());
            let shard = shard.map_err(|error| search_error(error.into()))?;
            Ok(Portion::new(Search { degree, find, space }, shard).map_err(search_error)?)
        })?;
        let (total, shared) = (part.range().end - part.range().start, Arc::new(Shared::default()));
        let own = Arc::clone(&shared);
        spawn(move || work(part, &own))?;
        Ok(Self { total, shared })
    }

    /// Ends the search at its next look.
    fn stop(&self) {
        self.shared.news().stop = true;
    }

    /// The latest state, once there is a new one; nothing after the last one.
    fn next(&self, py: Python<'_>) -> PyResult<Option<State>> {
        loop {
            let (state, over) = py.detach(|| {
                let news = self.shared.news();
                let waits = |news: &mut News| news.state.is_none() && !news.over;
                let news = self.shared.told.wait_timeout_while(news, LOOK, waits);
                let (mut news, _) = news.unwrap_or_else(PoisonError::into_inner);
                (news.state.take(), news.over)
            });
            match state {
                Some(state) => return Ok(Some(state?)),
                None if over => return Ok(None),
                None => py.check_signals().inspect_err(|_| self.stop())?,
            }
        }
    }
}

impl Drop for Searching {
    fn drop(&mut self) {
        self.stop();
    }
}

/// A goal by its name; a wrong one is told with those that there are.
#[derive(Deserialize)]
#[serde(transparent)]
struct GoalName(Goal);

/// A family as a search has it: its name or file, what stands in that, and what is set.
type Given = (String, String, BTreeMap<String, String>);

/// A family without an index; nothing for one that has it, whose members are those of the search by index.
fn of_family(name: &str, settings: Settings) -> Result<Option<Given>, Wrong> {
    let (family, given) = family(name, settings)?;
    if matches!(family.moebius(), Some(Some(_))) && given.is_empty() {
        return Ok(None);
    }
    let set = given.into_iter().map(|(name, values)| (name, values.to_string())).collect();
    Ok(Some((family.given.clone(), family.text.clone(), set)))
}

fn space(
    [limit, gap, height]: [Option<u64>; 3],
    [count, seed, spread]: [Option<u64>; 3],
    alpha: &[Index],
    of: Option<Given>,
) -> Space {
    let (seed, spread) = (seed.unwrap_or(0), spread.unwrap_or(DEFAULT_SPREAD));
    let size = limit.unwrap_or(if of.is_some() { DEFAULT_SIZE_OF_FAMILY } else { DEFAULT_SIZE });
    let limits = Limits { size, gap, height };
    match (of, count) {
        (Some((name, text, set)), _) => {
            let cases = count.map_or(MemberSpace::Exhaustive(limits), |count| {
                MemberSpace::Random(Sample { count, seed, spread })
            });
            Space::Family(FamilySpace { name, text, set, cases })
        }
        (None, None) => Space::Exhaustive(limits),
        (None, Some(count)) if alpha.is_empty() => Space::Random(Sample { count, seed, spread }),
        (None, Some(count)) => {
            Space::Indices(IndexSample { alpha: IndexSample::names(alpha), count, seed, spread })
        }
    }
}

fn work(mut part: Portion, shared: &Shared) {
    let ended = guarded(|| {
        _ = part.run(|part| shared.tell(state(part)));
        Ok(())
    });
    if let Err(wrong) = ended {
        _ = shared.tell(Err(wrong));
    }
    shared.news().over = true;
    shared.told.notify_all();
}

fn state(part: &Portion) -> Result<State, Wrong> {
    let json = |record| serde_json::to_string(record);
    let findings = part.findings().records().map(json).collect::<Result<_, _>>();
    let findings = findings.map_err(|error| Wrong::Bug(format!("internal error: {error}")))?;
    let decided = part.decided();
    let total = part.range().end - part.range().start;
    Ok(((part.done(), total), (decided.cases(), decided.several, decided.undecided), findings))
}
