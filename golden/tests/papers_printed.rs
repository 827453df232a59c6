//! Figures that docs/methods.md, docs/numerics.md and docs/extremes.md print, against `exact`.
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use specula_golden::exact::formula::{
    consistent, newton, normalisation::unit, point_light, slerp, wrap,
};

fn tilted(degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    DVec3::new(sin, 0.0, cos)
}

/// numerics N1: 0 <= q - q~ <= 0.0126887, at 40.20 degrees.
#[test]
fn rational_q_falls_short_as_printed() {
    let short = |k: u32| {
        consistent::q(FRAC_PI_2 * f64::from(k) / 9000.0)
            - consistent::rational_q(FRAC_PI_2 * f64::from(k) / 9000.0)
    };
    let worst = (0..=9000).max_by(|&a, &b| short(a).total_cmp(&short(b))).unwrap();
    assert!((short(worst) - 0.012_688_7).abs() < 1e-7 && worst == 4020);
    assert!((0..=9000).all(|k| short(k) > -1e-15));
}

/// numerics N2d: slerp and normalised lerp differ by .134 (30), 1.12 (60) and 4.07 degrees (90).
#[test]
fn slerp_differs_from_lerp_as_printed() {
    for (degrees, printed, last_place) in
        [(30.0, 0.134, 0.001), (60.0, 1.12, 0.01), (90.0, 4.07, 0.01)]
    {
        let ends = [tilted(0.0), tilted(degrees)];
        let at = |t: f64| {
            slerp::slerp(ends, t)
                .unwrap()
                .angle_between(unit(ends[0].lerp(ends[1], t)).unwrap())
                .to_degrees()
        };
        let worst = (0..=1000).map(|k| at(f64::from(k) / 1000.0)).fold(0.0, f64::max);
        assert!((worst - printed).abs() < last_place, "{degrees}: {worst}");
    }
}

/// extremes rows 7, 13, 14, 39 and 40.
#[test]
fn degenerate_vectors_are_defined() {
    assert_eq!(wrap::wrap(DVec3::Z, -DVec3::Z), None);
    assert_eq!(slerp::slerp([DVec3::X; 2], 0.5), Some(DVec3::X));
    assert_eq!(slerp::slerp([DVec3::X, -DVec3::X], 0.5), None);
    assert_eq!(point_light::wrapped(DVec3::Z, DVec3::ZERO), DVec3::Z);
    let far = 10.0 * tilted(60.0);
    assert!((point_light::wrapped_cosine(DVec3::Z, far) + 0.351).abs() < 1e-3);
    assert!(
        (point_light::wrapped_cosine(DVec3::Z, point_light::scaled([far; 2])[0]) - 0.5).abs()
            < 1e-14
    );
}

/// extremes row 20 and numerics N3c: steps back to 1 after a jump. They print no criterion; half
/// an LSB is taken for it here.
#[test]
fn newton_recovers_from_jumps() {
    const HALF_LSB: f64 = 0.5 / 255.0;
    for (guess, steps) in [(0.5_f64.sqrt(), 2), (0.5, 3), (0.26, 4), (0.1, 6), (0.01, 9)] {
        assert!((newton::root(guess, 1.0, steps) - 1.0).abs() < HALF_LSB, "{guess}");
        assert!((newton::root(guess, 1.0, steps - 1) - 1.0).abs() > HALF_LSB, "{guess}");
    }
}
