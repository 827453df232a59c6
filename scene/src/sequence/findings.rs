//! What has been found out about a sequence, so that its frames need not be made for it again.
use std::any::Any;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What others have found out about a sequence, of any type. It is a memory: whoever finds nothing in
/// it looks at the frames.
#[derive(Default)]
pub struct Findings(Mutex<Vec<Arc<dyn Any + Send + Sync>>>);

impl Findings {
    /// The first finding of a type that is the one that is looked for.
    pub fn find<T: Any + Send + Sync>(&self, is_it: impl Fn(&T) -> bool) -> Option<Arc<T>> {
        let of_type = |finding: &Arc<dyn Any + Send + Sync>| Arc::clone(finding).downcast().ok();
        self.lock().iter().filter_map(of_type).find(|finding| is_it(finding))
    }

    /// Adds a finding.
    pub fn add<T: Any + Send + Sync>(&self, finding: T) {
        self.lock().push(Arc::new(finding));
    }

    /// Locks the findings; a thread that panicked has left whole ones.
    fn lock(&self) -> MutexGuard<'_, Vec<Arc<dyn Any + Send + Sync>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl fmt::Debug for Findings {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "Findings({})", self.lock().len())
    }
}
