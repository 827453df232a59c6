//! All methods with every option through rust-hdl's checks, and what elaboration promises for all of
//! them.
use specula_datapath::Design;
use specula_datapath::block::check_all;
use specula_datapath::design::{NodeId, Op};
use specula_fixtures::specs::small_needs;
use specula_scene::Needs;
use specula_scene::limits::{LONGEST_SPAN, MOST_LIGHTS};
use specula_spec::consistent::{Curve, Diffuse};
use specula_spec::duff::Highlight;
use specula_spec::lyon::{Difference, Normalisation};
use specula_spec::{CoreSpec, LyonSpec, Method, MethodSpec, reflection};

fn needs(lights: usize, longest_span: u32, largest_shininess: u32) -> Needs {
    Needs { lights, longest_span, largest_shininess, ..small_needs() }
}

fn spec(method: Method, lights: usize, longest_span: u32, largest_shininess: u32) -> CoreSpec {
    CoreSpec::for_scene(&needs(lights, longest_span, largest_shininess), None, Some(method))
        .unwrap()
}

/// Every number of lights, short and long spans, small and large exponents.
fn sizes(method: Method) -> impl Iterator<Item = CoreSpec> {
    let lights = 1..=MOST_LIGHTS;
    lights.flat_map(move |lights| {
        [(1, 1), (2, 2), (256, 256), (LONGEST_SPAN, 4096)]
            .map(|(span, shininess)| spec(method, lights, span, shininess))
    })
}

/// Every combination of `lyon`'s options.
fn options() -> impl Iterator<Item = CoreSpec> {
    let first = [Normalisation::G1, Normalisation::G2].into_iter();
    let choices = first.flat_map(|normalisation| {
        [Difference::HalfwayCrossNormal, Difference::ReflectionMinusLight]
            .map(|difference| (normalisation, difference))
    });
    let choices = choices
        .flat_map(|(n, d)| (0..=3).flat_map(move |steps| (0..=3).map(move |k| (n, d, steps, k))));
    choices.map(|(normalisation, difference, newton_steps, squarings)| {
        let mut core = spec(Method::Lyon, 2, 100, 8191);
        if let MethodSpec::Lyon(lyon) = &mut core.method {
            *lyon = LyonSpec { normalisation, difference, newton_steps, squarings, ..lyon.clone() };
        }
        core.check().unwrap();
        core
    })
}

/// Every option of `duff`.
fn duff_options() -> impl Iterator<Item = CoreSpec> {
    [Highlight::Blinn, Highlight::Quotient, Highlight::Eq33, Highlight::Eq34].into_iter().map(
        |specular| {
            let mut core = spec(Method::Duff, 2, 100, 4096);
            if let MethodSpec::Duff(duff) = &mut core.method {
                duff.specular = specular;
            }
            core.check().unwrap();
            core
        },
    )
}

/// Every option of `reflection`.
fn reflection_options() -> impl Iterator<Item = CoreSpec> {
    [reflection::Highlight::Blinn, reflection::Highlight::Hybrid, reflection::Highlight::Eq34]
        .into_iter()
        .map(|specular| {
            let mut core = spec(Method::Reflection, 2, 100, 4096);
            if let MethodSpec::Reflection(reflection) = &mut core.method {
                reflection.specular = specular;
            }
            core.check().unwrap();
            core
        })
}

/// Every combination of `consistent`'s options.
fn curves() -> impl Iterator<Item = CoreSpec> {
    let choices = [Curve::Rational, Curve::Trigonometric].into_iter();
    let choices = choices
        .flat_map(|curve| [Diffuse::Lambert, Diffuse::Consistent].map(|diffuse| (curve, diffuse)));
    choices.map(|(curve, diffuse)| {
        let mut core = spec(Method::Consistent, 2, 100, 256);
        if let MethodSpec::Consistent(consistent) = &mut core.method {
            (consistent.curve, consistent.diffuse) = (curve, diffuse);
        }
        core
    })
}

fn every_spec() -> impl Iterator<Item = CoreSpec> {
    Method::ALL
        .into_iter()
        .flat_map(sizes)
        .chain(options())
        .chain(duff_options())
        .chain(reflection_options())
        .chain(curves())
}

fn elaborated(spec: &CoreSpec) -> Design {
    specula_hdl::elaborate(spec, "core").unwrap_or_else(|error| panic!("{error}: {spec:?}"))
}

#[test]
fn cores_pass_rust_hdls_checks() {
    for spec in every_spec() {
        check_all(&elaborated(&spec).to_block())
            .unwrap_or_else(|error| panic!("{error:?}: {spec:?}"));
    }
}

/// The same spec gives the same design, and so the same Verilog.
#[test]
fn elaboration_is_reproducible() {
    for spec in every_spec() {
        assert_eq!(elaborated(&spec), elaborated(&spec), "{spec:?}");
    }
}

/// Operands come first, belong to the same pixel as their result, and every bound is a number.
#[test]
fn signals_belong_together() {
    for spec in every_spec() {
        let design = elaborated(&spec);
        for (id, node) in design.iter() {
            match node.clock_enable(id) {
                Some((enable, next)) => check_kept(&design, id, enable, next),
                None => node.op.operands().for_each(|operand| check_operand(&design, id, operand)),
            }
        }
        assert!(
            design.output_errors.iter().all(|error| error.is_finite()),
            "{:?}: {spec:?}",
            design.output_errors
        );
        assert!(design.error_bound() >= 0.5, "rounding to 8 bits alone is half an LSB");
        let last = design.outputs.iter().map(|&output| design.node(output).stage);
        assert!(
            last.clone().all(|stage| stage == design.latency()),
            "{:?}",
            last.collect::<Vec<_>>()
        );
    }
}

/// A register that keeps its value until a valid pixel comes sees the pixel's validity together with
/// what it takes over: in its own clock where that is of the pixel before, else a clock earlier.
fn check_kept(design: &Design, id: NodeId, enable: NodeId, next: NodeId) {
    let stage = |id| design.node(id).stage;
    let name = || design.full_name(id);
    assert!(design.node(id).registered(), "{}: an enable without a register", name());
    if !design.node(next).still {
        assert_eq!(stage(enable), stage(next), "{} takes another pixel's value over", name());
    }
    assert!(stage(id) - stage(enable) <= 1, "{} waits for another pixel", name());
}

fn check_operand(design: &Design, id: NodeId, operand: NodeId) {
    let (node, source) = (design.node(id), design.node(operand));
    if source.op.constant().is_some() || source.still && !node.still {
        return;
    }
    let name = || format!("{} reads {}", design.full_name(id), design.full_name(operand));
    // A register that feeds back holds the value of the pixel before.
    let feeds_back = operand > id;
    let clocks = u32::from(node.registered() && !feeds_back);
    assert!(node.registered() || !feeds_back, "{}: a loop without a register", name());
    if node.still {
        let settled = node.stage >= source.stage + clocks;
        return assert!(settled, "{}, which has not settled", name());
    }
    assert_eq!(node.stage, source.stage + clocks, "{}", name());
}

/// What holds for a frame is there at any time: it is computed on, and never only delayed.
#[test]
fn nothing_still_is_delayed() {
    let mut inputs = 0;
    for spec in every_spec() {
        let design = elaborated(&spec);
        for (id, node) in design.iter().filter(|(_, node)| node.still && node.registered()) {
            assert!(!matches!(node.op, Op::Copy(_)), "{} in {spec:?}", design.full_name(id));
        }
        inputs += design.frame_inputs().len();
        assert_eq!(design.settling(), 0, "a frame's inputs are read late enough: {spec:?}");
    }
    assert!(inputs > 1000, "{inputs}");
}

/// What a spec makes use of less than another is not there.
#[test]
fn less_is_left_out() {
    let multipliers = |spec: &CoreSpec| elaborated(spec).size().multipliers;
    for method in Method::ALL {
        let [one, two, four] = [1, 2, 4].map(|lights| multipliers(&spec(method, lights, 64, 64)));
        assert_eq!(two - one, (four - two) / 2, "each light costs the same");
        assert!(one < two);
    }
    let [small, large] = [1, 4096].map(|n| multipliers(&spec(Method::Hybrid, 1, 64, n)));
    assert_eq!(large - small, 12, "a multiplier for each squaring");
}

/// What is finer for the brightest highlights still fits 63 bits, with the longest spans and the
/// largest exponents.
#[test]
fn cores_for_bright_highlights_can_be_built() {
    for method in Method::ALL {
        for (span, shininess) in [(1, 1), (LONGEST_SPAN, 8191)] {
            let of = |brightest_coefficient| {
                let needs = Needs {
                    brightest_coefficient,
                    shortest_normal: 0.05,
                    widest_angle: 170.0,
                    ..needs(4, span, shininess)
                };
                let spec = CoreSpec::for_scene(&needs, None, Some(method)).unwrap();
                specula_hdl::elaborate(&spec, "core").unwrap().error_bound()
            };
            let (full, bright) = (of(1.0), of(4.0));
            assert!(full > 0.5 && bright > 0.5, "{}: {full} and {bright}", method.name());
        }
    }
}
