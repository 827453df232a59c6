//! Pixels of several clocks.
use specula_datapath::Design;
use specula_datapath::builder::Sig;
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, Runner, paused};
use specula_spec::{Format, InputPort};

use super::Builder;

const STEPS: [i64; 3] = [1, 10, 100];

/// The accumulator of the last time slot and the sum over all of them, each for pixel i of a span whose
/// steps are `factor` times [`STEPS`]: 100 i and 7 + 111 i times the factor.
fn wanted(factor: i64, length: u32) -> Vec<[i64; 2]> {
    (0..i64::from(length)).map(|i| [100 * i * factor, 7 + 111 * i * factor]).collect()
}

#[test]
fn time_slots_have_values_of_their_own() {
    let b = Builder::new("bench", "");
    let control = b.control();
    let slots = b.time_slots(&control, 3);
    let input = |name: &str| {
        b.input(&InputPort { range: (0, 500), ..InputPort::whole(name, Format::unsigned(9, 0)) })
    };
    let step = slots.multiplexed(&["one", "ten", "hundred"].map(input));
    let zero = b.integer(0);
    let grown = b.unit(
        "grown",
        "",
        (("first", &slots.first_pixel), ("step", &step)),
        |_, (first, step)| Sig::accumulated(&first, &zero, &step, (0.0, 4000.0), 8, "few steps"),
    );
    let seven = b.integer(7);
    let sum = b.unit(
        "sum",
        "",
        (("begins", &slots.first_slot), ("term", &grown)),
        |_, (begins, term)| {
            Sig::summed(&begins, &seven, &term, (0.0, 12_007.0), 3, "three time slots")
        },
    );
    let design = b.finish(&slots.valid_in_last_slot, &[("grown", grown), ("sum", sum)]).unwrap();
    assert_eq!((design.interval, design.latency()), (3, design.depth() + 2));

    let spans = [(1, 4), (2, 1), (3, 3), (1, 2)];
    let drives: Vec<Drive> =
        spans.iter().flat_map(|&(factor, length)| clocks(factor, length)).collect();
    let all: Vec<[i64; 2]> =
        spans.iter().flat_map(|&(factor, length)| wanted(factor, length)).collect();
    assert_eq!(leaving(&design, &drives), all);
    for seed in 0..20 {
        assert_eq!(leaving(&design, &paused(&design, &drives, &mut Draw::new(seed))), all);
    }
}

/// The clocks of a span.
fn clocks(factor: i64, length: u32) -> impl Iterator<Item = Drive> {
    let inputs = STEPS.map(|step| factor * step).to_vec();
    (0..3 * length).map(move |clock| Drive {
        valid: true,
        start: clock == 0,
        inputs: inputs.clone(),
    })
}

/// What leaves the design with these clocks and idle ones behind them.
fn leaving(design: &Design, drives: &[Drive]) -> Vec<[i64; 2]> {
    let idle = Drive { valid: false, start: true, inputs: vec![0; 3] };
    let mut runner = Runner::new(design);
    let mut left = vec![];
    for drive in drives.iter().chain(vec![&idle; design.latency() as usize + 1]) {
        runner.apply(drive);
        if runner.value(design.valid_out) == Some(1) {
            left.push([0, 1].map(|output| runner.value(design.outputs[output]).unwrap()));
        }
        runner.edge();
    }
    left
}
