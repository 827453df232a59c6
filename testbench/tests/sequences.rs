//! Sequences: one core shades every frame.
use proptest::prelude::*;
use specula_fixtures::each_method;
use specula_scene::{LoadedScene, load, parse};
use specula_spec::{CoreSpec, Method, SceneCore, Survey};
use specula_testbench::{Bench, EngineKind, Outcome};

each_method!(one_core_shades_every_frame);

/// A lid that opens, an eye that comes near, and a lamp that goes around; materials differ.
const NEAR: &str = "
[camera]
target = [0, 0, 0]
eye = [0, 1, 6]
viewer = \"local\"
height = 4
[[light]]
kind = \"point\"
position = [2, 2, 3]
[[light]]
direction = [-1, 1, 1]
colour = 0.5
[[object]]
primitive = \"icosahedron\"
level = 1
[object.material]
shininess = 8
[[object]]
primitive = \"torus\"
level = 4
translate = [0, 0.5, 0]
[object.material]
diffuse = [0.2, 0.3, 0.9]
shininess = 64
[sequence]
frames = 6
[[sequence.motion]]
of = \"light 1\"
orbit = 360
[[sequence.motion]]
of = \"camera\"
orbit = [0, 60]
at = [0, 5]
[[sequence.motion]]
of = \"object 2\"
turn = 90
axis = [1, 0, 0]
steps = \"smooth\"
";

fn near() -> LoadedScene {
    parse("near.toml", format!("size = [64, 48]\n{NEAR}")).unwrap_or_else(|e| panic!("{e}"))
}

fn shaded(scene: &LoadedScene, spec: &CoreSpec, number: u32, engine: EngineKind) -> Outcome {
    let frame = scene.sequence.as_ref().unwrap().frame(number).unwrap();
    Bench::new(&frame, spec, "moving").unwrap().run(engine, &mut |_, _| ()).unwrap()
}

fn one_core_shades_every_frame(method: Method) {
    for scene in [near(), load("sunrise", Some((48, 36))).unwrap()] {
        let spec = scene.core_spec(Some(method)).unwrap();
        let frames = scene.sequence.as_ref().unwrap().frames();
        for number in (0..frames).step_by(if frames > 9 { 5 } else { 1 }) {
            let outcome = shaded(&scene, &spec, number, EngineKind::Fast);
            assert!(outcome.agrees() && outcome.pixels > 0, "{} {number}", scene.name);
        }
        let slow = shaded(&scene, &spec, 2, EngineKind::RustHdl);
        assert!(slow.agrees());
        assert_eq!(slow.codes, shaded(&scene, &spec, 2, EngineKind::Fast).codes);
    }
}

/// A core for the first frame alone does not take the others, and one for all frames takes each.
#[test]
fn a_core_for_all_frames_takes_each() {
    let scene = near();
    let sequence = scene.sequence.as_ref().unwrap();
    let all = scene.core_spec(Some(Method::Lyon)).unwrap();
    let first = all.specialised(&scene.frame);
    for number in 0..sequence.frames() {
        let frame = sequence.frame(number).unwrap();
        assert!(all.fit_to(&frame).is_ok(), "{number}");
        assert_eq!(first.fit_to(&frame).is_ok(), number == 0, "{number}");
    }
}

/// The witnesses of a survey give a core's inputs what all spans do.
fn witnesses_stand_for_all(method: Method, numbers: &[u32]) {
    let scene = near();
    let sequence = scene.sequence.as_ref().unwrap();
    let spec = scene.core_spec(Some(method)).unwrap();
    let Survey { core, witnesses } = spec.survey(sequence).unwrap();
    assert_eq!(core, spec);
    assert_eq!(core.specialised(&witnesses[..]), core);
    let count =
        |frames: &[specula_scene::Frame]| frames.iter().map(|f| f.spans.len()).sum::<usize>();
    let all: Vec<_> = (0..sequence.frames()).map(|n| sequence.frame(n).unwrap()).collect();
    assert_eq!(spec.specialised(&all[..]), core);
    assert!(4 * count(&witnesses) < count(&all), "{} of {}", count(&witnesses), count(&all));
    for &number in numbers {
        let some: Vec<_> = all.iter().take(number as usize).cloned().collect();
        let of_some = spec.specialised(&some[..]);
        assert!(some.iter().all(|frame| of_some.fit_to(frame).is_ok()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, ..ProptestConfig::default() })]
    #[test]
    fn witnesses_stand_for_all_spans(method in prop::sample::select(Method::ALL.to_vec()), few in 1..6u32) {
        witnesses_stand_for_all(method, &[few]);
    }
}
