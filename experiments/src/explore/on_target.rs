//! What a core is on the target that it is made for.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::resources::Resources;
use specula_datapath::target::Target;
use specula_datapath::timing::Timing;
use specula_spec::{CoreSpec, TargetClock};
use specula_testbench::BenchError;

/// The target and the clock that cores are to be made for.
#[derive(Clone, Debug)]
pub struct WantedClock {
    /// The target; its delays are known.
    pub target: Target,
    /// The clock in MHz; without, each core has its highest.
    pub mhz: Option<f64>,
}

/// A core on its target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct OnTarget {
    /// The cells that it takes.
    pub resources: Resources,
    /// All cells as one number: look-up tables, flip-flops, and for each multiplier block what the
    /// device has of look-up tables for each.
    pub cells: u64,
    /// The clock that the target's delays predict, in MHz.
    pub predicted_mhz: f64,
}

impl WantedClock {
    /// A core for this target, at its highest clock if none is asked for.
    ///
    /// # Errors
    /// [`BenchError`] if the core cannot be built.
    pub fn made(&self, spec: &CoreSpec) -> Result<CoreSpec, BenchError> {
        let mhz = match self.mhz {
            Some(mhz) => mhz,
            None => self.highest_clock(spec)?,
        };
        Ok(self.at(spec, mhz))
    }

    /// The highest clock of a core on this target, in MHz.
    ///
    /// # Errors
    /// As [`WantedClock::made`].
    pub fn highest_clock(&self, spec: &CoreSpec) -> Result<f64, BenchError> {
        Ok(specula_hdl::highest_clock(&self.at(spec, 1.0))?)
    }

    /// A core for this target, at a clock.
    fn at(&self, spec: &CoreSpec, clock_mhz: f64) -> CoreSpec {
        let target = TargetClock { name: self.target.name.clone(), clock_mhz };
        CoreSpec { target: Some(target), ..spec.clone() }
    }

    /// What a design that is made for the target is on it.
    pub fn of(&self, design: &Design) -> Option<OnTarget> {
        Some(self.with_clock(design, Timing::of(design, &self.target)?.mhz()))
    }

    /// What a design for any device is likely to be on the target, where its highest clock is known.
    pub fn estimated(&self, design: &Design, highest_mhz: f64) -> OnTarget {
        self.with_clock(design, self.mhz.map_or(highest_mhz, |mhz| mhz.min(highest_mhz)))
    }

    fn with_clock(&self, design: &Design, predicted_mhz: f64) -> OnTarget {
        let resources = Resources::of(design, &self.target);
        let worth = self.target.multiplier.as_ref().map_or(0, |block| u64::from(block.worth));
        let cells = resources.luts + resources.flip_flops + worth * resources.blocks;
        OnTarget { resources, cells, predicted_mhz }
    }

    /// Whether a core reaches the clock that is asked for.
    pub fn is_met(&self, core: &OnTarget) -> bool {
        // The clock that is asked for is met by the model but for rounding.
        self.mhz.is_none_or(|mhz| core.predicted_mhz >= mhz * (1.0 - 1e-9))
    }
}
