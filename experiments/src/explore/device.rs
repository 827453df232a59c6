//! The resources of an FPGA that a core takes, as far as they can be known without FPGA tools.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::target::{self, Target};

/// An FPGA, as its target's table has it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Device {
    /// Its name on the command line.
    pub name: String,
    /// The target that it belongs to.
    pub target: String,
    /// Widths of a multiplier block's signed operands, the wider one first; `None` without blocks.
    pub block: Option<[u32; 2]>,
    /// Number of multiplier blocks.
    pub blocks: u64,
    /// Number of flip-flops.
    pub registers: u64,
    /// Number of look-up tables.
    pub luts: u64,
    /// Number of block RAMs.
    pub memories: u64,
}

impl Device {
    /// The known devices.
    pub fn all() -> impl Iterator<Item = Device> {
        Target::families().flat_map(|family| {
            let (target, block) = (family.name, family.multiplier.map(|block| block.widths));
            let device = move |device: target::Device| Device {
                name: device.name,
                target: target.clone(),
                block,
                blocks: device.blocks,
                registers: device.flip_flops,
                luts: device.luts,
                memories: device.memories,
            };
            family.devices.into_iter().map(device)
        })
    }

    /// Number of blocks for a product of two signals, which is divided into parts that a block can
    /// multiply. Parts after the first have no sign, and therefore one bit less.
    ///
    /// None where the device has no blocks: logic multiplies.
    fn blocks_for(&self, [a, b]: [u32; 2]) -> u64 {
        let Some([long, short]) = self.block else { return 0 };
        let parts =
            |width: u32, port: u32| u64::from(width.saturating_sub(1).div_ceil(port - 1).max(1));
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
        let of_blocks = |(blocks, [a, b]): (u64, [u32; 2])| blocks * u64::from(a * b);
        let block = device.and_then(|device| device.block);
        Cost {
            multiplier_bits: blocks.zip(block).map_or(size.multiplier_bits, of_blocks),
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

    /// Whether a device has enough multiplier blocks, registers and look-up tables. Of the last,
    /// only those of adders count, and of products where the device has no blocks for them: the
    /// fewest that the core can take.
    pub fn fits(&self, device: &Device) -> bool {
        let of_products = if device.block.is_some() { 0 } else { self.multiplier_bits };
        self.blocks.unwrap_or(0) <= device.blocks
            && self.register_bits <= device.registers
            && self.adder_bits + of_products <= device.luts
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
    use std::collections::BTreeSet;

    use super::*;

    fn named(name: &str) -> Device {
        Device::all().find(|device| device.name == name).expect("a device of the tables")
    }

    #[test]
    fn devices_have_names_of_their_own_and_something_to_build_with() {
        let names: BTreeSet<String> = Device::all().map(|device| device.name).collect();
        assert_eq!(names.len(), Device::all().count());
        for name in ["ice40up5k", "ice40hx8k", "ecp5-25", "gw2a18", "xc7a35t"] {
            assert!(names.contains(name), "{name}");
        }
        for device in Device::all() {
            let Device { name, block, blocks, registers, luts, memories, .. } = &device;
            assert!(*registers > 0 && *luts > 0 && *memories > 0, "{name}");
            assert_eq!(block.is_some(), *blocks > 0, "{name}");
        }
    }

    #[test]
    fn a_device_without_blocks_takes_products_in_logic() {
        assert_eq!(named("ice40hx8k").blocks_for([18, 18]), 0);
    }

    #[test]
    fn products_are_cut_into_what_blocks_multiply() {
        let device = named("xc7a35t");
        assert_eq!(device.block, Some([25, 18]));
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
