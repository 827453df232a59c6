//! Cores as files, and cores for scenes that they were not made for.
use specula_scene::{Frame, Needs, SceneError, load, parse};
use specula_spec::phong::Places;
use specula_spec::{CoreSpec, Method, MethodSpec, SceneCore, SpecError, SpecFile, TargetClock};

const SIZE: Option<(u32, u32)> = Some((48, 36));

fn frame(scene: &str) -> Frame {
    load(scene, SIZE).unwrap().frame
}

fn core(scene: &str, method: Option<Method>) -> CoreSpec {
    load(scene, SIZE).unwrap().core_spec(method).unwrap()
}

/// The message, and the text it points at.
fn refusal(text: &str) -> (String, String) {
    match SpecFile::parse("spec.toml", text.to_owned()) {
        Err(SceneError::File { problem, at, .. }) => {
            (problem, text[at.offset()..at.offset() + at.len()].to_owned())
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_core_is_read_as_it_is_written() {
    for name in specula_fixtures::still_scenes() {
        let loaded = load(name, SIZE).unwrap();
        for spec in Method::ALL.into_iter().filter_map(|method| loaded.core_spec(Some(method)).ok())
        {
            for spec in [spec.general(), spec] {
                let file = SpecFile { name: name.to_owned(), spec };
                let text = file.text();
                let read = SpecFile::parse("spec.toml", text.clone()).unwrap();
                assert_eq!(read, file, "{text}");
                assert_eq!(read.text(), text);
            }
        }
    }
}

/// Files from before increments could be added are those of cores that multiply them.
#[test]
fn cores_that_say_nothing_of_increments_multiply_them() {
    for (method, format) in [
        (Method::Lyon, "normal_accumulator"),
        (Method::Phong, "vector_accumulator"),
        (Method::Direct, "scalar_accumulator"),
    ] {
        let file = SpecFile { name: "teapot".to_owned(), spec: core("teapot", Some(method)) };
        let text = file.text();
        let new = |line: &&str| line.starts_with("increments") || line.starts_with(format);
        let old: Vec<&str> = text.lines().filter(|line| !new(line)).collect();
        assert_eq!(old.len() + 2, text.lines().count(), "{text}");
        let read = SpecFile::parse("spec.toml", old.join("\n")).unwrap();
        assert_eq!(read.spec.inputs(), file.spec.inputs());
        assert_eq!(read.spec.narrowing_points(), file.spec.narrowing_points());
    }
}

/// Files of cores that were made before a host had a choice mean what there was.
#[test]
fn options_of_the_host_may_be_absent() {
    for (method, keys) in
        [(Method::Gouraud, &["highlight", "squarings"][..]), (Method::Slerp, &["edges"])]
    {
        let file = SpecFile { name: "teapot".to_owned(), spec: core("teapot", Some(method)) };
        let text = file.text();
        let is_kept = |line: &&str| !keys.iter().any(|key| line.starts_with(key));
        let before: String = text.lines().filter(is_kept).flat_map(|line| [line, "\n"]).collect();
        assert_eq!(text.lines().count() - before.lines().count(), keys.len(), "{text}");
        assert_eq!(SpecFile::parse("spec.toml", before).unwrap(), file);
    }
}

#[test]
fn what_is_no_core_is_refused_where_it_is_wrong() {
    let text =
        SpecFile { name: "teapot".to_owned(), spec: core("teapot", Some(Method::Lyon)) }.text();
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{text}");
        refusal(&text.replacen(from, to, 1))
    };
    assert_eq!(
        changed("version = 1", "version = 2"),
        ("this is version 2, and version 1 is read here".into(), "2".into())
    );
    assert_eq!(changed("\"teapot\"", "\"../pot\"").1, "\"../pot\"");
    assert!(changed("lights = 1", "lights = 9").0.contains("`lights` is 9"));
    assert!(changed("vector = \"S1.", "vector = \"S2.").0.contains("format `vector`"));
    assert!(
        changed("shortest_normal = 0.", "shortest_normal = 1.").0.contains("`shortest_normal`")
    );
    assert!(
        changed("light0_direction_x = [", "light0_direction_x = [1, ")
            .0
            .contains("expected two raw values")
    );
    assert!(changed("light0_direction_x", "light5_direction_x").0.contains("`light5_direction_x`"));
    assert!(
        changed("[spec.method.lyon]", "[spec.method.lyon]\ncolour = 1")
            .0
            .contains("unknown key `colour`")
    );
    assert!(matches!(SpecFile::read("nowhere.toml".as_ref()), Err(SceneError::Unreadable { .. })));
}

#[test]
fn a_target_and_its_clock_are_read_or_refused_where_they_are_wrong() {
    let target = Some(TargetClock { name: "ecp5".to_owned(), clock_mhz: 187.5 });
    let spec = CoreSpec { target, ..core("teapot", Some(Method::Lyon)) };
    let file = SpecFile { name: "teapot".to_owned(), spec };
    let text = file.text();
    assert_eq!(SpecFile::parse("spec.toml", text.clone()).unwrap(), file);
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{text}");
        refusal(&text.replacen(from, to, 1))
    };
    let (problem, place) = changed("\"ecp5\"", "\"ecp6\"");
    assert_eq!(place, "\"ecp6\"");
    assert!(problem.contains("there is no target `ecp6` with a clock"), "{problem}");
    assert!(problem.contains("there are") && problem.contains("ecp5"), "{problem}");
    // A target whose delays are not known cannot be asked for a clock.
    assert_eq!(changed("\"ecp5\"", "\"generic\"").1, "\"generic\"");
    assert!(changed("187.5", "0.5").0.contains("`clock_mhz` is 0.5"));
    assert!(changed("clock_mhz", "mhz").0.contains("mhz"));
}

#[test]
fn a_core_serves_its_own_scene_as_it_is() {
    for scene in specula_fixtures::still_scenes() {
        let frame = frame(scene);
        for spec in Method::ALL
            .into_iter()
            .filter_map(|method| load(scene, SIZE).unwrap().core_spec(Some(method)).ok())
        {
            let fitted = spec.fit_to(&frame).unwrap();
            assert_eq!((fitted.spec, fitted.frame), (spec, frame.clone()), "{scene}");
        }
    }
}

#[test]
fn a_general_core_takes_less_than_it_has() {
    let mut spec = core("spheres", None).general();
    spec.parameters.longest_span = 4;
    let teapot = frame("teapot");
    let fitted = spec.fit_to(&teapot).unwrap();
    assert_eq!(fitted.frame.lights.len(), spec.parameters.lights);
    assert_eq!(
        fitted.frame.lights[teapot.lights.len()..]
            .iter()
            .map(|light| light.colour)
            .collect::<Vec<_>>(),
        [[0.0; 3]]
    );
    let formats = |spec: &CoreSpec| (spec.method.clone(), spec.inputs());
    assert_eq!(formats(&fitted.spec), formats(&spec));
    // Bounds rest on the shorter normals of both.
    assert!(fitted.spec.parameters.shortest_normal <= spec.parameters.shortest_normal);
}

#[test]
fn what_a_core_lacks_is_named() {
    let lacking = |spec: &CoreSpec, frame: &Frame| match spec.fit_to(frame) {
        Err(error @ (SpecError::Lacks { .. } | SpecError::UnevenShininess { .. })) => {
            error.to_string()
        }
        other => panic!("{other:?}"),
    };
    let teapot = core("teapot", None);
    let said = [
        lacking(&teapot.general(), &frame("spheres")),
        lacking(&core("torus", None), &frame("teapot")),
        lacking(&teapot, &load("teapot", Some((96, 72))).unwrap().frame),
        lacking(&core("lamps", None), &frame("teapot")),
        lacking(&core("teapot", Some(Method::Phong)), &frame("lamps")),
    ];
    insta::assert_snapshot!(said.join("\n"));
    let uneven = "[[object]]\nprimitive = \"torus\"\n[object.material]\nshininess = 3\n".to_owned();
    let uneven = parse("uneven.toml", uneven).unwrap().frame;
    let mut hybrid = core("spheres", Some(Method::Hybrid)).general();
    hybrid.parameters.longest_span = 1024;
    assert!(lacking(&hybrid, &uneven).contains("shininess 3"));
}

/// The backquoted words of a cell of a table.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// docs/spec-file.md has every key that a file can have: those of the core by their full names, and
/// a row for each method with its options and its narrowing points, which has no others.
#[test]
fn the_page_has_every_key() {
    let page = include_str!("../../docs/spec-file.md");
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter(|line| line.starts_with('|'))
        .map(|line| line.trim_matches('|').split(" | ").collect())
        .collect();
    let of_core: Vec<&str> =
        rows.iter().filter(|row| row.len() == 2).flat_map(|row| quoted(row[0])).collect();
    for method in Method::ALL {
        let file = SpecFile { name: "teapot".to_owned(), spec: core("teapot", Some(method)) };
        let text: toml::Table = file.text().parse().unwrap();
        let absent: Vec<&String> =
            text.keys().filter(|key| *key != "spec" && !of_core.contains(&key.as_str())).collect();
        assert!(absent.is_empty(), "{absent:?}");
        let spec = text["spec"].as_table().unwrap();
        let is_named = |key: &str| of_core.contains(&format!("spec.{key}").as_str());
        let absent: Vec<&String> =
            spec.keys().filter(|key| *key != "method" && !is_named(key)).collect();
        assert!(absent.is_empty(), "spec: {absent:?}");
        let of_method = spec["method"][method.name()].as_table().unwrap();
        // Keys of what leaves beside the colour stand in files of cores that have it.
        let beside = method.output_domains().iter().map(|domain| domain.key);
        let written = of_method.keys().map(String::as_str).filter(|key| *key != "formats");
        let options: Vec<&str> = written.chain(beside).collect();
        let formats: Vec<&str> =
            of_method["formats"].as_table().unwrap().keys().map(String::as_str).collect();
        let row =
            rows.iter().find(|row| row.len() == 3 && quoted(row[0]) == [method.name()]).unwrap();
        let sorted = |mut keys: Vec<&str>| {
            keys.sort_unstable();
            keys.into_iter().map(str::to_owned).collect::<Vec<String>>()
        };
        assert_eq!(sorted(quoted(row[1])), sorted(options), "{}", method.name());
        assert_eq!(sorted(quoted(row[2])), sorted(formats), "{}", method.name());
    }
}

/// A lamp that comes near to a polygon: a core that is there with wrapped directions refuses it, and
/// one that is asked for has true ones.
#[test]
fn wraps_are_for_scenes_that_they_serve() {
    let far = load("lamps", Some((80, 60))).unwrap().frame;
    let table = "[phong]\nplaces = \"wrapped\"".parse().unwrap();
    let asked = |frame: &Frame| {
        CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(Method::Phong)).unwrap()
    };
    let places = |spec: &CoreSpec| match &spec.method {
        MethodSpec::Phong(phong) => phong.places,
        _ => panic!("it is phong"),
    };
    let spec = asked(&far);
    assert_eq!(places(&spec), Places::Wrapped);
    assert!(spec.fit_to(&far).is_ok());

    let longest = far.spans.iter().max_by_key(|span| span.length).unwrap();
    let middle = [0, 1, 2].map(|v| f64::midpoint(longest.start[v], longest.end[v]));
    let mut near = far.clone();
    near.local_lights[0].position =
        far.position_at(longest, middle) + 0.02 * far.normal_at(longest, middle);
    let refused = spec.fit_to(&near).unwrap_err().to_string();
    assert!(refused.contains("its directions to places are wrapped"), "{refused}");
    assert_eq!(places(&asked(&near)), Places::Exact);
}
