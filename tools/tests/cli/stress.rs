//! `specula stress`.
use crate::program::Place;

const SMALL: [&str; 7] = ["stress", "--method", "gouraud", "--spans", "1", "-o", "stress"];

#[test]
fn it_writes_scenes_that_run_takes() {
    let place = Place::new();
    let table = place.succeeds(&SMALL);
    assert!(table.contains(" are at a documented limit, none is at fault."), "{table}");
    assert!(!table.contains("FAULT"), "{table}");
    let text = std::fs::read_to_string(place.path("stress/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(report["at_fault"], 0);
    assert_eq!(report["hold"].as_u64().unwrap() + report["at_limit"].as_u64().unwrap(), 64);
    for file in report["files"].as_array().unwrap() {
        assert!(place.path(&format!("stress/{}", file.as_str().unwrap())).is_file(), "{file}");
    }
    let rows = report["rows"].as_array().unwrap();
    let wide = rows.iter().find(|row| row["row"] == "3").unwrap();
    assert_eq!(wide["methods"][0]["verdict"], "limit");
    let scene = wide["methods"][0]["scene"].as_str().unwrap();
    place.succeeds(&["run", &format!("stress/{scene}"), "--trace", "none"]);
}

/// What is farther than 1 LSB from exact shading has a limit and a reason, or says that it has
/// none; a bound of 255 LSB is none.
#[test]
fn it_says_what_is_asked_and_what_came() {
    let place = Place::new();
    let report: serde_json::Value =
        serde_json::from_str(&place.succeeds(&[&SMALL[..], &["--json"]].concat())).unwrap();
    let reasons: Vec<&str> = report["limits"]
        .as_array()
        .unwrap()
        .iter()
        .map(|limit| limit["reason"].as_str().unwrap())
        .collect();
    let mut far = 0;
    for method in
        report["rows"].as_array().unwrap().iter().flat_map(|row| row["methods"].as_array().unwrap())
    {
        let worst = method["worst"]["total"].as_f64().unwrap_or(0.0);
        let asked = method["asked"].as_array().unwrap();
        let distance =
            asked.iter().filter(|asked| asked["what"].as_str().unwrap().starts_with("LSB off"));
        let came: f64 = distance.map(|asked| asked["came"].as_f64().unwrap()).fold(0.0, f64::max);
        if worst > 1.0 {
            assert_eq!(method["verdict"], "limit", "{method}");
            let limit = asked.iter().find(|asked| asked["reasons"].is_array()).unwrap();
            assert!(
                limit["reasons"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .all(|reason| reasons.contains(&reason.as_str().unwrap()))
            );
            far += 1;
        } else {
            assert_eq!(method["verdict"], "holds", "{method}");
        }
        assert!(came <= worst + 1e-9, "{method}");
        assert!(
            asked.iter().all(|asked| asked["most"].as_f64().is_none_or(|most| most < 255.0)),
            "{method}"
        );
        assert!(method["worst"]["bound"].as_f64().is_none_or(|bound| bound < 255.0), "{method}");
    }
    assert!(far > 30, "{far} rows in which gouraud is off");
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let place = Place::new();
    let [once, again] = [(); 2].map(|()| place.succeeds(&[&SMALL[..], &["--json"]].concat()));
    assert_eq!(once, again);
}

#[test]
fn the_search_for_broken_bounds_writes_scenes_that_run_takes() {
    let place = Place::new();
    let climb = ["stress", "--climb", "--method", "gouraud", "--scenes", "120", "-o", "climb"];
    let table = place.succeeds(&climb);
    assert!(
        table.contains("No bound is broken.") && table.contains("seed 1; 120 scenes"),
        "{table}"
    );
    let [report, again] = [(); 2].map(|()| place.succeeds(&[&climb[..], &["--json"]].concat()));
    assert_eq!(report, again);
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let largest = &report["methods"][0]["largest"];
    assert_eq!((&report["holds"], &report["methods"][0]["scenes"]), (&true.into(), &120.into()));
    let run = place.succeeds(&["run", "climb/highest_gouraud.toml", "--trace", "none", "--json"]);
    let run: serde_json::Value = serde_json::from_str(&run).unwrap();
    assert_eq!(run["error"]["quantisation"]["max_lsb"], largest["quantisation_lsb"], "{run}");
    assert_eq!(run["bound_lsb"], largest["bound_lsb"], "{run}");
}

#[test]
fn what_belongs_to_the_search_is_refused_without_it() {
    let place = Place::new();
    for wrong in
        [&["--scenes", "100"][..], &["--climb", "--spans", "3"], &["--climb", "--scenes", "0"]]
    {
        assert_eq!(place.specula(&[&["stress"][..], wrong].concat()).status, Some(2), "{wrong:?}");
    }
}
