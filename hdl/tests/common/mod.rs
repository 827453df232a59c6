//! Running a design's rust-hdl block clock by clock.
// Each test program takes what it needs.
#![allow(dead_code)]
pub mod draw;

use specula_datapath::block::{Module, simulate};
use specula_datapath::design::{NodeId, Op, Range};
use specula_datapath::{Design, SpanPacket};

use draw::Draw;

/// What is put to the pins for one clock.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Whether a pixel enters.
    pub valid: bool,
    /// Whether it is the first of its span.
    pub start: bool,
    /// Raw values of the data inputs.
    pub inputs: Vec<i64>,
}

impl Drive {
    /// A pixel that is a span of its own.
    pub fn pixel(inputs: Vec<i64>) -> Drive {
        Drive { valid: true, start: true, inputs }
    }

    /// The clocks of a span.
    pub fn span(packet: &SpanPacket) -> impl Iterator<Item = Drive> + '_ {
        (0..packet.length).map(|i| Drive {
            valid: true,
            start: i == 0,
            inputs: packet.inputs.clone(),
        })
    }
}

/// The same clocks with bubbles of 0 to 2 clocks before each. In a bubble within a span the inputs
/// are held and `start` is anything; between spans the inputs are anything, too.
pub fn paused(design: &Design, drives: &[Drive], draw: &mut Draw) -> Vec<Drive> {
    let mut all = vec![];
    for drive in drives {
        for _ in 0..draw.between(0, 2) {
            let start = draw.between(0, 1) == 1;
            let inputs = if drive.start { any_inputs(design, draw) } else { drive.inputs.clone() };
            all.push(Drive { valid: false, start, inputs });
        }
        all.push(drive.clone());
    }
    all
}

fn any_inputs(design: &Design, draw: &mut Draw) -> Vec<i64> {
    let any = |input: &Option<NodeId>| {
        let range = input.map_or(Range::single(0), |id| design.node(id).range);
        range.low + (draw.unit() * range.extent()) as i64
    };
    design.inputs.iter().map(any).collect()
}

/// A design's block, from reset on.
pub struct Runner<'a> {
    design: &'a Design,
    block: Module,
    /// Path and wire of each signal.
    places: Vec<Option<(Vec<usize>, usize)>>,
    /// Whether a pixel entered, for each clock so far.
    entered: Vec<bool>,
}

impl<'a> Runner<'a> {
    /// The block of `design` after one clock in reset.
    pub fn new(design: &'a Design) -> Runner<'a> {
        let block = design.to_block();
        let mut places = vec![None; design.nodes.len()];
        place(&block, &mut vec![], &mut places);
        let mut runner = Runner { design, block, places, entered: vec![] };
        runner.block.set_reset(true);
        runner.edge();
        runner.block.set_reset(false);
        runner
    }

    /// Puts values to the pins and waits until nothing changes any more.
    pub fn apply(&mut self, drive: &Drive) {
        self.set(self.design.valid, i64::from(drive.valid));
        self.set(self.design.start, i64::from(drive.start));
        for (pin, &raw) in self.design.inputs.iter().zip(&drive.inputs) {
            if let Some(pin) = *pin {
                self.set(pin, raw);
            }
        }
        self.settle();
        self.entered.push(drive.valid);
    }

    /// The clock rises and falls.
    pub fn edge(&mut self) {
        self.block.set_clock(true);
        self.settle();
        self.block.set_clock(false);
        self.settle();
    }

    /// The raw value of a signal; `None` for a constant, which has no wire of its own.
    pub fn value(&self, node: NodeId) -> Option<i64> {
        let (path, wire) = self.places[node.0 as usize].as_ref()?;
        let module =
            path.iter().fold(&self.block, |module, &child| &module.children()[child].module);
        Some(module.wires()[*wire].value())
    }

    /// Whether a signal carries a pixel's value in this clock.
    pub fn carries_a_pixel(&self, node: NodeId) -> bool {
        let stage = self.design.node(node).stage as usize;
        let entry = (self.entered.len() - 1).checked_sub(stage);
        entry.is_some_and(|clock| self.entered[clock])
    }

    fn set(&mut self, pin: NodeId, raw: i64) {
        if let Some((_, wire)) = &self.places[pin.0 as usize] {
            self.block.set(*wire as u32, raw);
        }
    }

    fn settle(&mut self) {
        assert!(simulate(&mut self.block, 1000), "the design does not settle");
    }
}

fn place(module: &Module, path: &mut Vec<usize>, places: &mut [Option<(Vec<usize>, usize)>]) {
    for (number, wire) in
        module.wires().iter().enumerate().filter(|(_, w)| w.wire_type().name != "reset")
    {
        places[wire.wire_type().node.0 as usize] = Some((path.clone(), number));
    }
    for (number, child) in module.children().iter().enumerate() {
        path.push(number);
        place(&child.module, path, places);
        path.pop();
    }
}

/// Runs a design and gives the outputs of every pixel, in order. In every clock, each signal that
/// carries a pixel's value must lie in its proven range, every stated fact must hold, and a pixel
/// must leave exactly when one that entered is due.
pub fn run(design: &Design, drives: impl IntoIterator<Item = Drive>) -> Vec<Vec<i64>> {
    let mut runner = Runner::new(design);
    let mut pixels = vec![];
    let mut last = None;
    let mut step = |drive: &Drive| {
        runner.apply(drive);
        let faults = faults(design, &runner);
        assert!(faults.is_empty(), "clock {}:\n{}", runner.entered.len() - 1, faults.join("\n"));
        let due = runner.carries_a_pixel(design.valid_out);
        assert_eq!(
            runner.value(design.valid_out),
            Some(i64::from(due)),
            "clock {}",
            runner.entered.len() - 1
        );
        if due {
            pixels.push(
                design
                    .outputs
                    .iter()
                    .map(|&output| output_value(design, &runner, output))
                    .collect(),
            );
        }
        runner.edge();
    };
    for drive in drives {
        step(&drive);
        last = Some(drive);
    }
    let idle = Drive {
        valid: false,
        start: false,
        inputs: last.map(|drive| drive.inputs).unwrap_or_default(),
    };
    for _ in 0..=design.latency() {
        step(&idle);
    }
    pixels
}

fn output_value(design: &Design, runner: &Runner, output: NodeId) -> i64 {
    match design.node(output).op {
        Op::Constant(value) => value,
        _ => runner.value(output).expect("an output has a wire"),
    }
}

/// What is wrong in this clock, said in words.
fn faults(design: &Design, runner: &Runner) -> Vec<String> {
    let value = |node| runner.value(node).filter(|_| runner.carries_a_pixel(node));
    let outside = design.iter().filter_map(|(id, node)| {
        let raw = value(id).filter(|&raw| !node.range.contains(raw))?;
        Some(format!(
            "{} = {raw} is outside its proven range {:?}",
            design.full_name(id),
            node.range
        ))
    });
    let untrue = design.assumptions.iter().filter_map(|a| {
        let raw = value(a.node).filter(|&raw| !a.range.contains(raw))?;
        Some(format!(
            "{} = {raw} is against \"{}\", {:?}",
            design.full_name(a.node),
            a.fact,
            a.range
        ))
    });
    untrue.chain(outside).collect()
}
