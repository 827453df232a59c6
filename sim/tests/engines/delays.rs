//! Delay lines of all kinds, in every engine and at every clock.
use specula_datapath::SpanPacket;
use specula_datapath::design::{Design, Node, NodeId, Op, Range, Register, ScopeId};
use specula_datapath::verilog::{self, Header};
use specula_fixtures::{Draw, designs};
use specula_sim::Stimulus;

use crate::{agreement, outputs};

/// Clocks of the lines: on both sides of where registers become a shift register, and of where that
/// becomes a memory, and of where the memory's addresses become wider.
const CLOCKS: [u32; 11] = [1, 3, 4, 5, 31, 32, 33, 34, 65, 66, 67];

/// A design that is made signal by signal.
struct Draft(Design);

impl Draft {
    fn new() -> Draft {
        Draft(designs::empty("delays"))
    }

    fn add(&mut self, name: String, op: Op, register: Register, range: Range) -> NodeId {
        let before = op.operands().map(|operand| self.0.node(operand).stage).max().unwrap_or(0);
        let stage = before + u32::from(register != Register::None);
        let (scope, named) = (ScopeId::TOP, true);
        self.0.nodes.push(Node {
            op,
            register,
            range,
            fraction_bits: 0,
            stage,
            still: false,
            scope,
            name,
            named,
        });
        NodeId(self.0.nodes.len() as u32 - 1)
    }

    /// What `from` was so many clocks before.
    fn delayed(&mut self, from: NodeId, clocks: u32, register: Register) -> NodeId {
        (0..clocks).fold(from, |at, _| {
            let (range, name) = (self.0.node(at).range, format!("n{}", self.0.nodes.len()));
            self.add(name, Op::Copy(at), register, range)
        })
    }

    fn output(&mut self, of: NodeId) {
        let (range, name) = (self.0.node(of).range, format!("out{}", self.0.outputs.len()));
        let output = self.add(name, Op::Copy(of), Register::None, range);
        self.0.outputs.push(output);
        self.0.output_errors.push(0.0);
    }
}

/// Lines of a number and of a bit that is 1 before anything comes in, one line that is read at four
/// places, and validity that is read on its way.
fn design() -> Design {
    let mut draft = Draft::new();
    let number = draft.add("x".into(), Op::Input, Register::None, Range::new(-300, 200));
    draft.0.inputs.push(Some(number));
    let idle = draft.add("idle".into(), Op::Not(draft.0.valid), Register::None, Range::new(0, 1));
    let lines: Vec<NodeId> = [number, idle]
        .into_iter()
        .flat_map(|from| CLOCKS.map(|clocks| (from, clocks)))
        .map(|(from, clocks)| draft.delayed(from, clocks, Register::Data))
        .collect();
    let mut at = number;
    for clocks in [2, 8, 1, 40] {
        at = draft.delayed(at, clocks, Register::Data);
        draft.output(at);
    }
    lines.into_iter().for_each(|line| draft.output(line));
    let early = draft.delayed(draft.0.valid, 7, Register::Validity);
    draft.output(early);
    let last = draft.delayed(early, 63, Register::Validity);
    draft.0.valid_out =
        draft.add("valid_out".into(), Op::Copy(last), Register::Validity, Range::new(0, 1));
    draft.0
}

fn spans() -> Vec<SpanPacket> {
    let mut draw = Draw::new(31);
    let span =
        |_| SpanPacket { length: draw.between(1, 3) as u32, inputs: vec![draw.between(-300, 200)] };
    (0..60).map(span).collect()
}

fn agree(design: &Design, watched: &[NodeId]) {
    let spans = spans();
    let stimulus = Stimulus::whole(&spans, design);
    let (reference, others) = agreement::run_all(design, &stimulus, watched);
    for (engine, columns) in others {
        let first = if engine == "icarus" { u64::from(design.latency()) } else { 0 };
        agreement::assert_same(design, &reference, &columns, first, engine);
    }
}

/// As people get it: long lines are memories.
#[test]
fn what_leaves_agrees() {
    let design = design();
    let text = verilog::print(&design.to_block(), &Header::default());
    let count = |module: &str| text.matches(&format!("  {module} #(")).count();
    assert_eq!([count("core_delay"), count("core_delay_memory")], [9, 11]);
    agree(&design, &outputs(&design));
}

/// As it is traced: every stage of every line is seen.
#[test]
fn every_stage_agrees() {
    let design = design();
    agree(&design, &design.variables());
}
