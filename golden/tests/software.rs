//! The f32 loops against f64.
use glam::DVec3;
use specula_golden::exact;
use specula_golden::software::{METHODS, by_name};

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
