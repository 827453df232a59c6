//! The resources of an FPGA that a core takes, as far as they can be known without FPGA tools.
use serde::Serialize;
use specula_datapath::Design;

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

    /// Number of blocks for a product of two signals, which is divided into parts that a block can
    /// multiply. Parts after the first have no sign, and therefore one bit less.
    fn blocks_for(&self, [a, b]: [u32; 2]) -> u64 {
        let parts =
            |width: u32, port: u32| u64::from(width.saturating_sub(1).div_ceil(port - 1).max(1));
        let [long, short] = self.block;
        (parts(a, long) * parts(b, short)).min(parts(a, short) * parts(b, long))
    }
}

/// The resources that a core takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Sum of the products of operand widths over all multipliers of two variables; with a device,
    /// over all blocks that they take, including unused bits.
    pub multiplier_bits: u64,
    /// Number of multiplier blocks, if a device is given.
    pub blocks: Option<u64>,
    /// Bits of adders.
    pub adder_bits: u64,
    /// Bits of registers.
    pub register_bits: u64,
    /// Bits of read-only memory.
    pub table_bits: u64,
}

impl Cost {
    /// The resources that `design` takes, of a device if one is given.
    pub fn of(design: &Design, device: Option<&Device>) -> Cost {
        let size = design.size();
        let blocks =
            device.map(|device| products(design).map(|widths| device.blocks_for(widths)).sum());
        let of_blocks = |(blocks, device): (u64, &Device)| {
            blocks * u64::from(device.block[0] * device.block[1])
        };
        Cost {
            multiplier_bits: blocks.zip(device).map_or(size.multiplier_bits, of_blocks),
            blocks,
            adder_bits: size.adder_bits,
            register_bits: size.register_bits,
            table_bits: size.table_bits,
        }
    }

    /// All resources as one number: a cell for each bit product, each bit of an adder, of a
    /// register and of read-only memory.
    pub fn cells(&self) -> u64 {
        self.multiplier_bits + self.adder_bits + self.register_bits + self.table_bits
    }

    /// Whether a device has enough multiplier blocks and registers. Its logic cells are not
    /// compared.
    pub fn fits(&self, device: &Device) -> bool {
        self.blocks.unwrap_or(0) <= device.blocks && self.register_bits <= device.registers
    }
}

/// Widths of the operands of every product of two variables; a sign bit is added to unsigned ones.
fn products(design: &Design) -> impl Iterator<Item = [u32; 2]> {
    let width = |id| {
        let range = design.node(id).range;
        range.width() + u32::from(!range.signed())
    };
    design.nodes.iter().filter_map(move |node| Some(design.factors(node)?.map(width)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_cut_into_what_blocks_multiply() {
        let device = Device { name: "", block: [25, 18], blocks: 1, registers: 0 };
        for (widths, blocks) in [
            ([18, 25], 1),
            ([25, 18], 1),
            ([1, 1], 1),
            ([26, 18], 2),
            ([25, 25], 2),
            ([49, 35], 4),
            ([50, 35], 6),
        ] {
            assert_eq!(device.blocks_for(widths), blocks, "{widths:?}");
        }
    }
}
