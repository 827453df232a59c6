//! What every frame keeps to: spans in order, no pixel twice, weights and normals as [`Span`] and
//! [`Triangle`] say.
use std::fs;

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use specula_scene::mesh::normals::newell;
use specula_scene::{Facet, Frame, SceneError, Span, Triangle, builtin_names, load};

fn check(frame: &Frame) {
    assert!(!frame.spans.is_empty());
    for pair in frame.spans.windows(2) {
        let [before, after] = [&pair[0], &pair[1]];
        let in_order =
            after.y > before.y || (after.y == before.y && after.x >= before.x + before.length);
        assert!(in_order, "{before:?} {after:?}");
    }
    for span in &frame.spans {
        check_span(frame, span);
    }
    for triangle in &frame.triangles {
        assert!(triangle.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-12), "{triangle:?}");
        assert!(triangle.material < frame.materials.len());
        check_facet(triangle);
    }
    for light in &frame.lights {
        assert!((light.direction.length() - 1.0).abs() < 1e-12);
    }
}

/// All objects here are of triangles, each a polygon of its own: its plane's normal, towards the
/// eye.
fn check_facet(Triangle { facet, positions, .. }: &Triangle) {
    let Facet { normal, middle } = *facet;
    assert!((normal.length() - 1.0).abs() < 1e-12 && normal.z >= 0.0, "{facet:?}");
    let of_plane = newell(positions).expect("what is seen has an area");
    assert!(normal.cross(of_plane).length() < 1e-9, "{normal} for {of_plane}");
    let mean = positions.iter().sum::<DVec3>() / 3.0;
    assert!((middle - mean).length() < 1e-12 * (1.0 + mean.length()), "{middle} for {mean}");
}

fn check_span(frame: &Frame, span: &Span) {
    assert!(
        span.length >= 1 && span.x + span.length <= frame.width && span.y < frame.height,
        "{span:?}"
    );
    assert!(span.triangle < frame.triangles.len());
    for weights in [span.start, span.end] {
        assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{span:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{span:?}");
    }
    assert!(span.length > 1 || span.start == span.end);
    check_outline(frame, span);
}

/// The weights at both ends put the outline's corners together to the pixels' centres.
fn check_outline(frame: &Frame, span: &Span) {
    let outline = frame.triangles[span.triangle].outline.expect("all of a mesh have one");
    let farthest = outline.iter().map(|corner| corner.abs().max_element()).fold(1.0, f64::max);
    for (weights, column) in [(span.start, span.x), (span.end, span.x + span.steps())] {
        let place: DVec2 = outline.iter().zip(weights).map(|(&corner, w)| corner * w).sum();
        let centre = DVec2::new(f64::from(column), f64::from(span.y)) + 0.5;
        assert!((place - centre).length() < 1e-14 * farthest, "{span:?}: {place} for {centre}");
    }
}

/// Loads a scene from the text of a scene file.
fn load_text(text: &str) -> Frame {
    try_load_text(text).expect("the scene is right")
}

fn try_load_text(text: &str) -> Result<Frame, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).expect("a temporary file can be written");
    load(path.to_str().expect("temporary paths are plain"), None).map(|loaded| loaded.frame)
}

#[test]
fn built_in_scenes_keep_to_it_at_all_sizes() {
    for name in builtin_names() {
        for size in
            [None, Some((7, 5)), Some((7, 97)), Some((97, 7)), Some((53, 211)), Some((1920, 1080))]
        {
            let loaded =
                load(name, size).unwrap_or_else(|error| panic!("{name} at {size:?}: {error}"));
            assert_eq!(loaded.name, *name);
            check(&loaded.frame);
            assert!(loaded.frame.materials.iter().all(|m| m.shininess <= 256));
        }
    }
}

/// Spheres' silhouettes are discs, without a hole or a stray pixel: the exact area is known to
/// within the outline.
#[test]
fn a_sphere_covers_a_disc() {
    let text = "size = [200, 200]\n[camera]\ntarget = [0, 0, 0]\nheight = 4\n[[object]]\nprimitive = \"sphere\"\nlevel = 64\n";
    let frame = load_text(text);
    let disc = std::f64::consts::PI * 50.0 * 50.0;
    assert!((frame.shaded_pixels() as f64 - disc).abs() < 20.0, "{} {disc}", frame.shaded_pixels());
    // One run without gaps in each row.
    for y in 0..frame.height {
        let row: Vec<&Span> = frame.spans.iter().filter(|span| span.y == y).collect();
        assert!(row.windows(2).all(|pair| pair[0].x + pair[0].length == pair[1].x));
    }
}

/// The normals that are interpolated are those of the sphere.
#[test]
fn interpolated_normals_follow_the_sphere() {
    let text = "size = [200, 200]\n[camera]\ndirection = [0.3, 0.5, 1]\ntarget = [0, 0, 0]\nheight = 4\n[[object]]\nprimitive = \"sphere\"\nlevel = 64\n";
    let frame = load_text(text);
    for span in &frame.spans {
        for i in 0..span.length {
            let normal = frame.normal_at(span, span.weights(i)).normalize();
            let x = (f64::from(span.x + i) + 0.5 - 100.0) / 50.0;
            let y = (100.0 - f64::from(span.y) - 0.5) / 50.0;
            let error = (normal.x - x).abs().max((normal.y - y).abs());
            assert!(error < 0.002 && normal.z > -0.05, "{error} {normal} {span:?}");
        }
    }
}

/// Lyon's figure 9: the centre of each ball is that ball's, and left balls hide right ones.
#[test]
fn in_figure_9_left_balls_hide_right_ones() {
    let frame = load("spheres", None).expect("it is built in").frame;
    assert_eq!((frame.width, frame.height, frame.background), (416, 160, [255; 3]));
    let shininess_at = |x: u32, y: u32| {
        let covers = |span: &&Span| span.y == y && (span.x..span.x + span.length).contains(&x);
        frame.spans.iter().find(covers).map(|span| frame.material(span).shininess)
    };
    for (ball, shininess) in [1, 4, 16, 64, 256].into_iter().enumerate() {
        // 16 pixels of margin, 64 pixels to the first ball's centre and from ball to ball; right
        // half of each is seen.
        let right_edge = 16 + 128 + 64 * ball as u32;
        assert_eq!(shininess_at(right_edge - 2, 80), Some(shininess));
    }
    assert_eq!(shininess_at(17, 80), Some(1));
    assert_eq!(shininess_at(15, 80), None);
    let expected = [[1.0, 1.0, -1.0], [1.0, -1.0, 1.0]].map(|l| l.map(|c: f64| c / 3.0_f64.sqrt()));
    for (light, expected) in frame.lights.iter().zip(expected) {
        assert!((light.direction - glam::DVec3::from_array(expected)).length() < 1e-15);
    }
}

/// A mesh with its faces turned inside out is lit from outside all the same.
#[test]
fn inside_out_meshes_are_lit_from_the_side_that_is_seen() {
    let faces = ["f 1 2 3", "f 1 4 2", "f 1 3 4", "f 2 4 3"];
    let turned =
        faces.map(|face| face.split(' ').rev().collect::<Vec<_>>().join(" ").replace(" f", ""));
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let frames = [faces.map(str::to_owned), turned.map(|face| format!("f {face}"))].map(|faces| {
        let path = folder.path().join("tetra.obj");
        let vertices = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n";
        fs::write(&path, format!("{vertices}{}\n", faces.join("\n")))
            .expect("a temporary file can be written");
        load(path.to_str().expect("temporary paths are plain"), None)
            .expect("the mesh is right")
            .frame
    });
    let facing =
        |frame: &Frame| frame.triangles.iter().map(|t| t.normals.map(|n| n.z)).collect::<Vec<_>>();
    for frame in &frames {
        check(frame);
        let sums: Vec<f64> = facing(frame).iter().map(|z| z.iter().sum()).collect();
        assert!(sums.iter().all(|&z| z > 0.0), "{sums:?}");
    }
    assert_eq!(frames[0].shaded_pixels(), frames[1].shaded_pixels());
}

#[test]
fn the_same_scene_gives_the_same_frame() {
    let frame = |_| load("teapot", Some((160, 120))).expect("it is built in").frame;
    assert_eq!(frame(0), frame(1));
}

/// A number that changes with any bit of any span, normal or light [FNV-1a, 64 bits].
fn digest(frame: &Frame) -> u64 {
    let spans = frame.spans.iter().flat_map(|span| {
        let place = [span.x, span.y, span.length].map(u64::from);
        let weights = span.start.into_iter().chain(span.end).map(f64::to_bits);
        place.into_iter().chain([span.triangle as u64]).chain(weights)
    });
    let normals = frame.triangles.iter().flat_map(|triangle| triangle.normals);
    let vectors = normals.chain(frame.lights.iter().map(|light| light.direction));
    let words = spans.chain(vectors.flat_map(|v| v.to_array().map(f64::to_bits)));
    let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    words.flat_map(u64::to_le_bytes).fold(0xcbf2_9ce4_8422_2325, mix)
}

/// Built-in frames bit for bit, so that a machine, compiler or library that rounds otherwise is
/// noticed.
#[test]
fn frames_are_the_same_on_every_machine() {
    let line = |name: &&str| {
        let frame = load(name, None).expect("it is built in").frame;
        let (spans, pixels) = (frame.spans.len(), frame.shaded_pixels());
        format!("{name}: {spans} spans, {pixels} pixels, {:016x}", digest(&frame))
    };
    let lines: Vec<String> = builtin_names().iter().map(line).collect();
    insta::assert_snapshot!(lines.join("\n"));
}

#[test]
fn the_core_table_can_be_read_by_whoever_knows_it() {
    #[derive(serde::Deserialize)]
    struct Core {
        method: String,
        bits: toml::Spanned<u32>,
    }
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let path = folder.path().join("scene.toml");
    let text = "[[object]]\nprimitive = \"torus\"\n\n[core]\nmethod = \"lyon\"\nbits = 12\n";
    fs::write(&path, text).expect("a temporary file can be written");
    let core = load(path.to_str().expect("temporary paths are plain"), None)
        .expect("the scene is right")
        .core;
    let core = core.expect("the scene has a core");
    let read: Core = core.parse().expect("the table is right");
    assert_eq!((read.method.as_str(), *read.bits.get_ref()), ("lyon", 12));
    assert_eq!(&text[read.bits.span()], "12");
    assert!(text[core.span()].starts_with("[core]"));
    let error =
        core.parse::<std::collections::BTreeMap<String, u32>>().expect_err("a word is no number");
    assert!(error.to_string().contains("lyon"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Any two shapes, anywhere, seen from anywhere: the frame keeps to it, or nothing is visible.
    #[test]
    fn random_scenes_keep_to_it(
        size in (1..120_u32, 1..120_u32),
        direction in prop::array::uniform3(-1.0..1.0_f64),
        places in prop::array::uniform2(prop::array::uniform3(-2.0..2.0_f64)),
        turn in prop::array::uniform3(-400.0..400.0_f64),
        scale in prop::array::uniform3(prop_oneof![-2.0..-0.1_f64, 0.1..2.0_f64]),
        shapes in prop::array::uniform2(prop::sample::select(vec!["sphere", "torus", "icosahedron", "teapot"])),
    ) {
        let object = |k: usize| format!(
            "[[object]]\nprimitive = {:?}\nlevel = 3\ntranslate = {:?}\nrotate = {turn:?}\nscale = {scale:?}\n", shapes[k], places[k],
        );
        let text = format!(
            "size = [{}, {}]\n[camera]\ndirection = {direction:?}\nup = [1.5, 3, 2]\n{}{}", size.0, size.1, object(0), object(1),
        );
        match try_load_text(&text) {
            Ok(frame) => check(&frame),
            // In a small picture, no pixel's centre may be covered.
            Err(error) => prop_assert!(error.to_string().contains("nothing of the scene is visible"), "{error}"),
        }
    }
}
