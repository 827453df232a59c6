//! What a module's wires are called in a text.
use std::borrow::Cow;

use super::Delays;
use super::statement::{self, Operand};
use crate::block::{AtomKind, Cell, Module};
use crate::design::{NodeId, Register};

/// The names of a module's wires.
pub struct Nets<'a> {
    module: &'a Module,
    names: Vec<Cow<'a, str>>,
    constants: Vec<Option<i64>>,
}

impl<'a> Nets<'a> {
    /// Every wire under its own name.
    pub fn of_wires(module: &'a Module) -> Nets<'a> {
        let mut constants = vec![None; module.wires().len()];
        module.cells().for_each(|cell| constants[cell.wire as usize] = cell.op.constant());
        let names = module.wires().iter().map(|wire| Cow::from(&wire.wire_type().name)).collect();
        Nets { module, names, constants }
    }

    /// Local bits of validity as elements of their vectors, every other wire under its own name.
    pub fn with_vectors(module: &'a Module, delays: &Delays) -> Nets<'a> {
        let mut nets = Nets::of_wires(module);
        for line in &delays.validity {
            for (&wire, clock) in line.stages.iter().zip(1..) {
                if module.wires()[wire as usize].wire_type().kind == AtomKind::LocalSignal {
                    nets.names[wire as usize] = format!("{}[{clock}]", line.name).into();
                }
            }
        }
        nets
    }

    /// The name of a wire.
    pub fn name(&self, wire: u32) -> &str {
        &self.names[wire as usize]
    }

    /// A wire, or the constant that it carries, as an expression of the wire's width.
    pub fn value(&self, wire: NodeId) -> String {
        self.extended(wire, self.module.wires()[wire.0 as usize].wire_type().width)
    }

    /// A wire, or the constant that it carries, as an expression of so many bits.
    pub fn extended(&self, wire: NodeId, width: u32) -> String {
        statement::expression(crate::design::Op::Copy(wire), width, &|id| self.operand(id))
    }

    /// A cell as Verilog statements of an `always` block.
    pub fn assignment(&self, cell: &Cell) -> String {
        let arrow = if cell.register == Register::None { "=" } else { "<=" };
        statement::assignment(
            (self.name(cell.wire), NodeId(cell.wire)),
            arrow,
            cell.op,
            self.width(cell),
            &|id| self.operand(id),
            self.module.tables(),
        )
    }

    /// The right-hand side of a cell as a Verilog expression of the width of its wire.
    pub fn expression(&self, cell: &Cell) -> String {
        statement::expression(cell.op, self.width(cell), &|id| self.operand(id))
    }

    fn width(&self, cell: &Cell) -> u32 {
        self.module.wires()[cell.wire as usize].wire_type().width
    }

    fn operand(&self, id: NodeId) -> Operand<'_> {
        if let Some(value) = self.constants[id.0 as usize] {
            return Operand::Literal(value);
        }
        let wire_type = self.module.wires()[id.0 as usize].wire_type();
        Operand::Net { name: self.name(id.0), width: wire_type.width, signed: wire_type.signed }
    }
}
