//! The cells of a device that a design takes, estimated without synthesis: multiplier blocks and
//! memories as they are printed, flip-flops and look-up tables as Yosys maps them (`docs/targets.md`
//! says how well).
mod carry;
mod gates;
mod needed;
mod pairs;
mod products;
mod rom;
mod twins;
mod wiring;

use serde::Serialize;

use crate::design::Design;
use crate::target::{LogicCell, Target};
use crate::verilog::Counted;
use gates::Gates;
use wiring::Wiring;

pub use products::blocks_for;

/// Cells of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Resources {
    /// Look-up tables, those of carry chains and of memories in look-up tables included.
    pub luts: u64,
    /// Flip-flops, those inside blocks apart.
    pub flip_flops: u64,
    /// Cells of a look-up table and a flip-flop that are taken, where a flip-flop takes what its own
    /// look-up table gives; of other targets the look-up tables.
    pub logic_cells: u64,
    /// Multiplier blocks.
    pub blocks: u64,
    /// Block RAMs.
    pub memories: u64,
}

impl Resources {
    /// What a design takes of a target's devices. A design that was made for no target takes the
    /// blocks that its products are cut into.
    pub fn of(design: &Design, target: &Target) -> Resources {
        let counted = Counted::of(&design.to_block());
        let products = products::Products::of(design, target);
        let wiring = Wiring::of(design);
        let gates = Gates::of(&wiring, target.logic.carry);
        let luts = gates.luts
            + carry::luts(&wiring, &target.logic)
            + rom::luts(&wiring)
            + products.luts
            + target.logic.of_delay_lines(&counted);
        let logic_cells = match target.logic.cell {
            LogicCell::Apart => luts,
            LogicCell::Paired => luts + pairs::alone(&wiring, &gates),
        };
        Resources {
            luts,
            flip_flops: counted.flip_flops.saturating_sub(wiring.superfluous_flip_flops()),
            logic_cells,
            blocks: products.blocks,
            memories: match &target.table {
                Some(ram) if target.logic.memory == 0 => counted.memories(ram.widest.into()),
                _ => 0,
            },
        }
    }
}
