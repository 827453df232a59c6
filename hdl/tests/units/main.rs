//! Every unit by itself, against whole-number arithmetic written here; small widths exhaustively.
mod accumulators;
mod any_power;
mod channel;
mod component_turns;
mod cosine;
mod difference;
mod diffuse;
mod divider;
mod gaussian;
mod held;
mod kept_errors;
mod newton_root;
mod normalise;
mod normalise_exactly;
mod power;
mod quotient;
mod reciprocal_square_root;
mod rotation;
mod rounded_inputs;
mod shape;
mod square_root;
mod time_slots;

use proptest::test_runner::{Config as ProptestConfig, RngSeed};
use specula_datapath::Design;
use specula_datapath::builder::{Builder, Sig, TimeSlots};
use specula_fixtures::clocked::{Drive, run};
use specula_fixtures::specs::small_needs;
use specula_scene::Needs;
use specula_spec::{Format, InputPort, LyonSpec};

/// The ports, signals and outputs of a unit under test.
struct Bench {
    b: Builder,
    slots: TimeSlots,
    start: Sig,
}

impl Bench {
    fn new() -> Bench {
        let b = Builder::new("bench", "");
        let control = b.control();
        let slots = b.time_slots(&control, 1);
        Bench { b, slots, start: control.start }
    }

    fn input(&self, name: &str, format: Format, (low, high): (i64, i64)) -> Sig {
        self.b.input(&InputPort { range: (low, high), ..InputPort::whole(name, format) })
    }

    fn finish(self, outputs: &[(&str, Sig)]) -> Design {
        self.b.finish(&self.slots.valid_in_last_slot, outputs).expect("no unit is too wide here")
    }
}

/// The outputs for each row of inputs, every row a span of its own.
fn outputs(design: &Design, rows: &[Vec<i64>]) -> Vec<Vec<i64>> {
    run(design, rows.iter().cloned().map(Drive::pixel))
}

/// Few cases, since each is a design of its own, and the same ones on every run.
fn property_tests() -> ProptestConfig {
    ProptestConfig {
        cases: 24,
        rng_seed: RngSeed::Fixed(4),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// floor(raw / 2^bits + 1/2).
fn rounded(raw: i64, bits: u32) -> i64 {
    if bits == 0 { raw } else { (raw + (1 << (bits - 1))) >> bits }
}

/// A spec of `lyon` with these fraction bits everywhere.
fn lyon(fraction_bits: u32) -> LyonSpec {
    let needs =
        Needs { largest_shininess: 1, widest_angle: 0.0, shortest_normal: 1.0, ..small_needs() };
    let mut lyon = LyonSpec::for_needs(&needs);
    let f = &mut lyon.formats;
    for format in [
        &mut f.vector,
        &mut f.length_squared,
        &mut f.gain,
        &mut f.diffuse,
        &mut f.difference,
        &mut f.shape,
    ] {
        format.fraction_bits = fraction_bits;
    }
    lyon
}

/// Every vector of whole numbers whose components lie from -`limit` to `limit`.
fn cube(limit: i64) -> impl Iterator<Item = [i64; 3]> {
    let axis = move || -limit..=limit;
    axis().flat_map(move |x| axis().flat_map(move |y| axis().map(move |z| [x, y, z])))
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    (0..3).map(|c| a[c] * b[c]).sum()
}
