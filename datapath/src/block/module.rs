//! A module built at run time.
use std::rc::Rc;

use rust_hdl_core::prelude::*;

use super::Wire;
use crate::design::{MultiplierBlock, Op, Primitives, Register, Table};

/// An operator of a module; operands are numbers of the module's own wires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The wire it drives.
    pub wire: u32,
    /// What it computes.
    pub op: Op,
    /// Whether a register follows.
    pub register: Register,
}

/// A module inside another.
pub struct Child {
    /// The module.
    pub module: Module,
    /// Pairs of the child's input wire and the wire here that drives it.
    pub inputs: Vec<(u32, u32)>,
    /// Pairs of the child's output wire and the wire here that it drives.
    pub outputs: Vec<(u32, u32)>,
}

/// A module built at run time.
pub struct Module {
    /// What it is, such as `reflect`.
    pub unit: String,
    /// Its formula and source.
    pub formula: String,
    /// Its name in its parent.
    pub instance: String,
    /// Stages at which inputs and outputs are valid.
    pub stages: (u32, u32),
    pub(super) clock: Signal<In, Clock>,
    pub(super) reset: Option<u32>,
    pub(super) wires: Vec<Wire>,
    pub(super) gates: Vec<Cell>,
    pub(super) registers: Vec<Cell>,
    pub(super) children: Vec<Child>,
    pub(super) primitives: Primitives,
    /// Products in multiplier blocks, by numbers of the module's own wires.
    pub(super) multipliers: Vec<MultiplierBlock>,
    pub(super) tables: Rc<[Table]>,
    /// Whether anything changed in the last `update_all`, or has been put to a pin since.
    pub(super) active: bool,
}

impl Module {
    /// Its wires.
    pub fn wires(&self) -> &[Wire] {
        &self.wires
    }

    /// Its operators, gates first.
    pub fn cells(&self) -> impl Iterator<Item = &Cell> {
        self.gates.iter().chain(&self.registers)
    }

    /// The modules in it.
    pub fn children(&self) -> &[Child] {
        &self.children
    }

    /// What Verilog has cells of the device for.
    pub fn primitives(&self) -> Primitives {
        self.primitives
    }

    /// Its products that are instances of cells, by numbers of its own wires.
    pub fn multipliers(&self) -> &[MultiplierBlock] {
        match self.primitives.multiplier {
            Some(_) => &self.multipliers,
            None => &[],
        }
    }

    /// Whether it has a reset pin.
    pub fn has_reset(&self) -> bool {
        self.reset.is_some()
    }

    /// Whether this wire is the reset pin.
    pub fn is_reset(&self, wire: u32) -> bool {
        self.reset == Some(wire)
    }

    /// The read-only memories that its operators name.
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// Puts a raw value to a pin or wire; it takes effect when the design is simulated.
    pub fn set(&mut self, wire: u32, raw: i64) {
        let wire = &mut self.wires[wire as usize];
        wire.next = raw;
        self.active |= wire.next != wire.value;
    }

    /// Raises or lowers reset; it takes effect when the design is simulated.
    pub fn set_reset(&mut self, asserted: bool) {
        if let Some(reset) = self.reset {
            self.set(reset, i64::from(asserted));
        }
    }

    /// Raises or lowers the clock; it takes effect when the design is simulated.
    pub fn set_clock(&mut self, high: bool) {
        self.clock.next = Clock { clk: high };
        self.active |= self.clock.next != self.clock.val();
    }
}
