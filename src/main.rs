//! The program `knotproof`; everything it does is in the library.

use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Had the process no standard output when it began?
static STDOUT_CLOSED: AtomicBool = AtomicBool::new(false);

#[cfg(unix)]
ctor::declarative::ctor! {
    /// Before `main`: there the standard library has already put `/dev/null` in the place of what was closed.
    #[ctor(unsafe)]
    fn look_at_stdout() {
        let closed = rustix::io::fcntl_getfd(std::io::stdout()) == Err(rustix::io::Errno::BADF);
        STDOUT_CLOSED.store(closed, Ordering::Relaxed);
    }
}

fn main() -> ExitCode {
    knotproof::cli::main(STDOUT_CLOSED.load(Ordering::Relaxed))
}
