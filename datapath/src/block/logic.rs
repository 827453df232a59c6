//! A module as a rust-hdl `Block` like any other.
//!
//! # Why data never overtakes the clock
//! rust-hdl settles a design by calling `update_all` until nothing changes. In one call a module
//! first evaluates (`update`), then lets clock and wires take their next values, then does the same
//! for its children. The clock that a parent sees rise in one call reaches the child's clock pin in
//! the same call and is seen there in the next one. Data that changes with the edge stands on the
//! parent's wires at the end of the first call and is put to the child's pins in the next one,
//! where it becomes visible to registers only after they have sampled: registers read the values of
//! the last call, gates the values of this one. So on every path, however deep, data arrives at
//! least one call after the edge.
use rust_hdl_core::prelude::*;

use super::Module;
use crate::design::Register;
use crate::verilog::Nets;

impl Module {
    fn sample_registers(&mut self) {
        let in_reset = self.reset.is_some_and(|r| self.wires[r as usize].value == 1);
        for cell in &self.registers {
            let raw = cell.op.evaluate(&self.tables, |id| self.wires[id.0 as usize].value);
            let cleared = in_reset && cell.register == Register::Validity;
            let wire = &mut self.wires[cell.wire as usize];
            wire.next = if cleared { 0 } else { wire.wrap(raw) };
        }
    }

    fn evaluate_gates(&mut self) {
        for cell in &self.gates {
            let raw = cell.op.evaluate(&self.tables, |id| self.wires[id.0 as usize].next);
            let wire = &mut self.wires[cell.wire as usize];
            wire.next = wire.wrap(raw);
        }
    }

    fn exchange_with_children(&mut self) {
        for child in &mut self.children {
            child.module.set_clock(self.clock.val().clk);
            for &(pin, wire) in &child.inputs {
                child.module.set(pin, self.wires[wire as usize].value);
            }
            for &(pin, wire) in &child.outputs {
                self.wires[wire as usize].next = child.module.wires[pin as usize].value;
            }
        }
    }
}

impl Logic for Module {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.sample_registers();
        }
        // Outputs of children first: gates read this call's values.
        self.exchange_with_children();
        self.evaluate_gates();
    }

    fn connect(&mut self) {
        for wire in &mut self.wires {
            if wire.wire_type().kind != AtomKind::InputParameter {
                wire.drive();
            }
        }
        for child in &mut self.children {
            child.module.clock.connect();
            for &(pin, _) in &child.inputs {
                child.module.wires[pin as usize].drive();
            }
        }
    }

    /// Complete Verilog of the body, in the form in which rust-hdl's own generator joins it to the
    /// children's.
    fn hdl(&self) -> Verilog {
        let mut lines = vec![];
        let nets = Nets::of_wires(self);
        let name = |wire: u32| nets.name(wire);
        for cell in self.gates.iter().filter(|c| c.op.constant().is_none()) {
            lines.push(format!("always @(*) {}", nets.assignment(cell)));
        }
        for cell in &self.registers {
            lines.push(match cell.register {
                Register::Validity => {
                    format!(
                        "always @(posedge clock) {} <= reset ? 1'b0 : {};",
                        name(cell.wire),
                        nets.expression(cell)
                    )
                }
                _ => format!("always @(posedge clock) {}", nets.assignment(cell)),
            });
        }
        for child in &self.children {
            let pin = |wire: u32| {
                format!(
                    "{}${}",
                    child.module.instance,
                    child.module.wires[wire as usize].wire_type().name
                )
            };
            lines.push(format!("always @(*) {}$clock = clock;", child.module.instance));
            lines.extend(
                child.inputs.iter().map(|&(p, w)| format!("always @(*) {} = {};", pin(p), name(w))),
            );
            lines.extend(
                child
                    .outputs
                    .iter()
                    .map(|&(p, w)| format!("always @(*) {} = {};", name(w), pin(p))),
            );
        }
        Verilog::Custom(lines.join("\n"))
    }
}

impl Block for Module {
    fn connect_all(&mut self) {
        self.connect();
        self.clock.connect_all();
        for child in &mut self.children {
            child.module.connect_all();
        }
    }

    fn update_all(&mut self) {
        // Nothing changed here or below and nothing was put to a pin: another evaluation would give
        // the same.
        if !self.active {
            return;
        }
        self.update();
        self.clock.update_all();
        self.active = self.clock.has_changed();
        for wire in &mut self.wires {
            self.active |= wire.settle();
        }
        for child in &mut self.children {
            child.module.update_all();
            self.active |= child.module.active;
        }
    }

    fn has_changed(&self) -> bool {
        self.active
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        self.clock.accept("clock", probe);
        let constants: Vec<u32> =
            self.gates.iter().filter(|c| c.op.constant().is_some()).map(|c| c.wire).collect();
        for (number, wire) in self.wires.iter().enumerate() {
            if !constants.contains(&(number as u32)) {
                wire.accept(&wire.wire_type().name, probe);
            }
        }
        for child in &self.children {
            child.module.accept(&child.module.instance, probe);
        }
        probe.visit_end_scope(name, self);
    }
}
