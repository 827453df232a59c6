//! Mesh files: the same solid in every format, and damaged files that must not bring anything down.
use std::fs;
use std::path::{Path, PathBuf};

use glam::DVec3;
use proptest::prelude::*;
use specula_scene::mesh::normals::newell;
use specula_scene::mesh::{Mesh, Warning};

fn files() -> Vec<PathBuf> {
    let entries = fs::read_dir("tests/meshes").expect("tests run in the crate's folder");
    let mut files: Vec<PathBuf> =
        entries.map(|entry| entry.expect("the folder can be listed").path()).collect();
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
    let (mesh, warnings) =
        Mesh::from_bytes(Path::new(name), text).unwrap_or_else(|error| panic!("{error}"));
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

/// The tetrahedron's vertex normals point from its middle to its corners (methods A2), its faces
/// outwards.
fn check_corner_normals(mesh: &Mesh, middle: DVec3) {
    for (triangle, normals) in mesh.triangles.iter().zip(&mesh.normals) {
        let corners = triangle.map(|k| mesh.positions[k as usize]);
        for (corner, normal) in corners.iter().zip(normals) {
            assert!(
                ((*corner - middle).normalize() - *normal).length() < 1e-12,
                "{corner} {normal}"
            );
        }
        let face = newell(&corners).expect("the faces have areas");
        assert!(face.dot(corners[0] - middle) > 0.0);
    }
}

/// Quads count once in vertex normals, although they become two triangles.
#[test]
fn a_cube_of_quads_has_the_normals_of_its_corners() {
    let vertices =
        (0..8).map(|k| format!("v {} {} {}\n", k & 1, k >> 1 & 1, k >> 2)).collect::<String>();
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

/// A vertex that a face states twice, at the ends of a bridge, has the face's normal once in its
/// own.
#[test]
fn a_face_counts_once_for_a_vertex_it_states_twice() {
    let vertices =
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nv 0 0 -4\n";
    let (mesh, _) = read("a.obj", format!("{vertices}f 1 2 3 4 1 5 6 7 8 5\nf 1 4 9\n").as_bytes());
    let corner = mesh
        .triangles
        .iter()
        .zip(&mesh.normals)
        .find_map(|(t, n)| Some(n[t.iter().position(|&k| k == 0)?]));
    let half = 0.5_f64.sqrt();
    assert!(
        (corner.unwrap_or_default() - DVec3::new(-half, 0.0, half)).length() < 1e-12,
        "{corner:?}"
    );
}

/// A roof whose vertices have the normals that its faces make.
const ROOF: &str = "v 0 0 0\nv 2 0 0\nv 2 2 1\nv 0 2 1\nv 2 4 0\nv 0 4 0\n";

/// A normal without direction, or none at all, is the one that the faces around the vertex make,
/// whatever the other corners have.
#[test]
fn normals_without_direction_are_made_from_the_faces() {
    let (expected, warnings) = read("a.obj", format!("{ROOF}f 1 2 3 4\nf 4 3 5 6\n").as_bytes());
    assert_eq!(warnings, [""; 0]);
    assert!((expected.normals[0][2] - DVec3::Z).length() < 1e-12, "the ridge is smooth");
    for normal in ["0 0 0", "nan nan nan", "0 inf 0", "-nan(ind) 0 1", "1.#QNAN 0 0", "0 1", ""] {
        let faces = "f 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1 6//1\n";
        let (mesh, warnings) = read("a.obj", format!("{ROOF}vn {normal}\n{faces}").as_bytes());
        assert_eq!(mesh.normals, expected.normals, "{normal}");
        assert!(
            warnings.len() == 1 && warnings[0].starts_with("a.obj, line 7: a normal is "),
            "{warnings:?}"
        );
        // One corner of good ones.
        let faces = "f 1//2 2//2 3//1 4//2\nf 4//2 3//2 5//2 6//2\n";
        let (mesh, warnings) =
            read("a.obj", format!("{ROOF}vn {normal}\nvn 1 0 0\n{faces}").as_bytes());
        assert_eq!(mesh.normals[0], [DVec3::X, DVec3::X, expected.normals[0][2]], "{normal}");
        assert_eq!(warnings.len(), 1, "{warnings:?}");
    }
}

#[test]
fn normals_that_are_not_there_are_made_from_the_faces() {
    let (expected, _) = read("a.obj", format!("{ROOF}f 1 2 3 4\nf 4 3 5 6\n").as_bytes());
    for missing in ["2", "0", "-2", "99999999999", "-99999999999"] {
        let faces = format!("f 1//1 2//1 3//{missing} 4//1\nf 4//1 3//1 5//1 6//{missing}\n");
        let (mesh, warnings) = read("a.obj", format!("{ROOF}vn 1 0 0\n{faces}").as_bytes());
        assert_eq!(mesh.normals[0], [DVec3::X, DVec3::X, expected.normals[0][2]], "{missing}");
        let right = "a.obj, line 8: a face names a normal that is not among the 1 of the file; corners that name it get the normal \
                     that the faces around their vertex make (and 1 more line)";
        assert_eq!(warnings, [right], "{missing}");
    }
}

/// What is passed over is told once a kind, and where it stands first.
#[test]
fn what_an_obj_file_has_beside_its_faces_is_told() {
    let text = "# caf\u{e9}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nl 1 2\nf 3\ncurv 0 1 1 2\nf 1 2 3\nl 2 3\nl 3 1\nhello\x1b[31m\n";
    let bytes: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let (_, warnings) = read("a.obj", &bytes);
    let right = [
        "a.obj, line 5: a face has fewer than three corners: 2; it is left out (and 1 more line)",
        "a.obj, line 6: lines `l` are passed over; only `v`, `vn` and `f` are drawn (and 2 more lines)",
        "a.obj, line 8: lines `curv` are passed over; only `v`, `vn` and `f` are drawn",
        "a.obj, line 12: lines `hello` are passed over; only `v`, `vn` and `f` are drawn",
    ];
    assert_eq!(warnings, right);
}

#[test]
fn what_an_stl_file_has_beside_its_facets_is_told() {
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0 7\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let short = "facet\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n";
    let (mesh, warnings) =
        read("a.stl", format!("solid\n{facet}colour 1\n{short}endsolid\n").as_bytes());
    assert_eq!(mesh.triangles.len(), 1);
    let right = [
        "a.stl, line 4: numbers behind a vertex's third are passed over",
        "a.stl, line 9: `colour` is none of the words of a text .stl; its line is passed over",
        "a.stl, line 10: a facet has 1 vertices, fewer than three; it is left out",
    ];
    assert_eq!(warnings, right);
}

/// Words inside a facet that are unknown are passed over too, unless they may stand for a vertex.
#[test]
fn unknown_words_inside_a_facet_are_told_or_wrong() {
    let facet = "facet normal 0 0 1\n# one\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\ncolour 7\nendloop\nendfacet\n";
    let (mesh, warnings) = read("a.stl", format!("solid\n{facet}").as_bytes());
    assert_eq!(mesh.triangles.len(), 1);
    let right = [
        "a.stl, line 3: `#` is none of the words of a text .stl; its line is passed over (and 1 more line)",
        "a.stl, line 10: the last solid has no `endsolid`; the file may be cut off",
    ];
    assert_eq!(warnings, right);
    for (word, wrong, said) in [
        ("vertex 1", "vertx 1", "line 6: `vertex` is expected here, not `vertx`"),
        ("outer", "otter", "line 4: `outer` is expected here, not `otter`"),
        ("endloop", "end loop", "line 9: `endloop` is expected here, not `end`"),
    ] {
        let text = format!("solid\n{}", facet.replacen(word, wrong, 1));
        let error = Mesh::from_bytes(Path::new("a.stl"), text.as_bytes()).expect_err("it is wrong");
        assert!(error.to_string().contains(said), "{error}");
    }
}

/// A binary file that was not finished by whoever wrote it.
#[test]
fn a_binary_stl_of_no_triangles_with_bytes_behind_is_wrong() {
    let mut bytes = fs::read("tests/meshes/tetra_binary.stl").expect("it is there");
    bytes[80..84].fill(0);
    let error = Mesh::from_bytes(Path::new("a.stl"), &bytes).expect_err("it states no triangles");
    assert_eq!(
        error.to_string(),
        "mesh `a.stl`: its header states 0 triangles, but 200 bytes follow"
    );
}

/// A binary file is not taken for text by its comment, nor text for a binary file, cut off or not.
#[test]
fn binary_stl_files_are_told_from_text() {
    let (binary, text) =
        (fs::read("tests/meshes/tetra_binary.stl"), fs::read("tests/meshes/tetra_ascii.stl"));
    let (mut binary, text) = (binary.expect("it is there"), text.expect("it is there"));
    binary[..6].copy_from_slice(b"solid ");
    let said = |bytes: &[u8]| {
        Mesh::from_bytes(Path::new("a.stl"), bytes).expect_err("it is cut off").to_string()
    };
    assert_eq!(read("a.stl", &binary).0.triangles.len(), 4);
    assert_eq!(
        said(&binary[..120]),
        "mesh `a.stl`: it ends early: its header states 4 triangles, 284 bytes; the file has 120"
    );
    let said = said(&text[..120]);
    assert!(said.contains("line ") && said.contains("expected here"), "{said}");
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
