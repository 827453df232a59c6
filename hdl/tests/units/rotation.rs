//! The rotation: spans one straight after the other, each from (1, 0) on, against the same steps in
//! whole numbers.
use specula_datapath::SpanPacket;
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, paused, run};
use specula_fixtures::formats::slerp_formats;
use specula_hdl::units;

use super::{Bench, rounded};

const LENGTHS: [u32; 8] = [1, 1, 3, 2, 1024, 2, 1, 300];
const STEPS: u32 = 1023;

/// Turns of all sizes: none, so small that their sine rounds to 0, some that go round, and half a
/// turn.
#[test]
fn every_step_is_a_rounded_rotation() {
    for (turn, state) in [(15, 13), (13, 13), (30, 28), (20, 14)] {
        let formats = slerp_formats(turn, state);
        let one = 1i64 << turn;
        let bench = Bench::new();
        let cosine = bench.input("turn_cosine", formats.turn, (-one, one));
        let sine = bench.input("turn_sine", formats.turn, (0, one));
        let [c, s] = units::rotation(&bench.b, &bench.start, [&cosine, &sine], &formats, STEPS);
        assert_eq!([c.fraction_bits(), s.fraction_bits()], [state; 2]);
        let design = bench.finish(&[("c", c), ("s", s)]);
        assert_eq!(design.depth(), 1, "a turn takes one clock");

        let angles = [0.0, 1e-6, 0.003, 1.5, 0.01, std::f64::consts::PI, 0.7, 0.0101];
        let packet = |(&length, angle): (&u32, f64)| {
            let (sin, cos) = angle.sin_cos();
            SpanPacket {
                length,
                inputs: [cos, sin].map(|x| formats.turn.quantise(x).clamp(-one, one)).into(),
            }
        };
        let packets: Vec<SpanPacket> = LENGTHS.iter().zip(angles).map(packet).collect();
        let drives: Vec<Drive> = packets.iter().flat_map(Drive::span).collect();
        let got = run(&design, drives.clone());
        assert!(run(&design, paused(&design, &drives, &mut Draw::new(4))) == got);
        let mut got = got.into_iter();
        for packet in &packets {
            let (mut c, mut s) = (1i64 << state, 0);
            for pixel in 0..packet.length {
                assert_eq!(got.next().unwrap(), [c, s], "pixel {pixel} of {packet:?}");
                let (cos, sin) = (packet.inputs[0], packet.inputs[1]);
                (c, s) = (rounded(c * cos - s * sin, turn), rounded(s * cos + c * sin, turn));
            }
        }
    }
}

/// The bound on what many turns add up to holds, and says something: of turns once round in 1023
/// steps.
#[test]
fn drift_stays_within_its_bound() {
    let formats = slerp_formats(16, 14);
    let bench = Bench::new();
    let one = 1i64 << 16;
    let cosine = bench.input("turn_cosine", formats.turn, (-one, one));
    let sine = bench.input("turn_sine", formats.turn, (0, one));
    let [c, s] = units::rotation(&bench.b, &bench.start, [&cosine, &sine], &formats, STEPS);
    let bound = c.error_value();
    let design = bench.finish(&[("c", c), ("s", s)]);
    let mut largest: f64 = 0.0;
    for angle in [std::f64::consts::PI / 1023.0, 0.0017, 0.0009, 0.003] {
        let (sin, cos) = angle.sin_cos();
        let packet = SpanPacket {
            length: 1024,
            inputs: vec![formats.turn.quantise(cos), formats.turn.quantise(sin)],
        };
        for (i, got) in (0..).zip(run(&design, Drive::span(&packet))) {
            let (sin, cos) = (f64::from(i) * angle).sin_cos();
            let off = [got[0] as f64 / 16384.0 - cos, got[1] as f64 / 16384.0 - sin];
            largest = largest.max(off[0].hypot(off[1]));
        }
    }
    assert!(largest <= bound && largest > bound / 20.0, "{largest} of {bound}");
}
