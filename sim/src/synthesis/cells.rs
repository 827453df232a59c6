//! Cells of a device.
use std::ops::AddAssign;

/// Cells of an ECP5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Synthesised {
    /// Look-up tables of four inputs: `LUT4`, and the two of each carry cell, `CCU2C`.
    pub luts: u64,
    /// Multipliers of 18 x 18 bits, `MULT18X18D`.
    pub multipliers: u64,
    /// Flip-flops, `TRELLIS_FF`.
    pub flip_flops: u64,
}

impl AddAssign for Synthesised {
    fn add_assign(&mut self, other: Synthesised) {
        self.luts += other.luts;
        self.multipliers += other.multipliers;
        self.flip_flops += other.flip_flops;
    }
}
