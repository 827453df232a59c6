//! What time is counted in: clocks where there is a clock, else the file's units.
use std::ops::RangeInclusive;

use super::dump::Dump;
use super::error::WaveError;
use super::value::Value;

/// What time is counted in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ruler {
    /// Clocks: number c begins with the rising edge at `phase` + c `period`, and what stands before clock 0 is not shown.
    Clocks {
        /// The time of the edge that begins clock 0.
        phase: u64,
        /// From an edge to the next.
        period: u64,
    },
    /// The file's units of time.
    Time,
}

/// Names of a clock.
const CLOCKS: [&str; 2] = ["clock", "clk"];

impl Ruler {
    /// The ruler of a dump: the outermost signal named `clock` or `clk` gives it, if it rises at a constant pace.
    ///
    /// # Errors
    /// [`WaveError::Damaged`] if that signal cannot be read.
    pub fn of(dump: &mut Dump) -> Result<Ruler, WaveError> {
        let named = |name: &str| CLOCKS.iter().any(|clock| name.eq_ignore_ascii_case(clock));
        let variables = dump.variables.iter().enumerate();
        let clocks = variables.filter(|(_, variable)| variable.width == Some(1) && named(&variable.name));
        let Some((index, _)) = clocks.min_by_key(|(_, variable)| variable.scopes.len()) else { return Ok(Ruler::Time) };
        dump.load(&[index])?;
        let all = 0..u64::MAX;
        let segments = dump.segments(index, &all)?;
        let rises = segments.iter().filter(|segment| segment.value == Value::Bits("1".to_owned()));
        Ok(constant_pace(&rises.map(|segment| segment.time.start).collect::<Vec<_>>()).unwrap_or(Ruler::Time))
    }

    /// What it counts.
    pub fn unit(&self, dump: &Dump) -> String {
        match self {
            Ruler::Clocks { .. } => "clocks".to_owned(),
            Ruler::Time => dump.time_unit(),
        }
    }

    /// A window in words.
    pub fn described(&self, window: &RangeInclusive<u64>, dump: &Dump) -> String {
        let (first, last) = (window.start(), window.end());
        match self {
            Ruler::Clocks { .. } => format!("clocks {first} to {last}"),
            Ruler::Time => format!("{first} to {last}, in {}", dump.time_unit()),
        }
    }

    /// The clock in which `time` lies, or the time itself.
    pub fn at(&self, time: u64) -> u64 {
        match self {
            Ruler::Clocks { phase, period } => time.saturating_sub(*phase) / period,
            Ruler::Time => time,
        }
    }

    /// When a clock begins, or the time itself.
    pub fn time(&self, number: u64) -> u64 {
        match self {
            Ruler::Clocks { phase, period } => number.saturating_mul(*period).saturating_add(*phase),
            Ruler::Time => number,
        }
    }

    /// What the dump covers, the last included: a clock that has begun counts.
    pub fn extent(&self, dump: &Dump) -> RangeInclusive<u64> {
        let extent = dump.extent();
        match self {
            Ruler::Clocks { .. } => self.at(extent.start)..=self.at(extent.end.saturating_sub(1)),
            Ruler::Time => extent.start..=extent.end,
        }
    }
}

/// The ruler of a clock that rises at these times, if they are evenly spaced.
fn constant_pace(rises: &[u64]) -> Option<Ruler> {
    let period = rises.get(1)? - rises[0];
    let constant = rises.windows(2).all(|pair| pair[1] - pair[0] == period);
    constant.then(|| Ruler::Clocks { phase: rises[0] % period, period })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_needs_a_constant_pace() {
        assert_eq!(constant_pace(&[25, 35, 45]), Some(Ruler::Clocks { phase: 5, period: 10 }));
        assert_eq!(constant_pace(&[0, 10, 21]), None);
        assert_eq!(constant_pace(&[7]), None);
        assert_eq!(constant_pace(&[]), None);
    }

    #[test]
    fn numbers_and_times_belong_together() {
        let ruler = Ruler::Clocks { phase: 5, period: 10 };
        assert_eq!((ruler.time(3), ruler.at(35), ruler.at(44), ruler.at(0)), (35, 3, 3, 0));
        assert_eq!(ruler.time(u64::MAX), u64::MAX);
    }
}
