//! The resources that a core takes, as far as they can be known without FPGA tools, and what they
//! are worth together.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::{Extent, Size};
use specula_datapath::resources::blocks_for;
use specula_datapath::verilog::Counted;

/// Widths of the signed operands of a multiplier block where no device is named, the wider one
/// first: 18 x 18 bits fit the blocks of most families.
pub const GENERIC_BLOCK: [u32; 2] = [18, 18];

/// The resources that a core takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Sum of the products of operand widths over all multipliers of two variables; with a block,
    /// over all blocks that they take, including unused bits.
    pub multiplier_bits: u64,
    /// Number of multiplier blocks, if their shape is known.
    pub blocks: Option<u64>,
    /// Bits of adders.
    pub adder_bits: u64,
    /// Bits of registers.
    pub register_bits: u64,
    /// Bits of read-only memory.
    pub table_bits: u64,
}

impl Cost {
    /// The resources that `design` takes where multiplier blocks have operands of these widths, the
    /// wider one first, if blocks are to be counted.
    pub fn of(design: &Design, block: Option<[u32; 2]>) -> Cost {
        if !design.multipliers.is_empty() {
            return Cost::of_lowered(design, &design.size());
        }
        Cost::of_extent(&design.extent(), block)
    }

    /// The resources that a design takes which is made of this much and is for no target.
    pub fn of_extent(Extent { size, factors }: &Extent, block: Option<[u32; 2]>) -> Cost {
        let blocks = block.map(|block| factors.iter().map(|of| blocks_for(block, of.widths)).sum());
        let of_blocks = |(blocks, [a, b]): (u64, [u32; 2])| blocks * u64::from(a) * u64::from(b);
        Cost {
            multiplier_bits: blocks.zip(block).map_or(size.multiplier_bits, of_blocks),
            blocks,
            adder_bits: size.adder_bits,
            register_bits: size.register_bits,
            table_bits: size.table_bits,
        }
    }

    /// That of a design whose products stand in the blocks of its target already.
    fn of_lowered(design: &Design, size: &Size) -> Cost {
        let counted = Counted::of(&design.to_block());
        Cost {
            multiplier_bits: size.multiplier_bits,
            blocks: Some(design.multipliers.len() as u64),
            adder_bits: size.adder_bits,
            register_bits: counted.flip_flops,
            table_bits: size.table_bits,
        }
    }

    /// All resources as one number: a cell for each bit product, each bit of an adder, of a
    /// register and of read-only memory.
    pub fn cells(&self) -> u64 {
        self.multiplier_bits + self.adder_bits + self.register_bits + self.table_bits
    }
}
