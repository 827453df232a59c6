//! The clock that a core is made for.
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use specula_datapath::target::Target;

use crate::error::{SpecError, within};

/// A clock on a target, for which a core's operators are put into stages.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TargetClock {
    /// The name of a target whose delays are known.
    #[serde(deserialize_with = "known_name")]
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

/// The name of a target with known delays; an error where it is read says which there are.
fn known_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let name = String::deserialize(deserializer)?;
    let clock = TargetClock { name, clock_mhz: 1.0 };
    match clock.target() {
        Ok(_) => Ok(clock.name),
        Err(error) => Err(D::Error::custom(format!("{error}: {}", error.help_text()))),
    }
}
