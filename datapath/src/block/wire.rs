//! A wire whose width is known only at run time, as a rust-hdl `Atom`.
use rust_hdl_core::prelude::*;
use rust_hdl_core::signal::get_signal_id;

use crate::design::{Node, NodeId, wrapped};

/// What of a wire its node does not say.
#[derive(Debug)]
pub(super) struct Role {
    /// Port or local signal.
    pub kind: AtomKind,
    /// The stated fact that its width rests on, if it does.
    pub fact: Option<String>,
    /// Whether registers or inputs lead to it by wires alone.
    pub stored: bool,
}

/// What never changes about a wire.
#[derive(Debug)]
pub struct WireType {
    /// Its name in the module.
    pub name: String,
    /// The signal of the design that it carries.
    pub node: NodeId,
    /// Port or local signal.
    pub kind: AtomKind,
    /// Width in bits, sign included.
    pub width: u32,
    /// Whether it is in two's complement.
    pub signed: bool,
    /// Its format as text, for viewers.
    pub format: String,
    /// The stated fact that its width rests on, if it does.
    pub fact: Option<String>,
    /// Clocks after a pixel's entry at which its value belongs to that pixel.
    pub stage: u32,
    /// Whether it is still: the same for every pixel that is under way.
    pub still: bool,
    /// Whether registers or inputs lead to it by wires alone.
    pub stored: bool,
    id: usize,
}

/// A wire whose width is known only at run time.
#[derive(Debug)]
pub struct Wire {
    pub(super) value: i64,
    pub(super) next: i64,
    pub(super) changed: bool,
    driven: bool,
    wire_type: Box<WireType>,
}

impl Wire {
    pub(super) fn new(id: NodeId, node: &Node, role: Role) -> Wire {
        let Role { kind, fact, stored } = role;
        let wire_type = WireType {
            name: node.name.clone(),
            node: id,
            kind,
            width: node.width(),
            signed: node.range.signed(),
            format: node.format().to_string(),
            fact,
            stage: node.stage,
            still: node.still,
            stored,
            id: get_signal_id(),
        };
        Wire { value: 0, next: 0, changed: false, driven: false, wire_type: Box::new(wire_type) }
    }

    /// What never changes about it.
    pub fn wire_type(&self) -> &WireType {
        &self.wire_type
    }

    /// Its raw value.
    pub fn value(&self) -> i64 {
        self.value
    }

    /// `raw` brought to the wire's width.
    pub(super) fn wrap(&self, raw: i64) -> i64 {
        wrapped(raw, self.wire_type.width, self.wire_type.signed)
    }

    pub(super) fn drive(&mut self) {
        self.driven = true;
    }

    pub(super) fn settle(&mut self) -> bool {
        self.changed = self.value != self.next;
        self.value = self.next;
        self.changed
    }
}

impl Atom for Wire {
    fn bits(&self) -> usize {
        self.wire_type.width as usize
    }

    fn connected(&self) -> bool {
        self.driven
    }

    fn changed(&self) -> bool {
        self.changed
    }

    fn kind(&self) -> AtomKind {
        self.wire_type.kind
    }

    fn descriptor(&self) -> TypeDescriptor {
        let width = self.bits();
        let kind =
            if self.wire_type.signed { TypeKind::Signed(width) } else { TypeKind::Bits(width) };
        TypeDescriptor { name: self.wire_type.format.clone(), kind }
    }

    fn vcd(&self) -> VCDValue {
        let bit = |i: u32| if self.value >> i & 1 == 1 { vcd::Value::V1 } else { vcd::Value::V0 };
        VCDValue::Vector((0..self.wire_type.width).rev().map(bit).collect())
    }

    fn id(&self) -> usize {
        self.wire_type.id
    }

    fn verilog(&self) -> VerilogLiteral {
        let unsigned = wrapped(self.value, self.wire_type.width, false) as u64;
        unsigned.into()
    }

    fn constraints(&self) -> Vec<PinConstraint> {
        vec![]
    }
}

impl Logic for Wire {
    fn update(&mut self) {}
}

impl Block for Wire {
    fn connect_all(&mut self) {}

    fn update_all(&mut self) {
        self.settle();
    }

    fn has_changed(&self) -> bool {
        self.changed
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_atom(name, self)
    }
}
