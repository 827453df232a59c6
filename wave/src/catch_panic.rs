//! Calls into a reader that panics on damaged input.
//!
//! fst-reader 0.17 reports wrong headers as errors, but panics where values contradict their
//! declarations: the tests have dumps that make it panic.
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, PoisonError};

/// Locked while the panic hook, of which a process has one, is changed.
static HOOK: Mutex<()> = Mutex::new(());

/// Calls `work` and gives an error if it panics. The panic's message is discarded: it would mean
/// nothing to a user.
///
/// # Errors
/// `()` if `work` panics.
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, ()> {
    // The mutex guards no data that a panic could leave half changed.
    let _held = HOOK.lock().unwrap_or_else(PoisonError::into_inner);
    // The hook is silent during the work, since the caller reports the error.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    // What the work leaves half done is dropped by the caller, who gets no value.
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    done.map_err(drop)
}
