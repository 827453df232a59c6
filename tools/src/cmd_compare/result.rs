//! What came of a comparison, as tables, plots and reports see it.
use specula_experiments::benchmark::Machine;
use specula_experiments::pareto_front;
use specula_experiments::tradeoff::software::Software;
use specula_experiments::tradeoff::{Configuration, Measured, Measurement, Row, counterpart};
use specula_testbench::ErrorFigures;

use crate::clock::Clock;
use crate::plot::Place;

/// A comparison that was made.
pub struct Compared {
    /// The scene's name.
    pub scene: String,
    /// Width and height of the picture.
    pub size: (u32, u32),
    /// What cores are clocked with.
    pub clock: Clock,
    /// The cores that were measured.
    pub cores: Vec<Core>,
    /// Why there are no others: configurations with their reasons.
    pub refusals: Vec<String>,
    /// The papers' loops; none where they cannot shade the scene.
    pub software: Vec<Software>,
    /// What interpolation itself is off from surfaces that are known; none where none is.
    pub interpolation: Option<ErrorFigures>,
    /// Where the loops ran.
    pub machine: Machine,
}

/// A core that was measured.
pub struct Core {
    /// Its configuration.
    pub configuration: Configuration,
    /// Its spec and figures.
    pub measurement: Measurement,
    clock: Clock,
}

/// Cores that were measured, and configurations without one, with their reasons.
pub fn sorted(rows: Vec<Row>, clock: Clock) -> (Vec<Core>, Vec<String>) {
    let (mut cores, mut refusals) = (vec![], vec![]);
    for Row { configuration, result } in rows {
        match result {
            Ok(measurement) => cores.push(Core { configuration, measurement, clock }),
            Err(reason) => refusals.push(format!("{configuration}: {reason}")),
        }
    }
    (cores, refusals)
}

impl Core {
    /// Its figures.
    pub fn measured(&self) -> &Measured {
        &self.measurement.measured
    }

    /// Nanoseconds for each pixel, set-up counted.
    pub fn pixel_ns(&self) -> f64 {
        self.clock.nanoseconds(self.measured().cycles.per_pixel_with_set_up())
    }

    /// Frames in a second, set-up counted.
    pub fn frames_per_second(&self) -> f64 {
        self.clock.frames_per_second(&self.measured().cycles)
    }

    /// Root of the mean square of its total error, in LSBs.
    pub fn error(&self) -> f64 {
        self.measured().errors.total.rms_lsb
    }
}

impl Compared {
    /// Whether every core agrees with its model.
    pub fn agrees(&self) -> bool {
        self.cores.iter().all(|core| core.measured().agrees)
    }

    /// The loop that does in software what a core does.
    pub fn software_of(&self, core: &Core) -> Option<&Software> {
        let name = counterpart(&core.measurement.spec)?;
        self.software.iter().find(|software| software.name == name)
    }

    /// For each core whether no other one has as little error in as little of something.
    pub fn on_front(&self, cost: impl Fn(&Core) -> f64) -> Vec<bool> {
        let places: Vec<Place> = self.cores.iter().map(|core| (cost(core), core.error())).collect();
        let front = pareto_front(&places);
        (0..places.len()).map(|number| front.contains(&number)).collect()
    }
}

/// Full adders of a core's arithmetic, as a number to be compared.
pub fn size(core: &Core) -> f64 {
    core.measured().full_adders() as f64
}
