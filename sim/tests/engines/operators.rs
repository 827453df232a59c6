//! Every operator of the builder, in every engine, against what it means.
//!
//! Many operators share a design, since compiling one in Verilator takes seconds. All spans follow
//! each other, so pixel p leaves at clock p + latency.
use specula_datapath::SpanPacket;
use specula_datapath::design::{NodeId, Range};
use specula_fixtures::Draw;
use specula_sim::{Columns, Stimulus};

use crate::agreement;
use crate::program::{Operation, Place, Program, Step, port};

/// Runs a program in every engine and compares every result at every pixel with what it means.
fn check(program: &Program, spans: Vec<SpanPacket>) {
    let described = program.describe().unwrap();
    let expected = program.interpret(&described, &spans);
    let design = &described.design;
    let stimulus = Stimulus::whole(&spans, design);
    let watched: Vec<NodeId> = design.outputs.iter().chain([&design.valid_out]).copied().collect();
    let (reference, others) = agreement::run_all(design, &stimulus, &watched);
    println!(
        "{} operators, {} pixels, {} nodes",
        program.steps.len(),
        stimulus.pixels(),
        design.nodes.len()
    );
    for (engine, columns) in [("rust-hdl", reference)].iter().chain(&others) {
        compare(program, &expected, columns, design.latency() as usize, engine);
    }
}

fn compare(
    program: &Program,
    expected: &[Vec<i64>],
    columns: &Columns,
    latency: usize,
    engine: &str,
) {
    let pixels = expected[0].len();
    let leaves = latency..latency + pixels;
    let valid = &columns.values[program.steps.len()];
    assert!(
        valid.iter().enumerate().all(|(clock, &bit)| (bit == 1) == leaves.contains(&clock)),
        "{engine}: validity"
    );
    for ((step, expected), got) in program.steps.iter().zip(expected).zip(&columns.values) {
        let wrong = expected.iter().zip(&got[leaves.clone()]).position(|(e, g)| e != g);
        assert_eq!(
            wrong,
            None,
            "{engine}: {step:?} gives {:?}, not {:?}",
            wrong.map(|p| got[p + latency]),
            wrong.map(|p| expected[p])
        );
    }
}

/// A pixel a span.
fn single_pixels(inputs: impl Iterator<Item = Vec<i64>>) -> Vec<SpanPacket> {
    inputs.map(|inputs| SpanPacket { length: 1, inputs }).collect()
}

/// Operators on one number that make sense with so many fraction bits.
fn unary(fraction_bits: u32) -> Vec<Operation> {
    use Operation::*;
    let mut all = vec![Squared, Negated, AtLeastZero, Same];
    all.extend([-3, -1, 1, 2].map(TimesPowerOfTwo));
    all.extend(
        [-1, 0, 1, 3].into_iter().flat_map(|limit| [ClampedBelow(limit), ClampedAbove(limit)]),
    );
    let coarser = [0, 1, fraction_bits / 2, fraction_bits.saturating_sub(1)]
        .into_iter()
        .filter(|&f| f < fraction_bits);
    all.extend(coarser.flat_map(|f| [Truncated(f), Rounded(f)]));
    all
}

const BINARY: [Operation; 5] =
    [Operation::Add, Operation::Sub, Operation::Mul, Operation::LessThan, Operation::AtLeast];

/// All values of 1 to 4 bits and some ranges that fill no width, with 0 to 2 fraction bits.
fn small_types() -> Vec<(Range, u32)> {
    let whole = (1..=4)
        .flat_map(|width| [false, true].map(|signed| (Range::whole(width, signed), width / 2)));
    whole.chain([(Range::new(-3, 2), 0), (Range::new(1, 5), 1), (Range::new(-7, -2), 2)]).collect()
}

/// Every pair of types and, over the clocks, every pair of values.
#[test]
fn small_operands_exhaustively() {
    let types = small_types();
    let mut program = Program::default();
    for side in ["a", "b"] {
        let ports = types
            .iter()
            .enumerate()
            .map(|(i, &(range, fraction_bits))| port(format!("{side}{i}"), range, fraction_bits));
        program.ports.extend(ports);
    }
    program.ports.extend(["c", "d"].map(|name| port(name.into(), Range::new(0, 1), 0)));
    let (c, d) = (2 * types.len(), 2 * types.len() + 1);
    for a in 0..types.len() {
        for b in types.len()..2 * types.len() {
            BINARY
                .iter()
                .for_each(|&operation| assert!(program.push(operation, &[a, b], Place::Core)));
            assert!(program.push(Operation::Choose, &[c, a, b], Place::Core));
        }
        unary_and_constants(&mut program, a, types[a], [c, d]);
    }
    for place in [Place::Core, Place::Unit, Place::OneClock] {
        program.push(Operation::Not, &[c], place);
        [Operation::And, Operation::Or]
            .iter()
            .for_each(|&operation| assert!(program.push(operation, &[c, d], place)));
    }
    let ranges = program.input_ranges();
    let nth = |range: Range, n: i64| range.low + n % (range.high - range.low + 1);
    let inputs = (0..4 * 256).map(|clock: i64| {
        let number =
            |i: usize| [clock, clock / 16, clock / 256][i / types.len()] >> (i == d) as u32;
        (0..ranges.len()).map(|i| nth(ranges[i], number(i))).collect()
    });
    check(&program, single_pixels(inputs));
}

/// The operand with constants on either side, and in units and within a clock.
fn unary_and_constants(
    program: &mut Program,
    a: usize,
    (range, fraction_bits): (Range, u32),
    [c, d]: [usize; 2],
) {
    for operation in unary(fraction_bits) {
        assert!(program.push(operation, &[a], Place::Core));
    }
    let middle = (range.low + range.high).div_euclid(2);
    for (low, high) in [(range.low, middle), (middle, range.high), (0, 0), (-1, 1), (0, 2)] {
        assert!(program.push(Operation::Assumed(low, high), &[a], Place::Core));
    }
    if fraction_bits == 0 {
        assert!(program.push(Operation::WithBit, &[a, c], Place::Core));
    }
    for place in [Place::Unit, Place::OneClock] {
        for operation in BINARY {
            assert!(program.push(operation, &[a, a], place));
        }
        for operation in
            [Operation::Negated, Operation::Same, Operation::ClampedAbove(0), Operation::Rounded(0)]
        {
            assert!(program.push(operation, &[a], place));
        }
        assert!(program.push(Operation::Choose, &[d, a, c], place));
    }
}

/// Small operands against constants of either sign on either side.
#[test]
fn operators_on_constants_mean_what_they_say() {
    let types = small_types();
    let mut program = Program::default();
    for (i, &(range, fraction_bits)) in types.iter().enumerate() {
        program.ports.push(port(format!("a{i}"), range, fraction_bits));
    }
    let inputs = types.len();
    // Constants are steps without operands; they leave the core as well.
    let constants = [-9, -2, -1, 0, 1, 2, 7];
    program.steps.extend(constants.map(|value| step(Operation::Integer(value), &[])));
    for a in 0..inputs {
        for constant in inputs..inputs + constants.len() {
            let either_way = BINARY.iter().flat_map(|&operation| {
                [step(operation, &[a, constant]), step(operation, &[constant, a])]
            });
            program.steps.extend(either_way);
            program.steps.push(step(Operation::Choose, &[0, a, constant]));
            program.steps.push(step(Operation::Choose, &[0, constant, constant]));
        }
    }
    let ranges = program.input_ranges();
    let inputs =
        (0..32).map(|clock| ranges.iter().map(|r| r.low + clock % (r.high - r.low + 1)).collect());
    check(&program, single_pixels(inputs));
}

fn step(operation: Operation, operands: &[usize]) -> Step {
    Step { operation, operands: operands.to_vec(), place: Place::Core }
}

/// Up to 63 bits, at the extremes of the ranges and at random.
#[test]
fn large_operands_at_their_extremes() {
    let widths = [1, 8, 17, 31, 32, 33, 62, 63];
    let mut program = Program::default();
    for side in ["a", "b"] {
        for width in widths {
            for signed in [false, true] {
                let name = format!("{side}_{}{width}", if signed { "s" } else { "u" });
                let fraction_bits = if side == "a" { 0 } else { width / 2 };
                program.ports.push(port(name, Range::whole(width, signed), fraction_bits));
            }
        }
    }
    let c = program.ports.len();
    program.ports.push(port("c".into(), Range::new(0, 1), 0));
    let mut tried = 0;
    for a in 0..c / 2 {
        // Both without fraction bits, then with different ones.
        for b in [a + c / 2, (a + 5) % (c / 2), (a + 9) % (c / 2) + c / 2] {
            BINARY.iter().for_each(|&operation| {
                tried += usize::from(program.push(operation, &[a, b], Place::Core))
            });
            tried += usize::from(program.push(Operation::Choose, &[c, a, b], Place::Core));
        }
        tried += usize::from(program.push(Operation::WithBit, &[a, c], Place::Core));
    }
    for a in 0..c {
        let range = program.input_ranges()[a];
        let all = unary(program.ports[a].format.fraction_bits);
        let assumed = [
            Operation::Assumed(range.low / 2, range.high / 2),
            Operation::Assumed(0, range.high / 5),
        ];
        all.into_iter()
            .chain(assumed)
            .for_each(|operation| tried += usize::from(program.push(operation, &[a], Place::Core)));
    }
    assert!(tried > 500, "only {tried} operators fit 63 bits");
    let spans = single_pixels(extremes_and_random(&program.input_ranges()).into_iter());
    check(&program, spans);
}

/// Every pair of extremes of two inputs that are half the list apart, then random values.
fn extremes_and_random(ranges: &[Range]) -> Vec<Vec<i64>> {
    const SEED: u64 = 42;
    let mut draw = Draw::new(SEED);
    let extreme = |r: Range, n: usize| {
        [
            r.low,
            r.high,
            r.low + 1,
            r.high - 1,
            (-1).clamp(r.low, r.high),
            0.clamp(r.low, r.high),
            r.high / 2 + 1,
        ][n % 7]
            .clamp(r.low, r.high)
    };
    let half = ranges.len() / 2;
    let pair = |clock: usize| {
        (0..ranges.len())
            .map(|i| extreme(ranges[i], [clock, clock / 7, clock / 49][i / half]))
            .collect()
    };
    let mut rows: Vec<Vec<i64>> = (0..98).map(pair).collect();
    rows.extend((0..400).map(|_| {
        let value = |r: &Range| match draw.below(4) {
            0 => extreme(*r, draw.below(7)),
            _ => draw.between(r.low, r.high),
        };
        ranges.iter().map(value).collect()
    }));
    rows
}

/// Tables with signed and unsigned entries, shorter and longer than their addresses reach, and
/// registers that hold.
#[test]
fn tables_and_registers_that_hold() {
    const TABLES: [&[i64]; 5] = [
        &[5, 0, 3],
        &[-1, 0, 7, -8, 2, 2, 1, 6],
        &[1, 0],
        &[1 << 61, -(1 << 61), 12, 5],
        &[9, 9, 9, 9],
    ];
    let mut program = Program::default();
    let types = [
        (Range::whole(1, false), 0),
        (Range::whole(2, false), 0),
        (Range::whole(3, false), 0),
        (Range::new(1, 5), 0),
    ];
    program.ports.extend(
        types
            .iter()
            .enumerate()
            .map(|(i, &(range, fraction_bits))| port(format!("a{i}"), range, fraction_bits)),
    );
    program.ports.push(port("x".into(), Range::whole(9, true), 4));
    program.ports.push(port("y".into(), Range::new(3, 60), 2));
    let bits = ["enable", "load"].map(|name| port(name.into(), Range::new(0, 1), 0));
    program.ports.extend(bits);
    let [x, y, enable, load] = [4, 5, 6, 7];
    for place in [Place::Core, Place::Unit, Place::OneClock] {
        for address in 0..types.len() {
            TABLES.iter().for_each(|table| {
                assert!(program.push(Operation::LookedUp(table, 3), &[address], place))
            });
        }
    }
    for value in [x, y] {
        assert!(program.push(Operation::Held, &[value, enable], Place::Core));
        assert!(program.push(Operation::Held, &[value, enable], Place::Unit));
        assert!(program.push(
            Operation::HeldOrLoaded,
            &[value, enable, load, x + y - value],
            Place::Core
        ));
    }
    const SEED: u64 = 7;
    let mut draw = Draw::new(SEED);
    let ranges = program.input_ranges();
    let inputs = (0..300).map(|pixel| {
        let mut row: Vec<i64> = ranges.iter().map(|r| draw.between(r.low, r.high)).collect();
        // Registers that hold data have no reset: what they hold before something is taken over
        // does not count.
        if pixel == 0 {
            (row[enable], row[load]) = (1, 1);
        }
        row
    });
    let spans = single_pixels(inputs);
    check(&program, spans);
}

/// Netlists in which operators read each other's results, with feedback and spans of several
/// pixels.
#[test]
fn random_programs_mean_what_they_say() {
    const SEED: u64 = 20_240_611;
    const NETLISTS: usize = 20;
    const STEPS: usize = 14;
    const LONGEST: u32 = 6;
    let mut draw = Draw::new(SEED);
    let mut program = Program::default();
    for i in 0..12 {
        let range = Range::whole(1 + draw.below(10) as u32, draw.below(2) == 1);
        program.ports.push(port(format!("in{i}"), range, draw.below(4) as u32));
    }
    for bit in ["p", "q"] {
        program.ports.push(port(bit.into(), Range::new(0, 1), 0));
    }
    for _ in 0..NETLISTS {
        grow(&mut program, &mut draw, STEPS, LONGEST);
    }
    let ranges = program.input_ranges();
    let spans = (0..200).map(|_| SpanPacket {
        length: draw.between(1, LONGEST.into()) as u32,
        inputs: ranges.iter().map(|r| draw.between(r.low, r.high)).collect(),
    });
    let spans = spans.collect();
    check(&program, spans);
}

/// Adds a netlist that reads inputs and its own steps, none of them wider than 40 bits.
fn grow(program: &mut Program, draw: &mut Draw, steps: usize, longest: u32) {
    let inputs = program.ports.len();
    let own = inputs + program.steps.len();
    while inputs + program.steps.len() < own + steps {
        let described = program.describe().unwrap();
        let next = inputs + program.steps.len();
        let readable: Vec<usize> = (0..inputs).chain(own..next).collect();
        // Later ones more often, so that netlists grow deep.
        let pick =
            |draw: &mut Draw| readable[draw.below(readable.len()).max(draw.below(readable.len()))];
        let bits: Vec<usize> =
            readable.iter().copied().filter(|&i| described.ranges[i] == Range::new(0, 1)).collect();
        let [p, q] = [0; 2].map(|_| bits[draw.below(bits.len())]);
        let (a, b) = (pick(draw), pick(draw));
        let fraction_bits = described.fraction_bits[a];
        let (operation, operands) = drawn(draw, longest, [a, b, p, q], fraction_bits);
        let mut place = [Place::Core, Place::Core, Place::Unit, Place::OneClock][draw.below(4)];
        if matches!(operation, Operation::Accumulated(_)) && place == Place::OneClock {
            place = Place::Core;
        }
        program.steps.push(Step { operation, operands, place });
        if !program.describe().is_ok_and(|d| d.ranges[next].width() <= 40) {
            program.steps.pop();
        }
    }
}

fn drawn(
    draw: &mut Draw,
    longest: u32,
    [a, b, p, q]: [usize; 4],
    fraction_bits: u32,
) -> (Operation, Vec<usize>) {
    use Operation::*;
    let coarser = draw.below(fraction_bits as usize + 1) as u32;
    let limit = draw.between(-4, 4);
    match draw.below(18) {
        0 | 1 => (Add, vec![a, b]),
        2 | 3 => (Sub, vec![a, b]),
        4 | 5 => (Mul, vec![a, b]),
        6 => (Squared, vec![a]),
        7 => (Negated, vec![a]),
        8 => (TimesPowerOfTwo(draw.between(-3, 3) as i32), vec![a]),
        9 => (Truncated(coarser), vec![a]),
        10 => (Rounded(coarser), vec![a]),
        11 => (ClampedBelow(limit), vec![a]),
        12 => (ClampedAbove(limit), vec![a]),
        13 => (LessThan, vec![a, b]),
        14 => (AtLeast, vec![a, b]),
        15 => ([And, Or][draw.below(2)], vec![p, q]),
        16 => (Choose, vec![p, a, b]),
        _ => (Accumulated(longest), vec![a, b]),
    }
}
