//! MULT18X18D: products, latencies, clock enables and resets.
use std::fmt::Write;

use crate::bench::{Device, bits, refusal};

/// Registers of a block, in the order of [`Inputs::enables`] and [`Inputs::resets`].
const REGISTERS: [&str; 4] = ["INPUTA", "INPUTB", "PIPELINE", "OUTPUT"];

/// What goes in for a clock.
#[derive(Clone, Copy, Default)]
struct Inputs {
    a: u64,
    b: u64,
    signed_a: bool,
    signed_b: bool,
    /// Bit k is the enable of register k.
    enables: u64,
    /// Bit k is the reset of register k.
    resets: u64,
}

impl Inputs {
    /// All registers enabled, none reset.
    fn product(a: u64, b: u64, signs: u64) -> Inputs {
        let [signed_a, signed_b] = [signs & 1 == 1, signs & 2 == 2];
        Inputs { a, b, signed_a, signed_b, enables: 15, resets: 0 }
    }

    fn line(&self) -> Vec<u64> {
        let signs = [self.signed_a, self.signed_b].map(u64::from);
        vec![self.a, self.b, signs[0], signs[1], self.enables, self.resets]
    }
}

/// A value with its signedness, or a product with that of either operand.
type Held = (u64, bool);

/// A block: which registers it has, and what they hold.
struct Block {
    registers: [bool; 4],
    asynchronous: bool,
    held: [Held; 4],
}

impl Block {
    /// Bit k of `number` says whether register k is there.
    fn new(number: usize, asynchronous: bool) -> Block {
        let registers = [0, 1, 2, 3].map(|register| number >> register & 1 == 1);
        Block { registers, asynchronous, held: [(0, false); 4] }
    }

    /// Takes a clock's inputs, and gives product and sign before its edge.
    fn step(&mut self, inputs: &Inputs) -> [u64; 2] {
        let is_reset = |register: usize| inputs.resets >> register & 1 == 1;
        if self.asynchronous {
            (0..4).filter(|&k| is_reset(k)).for_each(|k| self.held[k] = (0, false));
        }
        let shown = |k: usize, given: Held| if self.registers[k] { self.held[k] } else { given };
        let given_a = (inputs.a, inputs.signed_a);
        let given_b = (inputs.b, inputs.signed_b);
        let (a, b) = (shown(0, given_a), shown(1, given_b));
        let product = (extended(a).wrapping_mul(extended(b)) as u64 & MASK, a.1 || b.1);
        let pipelined = shown(2, product);
        let output = shown(3, pipelined);
        for (k, next) in [given_a, given_b, product, pipelined].into_iter().enumerate() {
            if is_reset(k) {
                self.held[k] = (0, false);
            } else if inputs.enables >> k & 1 == 1 {
                self.held[k] = next;
            }
        }
        [output.0, u64::from(pipelined.1)]
    }
}

const MASK: u64 = (1 << 36) - 1;

/// The number that 18 bits stand for.
fn extended((bits, signed): Held) -> i64 {
    let negative = signed && bits >> 17 == 1;
    bits as i64 - if negative { 1 << 18 } else { 0 }
}

/// One block for each choice of registers, side by side.
fn instances(mode: &str) -> String {
    let mut text = String::new();
    for number in 0..16 {
        let parameters: String = REGISTERS
            .iter()
            .enumerate()
            .map(|(k, name)| {
                let clock = if number >> k & 1 == 1 { format!("CLK{k}") } else { "NONE".into() };
                format!(
                    ".REG_{name}_CLK(\"{clock}\"), .REG_{name}_CE(\"CE{k}\"), \
                     .REG_{name}_RST(\"RST{k}\"), "
                )
            })
            .collect();
        let (product, sign) = (2 * number, 2 * number + 1);
        let _ = writeln!(
            text,
            "  wire [35:0] out_{product};\n  wire out_{sign};\n  MULT18X18D #({parameters}\
             .RESETMODE(\"{mode}\")) block_{number} ({}{}{}{}{}.CLK0(clock), .CLK1(clock), \
             .CLK2(clock), .CLK3(clock), .SIGNEDA(signed_a), .SIGNEDB(signed_b), \
             .SOURCEA(1'b0), .SOURCEB(1'b0), .SIGNEDP(out_{sign}));",
            bits("A", "a", 18),
            bits("B", "b", 18),
            bits("P", &format!("out_{product}"), 36),
            bits("CE", "enables", 4),
            bits("RST", "resets", 4),
        );
    }
    text
}

/// Runs all choices of registers, and compares every clock.
fn agree(inputs: &[Inputs], asynchronous: bool) {
    let device = Device {
        model: "MULT18X18D.v",
        inputs: &[
            ("a", 18),
            ("b", 18),
            ("signed_a", 1),
            ("signed_b", 1),
            ("enables", 4),
            ("resets", 4),
        ],
        instances: instances(if asynchronous { "ASYNC" } else { "SYNC" }),
        outputs: 32,
    };
    let lines: Vec<Vec<u64>> = inputs.iter().map(Inputs::line).collect();
    let Some(found) = device.run(&lines) else { return };
    let mut blocks: Vec<Block> = (0..16).map(|number| Block::new(number, asynchronous)).collect();
    assert_eq!(found.len(), inputs.len());
    for (clock, (inputs, found)) in inputs.iter().zip(found).enumerate() {
        for (number, block) in blocks.iter_mut().enumerate() {
            let expected = block.step(inputs);
            assert_eq!(found[2 * number..][..2], expected, "clock {clock}, registers {number:04b}");
        }
    }
}

#[test]
fn small_operands_give_their_products_whatever_their_signs() {
    let near_zero = |k: u64| k.wrapping_sub(8) & 0x3ffff;
    let near_the_ends = |k: u64| (0x1fff8 + k) & 0x3ffff;
    let mut inputs = vec![];
    for operand in [near_zero, near_the_ends] {
        for signs in 0..4 {
            let pairs = (0..16).flat_map(|a| (0..16).map(move |b| (a, b)));
            inputs.extend(pairs.map(|(a, b)| Inputs::product(operand(a), operand(b), signs)));
        }
    }
    agree(&inputs, false);
}

#[test]
fn operands_of_full_width_give_their_products() {
    let mut random = fastrand::Rng::with_seed(18);
    let operand = |random: &mut fastrand::Rng| random.u64(..1 << 18);
    let inputs: Vec<Inputs> = (0..3000)
        .map(|_| {
            let [a, b] = [operand(&mut random), operand(&mut random)];
            Inputs::product(a, b, random.u64(..4))
        })
        .collect();
    agree(&inputs, false);
}

#[test]
fn registers_wait_for_their_enables_and_are_reset_at_the_edge_or_at_once() {
    let mut random = fastrand::Rng::with_seed(36);
    let inputs: Vec<Inputs> = (0..3000)
        .map(|_| {
            let [a, b] = [random.u64(..1 << 18), random.u64(..1 << 18)];
            let resets = if random.u8(..4) == 0 { random.u64(..16) } else { 0 };
            Inputs { enables: random.u64(..16), resets, ..Inputs::product(a, b, random.u64(..4)) }
        })
        .collect();
    agree(&inputs, false);
    agree(&inputs, true);
}

/// The second block takes its first operand from the register of the first block's.
#[test]
fn operands_are_shifted_from_block_to_block() {
    let clock = ".CLK0(clock), .CE0(1'b1), .RST0(1'b0), .SIGNEDA(1'b1), .SIGNEDB(1'b1), \
                 .SOURCEB(1'b0)";
    let parameters = ".REG_INPUTA_CLK(\"CLK0\")";
    let b = bits("B", "b", 18);
    let instances = format!(
        "  wire [35:0] out_0, out_1;\n  wire [17:0] out_2, out_3, chain;\n  \
         MULT18X18D #({parameters}) first ({}{b}{}{}{}.SOURCEA(1'b0), {clock});\n  \
         MULT18X18D #({parameters}) second ({}{b}{}{}.SOURCEA(1'b1), {clock});",
        bits("A", "a", 18),
        bits("P", "out_0", 36),
        bits("SROA", "chain", 18),
        bits("ROB", "out_2", 18),
        bits("SRIA", "chain", 18),
        bits("P", "out_1", 36),
        bits("ROA", "out_3", 18),
    );
    let inputs = [("a", 18), ("b", 18)];
    let device = Device { model: "MULT18X18D.v", inputs: &inputs, instances, outputs: 4 };
    let mut random = fastrand::Rng::with_seed(9);
    let lines: Vec<Vec<u64>> =
        (0..500).map(|_| vec![random.u64(..1 << 18), random.u64(..1 << 18)]).collect();
    let Some(found) = device.run(&lines) else { return };
    for clock in 2..lines.len() {
        let b = lines[clock][1];
        let [before, earlier] = [1, 2].map(|clocks| lines[clock - clocks][0]);
        let product = |a: u64| (extended((a, true)) * extended((b, true))) as u64 & MASK;
        assert_eq!(found[clock], [product(before), product(earlier), b, earlier], "{clock}");
    }
}

#[test]
fn what_is_not_modelled_is_refused() {
    let cases = [
        (".CLK2_DIV(\"DISABLED\")", "MULT18X18D: CLK2_DIV = DISABLED is not modelled\n"),
        (".REG_INPUTC_CLK(\"CLK0\")", "MULT18X18D: REG_INPUTC_CLK = CLK0 is not modelled\n"),
        (".MULT_BYPASS(\"ENABLED\")", "MULT18X18D: MULT_BYPASS = ENABLED is not modelled\n"),
        (".SOURCEB_MODE(\"HIGHSPEED\")", "MULT18X18D: SOURCEB_MODE = HIGHSPEED is not modelled\n"),
        (".REG_OUTPUT_CLK(\"CLK7\")", "MULT18X18D: a register has no CLK7 to take\n"),
        (".REG_PIPELINE_RST(\"NONE\")", "MULT18X18D: a register has no NONE to take\n"),
    ];
    for (parameters, expected) in cases {
        let Some(said) = refusal("MULT18X18D", parameters) else { return };
        assert_eq!(said, expected, "{parameters}");
    }
}
