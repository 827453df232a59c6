//! The FPGAs that are known, and whether a core fits them.
use serde::Serialize;
use specula_datapath::target::{self, Target};

use crate::cost::Cost;

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
}

impl Cost {
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

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
}
