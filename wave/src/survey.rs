//! The result of a first pass over a dump: the times at which something happens, and the clock's
//! period.
use std::collections::{BTreeMap, VecDeque};
use std::ops::RangeInclusive;

/// The latest time that is used: what lasts one unit from there still ends within a u64.
pub const LATEST: u64 = u64::MAX - 1;

/// Number of instants that are kept at the beginning, and on either side of the marker.
const KEPT: usize = 4096;

/// The times at which something happens in a dump, as far as they are kept.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    marker: Option<u64>,
    first: Option<u64>,
    last: u64,
    changes: bool,
    changes_at_last: bool,
    begin: Vec<u64>,
    before_marker: VecDeque<u64>,
    behind_marker: Vec<u64>,
    clocks: BTreeMap<u32, Pace>,
}

impl Survey {
    /// Begins a survey that keeps the instants around a marked time.
    pub fn new(marker: Option<u64>) -> Survey {
        Survey { marker, ..Survey::default() }
    }

    /// Watches a signal that may be a clock.
    pub fn watch(&mut self, signal: u32) {
        self.clocks.entry(signal).or_default();
    }

    /// Records an instant. Instants come in order; the same one may come more than once.
    pub fn instant(&mut self, time: u64) {
        if self.first.is_some() && time <= self.last {
            return;
        }
        // Changes that came before the first instant happen at it.
        self.changes_at_last &= self.first.is_none();
        self.first.get_or_insert(time);
        self.last = time;
        if self.begin.len() < KEPT {
            self.begin.push(time);
        }
        match self.marker {
            Some(marker) if time < marker => {
                self.before_marker.push_back(time);
                if self.before_marker.len() > KEPT {
                    self.before_marker.pop_front();
                }
            }
            Some(_) if self.behind_marker.len() < KEPT => self.behind_marker.push(time),
            _ => {}
        }
    }

    /// Records that a signal changes at the last instant that came.
    pub fn change(&mut self) {
        (self.changes, self.changes_at_last) = (true, true);
    }

    /// Records the level of a watched signal; other signals are ignored. Times of a signal come in
    /// order.
    pub fn level(&mut self, signal: u32, time: u64, high: bool) {
        if let Some(pace) = self.clocks.get_mut(&signal) {
            pace.level(time, high);
        }
    }

    /// Whether there is no instant and no value.
    pub fn is_empty(&self) -> bool {
        self.first.is_none() && !self.changes
    }

    /// The range from the first instant to the last.
    pub fn time_range(&self) -> RangeInclusive<u64> {
        self.first.unwrap_or(0)..=self.last
    }

    /// Whether something changes at the last instant, or there is only one instant.
    pub fn changes_at_last(&self) -> bool {
        self.changes_at_last || self.first.is_none_or(|first| first == self.last)
    }

    /// The marked time, if the dump covers it.
    pub fn marker(&self) -> Option<u64> {
        self.marker.filter(|marker| self.time_range().contains(marker))
    }

    /// The range of `count` instants around the marker, or at the beginning.
    pub fn default_range(&self, count: u64) -> RangeInclusive<u64> {
        let around: Vec<u64> = match self.marker() {
            Some(_) => self.before_marker.iter().chain(&self.behind_marker).copied().collect(),
            None => self.begin.clone(),
        };
        let Some(last) = around.len().checked_sub(1) else { return self.time_range() };
        let middle = self.marker().map(|_| self.before_marker.len() as u64);
        let shown = around_middle(&(0..=last as u64), middle, count);
        around[*shown.start() as usize]..=around[*shown.end() as usize]
    }

    /// The first rising edge and the period of a watched signal, if all of its periods are equal.
    pub fn clock_pace(&self, signal: u32) -> Option<(u64, u64)> {
        self.clocks.get(&signal)?.clone().finished()
    }
}

/// A range of `length` numbers within `extent`, around `middle` or else from the beginning.
pub fn around_middle(
    extent: &RangeInclusive<u64>,
    middle: Option<u64>,
    length: u64,
) -> RangeInclusive<u64> {
    let (first, last) = (*extent.start(), *extent.end());
    let latest = last.saturating_sub(length.max(1) - 1).max(first);
    let begin =
        middle.map_or(first, |middle| middle.saturating_sub(length / 2)).clamp(first, latest);
    begin..=begin.saturating_add(length.max(1) - 1).min(last)
}

/// The rising edges of a signal.
#[derive(Clone, Debug, Default)]
struct Pace {
    /// The level at the latest instant; it counts once that instant is over.
    latest: Option<(u64, bool)>,
    high: bool,
    first: Option<u64>,
    last: u64,
    period: Option<u64>,
    uneven: bool,
}

impl Pace {
    fn level(&mut self, time: u64, high: bool) {
        if self.latest.is_some_and(|(latest, _)| latest < time) {
            self.settle();
        }
        self.latest = Some((time, high));
    }

    fn settle(&mut self) {
        let Some((time, high)) = self.latest else { return };
        if high && !self.high {
            self.rise(time);
        }
        self.high = high;
    }

    fn rise(&mut self, time: u64) {
        if self.first.is_some() {
            let period = time.saturating_sub(self.last);
            self.uneven |= *self.period.get_or_insert(period) != period;
        }
        self.first.get_or_insert(time);
        self.last = time;
    }

    fn finished(mut self) -> Option<(u64, u64)> {
        self.settle();
        let even = self.first.zip(self.period);
        even.filter(|&(_, period)| !self.uneven && period > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clock(levels: &[(u64, bool)]) -> Option<(u64, u64)> {
        let mut survey = Survey::new(None);
        survey.watch(7);
        for &(time, high) in levels {
            survey.instant(time);
            survey.level(7, time, high);
        }
        survey.clock_pace(7)
    }

    #[test]
    fn a_clock_needs_a_constant_pace() {
        let rises = |times: &[u64]| -> Vec<(u64, bool)> {
            times.iter().flat_map(|&time| [(time, true), (time + 1, false)]).collect()
        };
        assert_eq!(clock(&rises(&[25, 35, 45])), Some((25, 10)));
        assert_eq!(clock(&rises(&[0, 10, 21])), None);
        assert_eq!(clock(&rises(&[7])), None);
        assert_eq!(clock(&[]), None);
    }

    #[test]
    fn what_a_clock_does_within_an_instant_does_not_count() {
        assert_eq!(
            clock(&[(0, true), (5, false), (5, true), (5, false), (10, true), (20, true)]),
            Some((0, 10))
        );
    }

    #[test]
    fn a_window_lies_around_its_middle_and_within_the_file() {
        assert_eq!(around_middle(&(0..=99), Some(50), 10), 45..=54);
        assert_eq!(around_middle(&(0..=99), Some(98), 10), 90..=99);
        assert_eq!(around_middle(&(0..=99), None, 10), 0..=9);
        assert_eq!(around_middle(&(40..=45), Some(43), 10), 40..=45);
        assert_eq!(around_middle(&(40..=45), Some(43), 0), 43..=43);
    }

    #[test]
    fn instants_around_the_marker_are_kept_of_a_long_file() {
        let surveyed = |marker| {
            let mut survey = Survey::new(marker);
            (0..100_000).for_each(|number| survey.instant(10 * number));
            survey.default_range(10)
        };
        assert_eq!(surveyed(None), 0..=90);
        assert_eq!(surveyed(Some(500_000)), 499_950..=500_040);
        assert_eq!(surveyed(Some(999_990)), 999_900..=999_990);
        assert_eq!(surveyed(Some(2_000_000)), 0..=90);
    }

    #[test]
    fn the_last_instant_counts_if_something_changes_at_it() {
        let mut survey = Survey::new(None);
        survey.change();
        assert!(survey.changes_at_last());
        survey.instant(5);
        assert!(survey.changes_at_last());
        survey.instant(9);
        assert!(!survey.changes_at_last());
        survey.change();
        survey.instant(9);
        assert!(survey.changes_at_last());
    }
}
