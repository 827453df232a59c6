//! The result of a comparison, from which tables, plots and reports are made.
use specula_experiments::benchmark::Machine;
use specula_experiments::pareto_front;
use specula_experiments::tradeoff::software::Software;
use specula_experiments::tradeoff::{
    Configuration, Measured, Measurement, SweepResult, software_equivalent,
};
use specula_testbench::ErrorFigures;

use crate::clock::Clock;
use crate::error::OtherTarget;
use crate::plot::PlotPoint;
use crate::target_arguments::TargetArguments;

/// The result of a comparison.
pub struct Compared {
    /// The scene's name.
    pub scene: String,
    /// Width and height of the picture.
    pub size: (u32, u32),
    /// The clocks at which the cores are counted to run.
    pub clocks: Clocks,
    /// The cores that were measured.
    pub cores: Vec<Core>,
    /// The configurations that have no core, each with the reason.
    pub refusals: Vec<String>,
    /// The papers' loops; empty if they cannot shade the scene.
    pub software: Vec<Software>,
    /// The error of interpolation itself against surfaces that are known; `None` if none is.
    pub interpolation: Option<ErrorFigures>,
    /// The machine on which the loops ran.
    pub machine: Machine,
}

/// A core that was measured.
pub struct Core {
    /// Its configuration.
    pub configuration: Configuration,
    /// Its spec and figures.
    pub measurement: Measurement,
    /// The clock at which it is counted to run.
    pub clock: Clock,
}

/// The clocks at which cores are counted to run.
pub enum Clocks {
    /// One for all of them.
    All(Clock),
    /// Each has the one that the delays of this target predict for it.
    Predicted(String),
}

impl Clocks {
    /// Those of cores that are made for what is asked for.
    ///
    /// # Errors
    /// [`OtherTarget`] where target and device do not belong together.
    pub fn of(made_for: &TargetArguments) -> Result<Clocks, OtherTarget> {
        let all = || Clocks::All(Clock::of(None, made_for.given_for_any_device()));
        Ok(made_for.wanted()?.map_or_else(all, |wanted| Clocks::Predicted(wanted.target.name)))
    }

    /// The clocks as text.
    pub fn in_words(&self) -> String {
        match self {
            Clocks::All(clock) => clock.in_words(),
            Clocks::Predicted(target) => {
                format!("the clock that the delays of {target} predict for each core")
            }
        }
    }

    /// The clock of all of them, if it is one.
    pub fn of_all(&self) -> Option<Clock> {
        match self {
            Clocks::All(clock) => Some(*clock),
            Clocks::Predicted(_) => None,
        }
    }
}

/// Separates the cores that were measured from configurations without a core, whose reasons are
/// given as text. `given` is a clock in MHz for cores that are made for no target.
pub fn sorted(rows: Vec<SweepResult>, given: Option<f64>) -> (Vec<Core>, Vec<String>) {
    let (mut cores, mut refusals) = (vec![], vec![]);
    for SweepResult { configuration, result } in rows {
        match result {
            Ok(measurement) => {
                let clock = Clock::of(measurement.measured.predicted_mhz, given);
                cores.push(Core { configuration, measurement, clock });
            }
            Err(reason) => refusals.push(format!("{configuration}: {reason}")),
        }
    }
    (cores, refusals)
}

impl Core {
    /// Its measured figures.
    pub fn measured(&self) -> &Measured {
        &self.measurement.measured
    }

    /// Nanoseconds for each pixel, including set-up.
    pub fn pixel_ns(&self) -> f64 {
        self.clock.nanoseconds(self.measured().cycles.per_pixel_with_set_up())
    }

    /// Frames per second, including set-up.
    pub fn frames_per_second(&self) -> f64 {
        self.clock.frames_per_second(&self.measured().cycles)
    }

    /// Root mean square of its total error, in LSBs.
    pub fn error(&self) -> f64 {
        self.measured().errors.total.rms_lsb
    }
}

impl Compared {
    /// Whether every core agrees with its model.
    pub fn agrees(&self) -> bool {
        self.cores.iter().all(|core| core.measured().agrees)
    }

    /// The software loop that computes the same as a core.
    pub fn software_of(&self, core: &Core) -> Option<&Software> {
        let name = software_equivalent(&core.measurement.spec)?;
        self.software.iter().find(|software| software.name == name)
    }

    /// For each core, whether no other core has both a smaller error and a smaller cost.
    pub fn on_front(&self, cost: impl Fn(&Core) -> f64) -> Vec<bool> {
        let places: Vec<PlotPoint> =
            self.cores.iter().map(|core| (cost(core), core.error())).collect();
        let front = pareto_front(&places);
        (0..places.len()).map(|number| front.contains(&number)).collect()
    }
}

/// The full adders of a core's arithmetic, as a floating-point number.
pub fn size(core: &Core) -> f64 {
    core.measured().full_adders() as f64
}
