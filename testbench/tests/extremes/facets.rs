//! Methods that take the polygon's own normal: lecture, eq. 2.1, and Hast et al., §4.
use specula_scene::{Frame, LoadedScene, load};
use specula_spec::{CoreSpec, SceneCore};

use crate::run::assert_agrees;

/// A zigzag roof whose vertex normals all point to the eye, and whose facets, of one slope either
/// way, do not: N = (∓1, 0, 2)/√5.
const ROOF: &str = "v 0 0 0\nv 0 4 0\nv 1 0 0.5\nv 1 4 0.5\nv 2 0 0\nv 2 4 0\nv 3 0 0.5\n\
    v 3 4 0.5\nv 4 0 0\nv 4 4 0\nv 5 0 0.5\nv 5 4 0.5\nv 6 0 0\nv 6 4 0\nvn 0 0 1\n";

/// The codes of the roof's facets under a light at (.7, 0, .7): N·L is 1/√10 or 3/√10, and a code
/// 204 (.05 + N·L).
const CODES: [u8; 2] = [75, 204];

/// The facets as triangles, or as quadrilaterals.
fn faces(corners: usize) -> String {
    let corner = |k: usize| format!("{k}//1");
    let face = |names: &[usize]| {
        format!("f {}\n", names.iter().map(|&k| corner(k)).collect::<Vec<_>>().join(" "))
    };
    let facet = |k: usize| {
        let [a, b, c, d] = [2 * k - 1, 2 * k + 1, 2 * k + 2, 2 * k];
        if corners == 3 { face(&[a, b, c]) + &face(&[a, c, d]) } else { face(&[a, b, c, d]) }
    };
    (1..=6).map(facet).collect()
}

/// The roof, put somewhere by `place`, shaded by `method` with `options`.
fn roof(corners: usize, place: &str, method: &str, options: &str) -> LoadedScene {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("roof.obj"), ROOF.to_owned() + &faces(corners)).unwrap();
    let path = folder.path().join("roof.toml");
    let scene = format!(
        "size = [48, 20]\nambient = 0.05\n[camera]\ndirection = [0, 0, 1]\n\
         [[light]]\nspace = \"view\"\ndirection = [0.7, 0, 0.7]\n\
         [[object]]\nmesh = \"roof.obj\"\n{place}\n\
         [object.material]\ndiffuse = 0.8\nspecular = 0\nshininess = 8\n\
         [core]\nmethod = \"{method}\"\n[core.{method}]\n{options}\n"
    );
    std::fs::write(&path, scene).unwrap();
    load(path.to_str().unwrap(), None).unwrap()
}

/// The codes that are seen, each once, in rising order.
fn codes(core: &CoreSpec, frame: &Frame) -> Vec<u8> {
    let outcome = assert_agrees(core, frame);
    let pixels = frame.spans.iter().flat_map(|span| {
        let first = (span.y * frame.width + span.x) as usize;
        &outcome.simulated.pixels[first..first + span.length as usize]
    });
    let mut seen: Vec<u8> = pixels.flatten().copied().collect();
    seen.sort();
    seen.dedup();
    seen
}

/// Methods that have the polygon's normal at every pixel.
const FLAT: [(&str, &str); 2] =
    [("gouraud", "interpolation = \"uniform\""), ("lyon", "normals = \"flat\"")];

#[test]
fn facets_have_the_code_of_their_own_normal() {
    for (method, options) in FLAT {
        for corners in [3, 4] {
            let roof = roof(corners, "", method, options);
            assert_eq!(codes(&roof.core_spec(None).unwrap(), &roof.frame), CODES, "{method}");
        }
    }
}

/// Mirrored, turned over and seen from behind, the roof still has one slope to the light and one
/// from it; stretched upwards by two its slopes are 45 degrees, and N·L is 0 or 1.
#[test]
fn facets_that_are_mirrored_turned_and_stretched_have_theirs() {
    let steep = [10, 214];
    let places = [
        ("scale = [-1, 1, 1]", CODES),
        ("scale = [1, 1, -1]", CODES),
        ("scale = [-1, -1, -1]", CODES),
        ("rotate = [0, 180, 0]", CODES),
        ("rotate = [0, 0, 180]", CODES),
        ("rotate = [180, 0, 0]\nscale = [1, -1, 1]", CODES),
        ("scale = [1, 1, 2]", steep),
        ("scale = [-1, 1, -2]\nrotate = [0, 180, 0]", steep),
    ];
    for (method, options) in FLAT {
        for (place, wanted) in places {
            let roof = roof(4, place, method, options);
            assert_eq!(
                codes(&roof.core_spec(None).unwrap(), &roof.frame),
                wanted,
                "{method}: {place}"
            );
        }
    }
}

/// Vertex normals are what the other methods shade, the one that `lyon` takes by itself among them:
/// √½ of the light all over.
#[test]
fn vertex_normals_that_are_not_the_polygons_are_shaded_by_methods_that_interpolate() {
    let lit = (204.0 * (0.05 + 0.5f64.sqrt())).round() as u8;
    let reflection = "bisector = \"triangle\"";
    let wrapped = "normals = \"wrapped\"\naxis = \"face\"";
    for (method, options) in [
        ("lyon", ""),
        ("gouraud", ""),
        ("phong", ""),
        ("lyon", wrapped),
        ("reflection", reflection),
    ] {
        let roof = roof(3, "", method, options);
        assert_eq!(codes(&roof.core_spec(None).unwrap(), &roof.frame), [lit], "{method} {options}");
    }
}
