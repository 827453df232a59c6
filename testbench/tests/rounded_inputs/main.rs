//! Bounds of cores made for one scene, in which inputs that the host rounded are constants, steps
//! are 0 and products fold away.
use glam::DVec3;
use specula_fixtures::Draw;
use specula_fixtures::frames::{Row, frame_of, material};
use specula_scene::{Frame, LoadedScene, Needs, parse};
use specula_spec::{CoreOptions, CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, BenchError, EngineKind, Outcome};

fn outcome(frame: &Frame, spec: &CoreSpec) -> Result<Outcome, BenchError> {
    Bench::new(frame, spec, "core")?.run(EngineKind::Fast, &mut |_, _| ())
}

/// The largest measured quantisation error and its bound, of a core that agrees.
fn measured(frame: &Frame, spec: &CoreSpec) -> (f64, f64) {
    let outcome = outcome(frame, spec).unwrap();
    assert_eq!(outcome.fault(), None, "{spec:?}");
    (outcome.comparison.errors.quantisation.max_lsb, outcome.bound_lsb)
}

fn scene(name: &str, text: &str) -> LoadedScene {
    parse(name, text.to_owned()).unwrap()
}

/// What each scene measures, and which bound it is to stay below for saying something.
#[test]
fn scenes_whose_bounds_were_broken_stay_within_them() {
    let scenes = [
        ("gouraud", include_str!("gouraud.toml"), 1.889, 6.0),
        ("lyon", include_str!("lyon.toml"), 19.107, 30.0),
        ("gouraud-coarse", include_str!("gouraud-coarse.toml"), 2.825, 13.0),
        ("hybrid-default-8191", include_str!("hybrid-default-8191.toml"), 0.737, 1.0),
    ];
    for (name, text, error, most) in scenes {
        let loaded = scene(name, text);
        let special = loaded.core_spec(None).unwrap();
        let (got, bound) = measured(&loaded.frame, &special);
        println!("{name}: {got} of {bound} LSB");
        assert!((got - error).abs() < 1e-3, "{name}: {got} LSB");
        assert!(bound < most, "{name}: a bound of {bound} LSB");
        // A core that knows less of the scene has no smaller bound.
        let (general_error, general_bound) = measured(&loaded.frame, &special.general());
        assert_eq!(general_error, got);
        assert!(
            general_bound >= bound,
            "{name}: {bound} LSB, and {general_bound} of the general core"
        );
    }
}

/// A unit vector near another.
fn near(direction: DVec3, by: f64, draw: &mut Draw) -> DVec3 {
    let away = DVec3::new(draw.signed_unit(), draw.signed_unit(), draw.signed_unit());
    (direction + by * away).normalize()
}

/// Rows whose normals hardly change, under lights near the axes, of which components and steps
/// round to 0 and to the same number.
fn nearly_constant(draw: &mut Draw) -> Frame {
    let steady = 10f64.powi(-(draw.below(4) as i32) - 1);
    let tilt = [0.02, 0.2, 1.0][draw.below(3)];
    let around = near(DVec3::Z, tilt, draw);
    let length = [2, 3, 30, 200, 900][draw.below(5)];
    let look = material(0.0, 0.5, 0.5, [1, 2, 16, 255][draw.below(4)]);
    let row = |draw: &mut Draw| Row {
        normals: [near(around, steady, draw), near(around, steady, draw)],
        length: 1 + draw.below(length) as u32,
        material: look.clone(),
    };
    let rows: Vec<Row> = (0..1 + draw.below(2)).map(|_| row(draw)).collect();
    let lights: Vec<DVec3> = (0..1 + draw.below(2)).map(|_| near(DVec3::Z, tilt, draw)).collect();
    frame_of(&rows, &lights)
}

/// The method with formats a bit or several coarser than its defaults, as far as each may be.
fn coarser(frame: &Frame, method: Method, draw: &mut Draw) -> Option<CoreSpec> {
    let table: CoreOptions =
        format!("light_pipelines = \"{}\"", ["each", "shared"][draw.below(2)]).parse().unwrap();
    let spec = CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(method)).ok()?;
    let spec = spec.finer(-(draw.below(9) as i32), &[]).unwrap_or(spec);
    Some(spec.specialised(frame))
}

/// Every method, in many formats, on scenes that leave most of a core constant.
#[test]
fn bounds_hold_where_most_of_a_core_is_constant() {
    let mut draw = Draw::new(12);
    let mut closest = (0.0_f64, String::new());
    for round in 0..120 {
        let frame = nearly_constant(&mut draw);
        for method in Method::ALL {
            let Some(spec) = coarser(&frame, method, &mut draw) else { continue };
            let Ok(outcome) = outcome(&frame, &spec) else { continue };
            let ratio = outcome.comparison.errors.quantisation.max_lsb / outcome.bound_lsb;
            assert_eq!(outcome.fault(), None, "round {round}, {}", method.name());
            if ratio > closest.0 {
                closest = (ratio, format!("round {round}, {}", method.name()));
            }
        }
    }
    println!("closest to its bound: {closest:?}");
    assert!(closest.0 > 0.9, "nothing comes near its bound: {closest:?}");
}

/// The finest weights and the shortest spans, of which 1/S in f64 is off by more than the weight's
/// own last place.
#[test]
fn weights_finer_than_an_f64_are_no_untrue_fact() {
    for method in [Method::Lyon, Method::Phong, Method::Direct, Method::Consistent] {
        for (bits, length) in (53..=56).flat_map(|bits| (2..=40).map(move |length| (bits, length)))
        {
            let normals = [DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.6, 0.0, 0.8)];
            let look = || material(0.1, 0.5, 0.4, 16);
            let rows = [length, length - 1].map(|length| Row { normals, length, material: look() });
            let frame = frame_of(&rows, &[DVec3::new(0.0, 0.6, 0.8)]);
            let table: CoreOptions =
                format!("[{}.formats]\nweight_accumulator = \"U1.{bits}\"", method.name())
                    .parse()
                    .unwrap();
            let spec = CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(method)).unwrap();
            for spec in [spec.specialised(&frame), spec] {
                let outcome = outcome(&frame, &spec).unwrap();
                assert_eq!(outcome.fault(), None, "{} U1.{bits}, {length} pixels", method.name());
            }
        }
    }
    let loaded = scene("six", include_str!("six.toml"));
    measured(&loaded.frame, &loaded.core_spec(None).unwrap());
}
