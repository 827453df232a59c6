//! `specula methods`.
use serde_json::{Value, json};

use crate::program::Place;

fn methods() -> Vec<Value> {
    serde_json::from_str(&Place::new().succeeds(&["methods", "--json"]))
        .expect("it prints a list in JSON")
}

fn named<'a>(methods: &'a [Value], name: &str) -> &'a Value {
    methods
        .iter()
        .find(|method| method["name"] == name)
        .unwrap_or_else(|| panic!("{name} is absent"))
}

/// The first word of each line of the table.
fn names_in_the_table() -> Vec<String> {
    let table = Place::new().succeeds(&["methods"]);
    table
        .lines()
        .map(|line| line.split_whitespace().next().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn json_has_every_method_of_the_table_and_its_core() {
    let methods = methods();
    let names: Vec<&str> = methods.iter().map(|method| method["name"].as_str().unwrap()).collect();
    assert_eq!(names, names_in_the_table());
    for method in &methods {
        for count in ["latency", "multipliers", "adders", "registers", "register_bits"] {
            assert!(method[count].as_u64() > Some(0), "{count}: {method}");
        }
        assert!(method["register_bits"].as_u64() >= method["registers"].as_u64(), "{method}");
        let (summary, paper) =
            (method["summary"].as_str().unwrap(), method["paper"].as_str().unwrap());
        let source = method["equations"]
            .as_str()
            .map_or(format!("[{paper}]"), |numbers| format!("[{paper}, eq. {numbers}]"));
        assert!(summary.ends_with(&source), "{summary} does not end with {source}");
        let formats = method["formats"].as_array().unwrap();
        assert!(
            !formats.is_empty()
                && formats.iter().all(|point| point["format"].as_str().unwrap().contains('.')),
            "{method}"
        );
    }
}

#[test]
fn json_says_what_scenes_a_method_takes() {
    let methods = methods();
    let needs = |name: &str| {
        let needs = &named(&methods, name)["needs"];
        assert_eq!((&needs["most_lights"], &needs["largest_shininess"]), (&json!(8), &json!(8191)));
        needs["places_seen_from"].as_str().unwrap().to_owned()
    };
    for method in &methods {
        let name = method["name"].as_str().unwrap();
        let seen_from = match name {
            "phong" => "pixel",
            "gouraud" => "vertex",
            _ => "span",
        };
        assert_eq!(needs(name), seen_from, "{name}");
    }
}

#[test]
fn json_has_the_values_of_options_as_a_scene_file_means_them() {
    let methods = methods();
    let options = |name: &str| &named(&methods, name)["options"];
    assert_eq!(options("lyon")["squarings"], json!([0, 1, 2, 3, 4]));
    assert_eq!(
        options("duff"),
        &json!({
            "places": ["span", "pixel"],
            "power": ["squaring", "tables"],
            "specular": ["blinn", "quotient", "eq33", "eq34"],
        })
    );
    assert_eq!(
        options("hybrid"),
        &json!({ "places": ["span", "pixel"], "power": ["squaring", "tables"] })
    );
}

/// One core for each value of each option, the default's among them.
#[test]
fn json_has_the_operations_of_every_option() {
    for method in methods() {
        let options = method["options"].as_object().unwrap();
        let variants = method["variants"].as_array().unwrap();
        let of = |variant: &Value| (variant["latency"].clone(), variant["operations"].clone());
        for (option, values) in options {
            let cores: Vec<&Value> =
                variants.iter().filter(|variant| variant["option"] == option.as_str()).collect();
            let shown: Vec<&Value> = cores.iter().map(|core| &core["value"]).collect();
            assert_eq!(shown, values.as_array().unwrap().iter().collect::<Vec<_>>(), "{option}");
            assert!(
                cores.iter().any(|core| of(core) == of(&method)),
                "no value of {option} is {}'s default",
                method["name"]
            );
        }
    }
}

/// Hast's counts of C8 to C11, as docs/operations.md has them.
#[test]
fn json_has_the_operations_that_the_paper_prints() {
    let methods = methods();
    let counts = |specular: &str| {
        let variants = named(&methods, "duff")["variants"].as_array().unwrap();
        let core = variants
            .iter()
            .find(|variant| variant["option"] == "specular" && variant["value"] == specular)
            .unwrap();
        ["accumulators", "multipliers", "dividers", "reciprocal_roots", "square_roots"]
            .map(|count| core["operations"][count].as_u64().unwrap())
    };
    assert_eq!(counts("blinn"), [4, 2, 0, 1, 0]);
    assert_eq!(counts("quotient"), [5, 1, 1, 1, 0]);
    assert_eq!(counts("eq33"), [4, 2, 1, 1, 0]);
    assert_eq!(counts("eq34"), [4, 3, 0, 1, 0]);
}
