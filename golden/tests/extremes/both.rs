//! Lights and eyes behind the surface.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_golden::exact;
use specula_spec::Method;

use crate::{assert_within_one_code, codes};

/// Row 32: a light behind the surface has no diffuse, and its highlight is not gated.
#[test]
fn light_behind_keeps_its_highlight() {
    let (normal, light) = (tilted(60.0), tilted(151.0));
    let expected = 255.0 * (2.0 * normal.z * normal - DVec3::Z).dot(light).powi(4);
    assert!(normal.dot(light) < 0.0 && expected > 100.0);
    let without = frame([normal; 2], 2, &[light], material(0.0, 1.0, 0.0, 4));
    let with = frame([normal; 2], 2, &[light], mirror(4));
    assert!((exact::phong(&with, &with.spans[0], 0)[0] - expected).abs() < 1e-12);
    for method in Method::ALL {
        assert_eq!(codes(&spec(&without, method), &without), [0, 0]);
        assert!(codes(&spec(&with, method), &with)[0] > 100);
        assert_within_one_code(&spec(&with, method), &with);
    }
}

/// Row 33: with the eye behind the surface R points inwards; the result is the formula's, within
/// one code.
#[test]
fn eye_behind_is_defined() {
    for degrees in [95.0, 120.0, 180.0] {
        let frame = frame(
            [tilted(degrees - 5.0), tilted(degrees + 5.0)],
            33,
            &[tilted(2.0 * degrees)],
            material(0.1, 0.4, 0.5, 16),
        );
        for method in Method::ALL {
            assert_within_one_code(&spec(&frame, method), &frame);
        }
    }
}

/// Row 34: a grazing light keeps its highlight with both forms of D.
#[test]
fn grazing_highlights_are_there() {
    let light = DVec3::new(1.0, 1.0, -1.0).normalize();
    let halfway = (light + DVec3::Z).normalize();
    let frame = frame([halfway; 2], 2, &[light], mirror(256));
    for method in Method::ALL {
        assert!(codes(&spec(&frame, method), &frame)[0] >= 254);
    }
}
