//! The target and the clock that a core was made for, and the clock that the target's delays predict
//! for it.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::target::Target;
use specula_datapath::timing::Timing;
use specula_spec::{CoreSpec, TargetClock};

/// A core's target, and what its delays say of the core.
pub struct MadeFor {
    /// The target.
    pub target: Target,
    /// The clock that was asked for.
    pub clock: TargetClock,
    /// Paths between registers.
    pub timing: Timing,
}

/// The same in a report.
#[derive(Clone, Debug, Serialize)]
pub struct Prediction {
    target: String,
    part: String,
    asked_mhz: f64,
    predicted_mhz: f64,
}

impl MadeFor {
    /// That of a core; none if it is for any device.
    pub fn of(spec: &CoreSpec, design: &Design) -> Option<MadeFor> {
        let clock = spec.target.clone()?;
        let target = clock.target().ok()?;
        let timing = Timing::of(design, &target)?;
        Some(MadeFor { target, clock, timing })
    }

    /// Nanoseconds from clock to clock that were asked for.
    pub fn period(&self) -> f64 {
        1000.0 / self.clock.clock_mhz
    }

    /// The target and its device.
    pub fn device(&self) -> String {
        format!("{} ({})", self.target.name, self.target.part)
    }

    /// What was asked for and what is predicted, for people to read.
    pub fn in_words(&self) -> String {
        format!(
            "{} at {} MHz; its delays predict {:.1} MHz",
            self.device(),
            self.clock.clock_mhz,
            self.timing.mhz()
        )
    }

    /// The same for programs to read.
    pub fn prediction(&self) -> Prediction {
        Prediction {
            target: self.target.name.clone(),
            part: self.target.part.clone(),
            asked_mhz: self.clock.clock_mhz,
            predicted_mhz: self.timing.mhz(),
        }
    }
}
