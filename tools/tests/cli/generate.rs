//! `specula generate`.
use std::fs;
use std::process::Command;

use specula_fixtures::tools::{is_installed, python_with_numpy};

use crate::program::Place;

#[test]
fn the_verilog_is_that_of_run() {
    let place = Place::new();
    assert_eq!(
        place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "rtl"]),
        "rtl/teapot.v\nrtl/spec.toml\n"
    );
    assert_eq!(place.names("rtl"), ["spec.toml", "teapot.v"]);
    place.succeeds(&["run", "teapot", "--size", "64x48"]);
    for file in ["teapot.v", "spec.toml"] {
        let [alone, run] = ["rtl", "out/teapot"]
            .map(|folder| fs::read_to_string(place.path(folder).join(file)).unwrap());
        assert!(alone == run, "{file}");
    }
}

#[test]
fn headers_say_what_the_core_is() {
    let place = Place::new();
    for method in ["lyon", "hybrid"] {
        place.succeeds(&["generate", "teapot", "--method", method, "-o", method]);
        let text = fs::read_to_string(place.path(method).join("teapot.v")).unwrap();
        let header: Vec<&str> = text.lines().take_while(|line| line.starts_with("//")).collect();
        insta::assert_snapshot!(format!("header_of_{method}"), header.join("\n"));
    }
}

/// The arguments that chose the formats, the device whose blocks they are cheapest on, and its target.
#[test]
fn headers_have_the_command_that_makes_the_same_core() {
    let place = Place::new();
    let teapot = ["generate", "teapot", "--size", "64x48", "--method", "hybrid"];
    let device = ["--device", "ecp5-25"];
    for (asked, recorded) in [
        (vec!["--bound", "0.75lsb"], " --bound 0.75lsb"),
        ([&["--bound", "1lsb"], &device[..]].concat(), " --bound 1lsb --device ecp5-25"),
        (vec!["--max-error", "25lsb"], " --max-error 25lsb"),
        (vec!["--max-quantisation", "1.5lsb"], " --max-quantisation 1.5lsb"),
        (device.to_vec(), " --device ecp5-25"),
        (vec!["--formats", "recommended"], " --formats recommended"),
    ] {
        let verilog = place.succeeds(&[&teapot[..], &asked, &["-o", "-"]].concat());
        let command = format!("specula {}{recorded}", teapot.join(" "));
        let mut indented = verilog.lines().filter_map(|line| line.strip_prefix("//   "));
        let found = indented.find_map(|line| line.strip_prefix(&command)).expect("the command");
        let on_target = asked.contains(&"--device");
        assert_eq!(found.starts_with(" --target ecp5 --clock "), on_target, "{found}");
        assert!(on_target || found.is_empty(), "{found}");
        let command = command + found;
        let words: Vec<&str> = command.split(' ').skip(1).chain(["-o", "-"]).collect();
        assert!(place.succeeds(&words) == verilog, "{command}");
    }
}

#[test]
fn a_bound_is_kept_and_named_formats_stay() {
    let place = Place::new();
    place.write(
        "named.toml",
        "[[object]]\nprimitive = \"teapot\"\n[core]\nmethod = \"lyon\"\n[core.lyon.formats]\nvector = \"S1.16\"\n",
    );
    place.succeeds(&["run", "named.toml", "--size", "48x36", "--bound", "0.8lsb"]);
    let report = place.report("out/named");
    let bound = report["bound_lsb"].as_f64().unwrap();
    assert!(bound < 0.8 && bound > 0.5, "{bound}");
    let spec = fs::read_to_string(place.path("out/named/spec.toml")).unwrap();
    assert!(spec.contains("vector = \"S1.16\""), "{spec}");
}

#[test]
fn names_that_verilog_keeps_are_avoided() {
    let place = Place::new();
    place.write("module.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(
        place.succeeds(&["generate", "module.obj", "--method", "lyon"]),
        "out/module/module_core.v\nout/module/spec.toml\n"
    );
}

#[test]
fn the_verilog_may_go_to_standard_output() {
    let place = Place::new();
    let printed = place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "-"]);
    assert!(place.names(".").is_empty(), "{:?}", place.names("."));
    place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "rtl"]);
    assert!(printed == fs::read_to_string(place.path("rtl/teapot.v")).unwrap());
    let again = place.succeeds(&["generate", "--spec", "rtl/spec.toml", "-o", "-"]);
    assert!(again.contains("\nmodule teapot (\n"), "{again}");
}

#[test]
fn a_core_may_be_called_otherwise() {
    let place = Place::new();
    let size = ["--size", "64x48", "--name", "shader_2"];
    let said = place.succeeds(&[&["generate", "teapot"], &size[..]].concat());
    assert_eq!(said, "out/shader_2/shader_2.v\nout/shader_2/spec.toml\n");
    let text = fs::read_to_string(place.path("out/shader_2/shader_2.v")).unwrap();
    assert!(
        text.contains("\nmodule shader_2 (\n") && text.contains("\nmodule shader_2_normalise (\n"),
        "{text}"
    );
    assert!(
        text.contains("//   specula generate teapot --size 64x48 --method lyon --name shader_2\n"),
        "{text}"
    );
    place.succeeds(&[&["run", "teapot", "-o", "run"], &size[..]].concat());
    let report = place.report("run");
    assert_eq!((&report["scene"], &report["module"]), (&"teapot".into(), &"shader_2".into()));
    assert!(text == fs::read_to_string(place.path("run/shader_2.v")).unwrap());
    // A core that is there is given another name, and its spec has it.
    let said = place.succeeds(&["generate", "--spec", "run", "--name", "shader_3", "-o", "again"]);
    assert_eq!(said, "again/shader_3.v\nagain/spec.toml\n");
    assert!(
        fs::read_to_string(place.path("again/spec.toml"))
            .unwrap()
            .contains("name = \"shader_3\"\n")
    );
}

#[test]
fn modules_are_not_called_as_their_ports() {
    let place = Place::new();
    for name in
        ["red", "green", "blue", "valid", "valid_out", "start", "clock", "normal_start_x", "entity"]
    {
        place
            .write(&format!("{name}.toml"), "size = [32, 24]\n[[object]]\nprimitive = \"torus\"\n");
        let file = format!("{name}.toml");
        let said = place.succeeds(&["generate", &file, "--method", "lyon", "-o", name]);
        assert_eq!(said, format!("{name}/{name}_core.v\n{name}/spec.toml\n"));
    }
}

#[test]
fn other_files_stay() {
    let place = Place::new();
    fs::create_dir(place.path("rtl")).unwrap();
    place.write("rtl/mine.v", "module mine; endmodule\n");
    place.succeeds(&["generate", "teapot", "-o", "rtl"]);
    place.succeeds(&["generate", "teapot", "-o", "rtl"]);
    assert_eq!(place.names("rtl"), ["mine.v", "spec.toml", "teapot.v"]);
}

#[test]
fn the_verilog_of_a_run_is_not_exchanged() {
    let place = Place::new();
    place.succeeds(&["run", "teapot", "--size", "64x48", "-o", "run"]);
    place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "run"]);
    let ended = place
        .specula(&["generate", "teapot", "--size", "64x48", "--method", "hybrid", "-o", "run"]);
    assert_eq!(ended.status, Some(2));
    insta::assert_snapshot!(ended.stderr);
    // A folder with nothing but a generated core can become a run's.
    place.succeeds(&["generate", "teapot", "-o", "core"]);
    place.succeeds(&["run", "teapot", "--size", "64x48", "-o", "core"]);
}

/// Whatever words ask for a clock, the command in the header makes the same bytes.
#[test]
fn the_command_in_the_header_makes_the_same_core() {
    let place = Place::new();
    let asked = [
        &["--target", "ecp5"][..],
        &["--target", "ecp5", "--clock", "max"],
        &["--target", "ecp5", "--clock", "87.5"],
        &["--target", "generic"],
    ];
    for words in asked {
        let wanted = ["generate", "torus", "--size", "32x24", "--method", "gouraud", "-o", "-"];
        let text = place.succeeds(&[&wanted[..], words].concat());
        let command = text.lines().find_map(|line| line.strip_prefix("//   specula "));
        let command = command.expect("the header has the command");
        assert_eq!(command.contains(" --target ecp5 --clock "), words[1] == "ecp5", "{command}");
        let again: Vec<&str> = command.split(' ').chain(["-o", "-"]).collect();
        assert!(place.succeeds(&again) == text, "{command}");
    }
    // A core that was made for a target can be made for any device.
    place.succeeds(&["generate", "torus", "--target", "ecp5", "--clock", "90", "-o", "core"]);
    let text = place.succeeds(&["generate", "--spec", "core", "--target", "generic", "-o", "-"]);
    assert!(text.contains("//   specula generate --spec spec.toml --target generic\n"), "{text}");
    assert!(!text.contains("Made for"), "{text}");
}

#[test]
fn a_clock_is_asked_for_on_a_target() {
    let place = Place::new();
    let refused = |words: &[&str]| {
        let ended = place.specula(&[&["generate", "torus", "-o", "-"], words].concat());
        assert_eq!(ended.status, Some(2), "{words:?}");
        ended.stderr
    };
    assert!(refused(&["--clock", "100"]).contains("--target <TARGET>"));
    assert!(refused(&["--target", "ecp6"]).contains("ecp5"));
    let other = refused(&["--target", "xilinx7", "--device", "ecp5-25"]);
    assert!(other.contains("`ecp5-25` is a device of the target `ecp5`"), "{other}");
    assert!(refused(&["--target", "ecp5", "--clock", "0"]).contains("from 1 to 1000 MHz"));
    let run = place.specula(&["run", "torus", "--clock", "max"]);
    assert!(run.stderr.contains("--target <TARGET>"), "{}", run.stderr);
}

/// The block's folder has everything, works, and can be written again.
#[test]
fn a_block_is_written_with_all_it_takes() {
    let place = Place::new();
    let words = ["generate", "teapot", "--size", "48x36", "--ip", "-o", "block"];
    let said = place.succeeds(&words);
    let names = place.names("block");
    let mut printed: Vec<&str> =
        said.lines().filter_map(|line| line.strip_prefix("block/")).collect();
    printed.sort_unstable();
    assert_eq!(printed, names);
    insta::assert_snapshot!("files_of_a_block", names.join("\n"));
    for name in ["teapot.md", "teapot_axis.v", "README.md"] {
        let text = fs::read_to_string(place.path("block").join(name)).unwrap();
        insta::assert_snapshot!(format!("block_{}", name.replace('.', "_")), text);
    }
    assert_eq!(place.succeeds(&words), said);
    let makes = |arguments: &[&str]| {
        let words = [&["-C", "block"], arguments].concat();
        let made = Command::new("make").args(words).current_dir(place.path(".")).output().unwrap();
        let said = String::from_utf8_lossy(&made.stdout);
        assert!(made.status.success() && said.contains("\nPASS"), "{arguments:?}: {said}");
    };
    let are_installed = |tools: &[&str]| tools.iter().all(|tool| is_installed(tool));
    if are_installed(&["make", "iverilog"]) {
        makes(&["sim", "SEED=2"]);
    }
    if are_installed(&["make", "gcc"]) {
        makes(&["host", "CC=gcc"]);
    }
    if let Some(python) = python_with_numpy().filter(|_| is_installed("make")) {
        makes(&["host-python", &format!("PYTHON={python}")]);
    }
}

/// A core that is there becomes a block with the spans of a scene as vectors.
#[test]
fn a_spec_becomes_a_block_for_a_scene() {
    let place = Place::new();
    place.write("ring.toml", "size = [32, 24]\n[[object]]\nprimitive = \"torus\"\n");
    let core = ["--target", "ecp5", "--clock", "120", "--method", "gouraud"];
    place.succeeds(&[&["generate", "ring.toml", "-o", "core"], &core[..]].concat());
    let words =
        ["generate", "--spec", "core", "--ip", "--word", "64", "--positions", "-o", "block"];
    let refused = place.specula(&words);
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("--vectors"), "{}", refused.stderr);
    place.succeeds(&[&words[..], &["--vectors", "ring.toml", "--spans", "3"]].concat());
    let text = |name: &str| fs::read_to_string(place.path("block").join(name)).unwrap();
    assert!(text("ring.lpf").contains("FREQUENCY PORT \"aclk\" 120 MHZ;"));
    let pixels = text("ring_pixels.hex");
    // 58 bits, of which bit 56 is `tlast`.
    let ends = pixels.lines().filter(|line| line.len() == 15 && line.as_bytes()[0] & 1 == 1);
    assert_eq!(ends.count(), 3, "{pixels}");
}

#[test]
fn a_block_is_asked_for_where_it_can_be() {
    let place = Place::new();
    let refused = |words: &[&str]| {
        let ended = place.specula(&[&["generate", "torus"], words].concat());
        assert_eq!(ended.status, Some(2), "{words:?}");
        ended.stderr
    };
    assert!(refused(&["--ip", "-o", "-"]).contains("--output"));
    assert!(refused(&["--word", "64"]).contains("--ip"));
    assert!(refused(&["--ip", "--word", "16"]).contains("32, 64"));
    assert!(refused(&["--ip", "--spans", "0"]).contains("--spans"));
    assert!(place.names(".").is_empty());
    fs::create_dir(place.path("mine")).unwrap();
    place.write("mine/Makefile", "all:\n");
    assert!(refused(&["--ip", "--size", "32x24", "-o", "mine"]).contains("Makefile"));
    assert_eq!(place.names("mine"), ["Makefile"]);
}
