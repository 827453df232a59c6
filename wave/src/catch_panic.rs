//! Calls into a reader that panics on damaged input.
//!
//! fst-reader 0.17 reports wrong headers as errors, but panics where values contradict what was
//! said of them: the tests have dumps that make it.
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, PoisonError};

/// Held while the hook is changed, which is the whole process's.
static HOOK: Mutex<()> = Mutex::new(());

/// Does `work`, and gives an error if it panics. The panic's message is discarded: only the
/// reader's authors could use it.
///
/// # Errors
/// `()` if `work` panics.
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, ()> {
    // Nothing is kept in the mutex that a panic could spoil.
    let _held = HOOK.lock().unwrap_or_else(PoisonError::into_inner);
    // The hook is silent for as long as the work takes, since the caller reports the error.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    // Whatever the work leaves half done is dropped by the caller, who gets no value.
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    done.map_err(drop)
}
