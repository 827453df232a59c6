//! Calls into a reader that panics on damaged input.
//!
//! wellen 0.25 reports wrong headers as errors, but panics on wrong values, such as a `2` in a vector: the tests have dumps that make it.
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, PoisonError};

/// Held by who has changed the hook, which is the whole process's.
static HOOK: Mutex<()> = Mutex::new(());

/// Does `work`; if it panics, gives what the panic said.
pub fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    // Nothing is kept in the mutex that a panic could spoil.
    let _held = HOOK.lock().unwrap_or_else(PoisonError::into_inner);
    // Silent for as long as the work takes, since the user is told in other words.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    // Whatever the work leaves half done is dropped by the caller, who gets no value.
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    done.map_err(|payload| {
        let said = payload.downcast_ref::<String>().cloned();
        said.or_else(|| payload.downcast_ref::<&str>().map(|text| (*text).to_owned())).unwrap_or_default()
    })
}
