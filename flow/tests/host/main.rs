//! Host code in C and in Python gives the words that Rust's set-up gives.
mod c;
mod cores;
mod float;
mod python;

use cores::{HostedCore, built_in, drawn};
use specula_fixtures::{Draw, each_method};
use specula_spec::Method;

/// Every span of every built-in scene, for the core that is made for the scene and for one that is
/// made for any.
fn words_are_those_of_rust(method: Method) {
    compare(&built_in(method));
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
    let cores: Vec<HostedCore> =
        built_in(method).into_iter().filter(HostedCore::has_float).collect();
    let Some(results) = c::run(&cores, "float") else { return };
    let share = |(core, result)| float::assert_near(core, result, &core.expected());
    let used = cores.iter().zip(&results).map(share).fold(0.0, f64::max);
    assert!(cores.is_empty() || used > 0.05, "{used}");
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
