//! Where the Verilog of a design has each signal, for those who look for it in a simulator's trace.
use std::collections::HashMap;

use super::delay_modules::LINE;
use super::delays::Delays;
use super::multiplier_modules::places_inside;
use crate::block::{AtomKind, Module};
use crate::design::NodeId;

/// Where a signal is: bits of a net.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The instances that it is in, from the core inwards, the core apart.
    pub path: Vec<String>,
    /// The net.
    pub net: String,
    /// The net's bit that is the signal's lowest, counted from the net's own lowest bit.
    pub low_bit: u32,
}

/// The places of all signals that are no constants, in a text whose long delays are shift
/// registers.
pub fn places(core: &Module) -> HashMap<NodeId, Place> {
    let mut places = HashMap::new();
    add(core, &[], &mut places);
    places
}

fn add(module: &Module, path: &[String], places: &mut HashMap<NodeId, Place>) {
    let wire_type = |wire: u32| module.wires()[wire as usize].wire_type();
    let mut place = |wire: u32, path: &[String], net: &str, low_bit: u32| {
        let place = Place { path: path.to_vec(), net: net.to_owned(), low_bit };
        places.insert(wire_type(wire).node, place);
    };
    for wire in (0..module.wires().len() as u32).filter(|&wire| !module.is_reset(wire)) {
        if wire_type(wire).kind != AtomKind::Constant {
            place(wire, path, &wire_type(wire).name, 0);
        }
    }
    let delays = Delays::of(module);
    for line in &delays.lines {
        let inside = inner(path, &line.name);
        for (&wire, before) in line.stages[..line.clocks() - 1].iter().zip(0..) {
            place(wire, &inside, LINE, before * wire_type(wire).width);
        }
    }
    for line in &delays.validity {
        for (&wire, before) in line.stages.iter().zip(0..) {
            if wire_type(wire).kind == AtomKind::LocalSignal {
                place(wire, path, &line.name, before);
            }
        }
    }
    for block in module.multipliers() {
        for (wire, scope, net) in places_inside(block) {
            let path = inner(&inner(path, delays.block_name(block.product)), scope);
            place(wire.0, &path, net, 0);
        }
    }
    for child in module.children() {
        add(&child.module, &inner(path, &child.module.instance), places);
    }
}

fn inner(path: &[String], instance: &str) -> Vec<String> {
    path.iter().cloned().chain([instance.to_owned()]).collect()
}
