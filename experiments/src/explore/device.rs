//! The FPGAs that are known, and whether a core fits them.
use serde::Serialize;

use crate::cost::Cost;

/// An FPGA, according to its data sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Device {
    /// Its name on the command line.
    pub name: &'static str,
    /// Widths of a multiplier block's signed operands, the wider one first.
    pub block: [u32; 2],
    /// Number of multiplier blocks.
    pub blocks: u64,
    /// Number of flip-flops.
    pub registers: u64,
}

impl Device {
    /// The known devices.
    pub const ALL: [Device; 3] = [
        // iCE40 UltraPlus, FPGA-DS-02008: 8 SB_MAC16, 5280 LUT4 with a flip-flop each.
        Device { name: "ice40up5k", block: [16, 16], blocks: 8, registers: 5280 },
        // ECP5, FPGA-DS-02012: 28 multipliers of 18 x 18, 24 000 LUT4 with a flip-flop each.
        Device { name: "ecp5-25", block: [18, 18], blocks: 28, registers: 24_000 },
        // 7 Series, DS180: 90 DSP48E1 of 25 x 18, 41 600 flip-flops.
        Device { name: "xc7a35t", block: [25, 18], blocks: 90, registers: 41_600 },
    ];
}

impl Cost {
    /// Whether a device has enough multiplier blocks and registers. Its logic cells are not
    /// compared.
    pub fn fits(&self, device: &Device) -> bool {
        self.blocks.unwrap_or(0) <= device.blocks && self.register_bits <= device.registers
    }
}
