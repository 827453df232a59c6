//! The clocks in which time slots of pixels go in: one after the other, or with bubbles or the end of
//! a frame between.
use std::ops::Range;
use std::sync::Arc;

/// The clocks in which the time slots of all pixels go in, in order.
#[derive(Clone, Debug)]
pub(crate) enum SlotClocks {
    /// One in each clock.
    Consecutive {
        /// The clock of the first.
        first: u64,
        /// How many there are.
        count: u64,
    },
    /// With clocks between in which none goes in.
    Paused(Pauses),
}

/// Time slots with clocks between in which none goes in.
#[derive(Clone, Debug)]
pub(crate) struct Pauses {
    /// The seed of random bubbles, if there are any.
    seed: Option<u64>,
    /// The clock of each time slot.
    clocks: Arc<[u64]>,
}

impl SlotClocks {
    /// So many time slots, each of which waits for as many clocks as `wait` says, and with a seed for
    /// a random bubble of 0 to 4 clocks besides.
    pub fn paused(slots: u64, seed: Option<u64>, wait: impl Fn(u64) -> u64) -> SlotClocks {
        let clocks = (0..slots).scan(0, |clock, slot| {
            let own = *clock + wait(slot) + seed.map_or(0, |seed| bubble(seed, slot));
            *clock = own + 1;
            Some(own)
        });
        SlotClocks::Paused(Pauses { seed, clocks: clocks.collect() })
    }

    /// Time slots that go in in these clocks, each behind the one before.
    pub fn given(clocks: Arc<[u64]>) -> SlotClocks {
        SlotClocks::Paused(Pauses { seed: None, clocks })
    }

    /// How many time slots there are.
    pub fn count(&self) -> u64 {
        match self {
            SlotClocks::Consecutive { count, .. } => *count,
            SlotClocks::Paused(pauses) => pauses.clocks.len() as u64,
        }
    }

    /// The clock of time slot number `slot`; the clock behind the last one's for a number behind the
    /// last.
    pub fn clock_of(&self, slot: u64) -> u64 {
        match self {
            SlotClocks::Consecutive { first, count } => first + slot.min(*count),
            SlotClocks::Paused(Pauses { clocks, .. }) => match clocks.get(slot as usize) {
                Some(&clock) => clock,
                None => clocks.last().map_or(0, |last| last + 1),
            },
        }
    }

    /// How many time slots have gone in before `clock`: the number of the one that goes in then, or
    /// else next.
    pub fn before(&self, clock: u64) -> u64 {
        match self {
            SlotClocks::Consecutive { first, count } => clock.saturating_sub(*first).min(*count),
            SlotClocks::Paused(Pauses { clocks, .. }) => {
                clocks.partition_point(|&own| own < clock) as u64
            }
        }
    }

    /// The time slot that goes in at `clock`.
    pub fn at(&self, clock: u64) -> Option<u64> {
        let slot = self.before(clock);
        (slot < self.count() && self.clock_of(slot) == clock).then_some(slot)
    }

    /// The clocks of time slot number `slot` and of those behind it, before number `end`, that
    /// follow without a bubble.
    pub fn run_from(&self, slot: u64, end: u64) -> Range<u64> {
        let first = self.clock_of(slot);
        match self {
            SlotClocks::Consecutive { .. } => first..self.clock_of(end),
            SlotClocks::Paused(Pauses { clocks, .. }) => {
                let row = clocks[slot as usize..end as usize].iter();
                let follow = row.zip(first..).take_while(|(own, expected)| *own == expected);
                first..first + follow.count() as u64
            }
        }
    }

    /// A bit for the bubble at `clock` that means nothing; 1 where there are no bubbles.
    pub fn nonsense(&self, clock: u64) -> bool {
        match self {
            SlotClocks::Paused(Pauses { seed: Some(seed), .. }) => drawn(!seed, clock) & 1 == 1,
            SlotClocks::Consecutive { .. } | SlotClocks::Paused(_) => true,
        }
    }
}

/// The clocks of the bubble before a time slot: none before every second, else 1 to 4.
fn bubble(seed: u64, slot: u64) -> u64 {
    let number = drawn(seed, slot);
    if number & 1 == 0 { 0 } else { 1 + (number >> 1) % 4 }
}

/// The number at place `at` of a seed's sequence, as SplitMix64 draws it. [Steele, Lea and Flood,
/// Fast splittable pseudorandom number generators, OOPSLA 2014]
fn drawn(seed: u64, at: u64) -> u64 {
    let mut z = seed.wrapping_add((at + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_slots_are_found_by_their_clock() {
        let wait = |slot: u64| if slot.is_multiple_of(100) { 11 } else { 0 };
        let consecutive = |first| SlotClocks::Consecutive { first, count: 500 };
        let paused = [None, Some(7)].map(|seed| SlotClocks::paused(500, seed, wait));
        for clocks in [0, 3].map(consecutive).into_iter().chain(paused) {
            let all: Vec<u64> = (0..500).map(|slot| clocks.clock_of(slot)).collect();
            assert!(all.is_sorted_by(|a, b| a < b));
            let end = clocks.clock_of(500);
            assert_eq!(end, all[499] + 1);
            for clock in 0..end + 10 {
                assert_eq!(clocks.before(clock), all.iter().filter(|&&c| c < clock).count() as u64);
                let at = all.iter().position(|&own| own == clock);
                assert_eq!(clocks.at(clock), at.map(|slot| slot as u64));
            }
        }
    }

    #[test]
    fn bubbles_are_of_0_to_4_clocks_and_runs_lie_between() {
        let clocks = SlotClocks::paused(500, Some(7), |_| 0);
        let before = |slot: u64| if slot == 0 { 0 } else { clocks.clock_of(slot - 1) + 1 };
        let lengths: Vec<u64> = (0..500).map(|slot| clocks.clock_of(slot) - before(slot)).collect();
        for length in 0..=4 {
            assert!(lengths.contains(&length), "{length}");
        }
        assert!(lengths.iter().all(|&length| length <= 4));
        let (mut slot, mut fed) = (0, vec![]);
        while slot < 300 {
            let run = clocks.run_from(slot, 300);
            slot += run.end - run.start;
            fed.extend(run);
        }
        assert_eq!(fed, (0..300).map(|slot| clocks.clock_of(slot)).collect::<Vec<_>>());
    }

    #[test]
    fn another_seed_pauses_elsewhere() {
        let [a, b] = [1, 2].map(|seed| SlotClocks::paused(100, Some(seed), |_| 0));
        assert!((0..100).any(|slot| a.clock_of(slot) != b.clock_of(slot)));
        let bits = |clocks: &SlotClocks| (0..64).filter(|&c| clocks.nonsense(c)).count();
        assert!((16..48).contains(&bits(&a)) && (16..48).contains(&bits(&b)));
    }
}
