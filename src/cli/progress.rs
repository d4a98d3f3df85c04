//! Progress on standard error, on a terminal only.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar that counts steps and names the one under way. Hidden where standard error is no terminal.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar for so many steps.
    pub(super) fn new(steps: usize) -> Self {
        let bar = ProgressBar::new(u64::try_from(steps).unwrap_or(u64::MAX));
        if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {wide_msg}") {
            bar.set_style(style);
        }
        Self { bar }
    }

    /// A bar for a file of so many bytes, or a count of bytes if nobody knows how many there are.
    pub(super) fn of_bytes(length: Option<u64>) -> Self {
        let template = match length {
            Some(_) => "{bar:30} {bytes}/{total_bytes} {elapsed} {wide_msg}",
            None => "{bytes} {elapsed} {wide_msg}",
        };
        let bar = length.map_or_else(ProgressBar::no_length, ProgressBar::new);
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        Self { bar }
    }

    /// The step before is done; this one comes next.
    pub(super) fn step(&self, name: &str) {
        if !self.bar.message().is_empty() {
            self.bar.inc(1);
        }
        self.bar.set_message(name.to_owned());
    }

    /// So many steps are done, and this is what there is to say of them.
    pub(super) fn reach(&self, steps: u64, note: &str) {
        self.bar.set_position(steps);
        self.bar.set_message(note.to_owned());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
