//! What must stay variable does: a core takes every scene within what is kept, and refuses others.
use std::fmt::Write;

use specula_fixtures::{Draw, each_method};
use specula_scene::{LoadedScene, parse};
use specula_spec::{CoreSpec, FittedCore, Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

each_method!(every_view_within_is_taken);

/// A torus under two lights; what is given stands in the place of the scene's own.
struct View {
    camera: [f64; 3],
    lights: Vec<[f64; 3]>,
    shininess: u32,
    diffuse: [f64; 3],
    core: String,
}

impl View {
    fn own() -> View {
        View {
            camera: [0.3, 0.6, 1.0],
            lights: vec![[0.4, 0.7, 1.0], [-0.5, 0.2, 1.0]],
            shininess: 32,
            diffuse: [0.6, 0.5, 0.3],
            core: String::new(),
        }
    }

    fn scene(&self) -> LoadedScene {
        let mut text = format!("size = [64, 48]\n[camera]\ndirection = {:?}\n", self.camera);
        for light in &self.lights {
            let _ =
                write!(text, "[[light]]\nspace = \"view\"\ndirection = {light:?}\ncolour = 0.6\n");
        }
        let _ = write!(
            text,
            "[[object]]\nprimitive = \"torus\"\nlevel = 8\n[object.material]\ndiffuse = {:?}\nshininess = {}\n{}",
            self.diffuse, self.shininess, self.core
        );
        parse("view.toml", text).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Something else within what is kept.
    fn drawn(draw: &mut Draw) -> View {
        let turn = draw.within(0.0, std::f64::consts::TAU);
        let light = |draw: &mut Draw| {
            let (from_eye, around) =
                (draw.within(0.0, 59f64.to_radians()), draw.within(0.0, std::f64::consts::TAU));
            [from_eye.sin() * around.cos(), from_eye.sin() * around.sin(), from_eye.cos()]
        };
        View {
            camera: [turn.cos(), draw.within(-2.0, 2.0), turn.sin()],
            lights: vec![light(draw), light(draw)],
            shininess: draw.within(8.0, 64.99) as u32,
            diffuse: std::array::from_fn(|_| draw.within(0.0, 1.0)),
            core: String::new(),
        }
    }
}

const KEPT: &str = "[core]\nkeep = [\"camera\", \"lights\", \"materials\"]\n\
                    [core.kept]\nshininess = [8, 64]\nwidest_angle = 20\n";

/// The core takes 20 views drawn at random, each with the model's pixels and within its bound.
fn every_view_within_is_taken(method: Method) {
    let own = View { core: KEPT.to_owned(), ..View::own() };
    let spec = own.scene().core_spec(Some(method)).unwrap();
    let mut draw = Draw::new(4711);
    for number in 0..20 {
        let scene = View::drawn(&mut draw).scene();
        let fitted = spec.fit_to(&scene.frame);
        let FittedCore { frame, spec } =
            fitted.unwrap_or_else(|error| panic!("{method:?} {number}: {error}"));
        let bench = Bench::new(&frame, &spec, "kept").unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        assert!(outcome.agrees() && outcome.pixels > 500, "{method:?} {number}");
    }
}

fn core(core: &str) -> CoreSpec {
    let view = View { core: core.to_owned(), ..View::own() };
    view.scene().core_spec(Some(Method::Lyon)).unwrap()
}

fn refusal(spec: &CoreSpec, view: &View) -> String {
    spec.fit_to(&view.scene().frame).expect_err("the view is outside").to_string()
}

#[test]
fn what_is_outside_is_refused_with_a_word() {
    let spec = core(KEPT);
    let three = View { lights: vec![[0.0, 0.0, 1.0]; 3], ..View::own() };
    assert_eq!(refusal(&spec, &three), "its lights at infinity are 2, and the scene has 3");
    let sharp = View { shininess: 100, ..View::own() };
    assert_eq!(
        refusal(&spec, &sharp),
        "it takes exponents up to 64, and the scene has a material with 100"
    );
}

/// Each word frees what it names and nothing else.
#[test]
fn only_what_is_kept_may_change() {
    let changes: [(&str, View); 3] = [
        ("lights", View { lights: vec![[0.0, 1.0, 1.0], [0.0, -1.0, 1.0]], ..View::own() }),
        ("materials", View { shininess: 17, diffuse: [0.1, 0.9, 0.4], ..View::own() }),
        ("objects", View { camera: [1.0, 1.0, 0.1], ..View::own() }),
    ];
    for (kept, _) in &changes {
        let spec = core(&format!("[core]\nkeep = [\"{kept}\"]\n"));
        for (changed, view) in &changes {
            let fits = spec.fit_to(&view.scene().frame);
            assert_eq!(fits.is_ok(), kept == changed, "{kept} {changed}: {:?}", fits.err());
        }
    }
}

/// A largest angle of lights to the eye keeps their directions within it.
#[test]
fn lights_are_kept_within_their_angle() {
    let spec = core("[core]\nkeep = [\"lights\"]\n[core.kept]\nlight_angle = 50\n");
    let at = |degrees: f64| {
        let light = [0.0, degrees.to_radians().sin(), degrees.to_radians().cos()];
        spec.fit_to(&View { lights: vec![light; 2], ..View::own() }.scene().frame)
    };
    assert!(at(0.0).is_ok() && at(49.9).is_ok());
    let error = at(60.0).expect_err("it is farther from the eye").to_string();
    assert!(error.contains("directions of lights"), "{error}");
    let free = core("[core]\nkeep = [\"lights\"]\n");
    assert!(
        free.fit_to(&View { lights: vec![[0.0, 1.0, 0.1]; 2], ..View::own() }.scene().frame)
            .is_ok()
    );
}

#[test]
fn single_inputs_are_kept() {
    let one = core("[core]\nkeep = [\"ambient_g\"]\n");
    let none = core("");
    assert!(none.specialisation.given("ambient_g").is_some());
    assert!(one.specialisation.given("ambient_g").is_none());
    let view = View { core: "[core]\nkeep = [\"colours\"]\n".to_owned(), ..View::own() };
    let error = view.scene().core_spec(None).expect_err("there is no such input").to_string();
    assert!(error.contains("there is no `colours` to keep"), "{error}");
}

#[test]
fn it_says_what_it_can_shade() {
    assert_eq!(
        core(KEPT).can_shade(),
        "any triangle mesh in spans of up to 64 pixels; 2 directional lights anywhere; n up to 64, any colours"
    );
    assert_eq!(
        core("").can_shade(),
        "surfaces within the ranges of what it was made for, in spans of up to 8 pixels; \
         2 directional lights from where it was made for; n = 32, the colours it was made for"
    );
}
