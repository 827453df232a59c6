//! `specula methods`.
use serde_json::{Value, json};

use crate::program::Place;

fn methods() -> Vec<Value> {
    serde_json::from_str(&Place::new().succeeds(&["methods", "--json"])).expect("it prints a list in JSON")
}

fn named<'a>(methods: &'a [Value], name: &str) -> &'a Value {
    methods.iter().find(|method| method["name"] == name).unwrap_or_else(|| panic!("{name} is absent"))
}

/// The first word of each line of the table.
fn names_in_the_table() -> Vec<String> {
    let table = Place::new().succeeds(&["methods"]);
    table.lines().map(|line| line.split_whitespace().next().unwrap_or_default().to_owned()).collect()
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
        let (summary, paper) = (method["summary"].as_str().unwrap(), method["paper"].as_str().unwrap());
        let source = method["equations"].as_str().map_or(format!("[{paper}]"), |numbers| format!("[{paper}, eq. {numbers}]"));
        assert!(summary.ends_with(&source), "{summary} does not end with {source}");
        let formats = method["formats"].as_array().unwrap();
        assert!(!formats.is_empty() && formats.iter().all(|point| point["format"].as_str().unwrap().contains('.')), "{method}");
    }
}

#[test]
fn json_says_what_scenes_a_method_takes() {
    let methods = methods();
    let needs = |name: &str| {
        let needs = &named(&methods, name)["needs"];
        assert_eq!((&needs["most_lights"], &needs["largest_shininess"]), (&json!(4), &json!(8191)));
        needs["lights_and_eye_at_infinity"].as_bool().unwrap()
    };
    for method in &methods {
        let name = method["name"].as_str().unwrap();
        assert_eq!(needs(name), !["phong", "gouraud"].contains(&name), "{name}");
    }
}

#[test]
fn json_has_the_values_of_options_as_a_scene_file_means_them() {
    let methods = methods();
    let options = |name: &str| &named(&methods, name)["options"];
    assert_eq!(options("lyon")["squarings"], json!([0, 1, 2, 3]));
    assert_eq!(options("duff"), &json!({ "power": ["squaring", "tables"], "specular": ["blinn", "quotient", "eq33", "eq34"] }));
    assert_eq!(options("hybrid"), &json!({ "power": ["squaring", "tables"] }));
}
