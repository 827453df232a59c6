//! Meshes in every dialect of every format, made here, against the silhouettes that an independent
//! rasteriser finds.
//!
//! Adding a dialect is adding a change to one of the tables in `*_files.rs`.
mod raster;
mod solids;

use std::fs;
use std::path::Path;

use specula_scene::load;

use raster::{SIZE, View};
use solids::{Solid, all};

use crate::{glb_files, obj_files, ply_files, stl_files};

/// The views that each mesh is seen from. Their targets are no round numbers, so that few edges run
/// through middles of pixels.
const VIEWS: [View; 2] = [
    View { direction: [0.0, 0.0, 1.0], target: [0.813, 0.629, 0.0], height: 4.37 },
    View { direction: [0.5, 0.45, 1.0], target: [0.713, 0.529, 0.2], height: 4.91 },
];

/// Every dialect of a solid: the name and the bytes of a file.
fn files(solid: &Solid) -> Vec<(String, Vec<u8>)> {
    [
        obj_files::of_faces(&solid.shape.positions, &solid.faces),
        stl_files::dialects(&solid.shape),
        ply_files::dialects(&solid.shape),
        glb_files::dialects(&solid.shape),
    ]
    .concat()
}

/// The pixels that a scene file with a mesh covers.
fn drawn(folder: &Path, view: View, mesh: &str, bytes: &[u8]) -> Vec<bool> {
    fs::write(folder.join(mesh), bytes).expect("it can be written");
    let View { direction, target, height } = view;
    let scene = format!(
        "size = {SIZE:?}\n[camera]\ndirection = {direction:?}\ntarget = {target:?}\nheight = {height}\n[[object]]\nmesh = \"{mesh}\"\n"
    );
    let path = folder.join("scene.toml");
    fs::write(&path, scene).expect("it can be written");
    let loaded = load(path.to_str().expect("it is a plain name"), None)
        .unwrap_or_else(|error| panic!("{mesh}: {error}"));
    let mut covered = vec![false; (SIZE[0] * SIZE[1]) as usize];
    for span in &loaded.frame.spans {
        let first = (span.y * SIZE[0] + span.x) as usize;
        covered[first..first + span.length as usize].fill(true);
    }
    covered
}

/// A picture for a reader: `#` covered, `.` not, `!` wrong.
fn shown(found: &[bool], expected: &[Option<bool>]) -> String {
    let mark = |(&found, &expected): (&bool, &Option<bool>)| match (found, expected) {
        (found, Some(right)) if found != right => '!',
        (true, _) => '#',
        (false, _) => '.',
    };
    let marks: Vec<char> = found.iter().zip(expected).map(mark).collect();
    marks
        .chunks(SIZE[0] as usize)
        .map(|row| row.iter().chain(&['\n']).collect::<String>())
        .collect()
}

#[test]
fn every_dialect_covers_what_the_rasteriser_does() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    for solid in all() {
        for view in VIEWS {
            let expected = view.covered(&solid.shape.positions, &solid.faces);
            let known = expected.iter().flatten().count();
            assert!(
                known * 10 > expected.len() * 9 && expected.contains(&Some(true)),
                "{}: {known} pixels",
                solid.name
            );
            for (name, bytes) in files(&solid) {
                let found = drawn(folder.path(), view, &name, &bytes);
                let right = found
                    .iter()
                    .zip(&expected)
                    .all(|(found, right)| right.is_none_or(|right| right == *found));
                assert!(right, "{} as {name}:\n{}", solid.name, shown(&found, &expected));
            }
        }
    }
}

/// The test's own triangles cover what its polygons do.
#[test]
fn solids_are_cut_as_they_should_be() {
    for Solid { name, shape, faces } in all() {
        let triangles: Vec<Vec<u32>> = shape.triangles.iter().map(|t| t.to_vec()).collect();
        for view in VIEWS {
            let (whole, cut) = (
                view.covered(&shape.positions, &faces),
                view.covered(&shape.positions, &triangles),
            );
            assert!(
                whole.iter().zip(&cut).all(|(a, b)| a.is_none() || b.is_none() || a == b),
                "{name}"
            );
        }
    }
}
