//! Mesh files in the dialects of many programs: each gives the mesh and the picture of
//! the plain file, and none that is damaged brings anything down.
mod corpus;
mod damage;
mod glb;
mod glb_files;
mod obj;
mod obj_files;
mod ply;
mod ply_files;
mod said;
mod shape;
mod stl;
mod stl_files;

use std::fs;
use std::path::Path;

use glam::DVec3;
use specula_scene::mesh::{Mesh, Warning};
use specula_scene::{Frame, load};

/// The mesh of a file, and what is passed over in it.
fn read(name: &str, bytes: &[u8]) -> (Mesh, Vec<String>) {
    let (mesh, warnings) =
        Mesh::from_bytes(Path::new(name), bytes).unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// What is wrong with a file.
fn refused(name: &str, bytes: &[u8]) -> String {
    match Mesh::from_bytes(Path::new(name), bytes) {
        Ok(_) => panic!("{name} was read"),
        Err(error) => error.to_string(),
    }
}

type Triangle = [(DVec3, DVec3); 3];

/// Each triangle as its corners with their normals, starting with the smallest, all in order.
fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let mut all: Vec<Triangle> = mesh
        .triangles
        .iter()
        .zip(&mesh.normals)
        .map(|(corners, normals)| {
            let corner = |k: usize| (mesh.positions[corners[k] as usize], normals[k]);
            let turns = [[0, 1, 2], [1, 2, 0], [2, 0, 1]].map(|turn| turn.map(corner));
            turns
                .into_iter()
                .min_by(|a, b| order(a).total_cmp(&order(b)))
                .expect("there are three turns")
        })
        .collect();
    all.sort_by(|a, b| {
        a.iter()
            .zip(b)
            .fold(std::cmp::Ordering::Equal, |so_far, (a, b)| so_far.then(places(a.0, b.0)))
    });
    all
}

/// Tells the corners of a triangle apart.
fn order(triangle: &Triangle) -> f64 {
    triangle[0].0.dot(DVec3::new(1.0, 0.618, 0.241))
}

fn places(a: DVec3, b: DVec3) -> std::cmp::Ordering {
    let (a, b) = (a.to_array(), b.to_array());
    a.iter().zip(&b).fold(std::cmp::Ordering::Equal, |so_far, (a, b)| so_far.then(a.total_cmp(b)))
}

/// Checks that two meshes have the same triangles, turned the same way, and the same normals but
/// for the rounding of their sums.
fn check_same(name: &str, found: &Mesh, expected: &Mesh) {
    let (found, expected) = (triangles(found), triangles(expected));
    assert_eq!(found.len(), expected.len(), "{name}");
    for (found, expected) in found.iter().zip(&expected) {
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!(found.0 + DVec3::ZERO, expected.0 + DVec3::ZERO, "{name}");
            assert!(found.1.distance(expected.1) < 1e-12, "{name}: {} for {}", found.1, expected.1);
        }
    }
}

/// The runs of pixels that are covered, from top to bottom.
fn silhouette(frame: &Frame) -> Vec<(u32, u32, u32)> {
    let mut runs: Vec<(u32, u32, u32)> = Vec::new();
    for span in &frame.spans {
        match runs.last_mut() {
            Some((y, x, length)) if *y == span.y && *x + *length == span.x => {
                *length += span.length
            }
            _ => runs.push((span.y, span.x, span.length)),
        }
    }
    runs
}

/// Checks that all files give the mesh of the plain one, and its picture when they are loaded as a
/// scene.
fn check_dialects(files: &[(String, Vec<u8>)]) {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let (plain_name, plain) =
        files.iter().find(|(name, _)| name.starts_with("plain.")).expect("there is a plain one");
    let (expected, warnings) = read(plain_name, plain);
    assert!(warnings.is_empty(), "{warnings:?}");
    let picture = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("it can be written");
        let scene = load(path.to_str().expect("it is a plain name"), Some((64, 48)))
            .unwrap_or_else(|error| panic!("{error}"));
        silhouette(&scene.frame)
    };
    let shown = picture(plain_name, plain);
    for (name, bytes) in files {
        check_same(name, &read(name, bytes).0, &expected);
        assert_eq!(picture(name, bytes), shown, "{name}");
    }
}
