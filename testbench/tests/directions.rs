//! Directions that leave a core of consistent normals: bit for bit the model's, pixel by pixel, and
//! the colours beside them those of the core without.
use specula_fixtures::{Draw, drawn};
use specula_golden::exact::ConsistentSpan;
use specula_golden::exact::formula::consistent::{normal, reflection};
use specula_golden::fixed::Model;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Needs, load};
use specula_spec::consistent::Directions;
use specula_spec::{CoreSpec, LightPipelines, Method, MethodSpec, SetUp};
use specula_testbench::{Bench, BenchError, EngineKind};

const ALL: [Directions; 4] =
    [Directions::None, Directions::Reflection, Directions::Normal, Directions::Both];

/// The same core with other directions.
fn giving(spec: &CoreSpec, directions: Directions) -> CoreSpec {
    let mut spec = spec.clone();
    if let MethodSpec::Consistent(consistent) = &mut spec.method {
        consistent.directions = directions;
    }
    spec
}

/// Specs and frames are drawn, with lights and eyes at places, time slots, and all that `any_spec`
/// draws.
#[test]
fn hardware_gives_the_models_directions() {
    let mut compared = 0;
    for seed in 0..30 {
        let mut draw = Draw::new(seed);
        let longest = draw.one_of(&[1, 3, 20]);
        let frame = drawn::frame(&mut draw, longest);
        let light_pipelines = draw.one_of(&LightPipelines::ALL);
        let mut spec = drawn::spec(&mut draw, &frame, Method::Consistent);
        spec.parameters.light_pipelines = light_pipelines;
        let codes: Vec<Option<Vec<[u8; 3]>>> =
            ALL.map(|directions| agreed(&frame, &giving(&spec, directions), seed)).into();
        for given in codes.iter().flatten() {
            assert_eq!(Some(given), codes[0].as_ref(), "seed {seed}: colours change");
            compared += 1;
        }
    }
    assert!(compared > 75, "{compared} cores could be built");
}

/// The codes of a core that agrees with its model; none where its formats are too fine.
fn agreed(frame: &Frame, spec: &CoreSpec, seed: u64) -> Option<Vec<[u8; 3]>> {
    let bench = match Bench::new(frame, spec, "core") {
        Ok(bench) => bench,
        Err(BenchError::TooWide(_)) => return None,
        Err(error) => panic!("seed {seed}: {error}"),
    };
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None, "seed {seed}: {spec:?}");
    assert_eq!(bench.design.outputs.len(), 3 + 3 * spec.direction_outputs().len());
    assert_eq!(bench.design.output_errors.len(), 3);
    Some(outcome.codes)
}

/// On a picture, where no face is seen from behind, they are those of the formulas to within a few
/// units of the last place, and r leaves the face.
#[test]
fn directions_are_those_of_the_formulas() {
    let frame = load("icosahedron", Some((48, 36))).unwrap().frame;
    let spec = CoreSpec::for_scene(&Needs::of(&frame), None, Some(Method::Consistent)).unwrap();
    let spec = giving(&spec, Directions::Both);
    let MethodSpec::Consistent(consistent) = &spec.method else { unreachable!("it is asked for") };
    let most = 8.0 * consistent.formats.vector.ulp();
    let (model, set_up) = (Model::new(&spec), SetUp::new(&spec, &frame));
    let mut pixels = 0;
    for span in &frame.spans {
        let (packet, exact) = (set_up.packet(span), ConsistentSpan::new(consistent, &frame, span));
        for i in 0..span.length {
            let trace = model.trace(&packet, i).unwrap();
            let vector = |name: &str| {
                ["x", "y", "z"].map(|axis| {
                    let named = format!("{name}_{axis}");
                    trace.iter().find(|value| value.name == named).unwrap().value()
                })
            };
            let (n, q) = exact.normal_and_q(i).unwrap();
            let r = reflection(n, EYE, q);
            let n_c = normal(EYE, r).unwrap();
            let off = |name: &str, exact: glam::DVec3| {
                (glam::DVec3::from_array(vector(name)) - exact).abs().max_element()
            };
            assert!(off("reflection", r) < most, "r is {} off", off("reflection", r));
            assert!(off("consistent_normal", n_c) < most, "{}", off("consistent_normal", n_c));
            pixels += 1;
        }
    }
    assert!(pixels > 500);
}
