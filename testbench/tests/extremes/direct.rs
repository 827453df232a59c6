//! Short normals under the root.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_spec::Method;

use crate::run::{assert_agrees, codes};

/// Rows 2 and 4: q = 0 in the middle gives no highlight there, not even with the light behind, and
/// the pixels beside it theirs.
#[test]
fn vanishing_normals_have_no_highlight() {
    for length in [3, 5, 9, 257] {
        let ahead = frame([DVec3::Z, -DVec3::Z], length, &[DVec3::Z], mirror(16));
        let codes_ahead = codes(&spec(&ahead, Method::Direct), &ahead);
        let middle = length as usize / 2;
        assert_eq!(
            (codes_ahead[0], codes_ahead[middle], codes_ahead[length as usize - 1]),
            (255, 0, 255)
        );
        let behind = frame([DVec3::X, -DVec3::X], length, &[-DVec3::Z], mirror(16));
        assert_eq!(codes(&spec(&behind, Method::Direct), &behind)[middle], 0);
    }
}

/// Rows 3 and 38: 150 degrees, and the longest span: within a code of exact shading, since ends are
/// unit vectors.
#[test]
fn wide_and_long_spans_are_exact() {
    for (half, length, n) in [(75.0, 300, 256), (45.0, 8192, 4096), (15.0, 8192, 256)] {
        let frame = frame(
            [tilted(-half), tilted(half)],
            length,
            &[tilted(10.0)],
            material(0.1, 0.4, 0.5, n),
        );
        let total =
            assert_agrees(&spec(&frame, Method::Direct), &frame).comparison.errors.total.max_lsb;
        assert!(total <= 1.0, "{half} degrees either side: {total} LSB");
    }
}
