//! The unit in which time is counted: clocks where there is a clock, and else the file's units.
use std::ops::RangeInclusive;

use super::clock;
use super::dump::Dump;

/// The unit in which time is counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TimeAxis {
    /// Clocks: clock c begins with the rising edge at `phase` + c · `period`. What precedes clock 0
    /// is not shown.
    Clocks {
        /// The time of the edge that begins clock 0.
        phase: u64,
        /// The time from one edge to the next.
        period: u64,
    },
    /// The file's units of time.
    Time,
}

impl TimeAxis {
    /// The time axis of a dump: the outermost signal named `clock` or `clk` defines it, if all of
    /// its periods are equal.
    pub fn of_dump(dump: &Dump) -> TimeAxis {
        let clock = clock::outermost(dump.variables(), dump.scopes())
            .map(|clock| dump.variables()[clock].signal);
        let pace = clock.and_then(|clock| dump.survey().clock_pace(clock));
        pace.map_or(TimeAxis::Time, |(first, period)| TimeAxis::Clocks {
            phase: first % period,
            period,
        })
    }

    /// The name of the axis's unit.
    pub fn unit(&self, dump: &Dump) -> String {
        match self {
            TimeAxis::Clocks { .. } => "clocks".to_owned(),
            TimeAxis::Time => dump.time_unit(),
        }
    }

    /// A window as text.
    pub fn described(&self, window: &RangeInclusive<u64>, dump: &Dump) -> String {
        let (first, last) = (window.start(), window.end());
        match self {
            TimeAxis::Clocks { .. } => format!("clocks {first} to {last}"),
            TimeAxis::Time => format!("{first} to {last}, in {}", dump.time_unit()),
        }
    }

    /// The number of the clock in which `time` lies, or the time itself.
    pub fn number(&self, time: u64) -> u64 {
        match self {
            TimeAxis::Clocks { phase, period } => time.saturating_sub(*phase) / period,
            TimeAxis::Time => time,
        }
    }

    /// The time at which a clock begins, or the number itself.
    pub fn time(&self, number: u64) -> u64 {
        match self {
            TimeAxis::Clocks { phase, period } => {
                number.saturating_mul(*period).saturating_add(*phase)
            }
            TimeAxis::Time => number,
        }
    }

    /// The numbers that the dump covers, the last included. A clock that has begun counts; one that
    /// begins with the last instant counts if something changes there.
    pub fn numbers(&self, dump: &Dump) -> RangeInclusive<u64> {
        let extent = dump.time_range();
        match self {
            TimeAxis::Clocks { .. } => {
                let behind = u64::from(!dump.survey().changes_at_last());
                self.number(*extent.start())..=self.number(extent.end().saturating_sub(behind))
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
            (time_axis.time(3), time_axis.number(35), time_axis.number(44), time_axis.number(0)),
            (35, 3, 3, 0)
        );
        assert_eq!(time_axis.time(u64::MAX), u64::MAX);
    }
}
