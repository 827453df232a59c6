//! `fixed` against whole-number arithmetic with shifts, written apart from it, at every format that
//! a spec may have.
//!
//! It runs with overflow checks, so it tries the widths that `fixed::number` argues for, too.
use glam::DVec3;
use proptest::prelude::*;
use specula_fixtures::any_spec;
use specula_fixtures::frames::material;
use specula_fixtures::highlights::{Choices, SpanRange, draw_frame};
use specula_fixtures::specs::packet;
use specula_golden::fixed::{Model, PacketError};
use specula_scene::{Attenuation, Frame, LocalLight, Needs, Spot};
use specula_spec::ways::Places;
use specula_spec::{CoreSpec, Method, MethodSpec, SpanPacket};

mod along;
mod consistent;
mod direct;
mod duff;
mod gaussian;
mod gouraud;
mod hybrid;
mod lyon;
mod phong;
mod power;
mod raw;
mod reflection;
mod slerp;

use raw::Raw;

const ANY: SpanRange = SpanRange { widest: 179.0, tilt: 180.0, log2_length: 10.0, lights: 3 };

fn codes_agree(core: &CoreSpec, packet: &SpanPacket) -> Result<(), TestCaseError> {
    let mut codes = Vec::new();
    Model::new(core).shade(packet, &mut codes).map_err(|e| TestCaseError::fail(e.to_string()))?;
    prop_assert_eq!(codes.len(), packet.length as usize);
    // A few dozen pixels of a long span are enough.
    for i in (0..packet.length).step_by(1 + packet.length as usize / 50) {
        let raw = Raw::new(core, packet, i);
        let expected = match &core.method {
            MethodSpec::Lyon(spec) => lyon::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Phong(spec) => phong::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Hybrid(spec) => hybrid::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Duff(spec) => duff::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Gouraud(spec) => gouraud::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Reflection(spec) => reflection::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Consistent(spec) => consistent::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Slerp(spec) => slerp::code(spec, &raw, core.parameters.lights, i),
            MethodSpec::Direct(spec) => direct::code(spec, &raw, core.parameters.lights, i),
        };
        prop_assert_eq!(codes[i as usize], expected, "pixel {}", i);
    }
    Ok(())
}

/// A spec with formats and options that `draw` decides, each of which is from 0 to 1.
fn core_for(frame: &Frame, method: Method, draw: &[f64; 8]) -> CoreSpec {
    // Eight draws decide a few more things: digits further down are as good as draws of their own.
    let mut drawn = 0;
    any_spec(&Needs::of(frame), method, |low, high| {
        let digits = draw[drawn % 8] * 7_f64.powi((drawn / 8) as i32);
        drawn += 1;
        let part = if digits > 1.0 { digits.fract() } else { digits };
        low + (f64::from(high - low) * part).round() as u32
    })
}

/// The same core, seeing places from the middles of spans.
fn of_the_middles(mut core: CoreSpec) -> CoreSpec {
    let span = Places::Span;
    match &mut core.method {
        MethodSpec::Lyon(spec) => spec.places = span,
        MethodSpec::Hybrid(spec) => spec.places = span,
        MethodSpec::Duff(spec) => spec.places = span,
        MethodSpec::Reflection(spec) => spec.places = span,
        MethodSpec::Consistent(spec) => spec.places = span,
        MethodSpec::Slerp(spec) => spec.places = span,
        MethodSpec::Direct(spec) => spec.places = span,
        MethodSpec::Phong(_) | MethodSpec::Gouraud(_) => {}
    }
    core
}

/// Powers of two, which squaring reaches, or any.
fn exponent() -> impl Strategy<Value = u32> {
    prop_oneof![(0..13_u32).prop_map(|j| 1 << j), 1..8192_u32]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn lyon_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in 1..8192_u32) {
        check(Method::Lyon, &draw, &bits, n)?;
    }

    #[test]
    fn phong_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in 1..8192_u32) {
        check(Method::Phong, &draw, &bits, n)?;
    }

    #[test]
    fn phong_at_places_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in 1..8192_u32) {
        check_frame(Method::Phong, &frame_with_places(&draw, n), &bits)?;
    }

    #[test]
    fn gouraud_at_places_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in 1..8192_u32) {
        check_frame(Method::Gouraud, &frame_with_places(&draw, n), &bits)?;
    }

    /// The other methods, where they see places from the middles of spans; ways to places are
    /// compared with the hardware alone (`testbench/tests/drawn_specs.rs`).
    #[test]
    fn the_others_at_places_agree_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), j in 0..13_u32) {
        let frame = frame_with_places(&draw, 1 << j);
        for method in Method::ALL {
            let core = of_the_middles(core_for(&frame, method, &bits));
            codes_agree(&core, &packet(&core, &frame))?;
        }
    }

    #[test]
    fn hybrid_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in exponent()) {
        check(Method::Hybrid, &draw, &bits, n)?;
    }

    #[test]
    fn duff_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in exponent()) {
        check(Method::Duff, &draw, &bits, n)?;
    }

    #[test]
    fn gouraud_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in 1..8192_u32) {
        check(Method::Gouraud, &draw, &bits, n)?;
    }

    #[test]
    fn slerp_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in exponent()) {
        check(Method::Slerp, &draw, &bits, n)?;
    }

    #[test]
    fn direct_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in exponent()) {
        check(Method::Direct, &draw, &bits, n)?;
    }

    #[test]
    fn reflection_agrees_with_integers(draw in prop::array::uniform12(0.0..1.0_f64), bits in prop::array::uniform8(0.0..=1.0_f64), n in exponent()) {
        check(Method::Reflection, &draw, &bits, n)?;
    }

    #[test]
    fn consistent_agrees_with_integers(
        draw in prop::array::uniform12(0.0..1.0_f64),
        bits in prop::array::uniform8(0.0..=1.0_f64),
        n in exponent(),
        cosines in prop::array::uniform3(-0.1..=1.0_f64),
    ) {
        let mut frame = draw_frame(ANY, &draw, material(draw[8], draw[9], 3.0 * draw[10], n)).frame;
        for (cone, cosine) in frame.triangles[0].cones.iter_mut().zip(cosines) {
            cone.cosine = cosine;
        }
        check_frame(Method::Consistent, &frame, &bits)?;
    }
}

/// A drawn frame with lights and the eye at places near the surface, and one light in it.
fn frame_with_places(draw: &Choices, n: u32) -> Frame {
    let mut frame = draw_frame(ANY, draw, material(draw[8], draw[9], 3.0 * draw[10], n)).frame;
    frame.triangles[0].positions = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let place = |k: usize| DVec3::new(draw[k], draw[k + 1], draw[k + 2] - 0.5);
    let spot = Spot { axis: -place(3).normalize_or(DVec3::Z), exponent: 1 + (n % 300) };
    let attenuation = Attenuation { constant: draw[4], linear: draw[5], quadratic: 3.0 * draw[6] };
    frame.lights.truncate(1);
    frame.local_lights = vec![
        LocalLight { position: place(0), spot: None, attenuation: None, colour: [1.0; 3] },
        LocalLight {
            position: place(3),
            spot: Some(spot),
            attenuation: Some(attenuation),
            colour: [0.5, 1.0, 2.0],
        },
        LocalLight {
            position: DVec3::ZERO,
            spot: None,
            attenuation: (draw[2] < 0.5).then_some(attenuation),
            colour: [1.0; 3],
        },
    ];
    frame.eye = (draw[11] < 0.7).then(|| place(6));
    frame
}

fn check_frame(method: Method, frame: &Frame, bits: &[f64; 8]) -> Result<(), TestCaseError> {
    let core = core_for(frame, method, bits);
    codes_agree(&core, &packet(&core, frame))
}

fn check(
    method: Method,
    draw: &Choices,
    bits: &[f64; 8],
    shininess: u32,
) -> Result<(), TestCaseError> {
    let frame = draw_frame(ANY, draw, material(draw[8], draw[9], 3.0 * draw[10], shininess)).frame;
    check_frame(method, &frame, bits)
}

/// Inputs at the ends of their ranges, all at once: not what a host would send, but nothing may
/// overflow. Over a long span they outgrow what the core is for, and are refused; over one of a
/// pixel they are as good as any.
#[test]
fn forward_differences_take_every_input_in_range() {
    for method in [Method::Hybrid, Method::Duff, Method::Reflection] {
        takes_every_input_in_range(method);
    }
}

fn takes_every_input_in_range(method: Method) {
    let draw = [0.5; 12];
    let frame = draw_frame(ANY, &draw, material(1.0, 1.0, 1.0, 4096)).frame;
    for bits in [[0.0; 8], [1.0; 8]] {
        let mut core = core_for(&frame, method, &bits);
        core.parameters.longest_span = 8192;
        for high in [0b0, 0b1, 0b01_0101, 0b10_1010, 0b11_0110] {
            let end = |(k, port): (usize, specula_spec::InputPort)| {
                if high >> (k % 6) & 1 == 1 { port.range.1 } else { port.range.0 }
            };
            let inputs: Vec<i64> = core.inputs().into_iter().enumerate().map(end).collect();
            codes_agree(&core, &SpanPacket { length: 1, inputs: inputs.clone() })
                .unwrap_or_else(|e| panic!("{e}"));
            let refused =
                Model::new(&core).shade(&SpanPacket { length: 8192, inputs }, &mut Vec::new());
            assert!(
                matches!(refused, Err(PacketError::Outgrown { .. })),
                "{method:?}, {high:b}: {refused:?}"
            );
        }
    }
}
