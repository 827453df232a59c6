//! Whether the components of vectors share hardware.
use serde::{Deserialize, Serialize};

/// How the X, Y and Z of vectors are multiplied [Lyon, TR 43, fig. 7: "parallelism versus
/// serialization"].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Components {
    /// Each by a multiplier of its own: a pixel enters with every clock.
    #[default]
    Parallel,
    /// One after another by one multiplier: a pixel takes three clocks.
    Serial,
}

impl Components {
    /// Whether there is nothing to say of it.
    pub(crate) fn is_parallel(&self) -> bool {
        *self == Components::Parallel
    }
}
