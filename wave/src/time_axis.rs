//! The unit in which time is counted: clocks where there is a clock, else the file's units.
use std::ops::RangeInclusive;

use super::dump::Dump;
use super::variables::{Scopes, Variable};

/// The unit in which time is counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TimeAxis {
    /// Clocks: number c begins with the rising edge at `phase` + c `period`, and what stands before
    /// clock 0 is not shown.
    Clocks {
        /// The time of the edge that begins clock 0.
        phase: u64,
        /// The time from an edge to the next.
        period: u64,
    },
    /// The file's units of time.
    Time,
}

/// Names of a clock.
const CLOCKS: [&str; 2] = ["clock", "clk"];

/// Whether a signal of one bit with that name may be a clock.
pub fn is_clock(name: &str) -> bool {
    CLOCKS.iter().any(|clock| name.eq_ignore_ascii_case(clock))
}

/// The outermost variable that may be a clock, by its number.
pub fn clock(variables: &[Variable], scopes: &Scopes) -> Option<usize> {
    let numbered = variables.iter().enumerate();
    let clocks =
        numbered.filter(|(_, variable)| variable.width == Some(1) && is_clock(&variable.name));
    clocks.min_by_key(|(_, variable)| scopes.depth(variable.scope)).map(|(index, _)| index)
}

impl TimeAxis {
    /// The time axis of a dump: the outermost signal named `clock` or `clk` gives it, if it rises
    /// at a constant pace.
    pub fn of(dump: &Dump) -> TimeAxis {
        let clock =
            clock(dump.variables(), dump.scopes()).map(|clock| dump.variables()[clock].signal);
        let pace = clock.and_then(|clock| dump.survey().pace(clock));
        pace.map_or(TimeAxis::Time, |(first, period)| TimeAxis::Clocks {
            phase: first % period,
            period,
        })
    }

    /// The unit that it counts in.
    pub fn unit(&self, dump: &Dump) -> String {
        match self {
            TimeAxis::Clocks { .. } => "clocks".to_owned(),
            TimeAxis::Time => dump.time_unit(),
        }
    }

    /// A window in words.
    pub fn described(&self, window: &RangeInclusive<u64>, dump: &Dump) -> String {
        let (first, last) = (window.start(), window.end());
        match self {
            TimeAxis::Clocks { .. } => format!("clocks {first} to {last}"),
            TimeAxis::Time => format!("{first} to {last}, in {}", dump.time_unit()),
        }
    }

    /// The clock in which `time` lies, or the time itself.
    pub fn at(&self, time: u64) -> u64 {
        match self {
            TimeAxis::Clocks { phase, period } => time.saturating_sub(*phase) / period,
            TimeAxis::Time => time,
        }
    }

    /// When a clock begins, or the time itself.
    pub fn time(&self, number: u64) -> u64 {
        match self {
            TimeAxis::Clocks { phase, period } => {
                number.saturating_mul(*period).saturating_add(*phase)
            }
            TimeAxis::Time => number,
        }
    }

    /// What the dump covers, the last included: a clock that has begun counts, and one that begins
    /// with the last instant if something changes at it.
    pub fn extent(&self, dump: &Dump) -> RangeInclusive<u64> {
        let extent = dump.extent();
        match self {
            TimeAxis::Clocks { .. } => {
                let behind = u64::from(!dump.survey().changes_at_last());
                self.at(*extent.start())..=self.at(extent.end().saturating_sub(behind))
            }
            TimeAxis::Time => extent,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_times_belong_together() {
        let time_axis = TimeAxis::Clocks { phase: 5, period: 10 };
        assert_eq!(
            (time_axis.time(3), time_axis.at(35), time_axis.at(44), time_axis.at(0)),
            (35, 3, 3, 0)
        );
        assert_eq!(time_axis.time(u64::MAX), u64::MAX);
    }
}
