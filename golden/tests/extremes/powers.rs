//! Bases and exponents.
use glam::DVec3;
use specula_fixtures::frames::{frame, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_golden::exact;
use specula_scene::Needs;
use specula_spec::{CoreSpec, Method};

use crate::{assert_within_one_code, codes, trace, value};

/// Row 5: a negative base has no highlight, though n is even.
#[test]
fn negative_base_is_zero() {
    let frame = frame([DVec3::Z; 2], 4, &[tilted(100.0)], mirror(2));
    let core = spec(&frame, Method::Hybrid);
    assert!(value(&trace(&core, &frame, 0), "light0_numerator") < 0.0);
    assert_eq!(value(&trace(&core, &frame, 0), "light0_base"), 0.0);
    assert_eq!(codes(&core, &frame), [0; 4]);
}

/// Row 6: p may round above q, and the base stays 1.
#[test]
fn base_is_at_most_one() {
    let mut above = 0;
    for tenths in 0..900 {
        let tilt = f64::from(tenths) / 10.0;
        let frame = frame([tilted(tilt); 2], 2, &[tilted(2.0 * tilt)], mirror(4096));
        let core = spec(&frame, Method::Hybrid);
        let mut packet = specula_fixtures::specs::packet(&core, &frame);
        let start = core.inputs().iter().position(|port| port.name == "denominator_start").unwrap();
        // Many units in the last place of the operand: a quotient of 1.0005 and more.
        packet.inputs[start] -= packet.inputs[start] >> 10;
        let trace = specula_golden::fixed::Model::new(&core).trace(&packet, 0).unwrap();
        above += u32::from(value(&trace, "light0_numerator") > value(&trace, "denominator"));
        assert_eq!(
            (value(&trace, "light0_base"), value(&trace, "code_r")),
            (1.0, 255.0),
            "{tilt} degrees"
        );
    }
    assert_eq!(above, 900);
}

/// Row 53 for `hybrid`: the centre of the highlight is 255.
#[test]
fn centre_of_the_highlight_is_full_scale() {
    for j in 0..=12 {
        let frame = frame([DVec3::Z; 2], 5, &[DVec3::Z], mirror(1 << j));
        assert_eq!(codes(&spec(&frame, Method::Hybrid), &frame), [255; 5]);
    }
}

/// Row 54: exponents that are no power of two; n = 0 is cos^0 = 1 in f64, and no core is built for
/// it.
#[test]
fn uneven_exponents_and_none() {
    let uneven = frame([tilted(-10.0), tilted(10.0)], 50, &[tilted(5.0)], mirror(100));
    for method in Method::ALL {
        assert_within_one_code(&spec(&uneven, method), &uneven);
    }
    let none = frame([DVec3::Z; 2], 1, &[tilted(80.0)], mirror(0));
    assert_eq!(exact::phong(&none, &none.spans[0], 0), [255.0; 3]);
    for method in Method::ALL {
        assert!(CoreSpec::for_scene(&Needs::of(&none), None, Some(method)).is_err());
    }
}
