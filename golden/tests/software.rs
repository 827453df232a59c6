//! The f32 loops against f64.
use glam::DVec3;
use specula_golden::exact;
use specula_golden::software::{METHODS, by_name};
use specula_scene::spec::phong::Places;
use specula_scene::{CoreSpec, Frame, LocalLight, Method, MethodSpec, Needs, Spot};

mod common;
use common::{frame, material, tilted};

/// Schemes that are Phong shading in exact arithmetic. f32 forward differences lose 2^-24 (1 + S + S²/2) of q at most (NUMERICS.md 3b), here 1.3e-4,
/// of which the base takes twice and n = 16 sixteen times: 1 LSB.
#[test]
fn exact_reformulations_are_phong() {
    let frame = frame([tilted(-15.0), tilted(15.0)], 65, &[tilted(20.0)], material(0.1, 0.3, 0.5, 16));
    let span = &frame.spans[0];
    for name in ["phong", "duff", "duff-hybrid", "duff-quotient", "direct", "fast-phong"] {
        let mut out = [[0.0; 3]; 65];
        (by_name(name).unwrap().set_up)(&frame, span).shade(&mut out);
        for (i, pixel) in (0..).zip(out) {
            let error = (f64::from(pixel[0]) - exact::phong(&frame, span, i)[0]).abs();
            assert!(error < 1.0, "{name}, pixel {i}: {error}");
        }
    }
}

/// EXTREMES rows 1, 2, 4, 7, 12, 13, 14 and 37: everything is a number between 0 and 255.
#[test]
fn nothing_is_undefined() {
    for (ends, length) in [([DVec3::X, -DVec3::X], 3), ([DVec3::Z, -DVec3::Z], 5), ([DVec3::Z; 2], 1), ([-DVec3::Z; 2], 4)] {
        let frame = frame(ends, length, &[DVec3::Z, -DVec3::Z, DVec3::X], material(0.1, 0.5, 0.5, 16));
        for method in METHODS {
            let mut out = vec![[0.0; 3]; length as usize];
            (method.set_up)(&frame, &frame.spans[0]).shade(&mut out);
            assert!(out.iter().flatten().all(|c| (0.0..=255.0).contains(c)), "{}: {out:?}", method.name);
        }
    }
}

/// Lights and an eye at places: a lamp, a spot and a light at infinity over a tilted span, close by and far away. f32 adds up S steps, each off by
/// 2^-24 of the vector; n = 16 multiplies that.
#[test]
fn places_are_those_of_the_methods() {
    for distance in [1.5, 100.0] {
        let frame = lit_from_places(distance);
        let (span, needs) = (&frame.spans[0], Needs::of(&frame));
        for (name, places) in [("phong-places", Places::Exact), ("phong-wrapped-places", Places::Wrapped)] {
            let mut core = CoreSpec::for_scene(&needs, None, Some(Method::Phong)).unwrap();
            if let MethodSpec::Phong(phong) = &mut core.method {
                phong.places = places;
            }
            let mut out = [[0.0; 3]; 65];
            (by_name(name).unwrap().set_up)(&frame, span).shade(&mut out);
            for (i, pixel) in (0..).zip(out) {
                let error = (f64::from(pixel[0]) - exact::method(&core, &frame, span, i)[0]).abs();
                assert!(error < 0.05, "{name} at {distance}, pixel {i}: {error}");
            }
        }
    }
}

fn lit_from_places(distance: f64) -> Frame {
    let mut frame = frame([tilted(-15.0), tilted(15.0)], 65, &[tilted(20.0)], material(0.1, 0.3, 0.3, 16));
    frame.triangles[0].positions = [DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.2, 0.0), DVec3::Y];
    let lamp = |direction: DVec3, spot| LocalLight { position: distance * direction, spot, colour: [0.5; 3] };
    let spot = Spot { axis: -tilted(-30.0), exponent: 20 };
    frame.local_lights = vec![lamp(tilted(40.0), None), lamp(tilted(-35.0), Some(spot))];
    frame.eye = Some(distance * tilted(10.0));
    frame
}
