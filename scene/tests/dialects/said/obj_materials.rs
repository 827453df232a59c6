//! Materials of `.obj` files, in `.mtl` libraries.
use proptest::prelude::*;
use specula_scene::{Material, Needs, defaults};

use super::{loaded, of_triangles, read};

/// Three triangles beside each other, of which the first has no material.
const THREE: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n\
                     f 1 2 3\nusemtl red\nf 2 4 5\nusemtl steel blue\nf 4 6 5\n";

const LIBRARY: &str = "# two\nnewmtl red\nKa 0.1 0 0\nKd 0.8 0.1 0.1\nKs 0.5 0.5 0.5\nNs 96.4\n\
                       newmtl steel blue\n\tKd 0.2 0.3 0.6\n";

/// The material of a line of statements.
fn material(statements: &str) -> (Material, Vec<String>) {
    let text = "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let library = format!("newmtl m\n{statements}\n");
    let (mesh, warnings) = read("a.obj", text.as_bytes(), ("a.mtl", library.as_bytes()));
    (of_triangles(&mesh).pop().unwrap_or_else(defaults::material), warnings)
}

#[test]
fn faces_have_the_material_that_is_named_before_them() {
    let (mesh, warnings) = read("a.obj", THREE.as_bytes(), ("a.mtl", LIBRARY.as_bytes()));
    assert_eq!(warnings, [""; 0]);
    let red = Material {
        ambient: [0.1, 0.0, 0.0],
        diffuse: [0.8, 0.1, 0.1],
        specular: [0.5; 3],
        shininess: 96,
    };
    let blue = [0.2, 0.3, 0.6];
    let blue = Material { ambient: blue, diffuse: blue, ..defaults::material() };
    assert_eq!(of_triangles(&mesh), [defaults::material(), red, blue]);
}

/// A library may be named late, several on a line, and with a blank in its name.
#[test]
fn libraries_are_found_by_all_of_their_names() {
    for (line, file) in [
        ("mtllib b.mtl a.mtl", "a.mtl"),
        ("mtllib my models.mtl", "my models.mtl"),
        ("mtllib sub\\a.mtl \\", "sub/a.mtl"),
        ("mtllib a#1.mtl # first", "a#1.mtl"),
    ] {
        let text = format!("{}\n{line}\n", THREE.replace("mtllib a.mtl\n", ""));
        let (mesh, _) = read("a.obj", text.as_bytes(), (file, LIBRARY.as_bytes()));
        assert_eq!(mesh.materials.len(), 3, "{line}");
    }
}

#[test]
fn what_cannot_be_shown_is_told_with_its_line() {
    let library = "Kd 1 0 0\nnewmtl red\nKd 1.5 -1 0\nKs spectral a.rfl 1\nNs 9000\nd 0.5\nTr 0.5\n\
                   map_Kd a.png\nmap_Kd b.png\nKe 1 1 1\nillum 0\nPr 0.5\nKa\nNs x\n\
                   newmtl steel blue\nillum 7\nNi 1.5\nd 1.0\nKe 0 0 0\n";
    let (_, warnings) = read("a.obj", THREE.as_bytes(), ("a.mtl", library.as_bytes()));
    insta::assert_snapshot!(warnings.join("\n"));
}

#[test]
fn materials_that_are_not_there_are_told_and_the_default_is_taken() {
    let (mesh, missing) = read("a.obj", THREE.as_bytes(), ("b.mtl", b""));
    assert!(mesh.materials.is_empty());
    let (mesh, empty) = read("a.obj", THREE.as_bytes(), ("a.mtl", b"newmtl other\n"));
    assert!(mesh.materials.is_empty());
    insta::assert_snapshot!([missing, empty].concat().join("\n"));
}

/// A library whose materials no face has is not opened.
#[test]
fn libraries_without_a_use_are_not_missed() {
    let text = "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(read("a.obj", text.as_bytes(), ("", b"")).1, [""; 0]);
}

/// Highlights are shown from illumination model 2 on, and `Ka` from model 1 on.
#[test]
fn the_illumination_model_says_what_counts() {
    let model = |model| material(&format!("Ka 0.3 0.3 0.3\nKd 0.5\nKs 1 1 1\nillum {model}")).0;
    let parts = |m: Material| (m.ambient[0], m.diffuse[0], m.specular[0]);
    assert_eq!(parts(model(0)), (0.5, 0.5, 0.0));
    assert_eq!(parts(model(1)), (0.3, 0.5, 0.0));
    assert_eq!(parts(model(2)), (0.3, 0.5, 1.0));
    assert_eq!(parts(model(4)), (0.3, 0.5, 1.0));
}

#[test]
fn exponents_are_whole_numbers_within_range() {
    for (stated, shown, warnings) in [
        ("0", 1, 0),
        ("0.4", 1, 0),
        ("10.5", 11, 0),
        ("1000", 1000, 0),
        ("1e9", 8191, 1),
        ("-3", 1, 1),
    ] {
        let (material, told) = material(&format!("Ns {stated}"));
        assert_eq!((material.shininess, told.len()), (shown, warnings), "{stated}");
    }
}

/// A key that the scene file gives holds for all triangles, and the others are those of the file.
#[test]
fn the_scene_file_takes_precedence_key_by_key() {
    let scene = "[[object]]\nmesh = \"a.obj\"\n[object.material]\nshininess = 8\nspecular = 0.25\n\
                 [[object]]\nprimitive = \"sphere\"\ntranslate = [5, 0, 0]\n";
    let files: [(&str, &[u8]); 3] = [
        ("scene.toml", scene.as_bytes()),
        ("a.obj", THREE.as_bytes()),
        ("a.mtl", LIBRARY.as_bytes()),
    ];
    let scene = loaded(&files);
    let materials = &scene.frame.materials;
    assert_eq!(materials.len(), 4);
    for material in &materials[..3] {
        assert_eq!((material.shininess, material.specular), (8, [0.25; 3]));
    }
    assert_eq!(materials[1].diffuse, [0.8, 0.1, 0.1]);
    assert_eq!(materials[3], defaults::material());
    // Each triangle shows its own, and the sphere its surface.
    let needs = Needs::of(&scene.frame);
    assert_eq!(needs.materials, 4);
    assert_eq!(scene.surfaces.len(), 4);
    assert!(scene.surfaces[..3].iter().all(Option::is_none) && scene.surfaces[3].is_some());
}

#[test]
fn a_mesh_in_place_of_a_scene_shows_its_materials() {
    let scene = loaded(&[("a.obj", THREE.as_bytes()), ("a.mtl", LIBRARY.as_bytes())]);
    assert_eq!(scene.frame.materials.len(), 3);
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn libraries_of_noise_do_not_panic(noise in prop::collection::vec(any::<u8>(), 0..200)) {
        read("a.obj", THREE.as_bytes(), ("a.mtl", &noise));
    }

    /// Words that libraries have, in any order.
    #[test]
    fn libraries_of_nonsense_have_materials_within_range(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "newmtl", "red", "steel", "blue", "Ka", "Kd", "Ks", "Ns", "illum", "d", "Tr", "map_Kd", "\n", "\n", "1",
                "-1e999", "nan", "0.5", "99999999999", "-3", "#", "\\", "spectral", "\u{e9}",
            ]),
            0..60,
        ),
    ) {
        let library = words.join(" ");
        let (mesh, _) = read("a.obj", THREE.as_bytes(), ("a.mtl", library.as_bytes()));
        for material in of_triangles(&mesh) {
            let colours = [material.ambient, material.diffuse, material.specular];
            prop_assert!(colours.iter().flatten().all(|c| (0.0..=1.0).contains(c)));
            prop_assert!((1..=8191).contains(&material.shininess));
        }
    }
}
