//! A core for one scene is the general core under what is known of the scene: Yosys proves it, for
//! every input there is, at reduced widths.
mod miter;

use std::process::Command;

use specula_fixtures::tools;
use specula_scene::parse;
use specula_spec::{CoreSpec, Method, SceneCore};

use miter::Miter;

/// Faces that look at the viewer, in a light, without ambient light, in formats so coarse that a
/// proof takes seconds.
const SCENE: &str = r#"
ambient = 0.0

[[light]]
direction = [0.0, 0.6, 0.8]

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

/// Normals at the ends of spans of the scene.
const FLAT: [[&str; 2]; 4] =
    [["0.28, 0, 0.96"; 2], ["-0.28, 0, 0.96"; 2], ["0, 0.28, 0.96"; 2], ["0, -0.6, 0.8"; 2]];
const BENT: [[&str; 2]; 2] =
    [["0, 0.28, 0.96", "0, 0.6, 0.8"], ["0.28, 0, 0.96", "-0.28, 0, 0.96"]];

/// The core for the scene with these spans, whose materials take turns, by `method`.
fn core(method: Method, normals: &[[&str; 2]], materials: &[&str]) -> CoreSpec {
    let span = |([first, last], material): (&[&str; 2], &&str)| {
        format!(
            "[[span]]\nlength = 3\nnormals = [[{first}], [{last}]]\n\n\
             [span.material]\nshininess = 2\n{material}\n\n"
        )
    };
    let spans: String = normals.iter().zip(materials.iter().cycle()).map(span).collect();
    parse("scene.toml", format!("{SCENE}\n{spans}")).unwrap().core_spec(Some(method)).unwrap()
}

/// Whether Yosys proves that both cores agree, given this.
fn proven(miter: &Miter, given: &[String]) -> bool {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in miter.files(given) {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let mut yosys = Command::new("yosys");
    let output = yosys
        .current_dir(folder.path())
        .args(["-s", "prove.ys"])
        .env("LC_ALL", "C")
        .output()
        .unwrap();
    let [said, complained] =
        [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
    let proof =
        output.status.success() && said.contains("SAT proof finished - no model found: SUCCESS!");
    // What it says of a model may be lost as it ends with an error.
    let refuted = complained.contains("Called with -verify and proof did fail!");
    assert!(proof || refuted, "{said}{complained}");
    proof
}

/// Given all that is known the cores agree, and they rest on every line of it that `matters`.
fn assert_equivalent(spec: &CoreSpec, facts: &str, matters: &[&str]) {
    if !tools::is_installed("yosys") {
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

const YELLOW: &str = "diffuse = [0.5, 0.5, 0.3]\nspecular = 0.2";

/// A normal is no longer than 1 + 2^-4: what both cores state of it.
const UNIT_NORMAL: &str =
    "normal_x * normal_x + normal_y * normal_y + normal_z * normal_z <= 17 * 17";

/// Constants (the light, the exponent, the colours), ambient light that is left out, and narrowed
/// normals.
#[test]
fn lyon_with_constants_is_the_general_core() {
    let yellow = core(Method::Lyon, &FLAT, &[YELLOW]);
    assert_equivalent(
        &yellow,
        UNIT_NORMAL,
        &["ambient_r", "light0_direction_y", "light0_diffuse_g", "normal_z"],
    );
}

/// Highlights that no material has: their vectors and powers are left out.
#[test]
fn lyon_without_highlights_is_the_general_core() {
    let matt = core(Method::Lyon, &FLAT, &["diffuse = [0.5, 0.5, 0.3]\nspecular = 0"]);
    assert_equivalent(&matt, UNIT_NORMAL, &["light0_specular_g"]);
}

/// Two inputs that are alike.
#[test]
fn lyon_with_equal_inputs_is_the_general_core() {
    // Faces of two greys, so that colours are no constants.
    let grey = core(
        Method::Lyon,
        &FLAT,
        &["diffuse = 0.5\nspecular = 0.2", "diffuse = 0.4\nspecular = 0.2"],
    );
    assert_equivalent(&grey, UNIT_NORMAL, &["light0_diffuse_g == light0_diffuse_r"]);
}

/// Intensities that are interpolated, over three pixels at which they stay within 0 to 1.
#[test]
fn gouraud_with_constants_is_the_general_core() {
    let stays = |name: &str| {
        // A start has no sign.
        let last = format!("$signed({{1'b0, {name}_start}}) + 2 * {name}_step");
        format!("{last} >= 0 && {last} <= 256")
    };
    let facts = ["light0_diffuse_intensity", "light0_specular_intensity"].map(stays).join(" && ");
    let yellow = core(Method::Gouraud, &BENT, &[YELLOW]);
    assert_equivalent(&yellow, &facts, &["ambient_r", "light0_specular_b"]);
}
