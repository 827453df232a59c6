//! What the options of `lyon` do at their ends.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::lyon;
use specula_scene::Frame;
use specula_spec::CoreSpec;
use specula_spec::lyon::{
    Difference, Halfway, LyonSpec, Normalisation, Normals, ShapeDatapath, WrapAxis,
};

use crate::run::codes;

fn flat(light: DVec3, shininess: u32) -> Frame {
    frame([DVec3::Z; 2], 1, &[light], mirror(shininess))
}

fn of_unit_halfway(
    frame: &Frame,
    difference: Difference,
    halfway: Halfway,
    squarings: u32,
) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.difference, lyon.halfway, lyon.squarings) = (difference, halfway, squarings)
    })
}

/// Row 12, figure 9's rows 6 to 10: L = -V leaves H/|H| undefined and without highlight; H/2 = 0
/// gives the projection its 1.0 for every normal, and 0 - N none.
#[test]
fn light_opposite_the_eye() {
    let frame = frame([tilted(10.0), tilted(20.0)], 8, &[-DVec3::Z], mirror(16));
    for k in 0..=3 {
        for difference in [Difference::UnitHalfwayProjection, Difference::UnitHalfwayMinusNormal] {
            assert_eq!(
                codes(&of_unit_halfway(&frame, difference, Halfway::Unit, k), &frame),
                [0; 8]
            );
        }
        for halfway in [Halfway::Half, Halfway::HalfG2] {
            let with = |difference| codes(&of_unit_halfway(&frame, difference, halfway, k), &frame);
            assert_eq!(with(Difference::UnitHalfwayProjection), [255; 8]);
            assert_eq!(with(Difference::UnitHalfwayMinusNormal), [0; 8]);
        }
    }
}

/// Row 12: n = 1 and k = 2 would leave f_2(2) = 1/16 of 0 - N; without a half-way vector there is
/// no highlight whatever n is.
#[test]
fn no_halfway_vector_no_highlight() {
    let frame = flat(-DVec3::Z, 1);
    let code = |halfway| {
        codes(&of_unit_halfway(&frame, Difference::UnitHalfwayMinusNormal, halfway, 2), &frame)[0]
    };
    assert_eq!((code(Halfway::Unit), code(Halfway::Half)), (0, 16));
}

/// Row 34: D = h1 - N loses the highlight of a light from behind, where h1 is short: figure 9's row
/// 10, at most 0.153 for n = 16.
#[test]
fn unit_halfway_minus_normal_loses_the_highlight_of_a_grazing_light() {
    let light = DVec3::new(1.0, 1.0, -1.0).normalize();
    let normal = (light + DVec3::Z).normalize();
    for (n, brightest) in [(16, 0.153), (64, 0.0)] {
        let frame = frame([normal; 2], 1, &[light], mirror(n));
        let code = codes(
            &of_unit_halfway(&frame, Difference::UnitHalfwayMinusNormal, Halfway::HalfG2, 2),
            &frame,
        )[0];
        assert!(f64::from(code) <= 255.0 * brightest + 1.0, "{code} at n = {n}");
        let unit = codes(
            &of_unit_halfway(&frame, Difference::UnitHalfwayMinusNormal, Halfway::Unit, 2),
            &frame,
        )[0];
        assert!(unit >= 254, "{unit}");
    }
}

fn root(frame: &Frame, squarings: u32) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.shape, lyon.difference, lyon.squarings) =
            (ShapeDatapath::Root, Difference::ReflectionMinusLight, squarings);
    })
}

/// Rows 30 and 31: m D has an integer part along one axis alone and no fraction at all; up to m =
/// 127 and D = 2.
#[test]
fn integer_part_is_enough() {
    for k in 0..=3 {
        for n in [64, 8191] {
            for light in [-DVec3::Z, DVec3::X, -DVec3::Y] {
                let frame = flat(light, n);
                assert_eq!(codes(&root(&frame, k), &frame), [0], "k = {k}, n = {n}, L = {light}");
            }
        }
    }
}

/// Rows 22, 23 and 53 of the root shape: the centre, and n = 1 at 180 and 90 degrees.
#[test]
fn root_shape_is_the_shape() {
    for (k, at_180, at_90) in [(0, 0, 0), (1, 0, 64), (2, 16, 81), (3, 26, 88)] {
        for (light, code) in [(DVec3::Z, 255), (-DVec3::Z, at_180), (DVec3::X, at_90)] {
            let frame = flat(light, 1);
            assert_eq!(codes(&root(&frame, k), &frame), [code], "k = {k}");
        }
    }
}

fn within_a_code(frame: &Frame, a: impl FnOnce(&mut LyonSpec), b: impl FnOnce(&mut LyonSpec)) {
    let (a, b) = (codes(&lyon(frame, a), frame), codes(&lyon(frame, b), frame));
    assert!(a.iter().zip(&b).all(|(&a, &b)| a.abs_diff(b) <= 1), "{a:?} and {b:?}");
}

/// For normals of unit length D2 is as long as R - L, and D3 as H x N; and the root shape is the
/// other one.
#[test]
fn forms_that_are_equal() {
    for n in [5, 64, 256] {
        let frame = frame([tilted(-12.0), tilted(14.0)], 60, &[tilted(8.0)], mirror(n));
        let exactly = |lyon: &mut LyonSpec, difference| {
            (lyon.normalisation, lyon.difference) = (Normalisation::Exact, difference)
        };
        let fine = |lyon: &mut LyonSpec| lyon.formats.vector.fraction_bits = 17;
        let with = |difference| {
            move |lyon: &mut LyonSpec| {
                exactly(lyon, difference);
                fine(lyon);
                (
                    lyon.formats.difference.fraction_bits,
                    lyon.formats.length_squared.fraction_bits,
                ) = (17, 19);
                lyon.formats.gain.fraction_bits = 19;
            }
        };
        within_a_code(
            &frame,
            with(Difference::ReflectionMinusLight),
            with(Difference::LightReflection),
        );
        within_a_code(
            &frame,
            with(Difference::HalfwayProjection),
            with(Difference::HalfwayCrossNormal),
        );
        within_a_code(&frame, with(Difference::HalfwayCrossNormal), |lyon| {
            with(Difference::HalfwayCrossNormal)(lyon);
            lyon.shape = ShapeDatapath::Root;
        });
    }
}

fn wrapped(frame: &Frame, axis: WrapAxis) -> CoreSpec {
    lyon(frame, |lyon| (lyon.normals, lyon.axis) = (Normals::Wrapped, axis))
}

/// Row 7: opposite normals have no bisector; any vector across them serves, and the ends are what
/// they are.
#[test]
fn wrapped_opposite_normals() {
    for normal in [DVec3::Z, DVec3::X, tilted(40.0)] {
        let frame = frame([normal, -normal], 33, &[normal], material(0.0, 1.0, 0.0, 16));
        for axis in [WrapAxis::Bisector, WrapAxis::Face] {
            let codes = codes(&wrapped(&frame, axis), &frame);
            // Half-way round the normal is across: the light grazes.
            assert!(codes[0] >= 254 && codes[16] <= 1 && codes[32] == 0, "{codes:?}");
        }
    }
}

/// Row 8: the face's normal, (2 N0 + N1)/|..| here, is 101 degrees from N1 and gives way to the
/// bisector; at 60 degrees it does not.
#[test]
fn wrapped_around_a_far_axis() {
    let with = |degrees| {
        let frame =
            frame([DVec3::Z, tilted(degrees)], 40, &[tilted(20.0)], material(0.0, 1.0, 0.0, 16));
        [WrapAxis::Face, WrapAxis::Bisector].map(|axis| codes(&wrapped(&frame, axis), &frame))
    };
    let ([far_face, far_bisector], [near_face, near_bisector]) = (with(130.0), with(60.0));
    assert_eq!(far_face, far_bisector);
    assert_ne!(near_face, near_bisector);
}

/// Row 9: ends all but opposite.
#[test]
fn wrapped_nearly_opposite_normals() {
    for degrees in [179.0, 179.99, 179.999_999, 180.0] {
        let frame =
            frame([tilted(0.0), tilted(degrees)], 50, &[tilted(90.0)], material(0.0, 1.0, 0.0, 16));
        let codes = codes(&wrapped(&frame, WrapAxis::Bisector), &frame);
        let end = 255.0 * (180.0 - degrees).to_radians().sin();
        assert!(codes[0] <= 1 && (f64::from(codes[49]) - end).abs() <= 1.0, "{codes:?}");
    }
}

/// Row 10: n = N makes H·H = 4 exactly; row 50: no normal at all, ambient light.
#[test]
fn wrapped_around_itself_and_nothing() {
    let frame_of = |normal| frame([normal; 2], 5, &[DVec3::Z], material(0.2, 0.0, 0.8, 256));
    for (normal, code) in [(DVec3::Z, 255), (DVec3::ZERO, 51)] {
        let frame = frame_of(normal);
        for axis in [WrapAxis::Bisector, WrapAxis::Face] {
            assert_eq!(codes(&wrapped(&frame, axis), &frame), [code; 5]);
        }
        assert_eq!(codes(&lyon(&frame, |lyon| lyon.normals = Normals::Flat), &frame), [code; 5]);
        for normalisation in [Normalisation::None, Normalisation::Exact] {
            assert_eq!(
                codes(&lyon(&frame, |lyon| lyon.normalisation = normalisation), &frame),
                [code; 5]
            );
        }
    }
}

/// Rows 1 and 2: opposite ends with the exact normalisation and with none; the middle is ambient
/// light and nothing is divided by.
#[test]
fn opposite_normals_without_direction() {
    let frame = frame([DVec3::X, -DVec3::X], 3, &[DVec3::X], material(0.2, 0.5, 0.3, 16));
    for normalisation in [Normalisation::None, Normalisation::Exact] {
        assert_eq!(codes(&lyon(&frame, |lyon| lyon.normalisation = normalisation), &frame)[1], 51);
    }
}

/// Flat normals do not change along a span.
#[test]
fn flat_normals_are_flat() {
    let frame =
        frame([tilted(-30.0), tilted(30.0)], 30, &[tilted(-10.0)], material(0.1, 0.5, 0.4, 16));
    let codes = codes(&lyon(&frame, |lyon| lyon.normals = Normals::Flat), &frame);
    // No polygon is known, and the third vertex has the first normal: the mean of (-30, 30, -30)
    // degrees.
    let mean = (2.0 * tilted(-30.0) + tilted(30.0)).normalize();
    let cosine = mean.dot(tilted(-10.0));
    let reflected = 2.0 * mean.z * mean - DVec3::Z;
    let x = 8.0 * (reflected - tilted(-10.0)).length_squared() / 4.0;
    let wanted = 255.0 * (0.1 + 0.5 * cosine + 0.4 * (1.0 - x).max(0.0).powi(4));
    assert!(
        codes.iter().all(|&code| (f64::from(code) - wanted).abs() < 1.5),
        "{codes:?}, {wanted}"
    );
}
