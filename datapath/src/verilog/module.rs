//! One module as text.
use std::fmt::Write;

use super::delay_modules::DelayModules;
use super::delays::{DelayLine, Delays};
use super::gated_sum_modules::GatedSum;
use super::multiplier_modules::{Factor, MultiplierModules};
use super::unread::unread_bits;
use super::{LongDelays, Nets};
use crate::block::{AtomKind, Cell, Module, Wire, WireType};
use crate::design::{NodeId, Op, Register};

/// Names of the modules that a module instantiates.
pub struct Instantiated<'a> {
    /// Those of its children, in order.
    pub children: &'a [String],
    /// Those of delay lines.
    pub delays: &'a DelayModules,
    /// Those of products in multiplier blocks.
    pub multipliers: &'a MultiplierModules,
    /// That of sums of which one summand may be cleared.
    pub gated_sum: &'a str,
}

/// The module called `name`.
pub fn text(
    module: &Module,
    name: &str,
    instantiated: &Instantiated,
    long_delays: LongDelays,
) -> String {
    let delays = Delays::of(module);
    let nets = Nets::with_vectors(module, &delays);
    let writer = Writer { module, delays: &delays, nets: &nets };
    let mut out = String::new();
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(out, "// {}: {}; {}.", module.unit, module.formula, timing(module));
    let _ = writeln!(out, "module {name} (\n{}\n);", writer.ports());
    writer.declarations(&mut out);
    writer.gates(&mut out);
    writer.data_registers(&mut out);
    writer.delay_lines(instantiated.delays, long_delays, &mut out);
    writer.multipliers(instantiated.multipliers, &mut out);
    writer.gated_sums(instantiated.gated_sum, &mut out);
    writer.validity_registers(&mut out);
    writer.instances(instantiated.children, &mut out);
    let unread = unread_bits(module, &nets);
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

/// The ports of a module, a line each.
pub fn ports(module: &Module) -> String {
    let delays = Delays::of(module);
    let nets = Nets::with_vectors(module, &delays);
    Writer { module, delays: &delays, nets: &nets }.ports()
}

/// When what leaves a module belongs to what entered it.
fn timing(module: &Module) -> String {
    let outputs = module.wires().iter().map(Wire::wire_type);
    let mut outputs = outputs.filter(|about| about.kind == AtomKind::OutputParameter);
    if outputs.all(|about| about.still) {
        return "what it gives holds for the frame".to_owned();
    }
    format!("latency {}", clocks(module.stages.1 - module.stages.0))
}

fn clocks(number: u32) -> String {
    format!("{number} clock{}", if number == 1 { "" } else { "s" })
}

/// Whether there is a register in the module or in one below, or a multiplier block, which has a
/// clock also where its registers are not used.
fn needs_clock(module: &Module) -> bool {
    module.cells().any(|c| c.register != Register::None)
        || !module.multipliers().is_empty()
        || module.children().iter().any(|c| needs_clock(&c.module))
}

/// Sign and bounds, as in `signed [15:0]`.
fn shape(wire: &WireType) -> String {
    let sign = if wire.signed { "signed " } else { "" };
    match wire.width {
        1 => sign.trim_end().to_owned(),
        width => format!("{sign}[{}:0]", width - 1),
    }
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

fn declaration(net: &str, about: &WireType) -> String {
    let shape = shape(about);
    let shape = if shape.is_empty() { shape } else { format!("{shape} ") };
    format!("{net} {shape}{}", about.name)
}

/// Whether a cell is a read-only memory, which only statements can describe.
fn is_table(cell: &Cell) -> bool {
    matches!(cell.op, Op::LookUp(..))
}

/// Whether a cell only delays a signal by a clock.
fn is_delay(cell: &Cell) -> bool {
    cell.register == Register::Data && matches!(cell.op, Op::Copy(_))
}

/// The format, and the fact that the width rests on.
fn described(WireType { format, fact, .. }: &WireType) -> String {
    fact.as_ref().map_or_else(|| format.clone(), |fact| format!("{format}, since {fact}"))
}

/// The most registers in a block. Yosys takes time with the square of their number.
const BLOCK: usize = 64;

/// A module, and what its text makes of its registers.
struct Writer<'a> {
    module: &'a Module,
    delays: &'a Delays,
    nets: &'a Nets<'a>,
}

impl<'a> Writer<'a> {
    fn wire(&self, number: u32) -> &'a WireType {
        self.module.wires()[number as usize].wire_type()
    }

    fn is_local(&self, number: u32) -> bool {
        self.wire(number).kind == AtomKind::LocalSignal
    }

    /// Registers of a kind that are part of no line.
    fn registers(&self, kind: Register) -> impl Iterator<Item = &'a Cell> {
        let delays = self.delays;
        self.cells().filter(move |cell| cell.register == kind && !delays.contains(cell.wire))
    }

    /// Cells that are not inside a multiplier block.
    fn cells(&self) -> impl Iterator<Item = &'a Cell> {
        let delays = self.delays;
        self.module.cells().filter(move |cell| !delays.in_block(cell.wire))
    }

    /// The cell that makes a variable of a wire: its register, or a table.
    fn variable_of(&self, wire: u32) -> Option<&'a Cell> {
        let is_variable = |cell: &&Cell| cell.register != Register::None || is_table(cell);
        let cell = self.cells().find(|cell| cell.wire == wire).filter(is_variable);
        cell.filter(|_| !self.delays.contains(wire))
    }

    fn ports(&self) -> String {
        let module = self.module;
        let mut rows: Vec<[String; 3]> = vec![];
        if needs_clock(module) {
            rows.push(["input wire".into(), "clock".into(), String::new()]);
        }
        for (number, about) in module.wires().iter().map(Wire::wire_type).enumerate() {
            let (direction, stage) = match about.kind {
                AtomKind::InputParameter => {
                    ("input wire".to_owned(), about.stage.saturating_sub(module.stages.0))
                }
                AtomKind::OutputParameter => {
                    let variable = self.variable_of(number as u32).is_some();
                    let net = if variable { "reg" } else { "wire" };
                    (format!("output {net}"), module.stages.1 - module.stages.0)
                }
                _ => continue,
            };
            let kind = format!("{direction} {}", shape(about)).trim_end().to_owned();
            let when = if about.still {
                "holds for the frame".to_owned()
            } else {
                format!("clock {stage}")
            };
            let comment = match (about.name.as_str(), about.width) {
                ("reset", _) => "synchronous; clears validity".to_owned(),
                (_, 1) => format!("bit, {when}"),
                _ => format!("{}, {when}", about.format),
            };
            let row = [kind, about.name.clone(), comment];
            // Reset belongs beside the clock.
            if about.name == "reset" { rows.insert(1, row) } else { rows.push(row) }
        }
        // The validity of a unit's loops is asked for last.
        rows.sort_by_key(|[kind, ..]| kind.starts_with("output"));
        aligned_rows(&rows)
    }

    /// Registers, delays, then nets that lines and children drive.
    fn declarations(&self, out: &mut String) {
        for number in (0..self.module.wires().len() as u32).filter(|&number| self.is_local(number))
        {
            if self.variable_of(number).is_some_and(|cell| !is_delay(cell)) {
                let about = self.wire(number);
                let _ = writeln!(out, "  {};  // {}", declaration("reg", about), about.format);
            }
        }
        for chain in self.short_delays() {
            let names: Vec<&str> = chain.iter().map(|about| about.name.as_str()).collect();
            let kind = format!("reg {}", shape(chain[0])).trim_end().to_owned();
            let _ = writeln!(out, "  {kind} {};  // {}", names.join(", "), chain[0].format);
        }
        for line in &self.delays.validity {
            let clocks = line.clocks();
            let _ =
                writeln!(out, "  reg [{clocks}:1] {};  // bits, clocks 1 to {clocks}", line.name);
        }
        let of_lines = self.delays.lines.iter().map(DelayLine::output);
        let of_children =
            self.module.children().iter().flat_map(|child| child.outputs.iter().map(|pair| pair.1));
        let of_blocks = self.module.multipliers().iter().map(|block| block.product.0);
        let of_sums = self.delays.gated_sums.iter().map(|of| of.sum);
        let driven = of_lines.chain(of_children).chain(of_blocks).chain(of_sums);
        for wire in driven.filter(|&wire| self.is_local(wire)) {
            let about = self.wire(wire);
            let _ = writeln!(out, "  {};  // {}", declaration("wire", about), about.format);
        }
    }

    /// Local delay registers that are part of no line, those that follow each other together.
    fn short_delays(&self) -> Vec<Vec<&'a WireType>> {
        let mut chains: Vec<Vec<&WireType>> = vec![];
        let mut last = None;
        for number in (0..self.module.wires().len() as u32).filter(|&number| self.is_local(number))
        {
            let Some(cell) = self.variable_of(number).filter(|cell| is_delay(cell)) else {
                continue;
            };
            let follows = last.is_some() && cell.op.operands().next().map(|o| o.0) == last;
            match chains.last_mut() {
                Some(chain) if follows => chain.push(self.wire(number)),
                _ => chains.push(vec![self.wire(number)]),
            }
            last = Some(number);
        }
        chains
    }

    fn gates(&self, out: &mut String) {
        let is_gate =
            |cell: &&Cell| cell.register == Register::None && cell.op.constant().is_none();
        let printed = |cell: &&Cell| is_gate(cell) && !self.delays.is_gated_sum(cell.wire);
        for cell in self.cells().filter(printed) {
            let about = self.wire(cell.wire);
            if is_table(cell) {
                let _ =
                    writeln!(out, "  always @(*) begin\n    {}\n  end", self.nets.assignment(cell));
                continue;
            }
            let value = self.nets.expression(cell);
            let _ = match about.kind {
                AtomKind::OutputParameter => writeln!(out, "  assign {} = {value};", about.name),
                _ => writeln!(
                    out,
                    "  {} = {value};  // {}",
                    declaration("wire", about),
                    described(about)
                ),
            };
        }
        for line in &self.delays.validity {
            for (&wire, clock) in line.stages.iter().zip(1..) {
                if !self.is_local(wire) {
                    let name = &self.wire(wire).name;
                    let _ = writeln!(out, "  assign {name} = {}[{clock}];", line.name);
                }
            }
        }
    }

    fn data_registers(&self, out: &mut String) {
        let (delays, computed): (Vec<&Cell>, Vec<&Cell>) =
            self.registers(Register::Data).partition(|cell| is_delay(cell));
        self.blocks(&computed, out);
        if !delays.is_empty() || !self.delays.lines.is_empty() {
            out.push_str("\n  // Delays, so that what belongs together arrives together.");
        }
        self.blocks(&delays, out);
    }

    fn blocks(&self, cells: &[&Cell], out: &mut String) {
        if !cells.is_empty() {
            out.push('\n');
        }
        for block in cells.chunks(BLOCK) {
            out.push_str("  always @(posedge clock) begin\n");
            for cell in block {
                let _ = writeln!(out, "    {}", self.nets.assignment(cell));
            }
            out.push_str("  end\n");
        }
    }

    fn delay_lines(&self, modules: &DelayModules, long: LongDelays, out: &mut String) {
        if !self.delays.lines.is_empty() && self.registers(Register::Data).all(|c| !is_delay(c)) {
            out.push('\n');
        }
        for line in &self.delays.lines {
            let kind = modules.instantiated(line, self.wire(line.input).width, long);
            let [input, output] = [line.input, line.output()].map(|wire| self.nets.name(wire));
            let name = &line.name;
            let _ = writeln!(out, "  {kind} {name} (.clock(clock), .d({input}), .q({output}));");
        }
    }

    fn multipliers(&self, modules: &MultiplierModules, out: &mut String) {
        for block in self.module.multipliers() {
            let shapes = block.factors.map(|factor| Factor::of(self.wire(factor.0)));
            let product = self.wire(block.product.0);
            let kind = modules.instantiated(block, shapes, product.width);
            let [a, b] = block.factors.map(|factor| self.nets.value(factor));
            let (name, product) = (self.delays.block_name(block.product), &product.name);
            let _ = writeln!(
                out,
                "\n  {kind} {name} (\n    .clock(clock), .a({a}), .b({b}), .p({product})\n  );"
            );
        }
    }

    fn gated_sums(&self, kind: &str, out: &mut String) {
        for &GatedSum { sum, clear, kept, gated, added } in &self.delays.gated_sums {
            let (name, width) = (self.delays.block_name(NodeId(sum)), self.wire(sum).width);
            let [a, gated, b] = [kept, gated, added].map(|id| self.nets.extended(id, width));
            let (clear, sum) = (self.nets.value(clear), self.nets.name(sum));
            let _ = writeln!(
                out,
                "\n  {kind} #(.WIDTH({width})) {name} (\n    .clear({clear}), .a({a}), \
                 .gated_a({gated}), .b({b}), .s({sum})\n  );"
            );
        }
    }

    fn validity_registers(&self, out: &mut String) {
        let of_line = |line: &DelayLine| {
            let (name, clocks) = (&line.name, line.clocks());
            let kept = if clocks == 2 { "1".to_owned() } else { format!("{}:1", clocks - 1) };
            let next = format!("{{{name}[{kept}], {}}}", self.nets.name(line.input));
            (name.clone(), format!("{clocks}'d0"), next)
        };
        let alone = |cell: &Cell| {
            (self.nets.name(cell.wire).to_owned(), "1'b0".into(), self.nets.expression(cell))
        };
        let registers: Vec<(String, String, String)> = (self.delays.validity.iter().map(of_line))
            .chain(self.registers(Register::Validity).map(alone))
            .collect();
        if registers.is_empty() {
            return;
        }
        out.push_str("\n  always @(posedge clock) begin\n    if (reset) begin\n");
        for (name, zero, _) in &registers {
            let _ = writeln!(out, "      {name} <= {zero};");
        }
        out.push_str("    end else begin\n");
        for (name, _, next) in &registers {
            let _ = writeln!(out, "      {name} <= {next};");
        }
        out.push_str("    end\n  end\n");
    }

    fn instances(&self, children: &[String], out: &mut String) {
        for (child, kind) in self.module.children().iter().zip(children) {
            let mut pins = vec![];
            if needs_clock(&child.module) {
                pins.push(".clock(clock)".to_owned());
            }
            let pin = |pin: u32| &child.module.wires()[pin as usize].wire_type().name;
            pins.extend(
                child
                    .inputs
                    .iter()
                    .chain(&child.outputs)
                    .map(|&(p, w)| format!(".{}({})", pin(p), self.nets.name(w))),
            );
            let _ = writeln!(
                out,
                "\n  {kind} {} (\n    {}\n  );",
                child.module.instance,
                pins.join(",\n    ")
            );
        }
    }
}
