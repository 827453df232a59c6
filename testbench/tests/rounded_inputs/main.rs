//! Bounds of cores made for one scene, in which inputs that the host rounded are constants, steps
//! are 0 and products fold away.
#[path = "../common/mod.rs"]
mod common;

use common::{Row, frame_of, material};
use glam::DVec3;
use specula_scene::{Frame, LoadedScene, Needs, parse};
use specula_spec::{CoreOptions, CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, BenchError, EngineKind, Outcome};

fn outcome(frame: &Frame, spec: &CoreSpec) -> Result<Outcome, BenchError> {
    Bench::new(frame, spec, "core")?.run(EngineKind::Fast, &mut |_, _| ())
}

/// The largest measured quantisation error and its bound, of a core that agrees.
fn measured(frame: &Frame, spec: &CoreSpec) -> (f64, f64) {
    let outcome = outcome(frame, spec).unwrap();
    let (error, bound) = (outcome.comparison.errors.quantisation.max_lsb, outcome.bound_lsb);
    assert!(error <= bound, "off by {error} LSB, bound {bound}: {spec:?}");
    assert!(outcome.agrees(), "{:?} {:?}", outcome.comparison.first_mismatch, outcome.violation);
    (error, bound)
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

/// Numbers from -1 to 1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn below(&mut self, number: u32) -> u32 {
        // From 0 to 1, so less than the number but at the very end.
        ((self.next() + 1.0) / 2.0 * f64::from(number)).min(f64::from(number) - 1.0) as u32
    }

    fn unit(&mut self, towards: DVec3, by: f64) -> DVec3 {
        (towards + by * DVec3::new(self.next(), self.next(), self.next())).normalize()
    }
}

/// Rows whose normals hardly change, under lights near the axes, of which components and steps
/// round to 0 and to the same number.
fn nearly_constant(noise: &mut Noise) -> Frame {
    let steady = 10f64.powi(-(noise.below(4) as i32) - 1);
    let tilt = [0.02, 0.2, 1.0][noise.below(3) as usize];
    let around = noise.unit(DVec3::Z, tilt);
    let length = [2, 3, 30, 200, 900][noise.below(5) as usize];
    let look = material(0.0, 0.5, 0.5, [1, 2, 16, 255][noise.below(4) as usize]);
    let row = |noise: &mut Noise| Row {
        normals: [noise.unit(around, steady), noise.unit(around, steady)],
        length: 1 + noise.below(length),
        material: look.clone(),
    };
    let rows: Vec<Row> = (0..1 + noise.below(2)).map(|_| row(noise)).collect();
    let lights: Vec<DVec3> = (0..1 + noise.below(2)).map(|_| noise.unit(DVec3::Z, tilt)).collect();
    frame_of(&rows, &lights)
}

/// The method with formats a bit or several coarser than its defaults, as far as each may be.
fn coarser(frame: &Frame, method: Method, noise: &mut Noise) -> Option<CoreSpec> {
    let table: CoreOptions =
        format!("light_pipelines = \"{}\"", ["each", "shared"][noise.below(2) as usize])
            .parse()
            .unwrap();
    let spec = CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(method)).ok()?;
    let spec = spec.finer(-(noise.below(9) as i32), &[]).unwrap_or(spec);
    Some(spec.specialised(frame))
}

/// Every method, in many formats, on scenes that leave most of a core constant.
#[test]
fn bounds_hold_where_most_of_a_core_is_constant() {
    let mut noise = Noise(12);
    let mut closest = (0.0_f64, String::new());
    for round in 0..120 {
        let frame = nearly_constant(&mut noise);
        for method in Method::ALL {
            let Some(spec) = coarser(&frame, method, &mut noise) else { continue };
            let Ok(outcome) = outcome(&frame, &spec) else { continue };
            let ratio = outcome.comparison.errors.quantisation.max_lsb / outcome.bound_lsb;
            assert!(
                outcome.agrees(),
                "round {round}, {}: {:?} of {} LSB",
                method.name(),
                outcome.beyond_bound(),
                outcome.bound_lsb
            );
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
                assert!(
                    outcome.agrees(),
                    "{} U1.{bits}, {length} pixels: {:?}",
                    method.name(),
                    outcome.violation
                );
            }
        }
    }
    let loaded = scene("six", include_str!("six.toml"));
    measured(&loaded.frame, &loaded.core_spec(None).unwrap());
}
