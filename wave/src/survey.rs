//! What is known of a dump after it has been read once: when something happens, and the clock's
//! pace.
use std::collections::{BTreeMap, VecDeque};
use std::ops::RangeInclusive;

/// The latest time: what lasts one unit ends behind it.
pub const LATEST: u64 = u64::MAX - 1;

/// Instants that are kept, at the begin and on either side of the marker.
const KEPT: usize = 4096;

/// What is known after a dump has been read once.
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
    /// Begins a survey that looks at what is around a marked time.
    pub fn new(marker: Option<u64>) -> Survey {
        Survey { marker, ..Survey::default() }
    }

    /// Watches a signal that may be a clock.
    pub fn watch(&mut self, signal: u32) {
        self.clocks.entry(signal).or_default();
    }

    /// An instant; they come in order, and one may come more than once.
    pub fn instant(&mut self, time: u64) {
        if self.first.is_some() && time <= self.last {
            return;
        }
        // What came before the first instant happened at it.
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

    /// A signal changes at the last instant that came.
    pub fn change(&mut self) {
        (self.changes, self.changes_at_last) = (true, true);
    }

    /// A watched signal changes; others are passed over. Times of a signal come in order.
    pub fn level(&mut self, signal: u32, time: u64, high: bool) {
        if let Some(pace) = self.clocks.get_mut(&signal) {
            pace.level(time, high);
        }
    }

    /// Whether there is any instant or value.
    pub fn is_empty(&self) -> bool {
        self.first.is_none() && !self.changes
    }

    /// From the first instant to the last.
    pub fn extent(&self) -> RangeInclusive<u64> {
        self.first.unwrap_or(0)..=self.last
    }

    /// Whether something changes at the last instant, or there is but one.
    pub fn changes_at_last(&self) -> bool {
        self.changes_at_last || self.first.is_none_or(|first| first == self.last)
    }

    /// The marked time, if the dump reaches to it.
    pub fn marker(&self) -> Option<u64> {
        self.marker.filter(|marker| self.extent().contains(marker))
    }

    /// `count` instants around the marker or at the begin, from the first to the last of them.
    pub fn usual(&self, count: u64) -> RangeInclusive<u64> {
        let around: Vec<u64> = match self.marker() {
            Some(_) => self.before_marker.iter().chain(&self.behind_marker).copied().collect(),
            None => self.begin.clone(),
        };
        let Some(last) = around.len().checked_sub(1) else { return self.extent() };
        let middle = self.marker().map(|_| self.before_marker.len() as u64);
        let shown = around_middle(&(0..=last as u64), middle, count);
        around[*shown.start() as usize]..=around[*shown.end() as usize]
    }

    /// The first rising edge and the period of a watched signal, if it rises at a constant pace.
    pub fn pace(&self, signal: u32) -> Option<(u64, u64)> {
        self.clocks.get(&signal)?.clone().finished()
    }
}

/// `length` numbers around `middle`, or from the begin, that are within `extent`.
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

/// When a signal rises.
#[derive(Clone, Debug, Default)]
struct Pace {
    /// The level at the latest instant: it counts when the instant is over.
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
        survey.pace(7)
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
            survey.usual(10)
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
