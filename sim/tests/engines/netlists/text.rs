//! Netlists and runs as text, a line for each thing:
//!
//! ```text
//! # what was wrong
//! unit 0                      a unit in the core (the core is unit 0)
//! table 5 0 -3
//! 0 input 0..1                signals in order: valid, start, ...
//! 3 reg add 1 2 : 0..2 @1     with a register, in unit 1
//! inputs 2 -                  the data inputs; - for a port that is constant
//! outputs 3
//! leaves 0 after 4            the bit that says a pixel leaves, and the latency
//! span 3 : -7 0               pixels and inputs
//! bubbles 7                   the seed of bubbles before pixels
//! window 3..9                 the clocks that a late run leads to
//! watch 3 2
//! run fast 64 avx2 2 100      batch, instruction set, threads, clocks of a thread's piece; or: run rust-hdl
//! ```
mod read;

use std::fmt::Write;

use specula_datapath::design::{Node, NodeId, Op, Register, ScopeId};
use specula_sim::fast::Settings;

use crate::netlists::case::{Case, Subject};

pub use read::parse;

/// A case as text.
pub fn print(case: &Case) -> String {
    let design = &case.design;
    let mut out = String::new();
    // Writing to a String cannot fail.
    for parent in design.scopes.iter().filter_map(|s| s.parent) {
        let _ = writeln!(out, "unit {}", parent.0);
    }
    for table in &design.tables {
        let _ = writeln!(out, "table {}", joined(&table.entries));
    }
    for (id, node) in design.iter() {
        let _ = writeln!(out, "{} {}", id.0, signal(node));
    }
    let number = |id: &Option<NodeId>| id.map_or("-".to_owned(), |id| id.0.to_string());
    let _ =
        writeln!(out, "inputs {}", joined(&design.inputs.iter().map(number).collect::<Vec<_>>()));
    let _ = writeln!(out, "outputs {}", numbers(&design.outputs));
    let _ = writeln!(out, "leaves {} after {}", design.valid_out.0, design.latency());
    for packet in &case.packets {
        let _ = writeln!(out, "span {} : {}", packet.length, joined(&packet.inputs));
    }
    if let Some(seed) = case.bubbles {
        let _ = writeln!(out, "bubbles {seed}");
    }
    if let Some(window) = &case.window {
        let _ = writeln!(out, "window {}..{}", window.start, window.end);
    }
    let _ = writeln!(out, "watch {}", numbers(&case.watched));
    let _ = writeln!(out, "run {}", subject(case.subject));
    out
}

fn subject(subject: Subject) -> String {
    match subject {
        Subject::Fast(Settings { batch, instruction_set, threads, piece }) => {
            format!("fast {batch} {} {threads} {piece}", instruction_set.name())
        }
        Subject::RustHdl => "rust-hdl".to_owned(),
    }
}

fn joined<T: ToString>(values: &[T]) -> String {
    values.iter().map(T::to_string).collect::<Vec<_>>().join(" ")
}

fn numbers(nodes: &[NodeId]) -> String {
    joined(&nodes.iter().map(|id| id.0).collect::<Vec<_>>())
}

fn signal(node: &Node) -> String {
    let register = match node.register {
        Register::None => "",
        Register::Data => "reg ",
        Register::Validity => "valid ",
    };
    let unit =
        if node.scope == ScopeId::TOP { String::new() } else { format!(" @{}", node.scope.0) };
    format!("{register}{} : {}..{}{unit}", operator(node.op), node.range.low, node.range.high)
}

fn operator(op: Op) -> String {
    let (name, number) = match op {
        Op::Input => ("input", None),
        Op::Constant(value) => return format!("constant {value}"),
        Op::Copy(_) => ("copy", None),
        Op::Add(..) => ("add", None),
        Op::Sub(..) => ("sub", None),
        Op::Mul(..) => ("mul", None),
        Op::ShiftLeft(_, bits) => ("left", Some(bits)),
        Op::ShiftRight(_, bits) => ("right", Some(bits)),
        Op::Wrap(_) => ("wrap", None),
        Op::LessThan(..) => ("less", None),
        Op::And(..) => ("and", None),
        Op::Or(..) => ("or", None),
        Op::Not(_) => ("not", None),
        Op::Select(..) => ("select", None),
        Op::LookUp(_, table) => ("look_up", Some(table.0)),
    };
    let words = op.operands().map(|o| o.0).chain(number).map(|n| format!(" {n}"));
    format!("{name}{}", words.collect::<String>())
}
