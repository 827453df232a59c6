//! One module as text.
use std::fmt::Write;

use super::unread::unread_bits;
use crate::block::{AtomKind, Cell, Module, Wire, WireType};
use crate::design::{Op, Register};

/// The module called `name`; `children` are the names of the modules of its children.
pub fn text(module: &Module, name: &str, children: &[String]) -> String {
    let mut out = String::new();
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(
        out,
        "// {}: {}; latency {}.",
        module.unit,
        module.formula,
        clocks(module.stages.1 - module.stages.0)
    );
    let _ = writeln!(out, "module {name} (\n{}\n);", ports(module));
    declarations(module, &mut out);
    gates(module, &mut out);
    registers(module, &mut out);
    instances(module, children, &mut out);
    let unread = unread_bits(module);
    if !unread.is_empty() {
        let _ = writeln!(
            out,
            "\n  // Bits that narrowing drops.\n  wire unused_bits = &{{1'b0, {}}};",
            unread.join(", ")
        );
    }
    out.push_str("endmodule\n");
    out
}

fn clocks(number: u32) -> String {
    format!("{number} clock{}", if number == 1 { "" } else { "s" })
}

/// Whether there is a register in the module or in one below.
fn needs_clock(module: &Module) -> bool {
    module.cells().any(|c| c.register != Register::None)
        || module.children().iter().any(|c| needs_clock(&c.module))
}

fn register_of(module: &Module, wire: usize) -> Option<&Cell> {
    module.cells().find(|c| c.wire as usize == wire && c.register != Register::None)
}

/// Sign and bounds, as in `signed [15:0]`.
fn shape(wire: &WireType) -> String {
    let sign = if wire.signed { "signed " } else { "" };
    match wire.width {
        1 => sign.trim_end().to_owned(),
        width => format!("{sign}[{}:0]", width - 1),
    }
}

/// The ports, a line each.
pub fn ports(module: &Module) -> String {
    let mut rows: Vec<[String; 3]> = vec![];
    if needs_clock(module) {
        rows.push(["input wire".into(), "clock".into(), String::new()]);
    }
    for (number, wire) in module.wires().iter().enumerate() {
        let about = wire.wire_type();
        let (direction, stage) = match about.kind {
            AtomKind::InputParameter => ("input wire".to_owned(), 0),
            AtomKind::OutputParameter => {
                let net = if variable_of(module, number).is_some() { "reg" } else { "wire" };
                (format!("output {net}"), module.stages.1 - module.stages.0)
            }
            _ => continue,
        };
        let kind = format!("{direction} {}", shape(about)).trim_end().to_owned();
        let comment = match (about.name.as_str(), about.width) {
            ("reset", _) => "synchronous; clears validity".to_owned(),
            (_, 1) => format!("bit, clock {stage}"),
            _ => format!("{}, clock {stage}", about.format),
        };
        let row = [kind, about.name.clone(), comment];
        // Reset belongs beside the clock.
        if about.name == "reset" { rows.insert(1, row) } else { rows.push(row) }
    }
    aligned_rows(&rows)
}

/// Port rows in columns, a comma after each but the last.
fn aligned_rows(rows: &[[String; 3]]) -> String {
    let widest = |column: usize| rows.iter().map(|r| r[column].len()).max().unwrap_or(0);
    let (kinds, names) = (widest(0), widest(1) + 1);
    let line = |(i, [kind, name, comment]): (usize, &[String; 3])| {
        let name = format!("{name}{}", if i + 1 < rows.len() { "," } else { "" });
        let comment = if comment.is_empty() { String::new() } else { format!("  // {comment}") };
        format!("    {kind:kinds$} {name:names$}{comment}").trim_end().to_owned()
    };
    rows.iter().enumerate().map(line).collect::<Vec<_>>().join("\n")
}

fn declaration(net: &str, wire: &Wire) -> String {
    let about = wire.wire_type();
    let shape = shape(about);
    let shape = if shape.is_empty() { shape } else { format!("{shape} ") };
    format!("{net} {shape}{}", about.name)
}

/// Whether a cell is a read-only memory, which only statements can describe.
fn is_table(cell: &Cell) -> bool {
    matches!(cell.op, Op::LookUp(..))
}

/// The cell that makes a variable of a wire: its register, or a table.
fn variable_of(module: &Module, wire: usize) -> Option<&Cell> {
    module
        .cells()
        .find(|c| c.wire as usize == wire && (c.register != Register::None || is_table(c)))
}

/// Whether a cell only delays a signal by a clock.
fn is_delay(cell: &Cell) -> bool {
    cell.register == Register::Data && matches!(cell.op, Op::Copy(_))
}

/// Registers, delays, then nets that children drive.
fn declarations(module: &Module, out: &mut String) {
    for (number, wire) in module.wires().iter().enumerate() {
        let register = variable_of(module, number);
        if wire.wire_type().kind == AtomKind::LocalSignal
            && register.is_some_and(|cell| !is_delay(cell))
        {
            let _ =
                writeln!(out, "  {};  // {}", declaration("reg", wire), wire.wire_type().format);
        }
    }
    for chain in delay_chains(module) {
        let names =
            chain.iter().map(|w| w.wire_type().name.as_str()).collect::<Vec<_>>().join(", ");
        let shape = shape(chain[0].wire_type());
        let kind = format!("reg {shape}").trim_end().to_owned();
        let _ = writeln!(out, "  {kind} {names};  // {}", chain[0].wire_type().format);
    }
    for child in module.children() {
        for &(_, wire) in &child.outputs {
            let wire = &module.wires()[wire as usize];
            if wire.wire_type().kind == AtomKind::LocalSignal {
                let _ = writeln!(
                    out,
                    "  {};  // {}",
                    declaration("wire", wire),
                    wire.wire_type().format
                );
            }
        }
    }
}

/// Local delay registers, those that follow each other together.
fn delay_chains(module: &Module) -> Vec<Vec<&Wire>> {
    let mut chains: Vec<Vec<&Wire>> = vec![];
    let mut last = None;
    for (number, wire) in module.wires().iter().enumerate() {
        let Some(cell) = register_of(module, number).filter(|cell| is_delay(cell)) else {
            continue;
        };
        if wire.wire_type().kind != AtomKind::LocalSignal {
            continue;
        }
        let follows = cell.op.operands().next().map(|o| o.0) == last && last.is_some();
        match chains.last_mut() {
            Some(chain) if follows => chain.push(wire),
            _ => chains.push(vec![wire]),
        }
        last = Some(number as u32);
    }
    chains
}

/// The format, and the fact that the width rests on.
fn described(wire: &Wire) -> String {
    let WireType { format, fact, .. } = wire.wire_type();
    fact.as_ref().map_or_else(|| format.clone(), |fact| format!("{format}, since {fact}"))
}

fn gates(module: &Module, out: &mut String) {
    for cell in module.cells().filter(|c| c.register == Register::None && c.op.constant().is_none())
    {
        let wire = &module.wires()[cell.wire as usize];
        if is_table(cell) {
            let _ = writeln!(out, "  always @(*) begin\n    {}\n  end", module.assignment(cell));
            continue;
        }
        let value = module.expression(cell);
        let _ = match wire.wire_type().kind {
            AtomKind::OutputParameter => {
                writeln!(out, "  assign {} = {value};", wire.wire_type().name)
            }
            _ => {
                writeln!(out, "  {} = {value};  // {}", declaration("wire", wire), described(wire))
            }
        };
    }
}

/// The most registers in a block. Yosys takes time with the square of their number.
const BLOCK: usize = 64;

fn registers(module: &Module, out: &mut String) {
    let of = |kind: Register| module.cells().filter(move |c| c.register == kind);
    let name = |cell: &Cell| module.wires()[cell.wire as usize].wire_type().name.clone();
    let (delays, computed): (Vec<&Cell>, Vec<&Cell>) =
        of(Register::Data).partition(|cell| is_delay(cell));
    for (cells, comment) in
        [(computed, ""), (delays, "  // Delays, so that what belongs together arrives together.\n")]
    {
        if !cells.is_empty() {
            let _ = write!(out, "\n{comment}");
        }
        for block in cells.chunks(BLOCK) {
            out.push_str("  always @(posedge clock) begin\n");
            for cell in block {
                let _ = writeln!(out, "    {}", module.assignment(cell));
            }
            out.push_str("  end\n");
        }
    }
    if of(Register::Validity).next().is_some() {
        out.push_str("\n  always @(posedge clock) begin\n    if (reset) begin\n");
        for cell in of(Register::Validity) {
            let _ = writeln!(out, "      {} <= 1'b0;", name(cell));
        }
        out.push_str("    end else begin\n");
        for cell in of(Register::Validity) {
            let _ = writeln!(out, "      {} <= {};", name(cell), module.expression(cell));
        }
        out.push_str("    end\n  end\n");
    }
}

fn instances(module: &Module, children: &[String], out: &mut String) {
    for (child, kind) in module.children().iter().zip(children) {
        let mut pins = vec![];
        if needs_clock(&child.module) {
            pins.push(".clock(clock)".to_owned());
        }
        let net = |wire: u32| &module.wires()[wire as usize].wire_type().name;
        let pin = |pin: u32| &child.module.wires()[pin as usize].wire_type().name;
        pins.extend(
            child
                .inputs
                .iter()
                .chain(&child.outputs)
                .map(|&(p, w)| format!(".{}({})", pin(p), net(w))),
        );
        let _ = writeln!(
            out,
            "\n  {kind} {} (\n    {}\n  );",
            child.module.instance,
            pins.join(",\n    ")
        );
    }
}
