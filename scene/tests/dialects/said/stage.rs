//! Lights and cameras of `.glb` files.
use std::path::Path;

use glam::DVec3;
use proptest::prelude::*;
use serde_json::{Value, json};
use specula_scene::mesh::{MeshProblem, Model, Warning};
use specula_scene::picture::{Light, LightSource};

use super::loaded;
use crate::glb_files::Glb;
use crate::shape::wedge;

/// The wedge, which is within (0, 0, 0) and (2, 1.5, 1.5), with nodes behind its own.
fn file(nodes: &[Value], lights: &Value, cameras: &Value) -> Vec<u8> {
    let mut glb = Glb::plain(&wedge());
    let all: Vec<Value> = [json!({"mesh": 0})].into_iter().chain(nodes.iter().cloned()).collect();
    glb.root["scenes"][0]["nodes"] = json!((0..all.len()).collect::<Vec<usize>>());
    glb.root["nodes"] = json!(all);
    glb.root["extensions"] = json!({"KHR_lights_punctual": {"lights": lights}});
    glb.root["extensionsUsed"] = json!(["KHR_lights_punctual"]);
    glb.root["cameras"] = cameras.clone();
    glb.file()
}

fn model(bytes: &[u8]) -> (Model, Vec<String>) {
    let none = |_: &Path| Err(MeshProblem::Unreadable("it is not given".into()));
    let (model, warnings) = Model::from_bytes(Path::new("a.glb"), bytes, &none)
        .unwrap_or_else(|error| panic!("{error}"));
    (model, warnings.iter().map(Warning::to_string).collect())
}

/// A node that turns -z to -y, with a light.
fn downwards(light: usize, translation: [f64; 3]) -> Value {
    json!({"translation": translation, "rotation": [-0.5_f64.sqrt(), 0, 0, 0.5_f64.sqrt()],
           "extensions": {"KHR_lights_punctual": {"light": light}}})
}

fn lights(nodes: &[Value], lights: Value) -> (Vec<Light>, Vec<String>) {
    let (model, warnings) = model(&file(nodes, &lights, &json!(null)));
    (model.lights, warnings)
}

/// The distance from a place to the ball around the wedge.
fn nearest(place: DVec3) -> f64 {
    let far = DVec3::new(2.0, 1.5, 1.5);
    (place - far / 2.0).length() - far.length() / 2.0
}

/// The illuminance at the objects counts: that of the sun is 4, of the lamp I/D².
#[test]
fn lights_keep_their_strengths_beside_each_other() {
    let place = DVec3::new(0.0, 10.0, 0.0);
    let distance = nearest(place);
    let lamp = 2.0 * distance * distance;
    let (all, warnings) = lights(
        &[
            downwards(0, [5.0, 5.0, 5.0]),
            downwards(1, place.to_array()),
            downwards(2, place.to_array()),
        ],
        json!([
            {"type": "directional", "intensity": 4, "color": [1, 0.5, 0]},
            {"type": "point", "intensity": lamp},
            {"type": "spot", "intensity": lamp, "color": [0, 0.5, 0], "spot": {"outerConeAngle": 0.5}},
        ]),
    );
    let near = |a: DVec3, b: DVec3| a.distance(b) < 1e-12;
    assert_eq!(all[0].colour, [1.0, 0.5, 0.0]);
    let LightSource::Directional { direction } = all[0].source else { panic!("{all:?}") };
    assert!(near(direction, DVec3::Y), "{direction}");
    assert!(all[1].colour.iter().all(|x| (x - 0.5).abs() < 1e-12), "{all:?}");
    let LightSource::Point { position, attenuation: Some(weaker) } = all[1].source else {
        panic!("{all:?}")
    };
    assert!(near(position, place) && (weaker.at(distance) - 1.0).abs() < 1e-12);
    assert!((weaker.at(2.0 * distance) - 0.25).abs() < 1e-12);
    let LightSource::Spot { axis, exponent, .. } = all[2].source else { panic!("{all:?}") };
    assert!(near(axis, DVec3::NEG_Y) && exponent > 8, "{all:?}");
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].contains("divided by 4.0 lux"), "{warnings:?}");
}

#[test]
fn what_is_not_shown_of_lights_and_cameras_is_told() {
    let at = |light: Value| json!({"extensions": {"KHR_lights_punctual": {"light": light}}});
    let nodes = [
        at(json!(0)),
        at(json!(1)),
        at(json!(2)),
        at(json!(9)),
        json!({"scale": [0, 0, 0], "extensions": {"KHR_lights_punctual": {"light": 3}}}),
        json!({"camera": 0}),
        json!({"camera": 1}),
    ];
    let all = json!([
        {"type": "laser"},
        {"type": "point", "intensity": -1},
        {"type": "point", "range": 10, "intensity": 100},
        {"type": "directional"},
    ]);
    let camera = json!([{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]);
    let (model, warnings) = model(&file(&nodes, &all, &camera));
    assert_eq!((model.lights.len(), model.camera), (1, None));
    let many = lights(&vec![at(json!(3)); 9], all).1;
    let wrong = |camera: Value| self::model(&file(&nodes, &json!([]), &json!([camera]))).1;
    let cameras =
        [json!({"type": "fish-eye"}), json!({"type": "orthographic"}), json!(3)].map(wrong);
    insta::assert_snapshot!([warnings, many, cameras.concat()].concat().join("\n"));
}

/// The picture that the camera shows, and the default light where the file has none.
#[test]
fn a_glb_in_place_of_a_scene_is_seen_by_its_camera() {
    let cameras = json!([{"type": "orthographic", "orthographic": {"xmag": 4, "ymag": 3, "znear": 0, "zfar": 9}}]);
    let place = json!({"camera": 0, "translation": [1, 0.75, 20]});
    let scene = loaded(&[("a.glb", &file(&[place], &json!([]), &cameras))]);
    assert_eq!(scene.frame.lights.len(), 1);
    // 6 units are 48 pixels; the wedge's left side is a unit from the middle, its foot 3/4.
    let left = scene.frame.spans.iter().map(|span| span.x).min();
    let lowest = scene.frame.spans.iter().map(|span| span.y).max();
    assert_eq!((left, lowest), (Some(24), Some(29)));
}

#[test]
fn a_scene_file_has_its_own_lights() {
    let scene = "[[object]]\nmesh = \"a.glb\"\n";
    let glb = file(
        &[downwards(0, [0.0; 3]), downwards(0, [0.0; 3])],
        &json!([{"type": "directional"}]),
        &json!([]),
    );
    let scene = loaded(&[("scene.toml", scene.as_bytes()), ("a.glb", &glb)]);
    assert_eq!(scene.frame.lights.len(), 1);
    let said = scene.warnings[0].to_string();
    assert!(
        said.ends_with("its lights are left out; they count where the file itself is the scene"),
        "{said}"
    );
}

/// Values that are apt to hurt.
fn value() -> impl Strategy<Value = Value> {
    prop::sample::select(vec![
        json!(null),
        json!(-1),
        json!(0),
        json!(1),
        json!(1e308),
        json!(-1e-300),
        json!("x"),
        json!([]),
        json!([1, 1, 1]),
        json!([1e308, 0, 0]),
        json!({}),
        json!("spot"),
        json!("point"),
        json!("directional"),
        json!("orthographic"),
        json!({"innerConeAngle": 9, "outerConeAngle": -9}),
        json!({"ymag": 1e-300}),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn nonsense_gives_lights_within_range(values in prop::collection::vec(value(), 12)) {
        let [a, b, c, d, e, f, g, h, i, j, k, l] = &values[..] else { unreachable!("there are 12") };
        let lights = json!([
            {"type": a, "color": b, "intensity": c, "range": d, "spot": e},
            {"type": "spot", "color": f, "intensity": g, "spot": {"outerConeAngle": h}},
            {"type": "point", "intensity": 3},
        ]);
        let cameras = json!([{"type": i, "orthographic": {"xmag": j, "ymag": k}}]);
        let nodes = [
            downwards(0, [1.0, 2.0, 3.0]), downwards(1, [0.0; 3]), downwards(2, [1e29, 0.0, 0.0]),
            json!({"camera": 0, "extensions": {"KHR_lights_punctual": l}}),
        ];
        let (model, _) = model(&file(&nodes, &lights, &cameras));
        for light in &model.lights {
            prop_assert!(light.colour.iter().all(|x| (0.0..=1.0).contains(x)), "{light:?}");
            if let LightSource::Spot { exponent, .. } = light.source {
                prop_assert!((1..=8191).contains(&exponent));
            }
        }
        prop_assert!(model.camera.is_none_or(|camera| camera.rotation().is_some()));
    }
}
