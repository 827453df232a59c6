//! What each input of each method's cores tells of a scene.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use specula_scene::{Needs, load};
use specula_spec::{CoreOptions, CoreSpec, InputMeaning, Method};

/// Scenes with lights at infinity and at places, of exponents that are powers of two and others.
const SCENES: [&str; 2] = ["teapot", "lamps"];

/// The options of a method: none, and each with each of its values.
fn tables(method: Method) -> impl Iterator<Item = CoreOptions> {
    let options = method
        .option_domains()
        .iter()
        .flat_map(|option| option.values.iter().map(|value| format!("{} = {value}", option.key)));
    let tables = [String::new()].into_iter().chain(options);
    // Some options tell only beside others.
    let beside = |option: &str| match option.split_once(' ') {
        Some(("frame", _)) => "form = \"vector\"",
        Some(("axis", _)) => "normals = \"wrapped\"",
        _ => "",
    };
    tables.map(move |option| {
        let table = format!("[{}]\n{option}\n{}", method.name(), beside(&option));
        table.parse().expect("it is TOML")
    })
}

/// The name of an input with the number of its light left open.
fn of_any_light(name: &str) -> String {
    match name.strip_prefix("light") {
        Some(rest) => format!("light<l>{}", &rest[1..]),
        None => name.to_owned(),
    }
}

/// Cores by one method.
fn cores(method: Method) -> impl Iterator<Item = CoreSpec> {
    SCENES.into_iter().flat_map(move |scene| {
        let frame = load(scene, Some((16, 12))).expect("it is built in").frame;
        let needs = Needs { uneven_shininess: None, ..Needs::of(&frame) };
        tables(method).map(move |table| {
            CoreSpec::for_scene(&needs, Some(&table), Some(method)).expect("it is one")
        })
    })
}

/// The inputs of all cores by one method, those of the first light alone.
fn roles(method: Method) -> BTreeMap<String, &'static str> {
    let mut roles = BTreeMap::new();
    for spec in cores(method) {
        for (port, role) in spec.inputs().iter().zip(spec.input_roles()) {
            let role = role.in_words();
            let first = *roles.entry(of_any_light(&port.name)).or_insert(role);
            assert_eq!(first, role, "{}", port.name);
        }
    }
    roles
}

#[test]
fn inputs_tell_of_what_they_are_for() {
    let mut text = String::new();
    for method in Method::ALL {
        let mut by_role: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for (name, role) in roles(method) {
            by_role.entry(role).or_default().push(name);
        }
        writeln!(text, "{}", method.name()).expect("a string takes all");
        for (role, names) in by_role {
            writeln!(text, "  {role}: {}", names.join(", ")).expect("a string takes all");
        }
    }
    insta::assert_snapshot!(text);
}

/// An input may be computed otherwise with other options.
#[test]
fn inputs_say_what_they_are() {
    let mut text = String::new();
    for method in Method::ALL {
        let mut lines = BTreeSet::new();
        for spec in cores(method) {
            for (port, meaning) in spec.inputs().iter().zip(spec.input_meanings()) {
                let InputMeaning { what, unit, computed, .. } = meaning;
                assert!(!what.is_empty() && !unit.is_empty() && !computed.is_empty());
                let name = of_any_light(&port.name);
                lines.insert(format!("  {name}: {what} [{unit}]: {computed}"));
            }
        }
        writeln!(text, "{}", method.name()).expect("a string takes all");
        lines.iter().for_each(|line| writeln!(text, "{line}").expect("a string takes all"));
    }
    insta::assert_snapshot!(text);
}
