//! The clock that a core is made for.
use serde::{Deserialize, Serialize};
use specula_datapath::target::Target;

use crate::error::{SpecError, within};

/// A clock on a target, for which a core's operators are put into stages.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TargetClock {
    /// The name of a target whose delays are known.
    pub name: String,
    /// The clock in MHz, 1 to 1000.
    pub clock_mhz: f64,
}

impl TargetClock {
    /// The target.
    ///
    /// # Errors
    /// [`SpecError::UnknownTarget`] where no target with known delays has the name.
    pub fn target(&self) -> Result<Target, SpecError> {
        let target = Target::named(&self.name).filter(|target| target.fabric.is_some());
        target.ok_or_else(|| {
            let known: Vec<&str> = Target::clocked().collect();
            SpecError::UnknownTarget { name: self.name.clone(), known: known.join(", ") }
        })
    }

    pub(crate) fn check(&self) -> Result<(), SpecError> {
        self.target()?;
        within("clock_mhz", self.clock_mhz, 1.0, 1000.0)
    }
}
