//! FuseSoC's generator, which asks the program for a core.
use std::path::Path;
use std::process::Command;

use specula_fixtures::tools;

use crate::program::Place;

/// Runs a target of a core below a folder; whether it succeeds, and what it prints.
fn run(place: &Place, cores: &Path, target: &str, core: &str) -> (bool, String) {
    let ended = Command::new("fusesoc")
        .arg("--cores-root")
        .arg(cores)
        .args(["run", &format!("--target={target}"), core])
        .env("SPECULA", env!("CARGO_BIN_EXE_specula"))
        .current_dir(place.path("."))
        .output()
        .expect("FuseSoC runs");
    let said = [ended.stdout, ended.stderr].concat();
    (ended.status.success(), String::from_utf8_lossy(&said).into_owned())
}

/// The generator and its example.
fn cores() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../flow/fusesoc"))
}

/// A design that asks for a core is linted with it, and the core's bench runs.
#[test]
fn a_core_file_asks_for_a_scenes_core() {
    if !["fusesoc", "python3", "iverilog", "verilator"].into_iter().all(tools::is_installed) {
        return;
    }
    let place = Place::new();
    let (succeeded, said) = run(&place, cores(), "lint", "specula:examples:lit_torus");
    assert!(succeeded, "{said}");
    let (succeeded, said) = run(&place, cores(), "sim", "specula:examples:lit_torus");
    assert!(succeeded && said.contains("\nPASS: 20 pixels"), "{said}");
}

/// What is wrong with a generator's parameters is said, by the generator or by the program.
#[test]
fn wrong_parameters_are_told() {
    if !["fusesoc", "python3"].into_iter().all(tools::is_installed) {
        return;
    }
    for (parameters, told) in [
        ("{methods: lyon, scene: torus}", "no parameter `methods`"),
        ("{method: lyon}", "`scene` is missing"),
        ("{scene: torus, word: 16}", "32, 64"),
    ] {
        let place = Place::new();
        let core = format!(
            "CAPI=2:\nname: ::asker:1\nfilesets:\n  rtl:\n    depend: [specula:generators:specula]\n\
             generate:\n  shader: {{generator: specula, parameters: {parameters}}}\n\
             targets:\n  default:\n    flow: lint\n    flow_options: {{tool: verilator}}\n    \
             filesets: [rtl]\n    generate: [shader]\n    toplevel: torus_ip\n"
        );
        place.write("asker.core", core);
        for file in ["specula.core", "specula_generator.py"] {
            std::fs::copy(cores().join(file), place.path(file)).expect("it can be copied");
        }
        let (succeeded, said) = run(&place, &place.path("."), "default", "asker");
        assert!(!succeeded && said.contains(told), "{said}");
    }
}
