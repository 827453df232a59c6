//! What adds up along a span: spans of 1, 2, 3 and 8192 pixels, one straight after the other
//! and with bubbles.
use specula_datapath::builder::Vector;
use specula_datapath::{Design, SpanPacket};
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, paused, run};
use specula_hdl::units::{self, Differences, Interpolation, SpanNormals, Steps};
use specula_spec::Format;

use super::{Bench, lyon, rounded};

const LENGTHS: [u32; 8] = [1, 1, 3, 2, 8192, 2, 1, 3];
const STEPS: u32 = 8191;

/// The outputs of every pixel of these spans, and those of pixel `i` of each as they should be.
fn check(design: &Design, packets: &[SpanPacket], wanted: impl Fn(&[i64], i64) -> Vec<i64>) {
    let drives: Vec<Drive> = packets.iter().flat_map(Drive::span).collect();
    let got = run(design, drives.clone());
    assert!(run(design, paused(design, &drives, &mut Draw::new(3))) == got);
    let pixels = packets.iter().flat_map(|packet| (0..packet.length).map(move |i| (packet, i)));
    assert_eq!(got.len(), packets.iter().map(|p| p.length as usize).sum::<usize>());
    for ((packet, i), got) in pixels.zip(got) {
        assert_eq!(got, wanted(&packet.inputs, i.into()), "pixel {i} of {packet:?}");
    }
}

fn packets(inputs: impl Fn(u32, usize) -> Vec<i64>) -> Vec<SpanPacket> {
    LENGTHS
        .iter()
        .enumerate()
        .map(|(number, &length)| SpanPacket { length, inputs: inputs(length - 1, number) })
        .collect()
}

/// x0 + i d0 + i(i - 1)/2 d2, bit for bit, from one limit to the other and back.
#[test]
fn quadratics_are_exact() {
    let format = Format::signed(3, 40);
    let one = 1i64 << 40;
    let bench = Bench::new();
    let value = bench.input("value_start", format, (-one, one));
    let first = bench.input("first_difference", format, (-2 * one, 2 * one));
    let second = bench.input("second_difference", format, (-4 * one, 4 * one));
    let of = Differences { start: &value, first_difference: &first, second_difference: &second };
    let x = units::quadratic(&bench.b, &bench.start, of, (-1.0, 1.0), STEPS);
    let design = bench.finish(&[("x", x)]);

    // A parabola from the end of the range to its other end half-way and back again.
    let parabola = |steps: u32, number: usize| {
        let end = if number.is_multiple_of(2) { one } else { -one };
        let s = i64::from(steps.max(1));
        let second = if steps < 2 { 0 } else { 16 * end / (s * s) };
        let first = if steps == 0 { 0 } else { -second * (s - 1) / 2 };
        vec![end, first, second]
    };
    check(&design, &packets(parabola), |x, i| vec![x[0] + i * x[1] + i * (i - 1) / 2 * x[2]]);
}

/// x0 + i d, bit for bit, from one end to the other.
#[test]
fn linear_values_are_exact() {
    linear_values_up_to(1);
    linear_values_up_to(2);
}

fn linear_values_up_to(limit: i64) {
    let format = Format::signed(3, 40);
    let one = limit << 40;
    let bench = Bench::new();
    let (start, step) = (
        bench.input("value_start", format, (-one, one)),
        bench.input("step", format, (-2 * one, 2 * one)),
    );
    let x = units::linear(
        &bench.b,
        &bench.start,
        Steps { start: &start, step: &step, limit: limit as f64 },
        STEPS,
    );
    let design = bench.finish(&[("x", x)]);
    let rising = |steps: u32, number: usize| {
        let from = if number.is_multiple_of(2) { one } else { -one };
        vec![from, if steps == 0 { 0 } else { -2 * from / i64::from(steps) }]
    };
    check(&design, &packets(rising), |x, i| vec![x[0] + i * x[1]]);
}

/// N0 + a (N1 - N0), with a rounded from i/S.
#[test]
fn normals_are_interpolated() {
    let mut lyon = lyon(9);
    let f = &mut lyon.formats;
    (f.weight.fraction_bits, f.weight_accumulator.fraction_bits) = (11, 25);
    let bench = Bench::new();
    let (vector, sum) = (f.vector, f.vector_sum());
    let start =
        ["x", "y", "z"].map(|axis| bench.input(&format!("start_{axis}"), vector, (-512, 512)));
    let delta =
        ["x", "y", "z"].map(|axis| bench.input(&format!("delta_{axis}"), sum, (-1024, 1024)));
    let weight_step = bench.input("weight_step", f.weight_accumulator, (0, 1 << 25));
    let (start, delta) = (Vector::new(start), Vector::new(delta));
    let span = SpanNormals {
        first: &bench.start,
        start: &start,
        delta: &delta,
        weight_step: &weight_step,
    };
    let n = units::interpolate(
        &bench.b,
        span,
        Interpolation {
            accumulator: f.weight_accumulator,
            weight: f.weight,
            vector: f.vector,
            longest: 1.0,
            apart: 2.0,
            steps: STEPS,
        },
    );
    let design = bench.finish(&[("x", n.x), ("y", n.y), ("z", n.z)]);

    let ends = [[512, 0, 0], [0, -512, 0], [300, -300, 290], [0, 0, 512], [-512, 0, 0]];
    let packets = packets(|steps, number| {
        let (from, to): ([i64; 3], [i64; 3]) = (ends[number % 5], ends[(number * 3 + 4) % 5]);
        let step =
            if steps == 0 { 0 } else { f.weight_accumulator.quantise(1.0 / f64::from(steps)) };
        [from[0], from[1], from[2], to[0] - from[0], to[1] - from[1], to[2] - from[2], step]
            .to_vec()
    });
    check(&design, &packets, |x, i| {
        let a = rounded(i * x[6], 25 - 11);
        (0..3).map(|c| rounded((x[c] << 11) + a * x[c + 3], 11)).collect()
    });
}

/// Gouraud's intensity, clamped to [0, 1] where rounding of the step leads past it.
#[test]
fn intensities_are_interpolated_and_clamped() {
    let accumulator = Format::signed(1, 18);
    let one = 1i64 << 18;
    let bench = Bench::new();
    let start = bench.input("intensity_start", accumulator, (0, one));
    let step = bench.input("intensity_step", accumulator, (-one, one));
    let intensity = units::gouraud(&bench.b, &bench.start, (&start, &step), 8, STEPS);
    let design = bench.finish(&[("intensity", intensity)]);

    // Up and down between the ends; 1/S is rounded away from 0, so that both ends are passed.
    let packets = packets(|steps, number| {
        let rising = number.is_multiple_of(2);
        let size = if steps == 0 {
            0
        } else {
            one / i64::from(steps) + i64::from(one % i64::from(steps) != 0)
        };
        vec![if rising { 0 } else { one }, if rising { size } else { -size }]
    });
    let passed =
        packets.iter().any(|p| p.inputs[0] + i64::from(p.length - 1) * p.inputs[1] >= one + 512);
    assert!(passed, "no span leads past 1 by as much as rounding sees");
    check(&design, &packets, |x, i| vec![rounded(x[0] + i * x[1], 10).clamp(0, 256)]);
}
