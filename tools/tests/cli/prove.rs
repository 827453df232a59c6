//! `specula prove`: bounds that Gappa derives again, where it is installed.
use serde_json::Value;
use specula_fixtures::tools;

use crate::program::Place;

#[test]
fn three_methods_are_proven() {
    if !tools::is_installed("gappa") {
        return;
    }
    let place = Place::new();
    for (method, goals) in [("gouraud", 40), ("lyon", 100), ("reflection", 100)] {
        let report = place.succeeds(&["prove", "teapot", "--method", method, "--json"]);
        let report: Value = serde_json::from_str(&report).expect("it prints JSON");
        let core = &report["methods"][0];
        assert_eq!(core["holds"], true, "{core}");
        let all = core["goals"].as_array().expect("a list");
        assert!(all.len() > goals, "{method} has {} goals", all.len());
        let proven = all.iter().filter(|goal| goal["standing"] == "proven").count();
        assert!(2 * proven > all.len(), "{method}: {proven} of {}", all.len());
        let facts = all.iter().filter(|goal| goal["standing"] == "fact");
        for goal in facts {
            assert!(goal["premises"].as_array().is_some_and(|names| !names.is_empty()), "{goal}");
        }
        assert_eq!(table(method, &report), documented(method), "docs/proofs.md is not up to date");
    }
}

/// The method's number of goals, and those that are proven, as the page has them.
fn table(method: &str, report: &Value) -> Vec<String> {
    let goals = report["methods"][0]["goals"].as_array().expect("a list");
    let count = |of: &[&str]| {
        let counted = goals.iter().filter(|goal| of.iter().any(|of| goal["standing"] == *of));
        counted.count().to_string()
    };
    let proven = [count(&["proven"]), count(&["proven_but_for_f64"]), count(&["fact"])];
    [vec![method.to_owned(), goals.len().to_string()], proven.into()].concat()
}

fn documented(method: &str) -> Vec<String> {
    let page = include_str!("../../../docs/proofs.md");
    let begins = format!("| {method} |");
    let row = page.lines().find(|line| line.starts_with(&begins)).expect("the page has the method");
    let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
    [0, 2, 3, 4, 5].map(|cell| cells[cell].to_owned()).into()
}

#[test]
fn scripts_are_proven_one_by_one() {
    if !tools::is_installed("gappa") {
        return;
    }
    let place = Place::new();
    let text = place.succeeds(&["prove", "icosahedron", "--method", "gouraud", "-o", "proof"]);
    assert!(text.contains("red_channel") && text.contains("propagation"), "{text}");
    let folder = std::fs::read_dir(place.path("proof")).expect("it is written");
    let mut scripts: Vec<_> = folder.map(|file| file.expect("it is there").path()).collect();
    scripts.retain(|path| path.extension().is_some_and(|ending| ending == "g"));
    assert!(scripts.len() > 20, "{scripts:?}");
    for script in scripts {
        let ended = std::process::Command::new("gappa").arg(&script).output().expect("it runs");
        assert!(ended.status.success(), "{script:?}: {ended:?}");
    }
}
