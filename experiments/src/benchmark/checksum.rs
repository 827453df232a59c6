//! Checksums of codes, with which engines are checked while they are measured.
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::{Batch, Lanes, Stimulus};

/// The sum of each output over all pixels, modulo 2^32: as narrow as lanes are, so that summing
/// costs next to nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Checksum(pub [u32; 3]);

impl Checksum {
    /// Adds the codes of pixels.
    pub fn add_pixels(&mut self, codes: &[[u8; 3]]) {
        for code in codes {
            *self = self.plus(Checksum(code.map(u32::from)));
        }
    }

    /// The checksum of the pixels of both sets.
    pub fn plus(self, other: Checksum) -> Checksum {
        Checksum(std::array::from_fn(|c| self.0[c].wrapping_add(other.0[c])))
    }

    /// The checksum of `count` repetitions.
    pub fn times(self, count: usize) -> Checksum {
        // The truncation is harmless, since both sides are taken modulo 2^32.
        Checksum(self.0.map(|sum| sum.wrapping_mul(count as u32)))
    }
}

/// Sums the outputs while an engine runs, over the clocks in which pixels must leave.
pub(crate) struct Accumulator {
    /// The outputs' positions among the watched signals.
    places: Vec<usize>,
    leaving: Range<u64>,
    checksum: Checksum,
}

impl Accumulator {
    /// An accumulator for a run of this stimulus that watches these signals, which include the
    /// outputs.
    pub fn new(design: &Design, watched: &[NodeId], stimulus: &Stimulus) -> Accumulator {
        let latency = u64::from(design.latency());
        let place = |node: &NodeId| watched.iter().position(|watched| watched == node);
        Accumulator {
            places: design.outputs.iter().filter_map(place).collect(),
            leaving: latency..latency + stimulus.fed_clocks(),
            checksum: Checksum::default(),
        }
    }

    /// Adds the pixels of a batch.
    pub fn take(&mut self, batch: &Batch) {
        let span = batch.span();
        let row = |clock: u64| (clock.clamp(span.start, span.end) - span.start) as usize;
        let rows = row(self.leaving.start)..row(self.leaving.end);
        for (sum, &place) in self.checksum.0.iter_mut().zip(&self.places) {
            *sum = sum.wrapping_add(added_up(batch.lanes(place).rows(rows.clone())));
        }
    }

    /// The checksum so far.
    pub fn checksum(&self) -> Checksum {
        self.checksum
    }
}

/// The sum of the lanes, modulo 2^32.
fn added_up(lanes: Lanes) -> u32 {
    match lanes {
        Lanes::Narrow(lanes) => {
            lanes.iter().fold(0, |sum: u32, &lane| sum.wrapping_add(lane as u32))
        }
        Lanes::Wide(lanes) => lanes.iter().fold(0, |sum: u32, &lane| sum.wrapping_add(lane as u32)),
        Lanes::Constant(value, clocks) => (value as u32).wrapping_mul(clocks as u32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_of_every_kind_are_added_up_modulo_2_to_the_32() {
        assert_eq!(added_up(Lanes::Narrow(&[3, -1, i32::MAX])), 0x8000_0001);
        assert_eq!(added_up(Lanes::Wide(&[3, -1, i64::MAX])), 1);
        assert_eq!(added_up(Lanes::Constant(-2, 3)), 6u32.wrapping_neg());
    }

    #[test]
    fn sums_of_repeated_frames_wrap() {
        let frame = Checksum([3_000_000_000, 1, 0]);
        assert_eq!(frame.times(3), frame.plus(frame).plus(frame));
    }
}
