//! Inputs that hold for a frame: what is computed of them is there at any time.

use specula_datapath::builder::Sig;
use specula_datapath::design::{Node, Op};
use specula_datapath::graph::Graph;
use specula_datapath::pass::{Pipelining, compile};
use specula_datapath::target::Target;
use specula_datapath::verilog::{self, Header};
use specula_datapath::{Builder, Design, Format, Hold, InputPort};

/// A design of what `body` makes of x, which is held for a span, and c, which is held as `hold` says.
fn design(hold: Hold, body: impl FnOnce(&Builder, [Sig; 2], &Sig) -> Sig) -> Design {
    compile(&graph(hold, body), &Pipelining::EachOperator).expect("no loop is late")
}

fn graph(hold: Hold, body: impl FnOnce(&Builder, [Sig; 2], &Sig) -> Sig) -> Graph {
    let builder = Builder::new("core", "f(x, c)");
    let control = builder.control();
    let port = |name| InputPort::whole(name, Format::unsigned(4, 0));
    let x = builder.input(&port("x"));
    let c = builder.input(&InputPort { hold, ..port("c") });
    let out = body(&builder, [x, c], &control.start);
    builder.graph(&control.valid, &[("out", out)]).expect("it can be built")
}

fn node<'a>(design: &'a Design, name: &str) -> &'a Node {
    design.nodes.iter().find(|node| node.name == name).expect("there is one")
}

/// Registers that only delay something.
fn delays(design: &Design) -> usize {
    let delays = |node: &&Node| node.registered() && matches!(node.op, Op::Copy(_));
    // Validity is not data.
    design.nodes.iter().filter(delays).filter(|node| node.width() > 1).count()
}

/// (x + 1 + 1)·c: c is read two clocks after x.
#[test]
fn what_holds_for_a_frame_is_read_without_delays() {
    let late = |builder: &Builder, [x, c]: [Sig; 2], _: &Sig| {
        let one = builder.integer(1);
        (x + &one + one) * c
    };
    let [span, frame] = [Hold::Span, Hold::Frame].map(|hold| design(hold, late));
    assert_eq!((span.latency(), delays(&span)), (3, 2));
    assert_eq!((frame.latency(), delays(&frame)), (3, 0));
    assert_eq!((frame.frame_inputs(), frame.settling()), (vec![1], 0));
    assert_eq!((span.frame_inputs(), span.settling()), (vec![], 0));
}

/// x + c³, which is ready two clocks after c: x does not wait for it, and the host does.
#[test]
fn what_is_still_moves_no_stage() {
    let early = |_: &Builder, [x, c]: [Sig; 2], _: &Sig| x + (&c * &c * c).named("cube");
    let [span, frame] = [Hold::Span, Hold::Frame].map(|hold| design(hold, early));
    // c for the second product, x for the sum.
    assert_eq!((span.latency(), delays(&span)), (3, 3));
    assert_eq!((frame.latency(), frame.settling()), (1, 2));
    // The second product's operand need not wait for the first.
    assert_eq!(delays(&frame), 0);
    let cube = node(&frame, "cube");
    assert!(cube.still && cube.registered() && cube.stage == 2);
}

/// An accumulator of c is no longer still, though its start and its step are.
#[test]
fn loops_are_not_still() {
    let sum = |_: &Builder, [x, c]: [Sig; 2], start: &Sig| {
        let sum = Sig::accumulated(start, &c, &c, (0.0, 1000.0), 60, "c (i + 1) < 1000");
        sum.named("sum") + x
    };
    let design = design(Hold::Frame, sum);
    assert!(!node(&design, "sum").still && node(&design, "c").still);
    assert_eq!(design.settling(), 0);
}

/// Units: the stage of a port is that of what is not still, and their headers say what holds.
#[test]
fn units_say_what_holds_for_the_frame() {
    let units = |builder: &Builder, [x, c]: [Sig; 2], _: &Sig| {
        let body = |_: &Builder, (c,): (Sig,)| c.squared();
        let squared = builder.unit("square", "c^2", (("c", &c),), body);
        let later = x + builder.integer(1);
        let inputs = (("x", &later), ("c", &squared));
        builder.unit("scale", "x c", inputs, |_, (x, c)| x * c)
    };
    let design = design(Hold::Frame, units);
    assert_eq!((design.latency(), design.settling()), (2, 0));
    let text = verilog::print(&design.to_block(), &Header::default());
    let words: Vec<&str> = text.split_whitespace().collect();
    let text = words.join(" ");
    for line in [
        "input wire [3:0] c, // U4.0, holds for the frame",
        "// square: c^2; what it gives holds for the frame.",
        "// scale: x c; latency 1 clock.",
        "input wire [7:0] c, // U8.0, holds for the frame",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

/// For a clock, too, the products of c have registers behind them, and x waits for none of them.
#[test]
fn what_is_still_moves_no_stage_of_a_schedule_for_a_clock() {
    let target = Target::named("ecp5").expect("there is one");
    let pipelining = Pipelining::ForClock { target: &target, mhz: 200.0 };
    let [span, frame] = [Hold::Span, Hold::Frame].map(|hold| {
        let body = |_: &Builder, [x, c]: [Sig; 2], _: &Sig| x + (&c * &c * c).named("cube");
        compile(&graph(hold, body), &pipelining).expect("no loop is late")
    });
    assert!(frame.latency() < span.latency() && frame.settling() > 0, "{}", frame.settling());
    let delays = |design: &Design| design.size().register_bits;
    assert!(delays(&frame) < delays(&span));
    let still = |node: &&Node| node.still && matches!(node.op, Op::Add(..) | Op::Mul(..));
    assert!(frame.nodes.iter().filter(still).all(Node::registered));
}

/// Only c: it leaves with a pixel all the same, a clock after that has entered.
#[test]
fn what_leaves_may_be_still() {
    let design = design(Hold::Frame, |_, [_, c], _| c.squared().squared());
    assert_eq!((design.latency(), design.settling()), (1, 1));
}
