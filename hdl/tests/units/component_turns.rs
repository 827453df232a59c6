//! Components that take turns in one multiplier, against whole-number arithmetic.
use specula_datapath::Design;
use specula_datapath::builder::{Control, TimeSlots, Vector};
use specula_datapath::design::Op;
use specula_datapath::pass::{Pipelining, compile};
use specula_datapath::target::Target;
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, paused, run};
use specula_spec::{Format, Hold, InputPort};

use super::Builder;

const RANGES: [(i64, i64); 7] =
    [(-9, 9), (-3, 8), (-16, 15), (0, 7), (-100, 100), (-8, 3), (-5, 60)];

/// a · b, a · a, the z of a × b and the y of a s, all of whole numbers: a and s come with each span,
/// and b holds for a frame. The products are made inside a unit, that of s inside one within it.
fn design(slots: impl Fn(&Builder, &Control) -> TimeSlots, pipelining: &Pipelining) -> Design {
    let b = Builder::new("bench", "");
    let slots = slots(&b, &b.control());
    let mut ports = RANGES.iter().zip(0..).map(|(&range, k)| {
        let hold = if (3..6).contains(&k) { Hold::Frame } else { Hold::Span };
        let port = InputPort::whole(format!("input_{k}"), Format::signed(8, 0));
        b.input(&InputPort { range, hold, ..port })
    });
    let mut next = || ports.next().unwrap();
    let (a, fixed, s) =
        (Vector::new([next(), next(), next()]), Vector::new([next(), next(), next()]), next());
    // Sums are there later than what was added, so that components come at different times.
    let a = Vector::new([a.x, a.y + b.integer(1), a.z]);
    let [dot, square, z, y] = b
        .unit("products", "", (("a", &a), ("b", &fixed), ("s", &s)), |b, (a, fixed, s)| {
            let scaled = b.unit("scaled", "", (("a", &a), ("s", &s)), |_, (a, s)| a.scaled(&s));
            let cross = a.truncated_cross(&fixed, 20);
            vec![a.dot(&fixed), a.length_squared(), cross.z, scaled.y]
        })
        .try_into()
        .unwrap_or_else(|_| panic!("four values leave"));
    let outputs = [("dot", dot), ("square", square), ("z", z), ("y", y)];
    let graph = b.graph(&slots.valid_in_last_slot, &outputs).unwrap();
    compile(&graph, pipelining).unwrap()
}

fn wanted(inputs: &[i64]) -> Vec<i64> {
    let [a, b]: [[i64; 3]; 2] =
        [[inputs[0], inputs[1] + 1, inputs[2]], inputs[3..6].try_into().unwrap()];
    let dot = |a: [i64; 3], b: [i64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<i64>();
    vec![dot(a, b), dot(a, a), a[0] * b[1] - a[1] * b[0], a[1] * inputs[6]]
}

/// The inputs that hold for a frame, which is one here.
const FRAME: [i64; 3] = [6, -44, -7];

/// Spans of one to three pixels, three clocks each.
fn drives() -> (Vec<Drive>, Vec<Vec<i64>>) {
    let mut draw = Draw::new(5);
    let (mut drives, mut pixels) = (vec![], vec![]);
    for _ in 0..200 {
        let inputs = of_frame(RANGES.iter().map(|&(low, high)| draw.between(low, high)).collect());
        let length = 1 + draw.below(3);
        drives.extend((0..3 * length).map(|clock| Drive {
            valid: true,
            start: clock == 0,
            inputs: inputs.clone(),
        }));
        pixels.extend(vec![wanted(&inputs); length]);
    }
    (drives, pixels)
}

fn of_frame(mut inputs: Vec<i64>) -> Vec<i64> {
    inputs[3..6].copy_from_slice(&FRAME);
    inputs
}

/// Products of two variables.
fn multipliers(design: &Design) -> usize {
    design.iter().filter(|(_, node)| matches!(node.op, Op::Mul(..))).count()
}

#[test]
fn components_in_turns_give_the_products_of_three_multipliers() {
    let (drives, pixels) = drives();
    let ecp5 = Target::named("ecp5").expect("there is one");
    for pipelining in [
        Pipelining::EachOperator,
        Pipelining::ForClock { target: &ecp5, mhz: 60.0 },
        Pipelining::ForClock { target: &ecp5, mhz: 150.0 },
        Pipelining::ForClock { target: &ecp5, mhz: 280.0 },
    ] {
        let parallel = design(|b, control| b.time_slots(control, 1), &pipelining);
        let serial = design(Builder::component_turns, &pipelining);
        assert_eq!((serial.interval, serial.last_slot_only), (3, true));
        // a · b, a · a, one of the cross product and one of the scaled vector are asked for.
        assert_eq!([multipliers(&parallel), multipliers(&serial)], [9, 5]);
        assert!(run(&serial, drives.clone()) == pixels, "{pipelining:?}");
        for seed in 0..5 {
            let paused = paused(&serial, &drives, &mut Draw::new(seed));
            let held = |drive: Drive| Drive { inputs: of_frame(drive.inputs), ..drive };
            let left = run(&serial, paused.into_iter().map(held));
            assert!(left == pixels, "{pipelining:?}, seed {seed}");
        }
    }
}
