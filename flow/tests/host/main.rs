//! Host code in C and in Python gives the words that Rust's set-up gives.
mod c;
mod cores;
mod float;
mod python;
mod vertices;

use cores::{HostedCore, built_in, drawn};
use specula_fixtures::{Draw, each_method};
use specula_spec::{Method, Specialise};

/// Every span of every built-in scene, for the core that is made for the scene; of two of them for one
/// that is made for any, too.
fn words_are_those_of_rust(method: Method) {
    let mut cores = built_in(method, &specula_fixtures::still_scenes(), Specialise::Scene);
    cores.extend(built_in(method, &["teapot", "lamps"], Specialise::General));
    compare(&cores);
}

each_method!(words_are_those_of_rust);

/// Cores with any options and formats, words of both widths, with positions and without.
fn words_are_those_of_rust_with_every_option(method: Method) {
    let mut draw = Draw::new(15);
    compare(&drawn(method, &mut draw));
}

each_method!(words_are_those_of_rust_with_every_option);

/// With float no input is off by more than `NAME.h` says.
fn floats_are_as_near_as_is_said(method: Method) {
    let cores = built_in(method, &specula_fixtures::still_scenes(), Specialise::General);
    if !cores.iter().all(HostedCore::has_float) {
        assert!(cores.iter().all(|core| core.text(".h").contains("for double alone")));
        return;
    }
    let Some(results) = c::run(&cores, "float") else { return };
    for (core, result) in cores.iter().zip(&results) {
        let expected = core.expected();
        float::assert_near(core, result, &expected);
        assert_ne!(result.words, expected.words, "{}: it is float", core.name);
    }
}

each_method!(floats_are_as_near_as_is_said);

/// Compares what both languages give with what Rust gives.
fn compare(cores: &[HostedCore]) {
    assert!(!cores.is_empty());
    for (language, results) in [("C", c::run(cores, "double")), ("Python", python::run(cores))] {
        // Skipped where the tool is not installed.
        for (core, result) in cores.iter().zip(results.unwrap_or_default()) {
            core.assert_words(language, &result);
        }
    }
}
