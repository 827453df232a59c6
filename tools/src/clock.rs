//! The clock at which cores are counted to run: assumed, given, or predicted by a target's delays. No
//! tool has placed and routed them, so nothing is proven about the clock that they reach.
use specula_experiments::tradeoff::FrameCycles;

/// A clock for which times are computed, without proof that a core reaches it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// The frequency in MHz.
    pub mhz: f64,
    /// Where it is from.
    pub source: ClockSource,
}

/// Where a clock is from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClockSource {
    /// Nowhere: a usual one.
    Assumed,
    /// The user.
    Given,
    /// The delays of the target that the core was made for.
    Predicted,
}

impl Clock {
    /// The clock that is assumed if none is given.
    pub const ASSUMED: Clock = Clock { mhz: 100.0, source: ClockSource::Assumed };

    /// A clock that the user gives.
    pub fn given(mhz: f64) -> Clock {
        Clock { mhz, source: ClockSource::Given }
    }

    /// The clock at which a core is counted to run: the one that is given for any device, else the
    /// one that its target's delays predict, else the assumed one.
    pub fn of(predicted: Option<f64>, given: Option<f64>) -> Clock {
        let predicted = predicted.map(Clock::predicted);
        given.map(Clock::given).or(predicted).unwrap_or(Clock::ASSUMED)
    }

    /// A clock that delays predict.
    pub fn predicted(mhz: f64) -> Clock {
        Clock { mhz, source: ClockSource::Predicted }
    }

    /// The clock as text.
    pub fn in_words(self) -> String {
        match self.source {
            ClockSource::Assumed => format!("an assumed {} MHz", self.mhz),
            ClockSource::Given => format!("a given {} MHz", self.mhz),
            ClockSource::Predicted => format!("a predicted {:.1} MHz", self.mhz),
        }
    }

    /// The duration of that many clocks, in nanoseconds.
    pub fn nanoseconds(self, clocks: f64) -> f64 {
        1000.0 * clocks / self.mhz
    }

    /// Frames per second, including set-up.
    pub fn frames_per_second(self, cycles: &FrameCycles) -> f64 {
        1e9 / self.nanoseconds(cycles.with_set_up as f64)
    }
}
