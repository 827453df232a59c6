//! A core for one scene is the general core under what is known of the scene: Yosys proves it, for every input there is, at reduced widths.
#[path = "../common/mod.rs"]
mod common;
mod miter;

use std::process::Command;

use specula_scene::{CoreSpec, Method, parse};

use common::tools;
use miter::Miter;

/// A white and a yellow face in a light, without ambient light, in formats so coarse that a proof takes a second.
const SCENE: &str = r#"
size = [24, 18]
ambient = 0.0

[[light]]
direction = [0.0, 0.6, 0.8]

[[object]]
primitive = "icosahedron"

[object.material]
diffuse = [0.5, 0.5, 0.3]
specular = 0.2
shininess = 2

[core.gouraud.formats]
accumulator = "S1.8"
intensity = "U1.4"

[core.lyon]
normals = "flat"
difference = "light-reflection"
squarings = 1

[core.lyon.formats]
vector = "S1.4"
diffuse = "U1.4"
difference = "S2.4"
shape = "U1.4"
"#;

/// The core for the scene, by `method`, after `changes` to the scene's text.
fn core(method: Method, changes: &[(&str, &str)]) -> CoreSpec {
    let text = changes.iter().fold(SCENE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    parse("scene.toml", text).unwrap().core_spec(Some(method)).unwrap()
}

/// Whether Yosys proves that both cores agree, given this.
fn proven(miter: &Miter, given: &[String]) -> bool {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in miter.files(given) {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let mut yosys = Command::new("yosys");
    let output = yosys.current_dir(folder.path()).args(["-s", "prove.ys"]).env("LC_ALL", "C").output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let proof = said.contains("SAT proof finished - no model found: SUCCESS!");
    assert!(
        proof == output.status.success() && (proof || said.contains("model found: FAIL!")),
        "{said}{}",
        String::from_utf8_lossy(&output.stderr)
    );
    proof
}

/// Given all that is known the cores agree, and they rest on every line of it that `matters`.
fn assert_equivalent(spec: &CoreSpec, facts: &str, matters: &[&str]) {
    if !tools::program("yosys") {
        return;
    }
    let miter = Miter::new(spec, facts);
    let given = miter.given();
    assert!(proven(&miter, &given), "{given:?}");
    for name in matters {
        let rest: Vec<String> = given.iter().filter(|fact| !fact.contains(name)).cloned().collect();
        assert!(rest.len() < given.len(), "{name} is none of {given:?}");
        assert!(!proven(&miter, &rest), "{name} does not matter");
    }
}

/// What a rounded unit normal comes to: (16 + √3/2)² at most.
const UNIT_NORMAL: &str = "normal_x * normal_x + normal_y * normal_y + normal_z * normal_z <= 284";

/// Constants (the light, the exponent, the colours), ambient light that is left out, and narrowed normals.
#[test]
fn flat_lyon() {
    assert_equivalent(&core(Method::Lyon, &[]), UNIT_NORMAL, &["ambient_r", "light0_direction_y", "light0_diffuse_g", "normal_z"]);
}

/// Two inputs that are alike.
#[test]
fn grey_lyon() {
    // Faces of two greys, so that colours are no constants.
    let second = "[[object]]\nprimitive = \"torus\"\n\n[object.material]\ndiffuse = 0.4\nspecular = 0.2\nshininess = 2\n\n[core.gouraud.formats]";
    let spec = core(Method::Lyon, &[("[0.5, 0.5, 0.3]", "0.5"), ("[core.gouraud.formats]", second)]);
    assert_equivalent(&spec, UNIT_NORMAL, &["light0_diffuse_g == light0_diffuse_r"]);
}

/// Intensities that are interpolated, over three pixels at which they stay within 0 to 1.
#[test]
fn gouraud() {
    let stays = |name: &str| {
        // A start has no sign.
        let last = format!("$signed({{1'b0, {name}_start}}) + 2 * {name}_step");
        format!("{last} >= 0 && {last} <= 256")
    };
    let facts = ["light0_diffuse_intensity", "light0_specular_intensity"].map(stays).join(" && ");
    let smooth = [("icosahedron", "torus")];
    assert_equivalent(&core(Method::Gouraud, &smooth), &facts, &["ambient_r", "light0_specular_b"]);
}
