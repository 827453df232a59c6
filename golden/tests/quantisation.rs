//! `fixed` stays within one code of the method in f64, at the formats that `CoreSpec::for_scene`
//! chooses.
use proptest::prelude::*;
use specula_fixtures::frames::{material, mirror};
use specula_fixtures::highlights::{Choices, Drawn, SpanRange, draw_frame};
use specula_fixtures::specs::{packet, spec};
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::Model;
use specula_scene::{Frame, Material};
use specula_spec::duff::Highlight;
use specula_spec::lyon::Difference;
use specula_spec::{CoreSpec, Method, MethodSpec, reflection};

const TYPICAL: SpanRange = SpanRange { widest: 30.0, tilt: 70.0, log2_length: 9.0, lights: 1 };
const EXTREME: SpanRange = SpanRange { widest: 90.0, tilt: 45.0, log2_length: 9.0, lights: 1 };

fn within_one_code(core: &CoreSpec, frame: &Frame) -> Result<(), TestCaseError> {
    let mut codes = Vec::new();
    Model::new(core)
        .shade(&packet(core, frame), &mut codes)
        .map_err(|e| TestCaseError::fail(e.to_string()))?;
    let method = MethodSpan::new(core, frame, &frame.spans[0]);
    for (i, code) in (0..).zip(&codes) {
        let exact = method.pixel(i);
        for channel in 0..3 {
            let difference = f64::from(code[channel]) - exact[channel].round();
            prop_assert!(
                difference.abs() <= 1.0,
                "pixel {} is {:?}, and {:?} in f64",
                i,
                code,
                exact
            );
        }
    }
    Ok(())
}

fn defaults_suffice(
    method: Method,
    range: SpanRange,
    draw: &Choices,
    material: Material,
) -> Result<(), TestCaseError> {
    let Drawn { frame, .. } = draw_frame(range, draw, material);
    let core = spec(&frame, method);
    within_one_code(&core, &frame)
}

fn duff_suffices(
    highlight: Highlight,
    range: SpanRange,
    draw: &Choices,
    material: Material,
) -> Result<(), TestCaseError> {
    let Drawn { frame, .. } = draw_frame(range, draw, material);
    let mut core = spec(&frame, Method::Duff);
    if let MethodSpec::Duff(duff) = &mut core.method {
        duff.specular = highlight;
    }
    within_one_code(&core, &frame)
}

fn reflection_suffices(
    highlight: reflection::Highlight,
    range: SpanRange,
    draw: &Choices,
    material: Material,
) -> Result<(), TestCaseError> {
    let Drawn { frame, .. } = draw_frame(range, draw, material);
    let mut core = spec(&frame, Method::Reflection);
    if let MethodSpec::Reflection(reflection) = &mut core.method {
        reflection.specular = highlight;
    }
    within_one_code(&core, &frame)
}

fn reflection_highlights() -> impl Strategy<Value = reflection::Highlight> {
    use reflection::Highlight;
    prop_oneof![Just(Highlight::Blinn), Just(Highlight::Hybrid), Just(Highlight::Eq34)]
}

fn highlights() -> impl Strategy<Value = Highlight> {
    prop_oneof![
        Just(Highlight::Blinn),
        Just(Highlight::Quotient),
        Just(Highlight::Eq33),
        Just(Highlight::Eq34)
    ]
}

fn draws() -> impl Strategy<Value = Choices> {
    prop::array::uniform12(0.0..1.0_f64)
}

proptest! {
    #[test]
    fn lyon_in_typical_scenes(draw in draws(), n in 1..=256_u32) {
        defaults_suffice(Method::Lyon, TYPICAL, &draw, mirror(n))?;
    }

    #[test]
    fn lyon_in_extreme_scenes(draw in draws(), n in 1..=8191_u32) {
        defaults_suffice(Method::Lyon, EXTREME, &draw, mirror(n))?;
    }

    #[test]
    fn lyon_with_two_lights_and_everything(draw in draws(), n in 1..=256_u32) {
        let lights = SpanRange { lights: 2, ..TYPICAL };
        defaults_suffice(Method::Lyon, lights, &draw, material(draw[8], draw[9], draw[10], n))?;
    }

    #[test]
    fn hybrid_in_typical_scenes(draw in draws(), j in 0..=8_u32) {
        defaults_suffice(Method::Hybrid, TYPICAL, &draw, mirror(1 << j))?;
    }

    #[test]
    fn hybrid_in_extreme_scenes(draw in draws(), j in 0..=12_u32) {
        defaults_suffice(Method::Hybrid, EXTREME, &draw, mirror(1 << j))?;
    }

    #[test]
    fn hybrid_with_two_lights_and_everything(draw in draws(), j in 0..=8_u32) {
        let lights = SpanRange { lights: 2, ..TYPICAL };
        defaults_suffice(Method::Hybrid, lights, &draw, material(draw[8], draw[9], draw[10], 1 << j))?;
    }

    #[test]
    fn duff_in_typical_scenes(draw in draws(), j in 0..=8_u32, highlight in highlights()) {
        duff_suffices(highlight, TYPICAL, &draw, mirror(1 << j))?;
    }

    #[test]
    fn duff_in_extreme_scenes(draw in draws(), j in 0..=12_u32, highlight in highlights()) {
        duff_suffices(highlight, EXTREME, &draw, mirror(1 << j))?;
    }

    #[test]
    fn duff_with_two_lights_and_everything(draw in draws(), j in 0..=8_u32, highlight in highlights()) {
        let lights = SpanRange { lights: 2, ..TYPICAL };
        duff_suffices(highlight, lights, &draw, material(draw[8], draw[9], draw[10], 1 << j))?;
    }

    #[test]
    fn reflection_in_typical_scenes(draw in draws(), j in 0..=8_u32, highlight in reflection_highlights()) {
        reflection_suffices(highlight, TYPICAL, &draw, mirror(1 << j))?;
    }

    #[test]
    fn reflection_in_extreme_scenes(draw in draws(), j in 0..=12_u32, highlight in reflection_highlights()) {
        reflection_suffices(highlight, EXTREME, &draw, mirror(1 << j))?;
    }

    #[test]
    fn reflection_with_two_lights_and_everything(draw in draws(), j in 0..=8_u32, highlight in reflection_highlights()) {
        let lights = SpanRange { lights: 2, ..TYPICAL };
        reflection_suffices(highlight, lights, &draw, material(draw[8], draw[9], draw[10], 1 << j))?;
    }

    #[test]
    fn gouraud_in_extreme_scenes(draw in draws(), n in 1..=8191_u32) {
        defaults_suffice(Method::Gouraud, EXTREME, &draw, mirror(n))?;
    }

    #[test]
    fn slerp_in_typical_scenes(draw in draws(), j in 0..=8_u32) {
        defaults_suffice(Method::Slerp, TYPICAL, &draw, mirror(1 << j))?;
    }

    #[test]
    fn slerp_in_extreme_scenes(draw in draws(), j in 0..=12_u32) {
        defaults_suffice(Method::Slerp, EXTREME, &draw, mirror(1 << j))?;
    }

    #[test]
    fn direct_in_typical_scenes(draw in draws(), j in 0..=8_u32) {
        defaults_suffice(Method::Direct, TYPICAL, &draw, mirror(1 << j))?;
    }

    #[test]
    fn direct_in_extreme_scenes(draw in draws(), j in 0..=12_u32) {
        defaults_suffice(Method::Direct, EXTREME, &draw, mirror(1 << j))?;
    }

    #[test]
    fn direct_with_two_lights_and_everything(draw in draws(), j in 0..=8_u32) {
        let lights = SpanRange { lights: 2, ..TYPICAL };
        defaults_suffice(Method::Direct, lights, &draw, material(draw[8], draw[9], draw[10], 1 << j))?;
    }

    /// D = R - L needs two Newton steps (numerics N3a).
    #[test]
    fn reflection_minus_light_with_two_newton_steps(draw in draws(), n in 1..=256_u32) {
        let Drawn { frame, .. } = draw_frame(TYPICAL, &draw, mirror(n));
        let mut core = spec(&frame, Method::Lyon);
        if let MethodSpec::Lyon(lyon) = &mut core.method {
            lyon.difference = Difference::ReflectionMinusLight;
            lyon.newton_steps = 2;
        }
        within_one_code(&core, &frame)?;
    }
}
