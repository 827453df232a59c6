//! What a target's clock makes of sums, products and delays.

use specula_datapath::builder::Sig;
use specula_datapath::design::{Op, Primitives};
use specula_datapath::pass::{Pipelining, compile};
use specula_datapath::target::Target;
use specula_datapath::verilog::{self, Delays, Header, LongDelays};
use specula_datapath::{Builder, Design, Format, InputPort};

/// A design for an ECP5 at 250 MHz of what `body` makes of two signals of 16 bits.
fn design(body: impl FnOnce(&Builder, [Sig; 2]) -> Sig) -> Design {
    design_at(250.0, body)
}

/// The same at so many MHz.
fn design_at(mhz: f64, body: impl FnOnce(&Builder, [Sig; 2]) -> Sig) -> Design {
    let builder = Builder::new("core", "f(x, y)");
    let control = builder.control();
    let port = |name| InputPort::whole(name, Format::unsigned(16, 0));
    let inputs = ["x", "y"].map(|name| builder.input(&port(name)));
    let out = body(&builder, inputs);
    let graph = builder.graph(&control.valid, &[("out", out)]).expect("it can be built");
    let target = Target::named("ecp5").expect("there is one");
    let pipelining = Pipelining::ForClock { target: &target, mhz };
    compile(&graph, &pipelining).expect("no loop is late")
}

/// x + y leaves a unit as the adder gives it, and waits for three squares: a flip-flop is before the
/// memory that delays it.
#[test]
fn a_delay_memory_takes_what_a_register_gives() {
    let late = |builder: &Builder, [x, y]: [Sig; 2]| {
        let sum = builder.unit("sum", "x + y", (("x", &x), ("y", &y)), |_, (x, y)| x + y);
        let low = |value: Sig| value.low_bits(9);
        sum + low(low(x.squared()).squared()).squared()
    };
    let design = design(late);
    assert!(memories_take_what_registers_give(&design));
    let primitives = Primitives { registered_memories: false, ..design.primitives };
    assert!(!memories_take_what_registers_give(&Design { primitives, ..design }));
}

/// Whether registers lead to every memory of a core, of which there is one at least, by wires alone.
fn memories_take_what_registers_give(design: &Design) -> bool {
    let core = design.to_block();
    let lines = Delays::of(&core).lines;
    let memories: Vec<_> =
        lines.iter().filter(|line| line.is_memory(LongDelays::Memories)).collect();
    assert!(!memories.is_empty());
    memories.iter().all(|line| core.wires()[line.input as usize].wire_type().stored)
}

/// 3x - 7y: 7 is 8 - 1, so what is computed is -7y = y - 8y, and it is added.
#[test]
fn a_sum_takes_over_the_sign_of_a_product() {
    let terms = |builder: &Builder, [x, y]: [Sig; 2]| {
        let [three, seven] = [3, 7].map(|factor| builder.integer(factor));
        x * three - y * seven
    };
    let design = design(terms);
    let subtracts_from_zero = |op: &Op| {
        let Op::Sub(zero, _) = op else { return false };
        design.node(*zero).op == Op::Constant(0)
    };
    assert!(!design.nodes.iter().any(|node| subtracts_from_zero(&node.op)));
    let names: Vec<&str> = design.nodes.iter().map(|node| node.name.as_str()).collect();
    assert!(names.iter().any(|name| name.contains("negative")), "{names:?}");
}

/// A slow product takes its block without registers, so that nothing else in its unit has a clock: the
/// block's pin has one all the same.
#[test]
fn a_block_without_registers_has_a_clock() {
    let product = |builder: &Builder, [x, y]: [Sig; 2]| {
        builder.unit("product", "x y", (("x", &x), ("y", &y)), |_, (x, y)| x * y)
    };
    let design = design_at(20.0, product);
    assert_eq!(design.multipliers.iter().map(|block| block.registers).max(), Some(0));
    let text = verilog::print(&design.to_block(), &Header::default());
    let (_, module) = text.split_once("\nmodule core_product (").expect("the unit is a module");
    let (ports, body) = module.split_once(");").expect("it has ports");
    assert!(ports.split_whitespace().any(|word| word == "clock,"), "{ports}");
    assert!(body.contains(".clock(clock), .a(x), .b(y)"), "{body}");
}
