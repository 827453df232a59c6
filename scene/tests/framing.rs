//! Pictures in which the camera frames the objects itself: whatever their size, something is seen.
use specula_scene::{Frame, SceneError, load, parse};

/// Shapes without a middle, or far thinner one way than the other.
const RING: &str = "[camera]\ndirection = [0, 1, 0]\nup = [0, 0, -1]\n[[object]]\nprimitive = \"torus\"\ntube = 0.1\n";
const PAIR: &str = "[[object]]\nprimitive = \"icosahedron\"\ntranslate = [-9, 0, 0]\n[[object]]\nprimitive = \"icosahedron\"\ntranslate = [9, 1, 0]\n";
const PLATE: &str =
    "[camera]\ndirection = [0, 0, 1]\n[[object]]\nprimitive = \"sphere\"\nscale = [8, 1, 1]\n";

/// Sizes around those in which the middle of the picture lies between pixels.
fn sizes() -> Vec<(u32, u32)> {
    let long = (1..=24).chain([63, 64, 65, 127, 480, 481, 1000, 4095, 8191, 8192]);
    let thin = long.flat_map(|long| [1, 2, 3, 4].map(|short| (short, long)));
    thin.flat_map(|(short, long)| [(short, long), (long, short)]).collect()
}

fn frame(text: &str, (width, height): (u32, u32)) -> Result<Frame, SceneError> {
    parse("a.toml", format!("size = [{width}, {height}]\n{text}")).map(|scene| scene.frame)
}

#[test]
fn thin_pictures_show_something() {
    for size in sizes() {
        for text in [RING, PAIR, PLATE] {
            let frame =
                frame(text, size).unwrap_or_else(|error| panic!("{size:?}: {error} of\n{text}"));
            assert!(frame.shaded_pixels() > 0);
        }
    }
    for size in [(1, 64), (64, 1), (2, 2), (1, 480), (1, 8192), (8192, 1), (1, 1), (3, 1)] {
        let scene = load("teapot", Some(size)).unwrap_or_else(|error| panic!("{size:?}: {error}"));
        assert!(scene.frame.shaded_pixels() > 0, "{size:?}");
    }
}

/// Where the user says what the camera looks at, nothing is moved.
#[test]
fn a_camera_with_a_target_looks_there() {
    let error = frame(&RING.replace("[camera]", "[camera]\ntarget = [0, 0, 0]"), (1, 1))
        .expect_err("the hole of the ring is at the middle of the pixel");
    assert!(error.to_string().contains("nothing of the scene is visible"), "{error}");
}
