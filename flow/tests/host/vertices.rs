//! What hosts compute at vertices.
use std::fmt::Write;
use std::process::Command;

use specula_fixtures::{Draw, tools};
use specula_scene::Frame;
use specula_spec::gouraud::LitPoint;
use specula_spec::{Method, MethodSpec, Specialise};

use crate::c::{succeed, write};
use crate::cores::{HostedCore, built_in, with_options};

/// Points at which functions are compared.
const POINTS: usize = 200;

/// `lambert`, and `highlight` or `lobe`, give what Rust does, but for the last bits of powers.
#[test]
fn intensities_of_vertices_are_those_of_rust() {
    compare_intensities("highlight = \"power\"", |n| format!("highlight({{}}, {n})"));
    for squarings in [0, 3] {
        let options = format!("highlight = \"f-k\"\nsquarings = {squarings}");
        compare_intensities(&options, |n| format!("lobe({{}}, {n}, {squarings})"));
    }
}

/// Compares what functions give with Rust's, for a core with options; `call` has the function of the
/// highlight for an exponent, `{}` for its vectors.
fn compare_intensities(options: &str, call: impl Fn(u32) -> String) {
    let core = with_options(Method::Gouraud, options);
    let MethodSpec::Gouraud(spec) = &core.spec.method else { unreachable!("it is asked for") };
    let mut draw = Draw::new(16);
    let (mut calls, mut expected) = ([vec![], vec![]], vec![]);
    for number in 0..POINTS {
        let unit = |draw: &mut Draw| draw.direction();
        let (normal, light) = (unit(&mut draw), unit(&mut draw));
        let n = 1 + number as u32;
        let frame = Frame {
            lights: vec![specula_scene::DirectionalLight { direction: light, colour: [1.0; 3] }],
            ..core.frame.clone()
        };
        let point = LitPoint::new(&frame, normal, core.frame.triangles[0].positions[0]);
        expected.extend([point.diffuse(0), point.highlight(0, spec.vertex_highlight(n))]);
        let [normal, light] = [normal, light].map(|v| format!("{:?}, {:?}, {:?}", v.x, v.y, v.z));
        for (language, [open, close]) in [["(double[]){", "}"], ["[", "]"]].into_iter().enumerate()
        {
            let arguments = format!("{open}{normal}{close}, {open}{light}{close}");
            calls[language].push(format!("lambert({arguments})"));
            calls[language].push(call(n).replace("{}", &arguments));
        }
    }
    compare(&core, &calls, &expected);
}

/// The angle of a vertex's cone is what Rust says, but for the last bits of arc cosines.
#[test]
fn angles_of_cones_are_those_of_rust() {
    let core = built_in(Method::Consistent, &["teapot"], Specialise::General).swap_remove(0);
    let MethodSpec::Consistent(spec) = &core.spec.method else { unreachable!("it is asked for") };
    let mut draw = Draw::new(17);
    let cosines: Vec<f64> = (0..POINTS).map(|_| draw.signed_unit()).collect();
    let expected: Vec<f64> = cosines.iter().map(|&m| spec.curve.quarter_turns(m)).collect();
    let text = core.text(".h");
    let name = ["rational_angle", "trigonometric_angle"]
        .into_iter()
        .find(|name| text.contains(name))
        .expect("one of them is there");
    let calls: Vec<String> = cosines.iter().map(|m| format!("{name}({m:?})")).collect();
    compare(&core, &[calls.clone(), calls], &expected);
}

/// Compares what calls in C and in Python give.
fn compare(core: &HostedCore, [c, python]: &[Vec<String>; 2], expected: &[f64]) {
    let folder = tempfile::tempdir().expect("there is room for a folder");
    let name = &core.name;
    write(folder.path(), &format!("{name}.h"), core.text(".h").as_bytes());
    write(folder.path(), &format!("{name}.py"), core.text("_ip.py").as_bytes());
    if tools::is_installed("gcc") {
        let mut text = format!("#include <stdio.h>\n#include \"{name}.h\"\nint main(void) {{\n");
        for call in c {
            let _ = writeln!(text, "  printf(\"%.17g\\n\", {name}_{call});");
        }
        write(folder.path(), "vertices.c", (text + "  return 0;\n}\n").as_bytes());
        let arguments = ["-std=c99", "-Wall", "-Werror", "-o", "vertices", "vertices.c", "-lm"];
        succeed(Command::new("gcc").args(arguments).current_dir(folder.path()));
        assert_near(Command::new("./vertices").current_dir(folder.path()), expected);
    }
    if let Some(interpreter) = tools::python_with_numpy() {
        let mut text = format!("import {name} as block\n");
        for call in python {
            let _ = writeln!(text, "print(repr(float(block.{call})))");
        }
        write(folder.path(), "vertices.py", text.as_bytes());
        let mut command = Command::new(interpreter);
        assert_near(command.arg("vertices.py").current_dir(folder.path()), expected);
    }
}

/// Asserts that a program prints these numbers, but for some units of an f64's last place.
fn assert_near(command: &mut Command, expected: &[f64]) {
    let said = command.output().expect("the program runs").stdout;
    let said = String::from_utf8(said).expect("it is text");
    let numbers: Vec<f64> = said.lines().map(|line| line.parse().expect("a number")).collect();
    assert_eq!(numbers.len(), expected.len());
    for (own, exact) in numbers.iter().zip(expected) {
        assert!((own - exact).abs() <= 4.0 * f64::EPSILON * exact.abs(), "{own} {exact}");
    }
}
