//! Animations of `.glb` files.
use std::path::Path;

use glam::DVec3;
use proptest::prelude::*;
use serde_json::{Value, json};
use specula_scene::mesh::{Mesh, MeshProblem, Model, Warning};
use specula_scene::picture::camera::Camera;
use specula_scene::picture::{Object, Scene};
use specula_scene::sequence::{FrameSource, MovingScene, Script, Sequence};
use specula_scene::{PartialMaterial, defaults};

use super::loaded;
use crate::glb_files::{F32, Glb};
use crate::shape::wedge;

fn model(bytes: &[u8]) -> (Model, Vec<String>) {
    let none = |_: &Path| Err(MeshProblem::Unreadable("it is not given".into()));
    let (model, warnings) = Model::from_bytes(Path::new("a.glb"), bytes, &none)
        .unwrap_or_else(|error| panic!("{error}"));
    (model, warnings.iter().map(Warning::to_string).collect())
}

/// Node 0 with the wedge stands still; node 1, below it and shifted by (0, 0, 2), has a wedge that is
/// animated, and node 2 below that another one, shifted by (3, 0, 0).
fn still() -> Glb {
    let mut glb = Glb::plain(&wedge());
    glb.root["nodes"] = json!([
        {"mesh": 0, "children": [1]},
        {"mesh": 0, "translation": [0, 0, 2], "children": [2]},
        {"mesh": 0, "translation": [3, 0, 0]},
    ]);
    glb
}

fn numbers(glb: &mut Glb, kind: &str, parts: usize, numbers: &[f32]) -> usize {
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    glb.accessor(&bytes, F32, kind, numbers.len() / parts)
}

/// The file in which a property of node 1 has these values at these times.
pub fn animated(path: &str, interpolation: &str, times: &[f32], values: &[f32]) -> Glb {
    let mut glb = still();
    let (kind, parts) = if path == "rotation" { ("VEC4", 4) } else { ("VEC3", 3) };
    let input = numbers(&mut glb, "SCALAR", 1, times);
    let output = numbers(&mut glb, kind, parts, values);
    glb.root["animations"] = json!([{
        "samplers": [{"input": input, "output": output, "interpolation": interpolation}],
        "channels": [{"sampler": 0, "target": {"node": 1, "path": path}}],
    }]);
    glb
}

/// The scene of a moving file.
fn moving(glb: &Glb) -> MovingScene {
    let (model, warnings) = model(&glb.file());
    assert_eq!(warnings, [""; 0]);
    scene(model)
}

/// A mesh of the file, where its node has it.
fn object(mesh: Mesh) -> Object {
    Object {
        mesh: mesh.into(),
        primitive: None,
        place: glam::DAffine3::IDENTITY,
        material: PartialMaterial::default(),
    }
}

fn scene(model: Model) -> MovingScene {
    let movement = model.movement.expect("it moves");
    let scene = Scene {
        size: (64, 48),
        background: [0; 3],
        camera: model.camera.unwrap_or_else(|| Camera {
            target: Some(DVec3::ZERO),
            height: Some(20.0),
            ..Camera::default()
        }),
        ambient: defaults::AMBIENT,
        lights: if model.lights.is_empty() { vec![defaults::light()] } else { model.lights },
        objects: movement.meshes.into_iter().map(object).collect(),
    };
    let script = Script::Nodes(movement.motions.into());
    MovingScene::new(scene, movement.frames, script)
}

/// Where the wedge's own (2, 0, 0) of node 2 is in a frame, which is the farthest to the right.
fn place(scene: &MovingScene, frame: u32) -> DVec3 {
    let object = scene.scene(frame).objects[1].clone();
    let corner = object.mesh.positions.iter().find(|p| **p == DVec3::new(5.0, 0.0, 0.0));
    object.place.transform_point3(*corner.expect("the wedge has it"))
}

/// Half a second is twelve frames, and the end would be the thirteenth.
#[test]
fn nodes_are_shifted_from_key_to_key() {
    let scene =
        moving(&animated("translation", "LINEAR", &[0.0, 0.5], &[0.0, 0.0, 0.0, 0.0, 6.0, 0.0]));
    assert_eq!(scene.frames(), 12);
    let still = scene.scene(0).objects[0].place;
    for frame in 0..12 {
        let expected = DVec3::new(5.0, 0.5 * f64::from(frame), 0.0);
        assert!(place(&scene, frame).distance(expected) < 1e-12, "{frame}");
        assert_eq!(scene.scene(frame).objects[0].place, still);
    }
}

#[test]
fn nodes_are_turned_and_scaled_with_what_is_below_them() {
    let half = 0.5_f32.sqrt();
    let turn = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half];
    let scene = moving(&animated("rotation", "LINEAR", &[0.0, 1.0], &turn));
    // 45 degrees about z, and the node is shifted by 2 along z.
    let expected = DVec3::new(12.5_f64.sqrt(), 12.5_f64.sqrt(), 2.0);
    assert!(place(&scene, 12).distance(expected) < 1e-6, "{}", place(&scene, 12));
    let scene = moving(&animated("scale", "STEP", &[0.0, 0.5], &[1.0, 1.0, 1.0, 2.0, 1.0, 1.0]));
    assert_eq!([place(&scene, 11).x, scene.frames().into()], [5.0, 12.0]);
}

/// The value of a cubic spline stands between its tangents.
#[test]
fn splines_are_linear_between_their_values() {
    let mut values = vec![9.0; 18];
    values[3..6].copy_from_slice(&[0.0, 0.0, 0.0]);
    values[12..15].copy_from_slice(&[0.0, 4.0, 0.0]);
    let glb = animated("translation", "CUBICSPLINE", &[0.0, 1.0], &values);
    let (model, warnings) = model(&glb.file());
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(place(&scene(model), 12).distance(DVec3::new(5.0, 2.0, 0.0)) < 1e-12);
}

/// A light and a camera at a node that moves.
#[test]
fn lights_and_cameras_move_with_their_nodes() {
    let mut glb = animated("translation", "LINEAR", &[0.0, 1.0], &[0.0, 0.0, 9.0, 24.0, 0.0, 9.0]);
    glb.root["nodes"][1]["camera"] = json!(0);
    glb.root["nodes"][1]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
    glb.root["cameras"] = json!([{"type": "orthographic", "orthographic": {"xmag": 8, "ymag": 6}}]);
    glb.root["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point"}]}});
    let scene = scene(model(&glb.file()).0);
    let moved = scene.scene(5);
    assert_eq!(moved.camera.target, Some(DVec3::new(5.0, 0.0, 9.0)));
    let light = format!("{:?}", moved.lights[0].source);
    assert!(light.contains("position: DVec3(5.0, 0.0, 9.0)"), "{light}");
}

#[test]
fn a_glb_in_place_of_a_scene_moves() {
    let glb = animated("translation", "LINEAR", &[0.0, 0.25], &[0.0, 0.0, 0.0, 0.0, 6.0, 0.0]);
    let scene = loaded(&[("a.glb", &glb.file())]);
    let sequence = scene.sequence.expect("it moves");
    assert_eq!(sequence.frames(), 6);
    let frames = [0, 5].map(|index| sequence.frame(index).expect("it can be drawn"));
    assert_ne!(frames[0], frames[1]);
    assert_eq!(frames[0], scene.frame);
}

#[test]
fn what_is_not_shown_of_animations_is_told() {
    let shift = [0.0, 0.0, 0.0, 0.0, 6.0, 0.0];
    let good = || animated("translation", "LINEAR", &[0.0, 0.5], &shift);
    let with = |path: &str, value: Value| {
        let mut glb = good();
        *glb.root.pointer_mut(path).expect("it is there") = value;
        model(&glb.file()).1
    };
    let mut said = vec![
        with("/animations", json!("x")),
        with("/animations/0", json!(7)),
        with("/animations/0/channels/0/target/path", json!("weights")),
        with("/animations/0/channels/0/target", json!({"path": "pointer"})),
        with("/animations/0/channels/0/target/node", json!(9)),
        with("/animations/0/channels/0/sampler", json!(3)),
        with("/animations/0/samplers/0/interpolation", json!("WILD")),
        with("/animations/0/samplers/0/input", json!(99)),
        with("/animations/0/samplers/0/output", json!(0)),
        with("/nodes/1", json!({})),
    ];
    said.push(model(&animated("translation", "LINEAR", &[1.0, 0.5], &shift).file()).1);
    said.push(model(&animated("translation", "LINEAR", &[0.0, f32::NAN], &shift).file()).1);
    said.push(model(&animated("translation", "LINEAR", &[0.0, 1e6], &shift).file()).1);
    let mut two = good();
    let again = two.root["animations"][0].clone();
    two.root["animations"].as_array_mut().expect("it is a list").push(again);
    said.push(model(&two.file()).1);
    insta::assert_snapshot!(said.concat().join("\n"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Frames of nonsense are drawn, or an error; never a panic.
    #[test]
    fn nonsense_does_not_panic(
        path in prop::sample::select(vec!["translation", "rotation", "scale"]),
        interpolation in prop::sample::select(vec!["LINEAR", "STEP", "CUBICSPLINE"]),
        times in prop::collection::vec(prop::sample::select(vec![0.0_f32, 0.1, 0.3, 0.5, -1.0, 3e38]), 1..4),
        values in prop::collection::vec(
            prop::sample::select(vec![0.0_f32, 1.0, -1.0, 1e-30, 3e38, -3e38, 1e10]), 12..24),
    ) {
        let mut sorted = times;
        sorted.sort_by(f32::total_cmp);
        let glb = animated(path, interpolation, &sorted, &values);
        let (model, _) = model(&glb.file());
        if let Some(movement) = model.movement {
            let scene = Scene {
                size: (16, 12),
                background: [0; 3],
                camera: Camera::default(),
                ambient: defaults::AMBIENT,
                lights: vec![defaults::light()],
                objects: movement.meshes.into_iter().map(object).collect(),
            };
            // Framing looks at all frames, so a few are enough.
            let script = Script::Nodes(movement.motions.into());
            let moving = MovingScene::new(scene, movement.frames.min(4), script);
            if let Ok(sequence) = Sequence::new("a.glb", FrameSource::Moving(moving.into())) {
                for frame in 0..sequence.frames() {
                    let _ = sequence.frame(frame);
                }
            }
        }
    }
}
