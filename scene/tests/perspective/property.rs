//! Triangles anywhere, also behind the eye and around the near plane.
use std::fs;

use proptest::prelude::*;
use specula_fixtures::ray_caster::CastCamera;

use super::shot::{Model, Shot, camera};
use super::{differing, is_empty};

/// Coordinates near the eye and far from it.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -4.0..4.0_f64, 2 => -1.0..1.0_f64, 1 => -1000.0..1000.0_f64]
}

/// A mesh of triangles by themselves.
fn obj(triangles: &[[[f64; 3]; 3]]) -> String {
    let vertex = |[x, y, z]: &[f64; 3]| format!("v {x} {y} {z}\n");
    let faces =
        (0..triangles.len()).map(|k| format!("f {} {} {}\n", 3 * k + 1, 3 * k + 2, 3 * k + 3));
    triangles.iter().flatten().map(vertex).chain(faces).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// What the picture shows is what rays meet; and if it shows nothing, they meet nothing.
    #[test]
    fn triangles_anywhere_are_where_rays_meet_them(
        triangles in prop::collection::vec(
            prop::array::uniform3(prop::array::uniform3(coordinate())), 1..5),
        near in prop_oneof![0.001..0.1_f64, 0.1..3.0_f64],
        field_of_view in 2.0..160.0_f64,
    ) {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        let path = folder.path().join("triangles.obj");
        fs::write(&path, obj(&triangles)).expect("a temporary file can be written");
        let size = (24, 18);
        let view = CastCamera { field_of_view, size, ..camera([0.1, 0.2, 0.3], [0.4, 0.1, -3.0], near) };
        let shot = Shot { model: Model::read(path.to_str().expect("temporary paths are plain")), camera: view };
        match shot.frame("screen") {
            Ok(frame) => {
                differing(&shot, &frame);
            }
            Err(error) => {
                let text = error.to_string();
                let known = text.contains("nothing of the scene") || text.contains("behind the eye");
                prop_assert!(known && is_empty(&shot), "{text}");
            }
        }
    }
}
