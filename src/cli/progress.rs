//! Progress on standard error: a bar on a terminal, and a line now and then elsewhere.

use std::fmt::Write as _;
use std::io::{IsTerminal, Write as _};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::scalar::effort;

/// What a command has done so far, told while it works.
///
/// The time moves on, and so does the number of small steps inside the step that is under way, however long that takes.
/// On a terminal it is a bar. Elsewhere, as in the log of a job, it is a line after [`FIRST`], after twice that, and so
/// on, up to one every [`LONGEST`]. `KNOTPROOF_PROGRESS=never` turns both off, and
/// `KNOTPROOF_PROGRESS=terminal` the lines.
pub(super) struct Progress {
    shared: Arc<Shared>,
    ticker: Option<JoinHandle<()>>,
}

/// The time until the first line.
const FIRST: Duration = Duration::from_secs(5);
/// The longest time between two lines.
const LONGEST: Duration = Duration::from_secs(60);
/// The time between two looks of the bar.
const TICK: Duration = Duration::from_millis(250);
/// Characters of a name that are shown.
const NAME: usize = 60;

struct Shared {
    state: Mutex<State>,
    /// The work is over.
    over: Condvar,
}

struct State {
    done: u64,
    total: Option<u64>,
    /// What is counted: `of 49`, or `of 49 bytes`.
    unit: &'static str,
    /// What is under way, if that has a name, since when, and how much effort there had been before.
    name: String,
    begun: Instant,
    before: u64,
    over: bool,
}

impl Progress {
    /// For so many steps.
    pub(super) fn new(steps: usize) -> Self {
        let steps = u64::try_from(steps).unwrap_or(u64::MAX);
        Self::begin(Some(steps), "", "{bar:30} {pos}/{len} {elapsed} {wide_msg}")
    }

    /// For a file of so many bytes, or a count of bytes if nobody knows how many there are.
    pub(super) fn of_bytes(length: Option<u64>) -> Self {
        let template = match length {
            Some(_) => "{bar:30} {bytes}/{total_bytes} {elapsed} {wide_msg}",
            None => "{bytes} {elapsed} {wide_msg}",
        };
        Self::begin(length, " bytes", template)
    }

    fn begin(total: Option<u64>, unit: &'static str, template: &str) -> Self {
        let (name, begun, before) = (String::new(), Instant::now(), effort());
        let state = State { done: 0, total, unit, name, begun, before, over: false };
        let shared = Arc::new(Shared { state: Mutex::new(state), over: Condvar::new() });
        let terminal = std::io::stderr().is_terminal();
        let wanted = match std::env::var_os("KNOTPROOF_PROGRESS") {
            Some(when) if when == "never" => false,
            Some(when) if when == "terminal" => terminal,
            _ => true,
        };
        let bar = terminal.then(|| bar(total, template));
        let told = Arc::clone(&shared);
        // Without a thread to spare the work goes on in silence.
        let ticker =
            wanted.then(|| thread::Builder::new().spawn(move || told.tell(bar))).and_then(Result::ok);
        Self { shared, ticker }
    }

    /// The step before is done; this one comes next.
    pub(super) fn step(&self, name: &str) {
        let mut state = self.shared.state();
        state.done += u64::from(!state.name.is_empty());
        state.next(name);
    }

    /// A step for each, in parallel, with what comes of them in their order; the name shown is that of the last one that began.
    pub(super) fn each<T: Sync, R: Send>(
        &self,
        all: &[T],
        name: impl Fn(&T) -> String + Sync,
        step: impl Fn(&T) -> R + Sync,
    ) -> Vec<R> {
        let done = AtomicU64::new(0);
        let one = |of: &T| {
            self.reach(done.load(Ordering::Relaxed), &name(of));
            let result = step(of);
            done.fetch_add(1, Ordering::Relaxed);
            result
        };
        all.par_iter().map(one).collect()
    }

    /// So many steps are done, and this is what there is to say of them.
    pub(super) fn reach(&self, steps: u64, note: &str) {
        let mut state = self.shared.state();
        state.done = steps;
        state.next(note);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.shared.state().over = true;
        self.shared.over.notify_all();
        if let Some(ticker) = self.ticker.take() {
            // It has nothing to return, and a panic of it has been told.
            let _ = ticker.join();
        }
    }
}

fn bar(total: Option<u64>, template: &str) -> ProgressBar {
    let bar = total.map_or_else(ProgressBar::no_length, ProgressBar::new);
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar
}

impl Shared {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells what there is until the work is over.
    fn tell(&self, bar: Option<ProgressBar>) {
        let start = Instant::now();
        let mut pause = if bar.is_some() { TICK } else { FIRST };
        loop {
            let state = self.state();
            let ended = |state: &mut State| !state.over;
            let (state, _) =
                self.over.wait_timeout_while(state, pause, ended).unwrap_or_else(PoisonError::into_inner);
            if state.over {
                break;
            }
            match &bar {
                Some(bar) => {
                    bar.set_position(state.done);
                    bar.set_message(state.inside(state.begun.elapsed(), effort()));
                }
                None => {
                    let line = state.line(start.elapsed(), state.begun.elapsed(), effort());
                    drop(state);
                    // Nobody is left to be told that standard error is closed.
                    let _ = writeln!(anstream::stderr(), "{line}");
                    // The next line when twice the time has gone by.
                    pause = start.elapsed().min(LONGEST);
                }
            }
        }
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
    }
}

impl State {
    fn next(&mut self, name: &str) {
        name.clone_into(&mut self.name);
        (self.begun, self.before) = (Instant::now(), effort());
    }

    /// What is under way, for how long, and how many steps there have been in it.
    fn inside(&self, time: Duration, effort: u64) -> String {
        let mut text: String = self.name.chars().take(NAME).collect();
        if self.name.chars().nth(NAME).is_some() {
            text.push('…');
        }
        let steps = effort - self.before;
        if time >= Duration::from_secs(1) {
            let separator = if text.is_empty() { "" } else { ", " };
            let _ = write!(text, "{separator}{} inside", clock(time));
            if steps > 0 {
                let _ = write!(text, ", {steps} steps of it");
            }
        }
        text
    }

    fn line(&self, elapsed: Duration, inside: Duration, effort: u64) -> String {
        let Self { done, unit, .. } = self;
        let of = self.total.map(|total| format!(" of {total}")).unwrap_or_default();
        let inside = self.inside(inside, effort);
        let separator = if inside.is_empty() { "" } else { ": " };
        format!("progress: {} elapsed, {done}{of}{unit} done{separator}{inside}", clock(elapsed))
    }
}

/// Minutes and seconds, and hours if there are any.
fn clock(time: Duration) -> String {
    let seconds = time.as_secs();
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    if hours > 0 { format!("{hours}:{minutes:02}:{seconds:02}") } else { format!("{minutes}:{seconds:02}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(done: u64, total: Option<u64>, name: &str) -> State {
        State { done, total, unit: "", name: name.to_owned(), begun: Instant::now(), before: 7, over: false }
    }

    #[test]
    fn a_line_says_what_is_done_and_what_moves() {
        let seconds = Duration::from_secs;
        let line = state(21, Some(49), "T3.5.3").line(seconds(65), seconds(60), 107);
        assert_eq!(line, "progress: 1:05 elapsed, 21 of 49 done: T3.5.3, 1:00 inside, 100 steps of it");
        let line = state(0, None, "").line(seconds(3605), seconds(0), 7);
        assert_eq!(line, "progress: 1:00:05 elapsed, 0 done");
        let long = "9".repeat(100_000);
        assert!(state(0, Some(1), &long).line(seconds(5), seconds(5), 7).chars().count() < 150);
    }

    #[test]
    fn steps_are_counted_when_the_next_one_begins() {
        let progress = Progress::new(3);
        let done = || progress.shared.state().done;
        progress.step("one");
        assert_eq!(done(), 0);
        progress.step("two");
        assert_eq!(done(), 1);
        progress.reach(3, "");
        assert_eq!(done(), 3);
    }
}
