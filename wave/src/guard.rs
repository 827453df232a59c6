//! Calls into a reader that panics on damaged input.
//!
//! fst-reader 0.17 reports wrong headers as errors, but panics where values contradict what was
//! said of them: the tests have dumps that make it.
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, PoisonError};

/// Held by who has changed the hook, which is the whole process's.
static HOOK: Mutex<()> = Mutex::new(());

/// Does `work`; what a panic said is of no use to anybody but the reader's authors.
pub fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, ()> {
    // Nothing is kept in the mutex that a panic could spoil.
    let _held = HOOK.lock().unwrap_or_else(PoisonError::into_inner);
    // Silent for as long as the work takes, since the user is told in other words.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    // Whatever the work leaves half done is dropped by the caller, who gets no value.
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    done.map_err(drop)
}
