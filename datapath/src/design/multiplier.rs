//! Products in the multiplier blocks of a device, with the registers that blocks have inside.
use super::NodeId;
use crate::target::{Cells, SumCells};

/// What Verilog makes of parts of a design that a device has cells for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Primitives {
    /// The cells that products in multiplier blocks are instances of; without, they are `*` and
    /// the registers around it, which tools take into their blocks.
    pub multiplier: Option<Cells>,
    /// The cells of sums of which one summand may be cleared; without, that is a choice before the
    /// sum.
    pub gated_sum: Option<SumCells>,
    /// Clocks of the shortest delay line that is a memory.
    pub shortest_memory: u32,
    /// Clocks of the longest that is one memory; longer ones are several in a row.
    pub longest_memory: u32,
    /// Whether what such a memory delays has to come from a register.
    pub registered_memories: bool,
}

impl Default for Primitives {
    fn default() -> Primitives {
        Primitives {
            multiplier: None,
            gated_sum: None,
            shortest_memory: 33,
            longest_memory: u32::MAX,
            registered_memories: false,
        }
    }
}

/// A product in a multiplier block. In the design it is signals like any others; Verilog has an
/// instance for them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MultiplierBlock {
    /// What enters: signals outside the block.
    pub factors: [NodeId; 2],
    /// Registers from what enters to what leaves, 0 to 3: behind the product, then before it too,
    /// then one more between.
    pub registers: u32,
    /// The registers of the factors, if there are any; one that is constant has none.
    pub taken: [Option<NodeId>; 2],
    /// The product's register inside the block, if there is one.
    pub pipelined: Option<NodeId>,
    /// The product as it leaves.
    pub product: NodeId,
}

impl MultiplierBlock {
    /// The signals that are inside the block, what leaves it included.
    pub fn inside(&self) -> impl Iterator<Item = NodeId> + use<> {
        self.taken.into_iter().flatten().chain(self.pipelined).chain([self.product])
    }

    /// The same block by other numbers of its signals; none if what leaves it has none.
    pub fn renumbered(&self, new: impl Fn(NodeId) -> Option<NodeId>) -> Option<MultiplierBlock> {
        let [a, b] = self.factors.map(&new);
        Some(MultiplierBlock {
            factors: [a?, b?],
            registers: self.registers,
            taken: self.taken.map(|taken| taken.and_then(&new)),
            pipelined: self.pipelined.and_then(&new),
            product: new(self.product)?,
        })
    }
}
