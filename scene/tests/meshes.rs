//! Mesh files: the same solid in every format, and damaged files that must not bring anything down.
use std::fs;
use std::path::{Path, PathBuf};

use glam::DVec3;
use proptest::prelude::*;
use specula_scene::mesh::normals::newell;
use specula_scene::mesh::{Mesh, Warning};

fn files() -> Vec<PathBuf> {
    let entries = fs::read_dir("tests/meshes").expect("tests run in the crate's folder");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("the folder can be listed").path()).collect();
    files.sort();
    files
}

/// The mesh of a file that has nothing to be passed over.
fn mesh(path: &Path) -> Mesh {
    let (mesh, warnings) = Mesh::read(path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(warnings, []);
    mesh
}

/// The mesh of a file's text, and what is passed over in it.
fn read(name: &str, text: &[u8]) -> (Mesh, Vec<String>) {
    let (mesh, warnings) = Mesh::from_bytes(Path::new(name), text).unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// Triangles as their corners' places, each turned so that it starts with the smallest, and sorted.
fn triangles(mesh: &Mesh) -> Vec<[[i64; 3]; 3]> {
    let place = |k: u32| mesh.positions[k as usize].to_array().map(|x| x as i64);
    let turned = |t: &[u32; 3]| {
        let corners = t.map(place);
        let turns = [[0, 1, 2], [1, 2, 0], [2, 0, 1]].map(|order| order.map(|k: usize| corners[k]));
        turns.into_iter().min().expect("there are three turns")
    };
    let mut all: Vec<_> = mesh.triangles.iter().map(turned).collect();
    all.sort();
    all
}

#[test]
fn every_format_gives_the_same_tetrahedron() {
    let expected = mesh(Path::new("tests/meshes/tetra.obj"));
    for path in files() {
        if path.ends_with("tetra_mirrored.glb") {
            continue;
        }
        let mesh = mesh(&path);
        assert_eq!(triangles(&mesh), triangles(&expected), "{}", path.display());
        assert_eq!(mesh.positions.len(), 4, "{}", path.display());
        check_corner_normals(&mesh, DVec3::ZERO);
    }
}

#[test]
fn nodes_of_a_glb_move_and_mirror_its_meshes() {
    let mesh = mesh(Path::new("tests/meshes/tetra_mirrored.glb"));
    // Moved by -1 and then mirrored: x from -2..0 to 0..2.
    assert!(mesh.positions.iter().all(|p| (0.0..=2.0).contains(&p.x)));
    check_corner_normals(&mesh, DVec3::X);
}

/// The tetrahedron's vertex normals point from its middle to its corners (METHODS.md A2), its faces outwards.
fn check_corner_normals(mesh: &Mesh, middle: DVec3) {
    for (triangle, normals) in mesh.triangles.iter().zip(&mesh.normals) {
        let corners = triangle.map(|k| mesh.positions[k as usize]);
        for (corner, normal) in corners.iter().zip(normals) {
            assert!(((*corner - middle).normalize() - *normal).length() < 1e-12, "{corner} {normal}");
        }
        let face = newell(&corners).expect("the faces have areas");
        assert!(face.dot(corners[0] - middle) > 0.0);
    }
}

/// Quads count once in vertex normals, although they become two triangles.
#[test]
fn a_cube_of_quads_has_the_normals_of_its_corners() {
    let vertices = (0..8).map(|k| format!("v {} {} {}\n", k & 1, k >> 1 & 1, k >> 2)).collect::<String>();
    let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    let (mesh, _) = read("cube.obj", format!("{vertices}{faces}").as_bytes());
    assert_eq!(mesh.triangles.len(), 12);
    for (triangle, normals) in mesh.triangles.iter().zip(&mesh.normals) {
        for (&k, normal) in triangle.iter().zip(normals) {
            let outward = (mesh.positions[k as usize] - DVec3::splat(0.5)).normalize();
            assert!((outward - *normal).length() < 1e-12);
        }
    }
}

#[test]
fn obj_files_may_have_comments_missing_normals_and_lines() {
    let text = "v 0 0 0 # first\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nvn 0 0 7\nvt 0 0\nl 1 2 3\nf -3//1 2/1/1 3 # last\n";
    let (mesh, _) = read("a.obj", text.as_bytes());
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
    assert_eq!(mesh.normals, [[DVec3::Z; 3]]);
}

/// Degenerate faces beside good ones are left out and do not disturb normals.
#[test]
fn degenerate_faces_are_skipped() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 4\nf 1 1 2\nf 1 2 3\n";
    let (mesh, _) = read("a.obj", text.as_bytes());
    assert_eq!((mesh.triangles.len(), mesh.normals[0]), (1, [DVec3::Z; 3]));
}

/// Where face normals cancel at a vertex, the face's own normal is taken.
#[test]
fn a_sheet_with_two_sides_keeps_its_face_normals() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n";
    let (mesh, _) = read("a.obj", text.as_bytes());
    assert_eq!(mesh.normals, [[DVec3::Z; 3], [DVec3::NEG_Z; 3]]);
}

/// Files cut off at every length: an error or a mesh, never a panic.
#[test]
fn files_cut_off_anywhere_do_not_panic() {
    for path in files() {
        let bytes = fs::read(&path).expect("the file is there");
        for length in 0..bytes.len() {
            let _ = Mesh::from_bytes(&path, &bytes[..length]);
        }
    }
}

/// Every byte of every file replaced by some that are apt to hurt.
#[test]
fn single_wrong_bytes_do_not_panic() {
    for path in files() {
        let bytes = fs::read(&path).expect("the file is there");
        for at in 0..bytes.len() {
            for wrong in [0, 0x7f, 0x80, 0xff, b'-', b'9', b' ', b'\n', bytes[at] ^ 1] {
                let mut damaged = bytes.clone();
                damaged[at] = wrong;
                let _ = Mesh::from_bytes(&path, &damaged);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn damaged_files_do_not_panic(
        file in any::<prop::sample::Index>(),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let files = files();
        let path = &files[file.index(files.len())];
        let mut bytes = fs::read(path).expect("the file is there");
        for (at, byte) in flips {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let length = cut.map_or(bytes.len(), |cut| cut.index(bytes.len()));
        let _ = Mesh::from_bytes(path, &bytes[..length]);
    }

    #[test]
    fn noise_does_not_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), extension in 0..4_usize) {
        let names = ["a.obj", "a.ply", "a.stl", "a.glb"];
        let _ = Mesh::from_bytes(Path::new(names[extension]), &bytes);
    }
}
