//! Normals that vanish or oppose each other.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::{lyon, spec};
use specula_scene::Needs;
use specula_spec::Method;
use specula_spec::lyon::Difference;
use specula_spec::reflection::Bisector;

use crate::cores::{cores, cross_form, duffs, reflection_form, reflections};
use crate::run::{assert_agrees, codes};

const AMBIENT: f64 = 0.2;
const AMBIENT_CODE: u8 = 51;

/// Rows 1 and 2: N0 = -N1, and t = 1/2 is a pixel, whose normal has no direction. `lyon` gives
/// ambient light there.
#[test]
fn opposite_normals_leave_ambient_light_in_the_middle() {
    for (first, length) in [(DVec3::X, 3), (DVec3::Z, 5), (tilted(40.0), 33), (DVec3::Y, 257)] {
        let frame =
            frame([first, -first], length, &[tilted(30.0)], material(AMBIENT, 0.5, 0.3, 16));
        for core in cores(&frame) {
            let codes = codes(&core, &frame);
            if core.method() == Method::Lyon {
                assert_eq!(codes[length as usize / 2], AMBIENT_CODE);
            }
        }
    }
}

/// Row 1: an even number of pixels never meets t = 1/2.
#[test]
fn opposite_normals_without_a_middle() {
    let frame =
        frame([tilted(20.0), -tilted(20.0)], 4, &[tilted(10.0)], material(0.0, 1.0, 0.0, 16));
    let lambert = (255.0 * tilted(20.0).dot(tilted(10.0))).round() as u8;
    // At t = 1/3 the normal has length 1/3, which g2 and a Newton step bring no nearer to 1 than
    // they can.
    let codes = codes(&spec(&frame, Method::Lyon), &frame);
    assert!((lambert / 2..=lambert).contains(&codes[1]), "{codes:?}");
    assert_eq!((codes[0], codes[2], codes[3]), (lambert, 0, 0));
}

/// Rows 2 and 4: q = 0 gives no highlight, and the pixels beside it theirs.
#[test]
fn hybrid_at_q_zero() {
    for length in [3, 5, 9, 257] {
        let frame = frame([DVec3::Z, -DVec3::Z], length, &[DVec3::Z], mirror(16));
        let codes = codes(&spec(&frame, Method::Hybrid), &frame);
        let middle = length as usize / 2;
        assert_eq!((codes[0], codes[middle], codes[length as usize - 1]), (255, 0, 255));
    }
    // In the longest span rounding leaves something of q, and what p/q then is nobody knows: the
    // bound says so.
    let longest = frame([DVec3::Z, -DVec3::Z], 8191, &[DVec3::Z], mirror(16));
    assert_agrees(&spec(&longest, Method::Hybrid), &longest);
}

/// Row 2: where q = 0 nobody knows a direction, and ambient light is all there is; the pixels
/// beside it have theirs.
#[test]
fn duff_at_q_zero() {
    for length in [3, 5, 9, 257] {
        let frame =
            frame([DVec3::Z, -DVec3::Z], length, &[DVec3::Z], material(AMBIENT, 0.5, 0.3, 16));
        let lit = |diffuse: f64, highlight: f64| {
            (255.0 * (AMBIENT + 0.5 * diffuse + 0.3 * highlight)).round() as u8
        };
        for core in duffs(&frame) {
            let codes = codes(&core, &frame);
            let middle = length as usize / 2;
            // Behind the middle the light is behind the surface, and the highlight is not gated
            // (row 32).
            assert_eq!(
                (codes[0], codes[middle], codes[length as usize - 1]),
                (lit(1.0, 1.0), AMBIENT_CODE, codes[middle + 1])
            );
            assert_eq!(codes[middle - 1], codes[0]);
        }
    }
    // In the longest span rounding leaves something of q.
    let longest = frame([DVec3::Z, -DVec3::Z], 8191, &[DVec3::Z], mirror(16));
    for core in duffs(&longest) {
        assert_agrees(&core, &longest);
    }
}

/// Row 12: L = -V leaves Blinn's half-way vector without a direction, and the highlight is 0; R·L
/// is -N·L there, 0 as well.
#[test]
fn duff_with_the_light_opposite_the_eye() {
    let frame = frame([tilted(10.0), tilted(20.0)], 8, &[-DVec3::Z], mirror(16));
    for core in duffs(&frame) {
        assert_eq!(codes(&core, &frame), [0; 8]);
    }
}

/// Rows 1, 7 and 9: opposite ends have no normal half-way between them, nor do those that are
/// opposite but for a millionth; the span gets no diffuse light, and a highlight of the hybrid's
/// alone.
#[test]
fn reflection_between_opposite_normals() {
    let nearly = -(DVec3::Z + 5e-7 * DVec3::X).normalize();
    for end in [-DVec3::Z, nearly] {
        for length in [2, 3, 257] {
            let frame =
                frame([DVec3::Z, end], length, &[tilted(10.0)], material(AMBIENT, 0.8, 0.0, 16));
            for core in reflections(&frame) {
                assert_eq!(codes(&core, &frame), vec![AMBIENT_CODE; length as usize]);
            }
        }
    }
}

/// Row 8: the polygon's normal lies behind the normal at one end, and the span's own bisector is
/// taken; no pixel is 180 degrees wrong.
#[test]
fn reflection_falls_back_to_the_spans_bisector() {
    let mut frame =
        frame([tilted(0.0), tilted(110.0)], 20, &[tilted(55.0)], material(0.0, 1.0, 0.0, 1));
    frame.triangles[0].facet.normal = tilted(10.0);
    let [of_span, of_triangle] = [Bisector::Span, Bisector::Triangle]
        .map(|bisector| bisector.fixed_normal(&frame, &frame.spans[0]).unwrap());
    assert_eq!(of_triangle, of_span);
    let at_the_ends = (255.0 * 55f64.to_radians().cos()).round() as u8;
    for core in reflections(&frame) {
        let codes = codes(&core, &frame);
        assert_eq!((codes[0], codes[19]), (at_the_ends, at_the_ends), "{core:?}");
    }
}

/// Row 10: n = N makes H as long as it can be, and the normal comes out as it went in.
#[test]
fn reflection_about_the_normal_itself() {
    for axis in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z] {
        let frame = frame([axis; 2], 300, &[axis], material(0.0, 1.0, 0.0, 1));
        for core in reflections(&frame) {
            assert_eq!(codes(&core, &frame), vec![255; 300]);
        }
    }
}

/// Row 3: 150 degrees.
#[test]
fn spans_of_150_degrees_agree() {
    for shininess in [1, 256, 4096] {
        let frame = frame([tilted(-75.0), tilted(75.0)], 300, &[tilted(10.0)], mirror(shininess));
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 27: z = 0 gives g2 = 2 and, with three Newton steps, 6.75; nothing wraps around.
#[test]
fn the_largest_gain_does_not_wrap_around() {
    let frame = frame([DVec3::X, -DVec3::X], 3, &[DVec3::Z], material(AMBIENT, 0.5, 0.3, 8191));
    for newton_steps in 0..=3 {
        for difference in [Difference::HalfwayCrossNormal, Difference::ReflectionMinusLight] {
            let core = lyon(&frame, |lyon| {
                (lyon.newton_steps, lyon.difference) = (newton_steps, difference)
            });
            assert_eq!(codes(&core, &frame)[1], AMBIENT_CODE);
        }
    }
}

/// A normal that rounds to nothing though it has a direction: its highlight is lost whole, and the
/// bound must say so.
#[test]
fn bound_knows_of_normals_that_round_away() {
    let frame = frame([tilted(90.0), tilted(-89.9)], 3, &[tilted(4.0)], mirror(1));
    let shortest = Needs::of(&frame).shortest_normal;
    let (vanishes, squared_does_not) =
        (shortest < (-9f64).exp2(), shortest * shortest > (-24f64).exp2());
    assert!(
        vanishes && squared_does_not,
        "{shortest} is to round to 0 in S1.8, and its square not to in U1.24"
    );
    for squarings in 0..=3 {
        let core = lyon(&frame, |lyon| {
            (lyon.difference, lyon.squarings) = (Difference::HalfwayCrossNormal, squarings);
            lyon.formats.vector.fraction_bits = 8;
            lyon.formats.length_squared.fraction_bits = 24;
        });
        let outcome = assert_agrees(&core, &frame);
        assert_eq!(outcome.simulated.pixels[1], [0; 3]);
        assert!(outcome.comparison.errors.quantisation.max_lsb > 200.0);
    }
}

/// Row 50: a triangle whose normals are all 0 has ambient light alone in `lyon`, and no highlight
/// in `hybrid`.
#[test]
fn normals_of_length_0_leave_ambient_light() {
    for length in [1, 2, 100] {
        let frame = frame(
            [DVec3::ZERO; 2],
            length,
            &[DVec3::Z, tilted(50.0)],
            material(AMBIENT, 1.0, 1.0, 64),
        );
        for core in cores(&frame) {
            assert_eq!(codes(&core, &frame), vec![AMBIENT_CODE; length as usize]);
        }
    }
}

/// Row 50: a zero normal at one end alone.
#[test]
fn a_zero_normal_at_one_end() {
    for normals in [[DVec3::ZERO, DVec3::Z], [tilted(60.0), DVec3::ZERO]] {
        let frame = frame(normals, 17, &[tilted(20.0)], material(AMBIENT, 0.3, 0.3, 64));
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 12: L = -V makes H = 0, and H × N 0 for every normal: highlight everywhere. D = R - L and
/// p/q know better.
#[test]
fn light_opposite_the_eye() {
    let frame = frame([tilted(10.0), tilted(20.0)], 8, &[-DVec3::Z], mirror(16));
    for squarings in 0..=3 {
        assert_eq!(codes(&cross_form(&frame, squarings), &frame), [255; 8]);
        assert_eq!(codes(&reflection_form(&frame, squarings), &frame), [0; 8]);
    }
    assert_eq!(codes(&spec(&frame, Method::Hybrid), &frame), [0; 8]);
}

/// Row 35: V and L nearly opposite.
#[test]
fn light_nearly_opposite_the_eye() {
    for degrees in [170.0, 179.0, 179.9, 179.999] {
        let frame = frame(
            [tilted(degrees / 2.0 - 5.0), tilted(degrees / 2.0 + 4.0)],
            50,
            &[tilted(degrees)],
            mirror(64),
        );
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}
