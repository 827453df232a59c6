//! The clock at which cores are counted to run: assumed, given, or predicted by a target's delays. No
//! tool has placed and routed them, so nothing is proven about the clock that they reach.
use clap::Args;
use specula_experiments::tradeoff::FrameCycles;

/// `--clock`, for every command that states how fast a core is.
#[derive(Clone, Debug, Default, Args)]
pub struct ClockArguments {
    /// Clock in MHz for which times and frames per second are computed: assumed, not proven
    /// [default: 100]
    #[arg(long = "clock", value_name = "MHZ", allow_hyphen_values = true, value_parser = parse_clock)]
    mhz: Option<f64>,
}

impl ClockArguments {
    /// The clock that the user gives, or the assumed one.
    pub fn clock(&self) -> Clock {
        self.mhz.map_or(Clock::ASSUMED, Clock::given)
    }
}

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

fn parse_clock(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|mhz| (0.001..=100_000.0).contains(mhz));
    number.ok_or_else(|| "write a number of MHz from 0.001 to 100000".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clocks_are_read_or_refused() {
        assert_eq!(parse_clock("150"), Ok(150.0));
        for text in ["", "0", "-1", "fast", "inf", "NaN", "1e9", "100MHz"] {
            assert!(parse_clock(text).is_err(), "{text}");
        }
    }
}
