//! The FPGAs that are known, and whether a core fits them.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::resources::Resources;
use specula_datapath::target::{self, LogicCell, Target};

/// An FPGA, as its target's table has it.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    /// The share of its look-up tables and flip-flops that a core may take and still be placed.
    pub usable: f64,
    /// What a look-up table and a flip-flop are to each other.
    #[serde(skip)]
    pub cell: LogicCell,
}

/// What a core takes of one kind of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// The cells.
    pub cells: &'static str,
    /// How many of them it takes.
    pub taken: u64,
    /// How many the device has for it.
    pub available: u64,
}

impl Device {
    /// The known devices.
    pub fn all() -> impl Iterator<Item = Device> {
        Target::families().flat_map(|family| {
            let (target, block) = (family.name, family.multiplier.map(|block| block.widths));
            let logic = family.logic;
            let device = move |device: target::Device| Device {
                name: device.name,
                target: target.clone(),
                block,
                blocks: device.blocks,
                registers: device.flip_flops,
                luts: device.luts,
                memories: device.memories,
                usable: logic.usable,
                cell: logic.cell,
            };
            family.devices.into_iter().map(device)
        })
    }

    /// What a design takes of the device, or of a larger one of its target.
    pub fn resources(&self, design: &Design) -> Resources {
        // Each device is of a target that has a table.
        Target::named(&self.target)
            .map_or(Resources::default(), |target| Resources::of(design, &target))
    }

    /// The shares of the device that such resources are.
    pub fn shares(&self, resources: &Resources) -> impl Iterator<Item = Share> + use<> {
        let usable = |cells: u64| (cells as f64 * self.usable) as u64;
        let share = |cells, taken, available| Share { cells, taken, available };
        let [luts, registers] = [self.luts, self.registers].map(usable);
        let logic = match self.cell {
            LogicCell::Paired => vec![share("usable logic cells", resources.logic_cells, luts)],
            LogicCell::Apart => vec![
                share("usable look-up tables", resources.luts, luts),
                share("usable flip-flops", resources.flip_flops, registers),
            ],
        };
        let blocks = share("multiplier blocks", resources.blocks, self.blocks);
        let memories = share("block RAMs", resources.memories, self.memories);
        logic.into_iter().chain([blocks, memories])
    }

    /// Whether the device has such resources.
    pub fn has(&self, resources: &Resources) -> bool {
        self.shares(resources).all(|share| share.taken <= share.available)
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
