//! Cameras and objects that hardly make a picture: it is right all the same, or an error says why there
//! is none.
use std::fs;

use specula_scene::{Frame, SceneError, parse};

/// The picture of a mesh that is written here, before a perspective camera.
fn frame(mesh: &str, camera: &str) -> Result<Frame, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let path = folder.path().join("mesh.obj");
    fs::write(&path, mesh).expect("a temporary file can be written");
    let path = path.to_str().expect("temporary paths are plain");
    of_object(&format!("mesh = '{path}'"), camera)
}

fn of_object(object: &str, camera: &str) -> Result<Frame, SceneError> {
    let text = format!(
        "size = [32, 24]\n[camera]\nkind = \"perspective\"\n{camera}\n[[object]]\n{object}\n"
    );
    parse("a.toml", text).map(|scene| scene.frame)
}

fn error(mesh: &str, camera: &str) -> String {
    frame(mesh, camera).expect_err("there is nothing to see").to_string()
}

/// A triangle in the plane z = 0.
const TRIANGLE: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";

/// A floor to the horizon.
const FLOOR: &str = "v -1e6 -1 1e6\nv 1e6 -1 1e6\nv 1e6 -1 -1e6\nv -1e6 -1 -1e6\nf 1 2 3 4\n";

#[test]
fn an_eye_in_the_plane_of_a_triangle_sees_nothing_of_it() {
    for eye in ["[5, 0, 0]", "[0.1, 0.1, 0]", "[1, -1, 0]"] {
        let camera = format!("eye = {eye}\ntarget = [0.2, 0, 0]");
        assert!(error(TRIANGLE, &camera).contains("nothing of the scene is in the picture"));
    }
}

#[test]
fn objects_edge_on_have_a_distance_nevertheless() {
    let camera = "direction = [1, 0, 0]";
    assert!(error(TRIANGLE, camera).contains("nothing of the scene is in the picture"));
}

/// Needles along the direction in which the camera looks.
#[test]
fn objects_on_the_line_of_sight_have_no_extent() {
    let needle = "v 0 0 0\nv 0 0 1e-300\nv 1e-320 0 2\nf 1 2 3\n";
    match frame(needle, "direction = [0, 0, 1]\ntarget = [0, 0, 3]") {
        Ok(frame) => assert!(frame.shaded_pixels() > 0),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
    let error = error(TRIANGLE, "direction = [0, 0, 1]\ntarget = [0, 0, 0]\nnear = 1e30");
    assert!(error.contains("behind the eye, or nearer"), "{error}");
}

/// The horizon is at the height of the eye, and the floor is a run without gaps in every row below it.
#[test]
fn a_floor_reaches_from_below_the_eye_to_the_horizon() {
    for near in ["0.001", "1e-9", "1e-30"] {
        let camera = format!("eye = [0, 0, 0]\ntarget = [0, 0, -1]\nnear = {near}");
        let frame = frame(FLOOR, &camera).expect("there is something to see");
        assert_eq!(frame.shaded_pixels(), 32 * 12, "{near}");
        assert!(frame.spans.iter().all(|span| span.y >= 12));
    }
}

/// Where the near plane is farther than the floor is below the picture, it is a straight line.
#[test]
fn the_near_plane_cuts_a_floor_along_a_row() {
    let camera = "eye = [0, 0, 0]\ntarget = [0, 0, -1]\nnear = 5\nfield_of_view = 90";
    let frame = frame(FLOOR, camera).expect("there is something to see");
    // At the distance 5 it is 1 below the eye: 1/5 of half of the picture's height, 2.4 rows.
    let rows: Vec<u32> = frame.spans.iter().map(|span| span.y).collect();
    assert_eq!((rows.iter().min(), rows.iter().max()), (Some(&12), Some(&13)));
}

#[test]
fn a_camera_inside_of_an_object_sees_its_inside() {
    for object in ["sphere", "torus"] {
        let camera = "eye = [1, 0, 0]\ntarget = [0, 0, -0.8]\nnear = 1e-6";
        let object = format!("primitive = \"{object}\"\nscale = [2, 2, 2]");
        let frame = of_object(&object, camera).expect("there is something to see");
        if object.contains("sphere") {
            assert_eq!(frame.shaded_pixels(), 32 * 24);
        }
    }
}

#[test]
fn extremes_of_the_camera_make_pictures_or_errors() {
    let eyes = ["[1e30, 0, 0]", "[0, 1e-30, 0]", "[1e-30, 1e-30, 1e-30]", "[-1e30, 3, 1e30]"];
    for eye in eyes {
        for field_of_view in [1.0, 170.0] {
            for near in ["", "near = 1e-30", "near = 1e30"] {
                let up = "up = [0.1, 1, 0.3]\ntarget = [0, 0, 0]";
                let camera = format!("eye = {eye}\nfield_of_view = {field_of_view}\n{near}\n{up}");
                for object in ["primitive = \"sphere\"", "primitive = \"torus\"\nscale = 1e29"] {
                    match of_object(object, &camera) {
                        Ok(frame) => assert!(frame.shaded_pixels() > 0),
                        Err(error) => {
                            let text = error.to_string();
                            let known = ["nothing of the scene", "behind the eye"];
                            assert!(known.iter().any(|word| text.contains(word)), "{text}");
                        }
                    }
                }
            }
        }
    }
}

/// A camera with a direction alone stands so far away that all is in the picture, and something near its
/// border. With a wide field of view it stands close, and the nearest point says where.
#[test]
fn a_camera_without_an_eye_frames_the_objects() {
    for object in ["teapot", "torus", "icosahedron", "sphere"] {
        for size in ["[64, 48]", "[48, 64]", "[64, 8]", "[2, 2]", "[1, 1]", "[1, 480]"] {
            for field_of_view in [1, 40, 120, 170] {
                let text = format!(
                    "size = {size}\n[camera]\nkind = \"perspective\"\nfield_of_view = {field_of_view}\n[[object]]\nprimitive = \"{object}\"\n"
                );
                let frame = parse("a.toml", text).expect("it is framed").frame;
                let inside = |span: &specula_scene::Span| span.x + span.length <= frame.width;
                assert!(frame.shaded_pixels() > 0 && frame.spans.iter().all(inside));
                if size == "[64, 48]" && field_of_view <= 40 {
                    assert_framed(&frame);
                }
            }
        }
    }
}

/// What is seen keeps a margin of a twentieth of the picture on all sides, and hardly more than that either
/// on the left and on the right or at the top and at the bottom.
fn assert_framed(frame: &Frame) {
    let [mut low, mut high] = [[u32::MAX; 2], [0; 2]];
    for span in &frame.spans {
        low = [low[0].min(span.x), low[1].min(span.y)];
        high = [high[0].max(span.x + span.length), high[1].max(span.y + 1)];
    }
    let free = [[low[0], frame.width - high[0]], [low[1], frame.height - high[1]]];
    let margins = [3, 2];
    let is_tight = |(free, margin): ([u32; 2], u32)| free.iter().all(|free| *free <= margin + 2);
    assert!(
        free.iter().zip(margins).all(|(free, margin)| free.iter().all(|f| *f >= margin)),
        "{free:?}"
    );
    assert!(free.into_iter().zip(margins).any(is_tight), "{free:?}");
}
