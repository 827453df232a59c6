//! Lights that become weaker with distance, in specs and packets.
use specula_scene::{LoadedScene, Needs};
use specula_spec::{CoreOptions, CoreSpec, Method, SpecFile};

/// The built-in scene `lamps`, whose spot becomes weaker or does not.
fn lamps(weaker: bool) -> LoadedScene {
    let text = specula_scene::builtin_text("lamps").unwrap().replace("[640, 480]", "[64, 48]");
    let weak = "exponent = 60\nattenuation = { constant = 0.5, quadratic = 0.1 }";
    let text = if weaker { text.replace("exponent = 60", weak) } else { text };
    specula_scene::parse("lamps.toml", text).unwrap()
}

fn spec(scene: &LoadedScene, method: Method, options: &str) -> CoreSpec {
    let options: CoreOptions = options.parse().unwrap();
    CoreSpec::for_scene(&Needs::of(&scene.frame), Some(&options), Some(method)).unwrap()
}

#[test]
fn files_say_which_lights_become_weaker() {
    for method in Method::ALL {
        let spec = spec(&lamps(true), method, "");
        let file = SpecFile { name: "lamps".to_owned(), spec };
        let text = file.text();
        assert_eq!(text.contains("[spec.attenuation]\nlights = [1]"), method != Method::Gouraud);
        assert_eq!(SpecFile::parse("spec.toml", text).unwrap(), file);
        let without = self::spec(&lamps(false), method, "");
        let file = SpecFile { name: "lamps".to_owned(), spec: without };
        assert!(!file.text().contains("attenuat"), "{}", method.name());
    }
}

#[test]
fn formats_are_named_beside_those_of_the_method() {
    let options = "[duff.formats]\nattenuated = \"U1.9\"\ndiffuse = \"U1.11\"";
    let spec = spec(&lamps(true), Method::Duff, options);
    let bits = |name: &str| {
        let points = spec.narrowing_points();
        points.iter().find(|point| point.name == name).map(|point| point.format.fraction_bits)
    };
    assert_eq!([bits("attenuated"), bits("diffuse")], [Some(9), Some(11)]);
    let finer = spec.finer(1, &["diffuse"]).unwrap();
    let attenuation = finer.parameters.attenuation.unwrap();
    assert_eq!(attenuation.formats.attenuated.fraction_bits, 10);
}

/// A light that does not become weaker is whole in a core where it could; a core without cannot have
/// one that does, unless vertices know.
#[test]
fn cores_shade_what_they_know() {
    let [weaker, whole] = [true, false].map(lamps);
    for method in Method::ALL {
        let [knowing, plain] = [&weaker, &whole].map(|scene| spec(scene, method, ""));
        assert!(knowing.fit_to(&whole.frame).is_ok());
        let refused = plain.fit_to(&weaker.frame).err().map(|error| error.to_string());
        let says = refused.is_some_and(|error| error.contains("become weaker with distance"));
        assert_eq!(says, method != Method::Gouraud);
        let packet = knowing.packet(&whole.frame, &whole.frame.spans[0]);
        for (port, raw) in knowing.inputs().iter().zip(packet.inputs) {
            let whole = i64::from(port.name.ends_with("start"));
            if port.name.contains("_attenuation_") {
                assert_eq!(raw, whole << port.format.fraction_bits, "{}", port.name);
            }
        }
    }
}

/// The quadratic goes through what is left at both ends and half-way.
#[test]
fn packets_hold_a_quadratic_through_three_values() {
    let scene = lamps(true);
    let core = spec(&scene, Method::Phong, "");
    let mut compared = 0;
    for span in scene.frame.spans.iter().filter(|span| span.length % 2 == 1) {
        let packet = core.packet(&scene.frame, span);
        let value = |part: &str| {
            let name = format!("light2_attenuation_{part}");
            let input = core.inputs().iter().position(|port| port.name == name).unwrap();
            core.inputs()[input].format.value(packet.inputs[input])
        };
        let [start, first, second] = ["start", "first_difference", "second_difference"].map(value);
        let along = scene.frame.attenuation_along(span, 2).unwrap();
        for (i, expected) in [0, span.steps() / 2, span.steps()].into_iter().zip(along) {
            let i = f64::from(i);
            let found = start + i * first + i * (i - 1.0) / 2.0 * second;
            assert!((found - expected).abs() < 1e-3, "{found} {expected}");
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared}");
}
