//! Values at the ends of their ranges.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_scene::Frame;
use specula_scene::limits::MOST_LIGHTS;
use specula_spec::Method;
use specula_testbench::{Bench, EngineKind};

use crate::cores::cores;
use crate::run::{assert_agrees, codes};

/// Row 26: quantised normals may be a little longer than 1, and y negative.
#[test]
fn normals_longer_than_one() {
    for degrees in 1..90 {
        let frame = frame(
            [tilted(f64::from(degrees)); 2],
            2,
            &[tilted(2.0 * f64::from(degrees))],
            mirror(256),
        );
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 29: normals and lights along every axis, in both directions: ±1.0 is representable.
#[test]
fn normals_and_lights_along_axes_are_exact() {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    for normal in axes {
        for light in axes {
            let frame = frame([normal; 2], 2, &[light], material(0.0, 1.0, 0.0, 4));
            let lambert = if normal == light { 255 } else { 0 };
            for core in cores(&frame) {
                assert_eq!(codes(&core, &frame), [lambert; 2], "N = {normal}, L = {light}");
            }
        }
    }
}

fn bright(lights: usize, factor: f64) -> Frame {
    let mut frame = frame([DVec3::Z; 2], 3, &vec![DVec3::Z; lights], material(1.0, 1.0, 1.0, 64));
    frame.ambient = [factor; 3];
    frame.lights.iter_mut().for_each(|light| light.colour = [factor; 3]);
    frame
}

/// All coefficients at full scale, then at the largest that a core takes: white, not wrapped
/// around.
#[test]
fn light_beyond_full_scale_is_white() {
    for (lights, factor) in [(1, 1.0), (MOST_LIGHTS, 1.0), (1, 256.0), (MOST_LIGHTS, 256.9)] {
        let frame = bright(lights, factor);
        for core in cores(&frame) {
            assert_eq!(codes(&core, &frame), [255; 3]);
        }
    }
}

/// Every coefficient all ones: as bright as the format goes, by raw value.
#[test]
fn coefficients_of_all_ones_do_not_wrap_around() {
    for method in Method::ALL {
        let mut frame = bright(MOST_LIGHTS, 1.0);
        let mut core = spec(&frame, method);
        core.parameters.coefficient.integer_bits = 16;
        core.check().unwrap();
        // Far above what the format holds, so that the host's quantisation ends at all ones.
        frame.ambient = [1e6; 3];
        frame.lights.iter_mut().for_each(|light| light.colour = [1e6; 3]);
        let packet = core.packet(&frame, &frame.spans[0]);
        let ones = packet
            .inputs
            .iter()
            .filter(|&&raw| raw == core.parameters.coefficient.max_raw())
            .count();
        assert_eq!(ones, 3 * (1 + 2 * MOST_LIGHTS));
        // The bound does not count what saturated in set-up, so `shade` would be asking too much.
        let bench = Bench::new(&frame, &core, "core").unwrap();
        let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
        assert_eq!(outcome.fault(), None);
        assert!(outcome.simulated.pixels.iter().all(|&code| code == [255; 3]));
    }
}

/// Nothing reflects anything: black, and no code below it.
#[test]
fn what_reflects_nothing_is_black() {
    let frame =
        frame([tilted(-40.0), tilted(40.0)], 20, &[tilted(10.0)], material(0.0, 0.0, 0.0, 1));
    for core in cores(&frame) {
        assert_eq!(codes(&core, &frame), [0; 20]);
    }
}
