//! Cores in every engine.
use specula_fixtures::specs::{packets, spec, spec_with};
use specula_fixtures::{each_method, few_spans};
use specula_scene::Frame;
use specula_sim::{Effort, Engine, Icarus, RustHdl, Stimulus, Verilator};
use specula_spec::phong::Places;
use specula_spec::{Components, CoreSpec, Increments, LightPipelines, Method, MethodSpec};

use crate::agreement;
use crate::installed::{if_installed, verilator};
use crate::{elaborated, outputs};

fn outputs_agree(method: Method) {
    options_agree(method, "");
}

each_method!(outputs_agree);

/// With these lines in the method's table.
fn options_agree(method: Method, options: &str) {
    let frame = few_spans::frame(1993, 2, 12);
    outputs_of_agree(&spec_with(&frame, method, options), &frame);
}

fn outputs_of_agree(spec: &CoreSpec, frame: &Frame) {
    let design = elaborated(spec);
    let packets = packets(spec, frame);
    let stimulus = Stimulus::whole(&packets, &design);
    let (reference, others) = agreement::run_all(&design, &stimulus, &outputs(&design));
    assert_eq!(reference.values[0].iter().sum::<i64>() as u64, frame.shaded_pixels());
    let colours = |clock: &usize| (1..4).map(|c| reference.values[c][*clock]).sum::<i64>();
    assert!((0..reference.clocks()).any(|clock| colours(&clock) > 200), "nothing is lit");
    for (engine, columns) in others {
        // Verilator's registers begin as rust-hdl's do; Icarus's are X until the first pixel has
        // passed.
        let first = if engine == "icarus" { u64::from(design.latency()) } else { 0 };
        agreement::assert_same(&design, &reference, &columns, first, engine);
    }
}

#[test]
fn phongs_distributions_agree() {
    for highlight in ["blinn", "torrance-sparrow", "trowbridge-reitz"] {
        options_agree(Method::Phong, &format!("highlight = \"{highlight}\""));
    }
}

/// The unit is the same in all methods that have the choice.
#[test]
fn powers_by_tables_agree() {
    for method in [Method::Hybrid, Method::Consistent] {
        options_agree(method, "power = \"tables\"");
    }
}

#[test]
fn directs_outputs_agree_with_newtons_root() {
    options_agree(Method::Direct, "root = \"newton\"");
}

#[test]
fn directs_outputs_agree_with_numerators_that_are_added_up() {
    for root in ["exact", "newton"] {
        options_agree(Method::Direct, &format!("root = \"{root}\"\nincrements = \"added\""));
    }
}

#[test]
fn lyons_outputs_agree_with_normals_that_follow_and_go_along_by_additions() {
    let options = "normals = \"wrapped\"\naxis = \"previous\"\nincrements = \"added\"";
    options_agree(Method::Lyon, options);
}

#[test]
fn slerps_outputs_agree_with_the_normal_itself() {
    for frame in ["orthonormal", "ends"] {
        options_agree(Method::Slerp, &format!("form = \"vector\"\nframe = \"{frame}\""));
    }
}

#[test]
fn consistent_normals_outputs_agree() {
    options_agree(Method::Consistent, "diffuse = \"consistent\"\nhighlight = \"blinn\"");
}

/// A distant light, a lamp and a spot, seen from a place, in the core that `run` makes.
fn outputs_with_lights_and_an_eye_at_places_agree(method: Method) {
    let mut frame = few_spans::frame(1968, 3, 7);
    few_spans::place_lights(&mut frame);
    assert_eq!((frame.lights.len(), frame.local_lights.len(), frame.eye.is_some()), (1, 2, true));
    let spec = spec(&frame, method).specialised(&frame);
    let design = elaborated(&spec);
    let packets = packets(&spec, &frame);
    let stimulus = Stimulus::whole(&packets, &design);
    let Some(mut verilator) = verilator(&design) else { return };
    let outputs = outputs(&design);
    let reference =
        agreement::run(&mut RustHdl::new(&design).unwrap(), &stimulus, &outputs).unwrap();
    let columns = agreement::run(&mut verilator, &stimulus, &outputs).unwrap();
    agreement::assert_same(&design, &reference, &columns, 0, verilator.name());
}

each_method!(outputs_with_lights_and_an_eye_at_places_agree);

/// Lights that take turns: quadratics, rotations, and lights of all kinds with an eye at a place,
/// wrapped by additions or not.
#[test]
fn shared_pipelines_outputs_agree() {
    let mut frame = few_spans::frame(1968, 3, 7);
    for method in [Method::Hybrid, Method::Slerp] {
        outputs_of_agree(&shared(spec(&frame, method)), &frame);
    }
    few_spans::place_lights(&mut frame);
    let exact = shared(spec(&frame, Method::Phong));
    let mut wrapped = exact.clone();
    if let MethodSpec::Phong(phong) = &mut wrapped.method {
        (phong.places, phong.increments) = (Places::Wrapped, Increments::Added);
    }
    outputs_of_agree(&exact, &frame);
    outputs_of_agree(&wrapped, &frame);
}

fn shared(mut spec: CoreSpec) -> CoreSpec {
    spec.parameters.light_pipelines = LightPipelines::Shared;
    spec
}

#[test]
fn outputs_agree_where_components_take_turns() {
    let mut frame = few_spans::frame(1969, 3, 7);
    outputs_of_agree(&serial(spec(&frame, Method::Lyon)), &frame);
    few_spans::place_lights(&mut frame);
    outputs_of_agree(&serial(spec(&frame, Method::Phong)), &frame);
}

fn serial(mut spec: CoreSpec) -> CoreSpec {
    spec.parameters.components = Components::Serial;
    spec
}

#[test]
fn every_signal_agrees_in_a_trace() {
    let frame = few_spans::frame(7, 1, 5);
    let spec = spec(&frame, Method::Lyon);
    let design = elaborated(&spec);
    let packets = packets(&spec, &frame);
    let stimulus = Stimulus::whole(&packets, &design);
    let all = design.variables();
    let reference = agreement::run(&mut RustHdl::new(&design).unwrap(), &stimulus, &all).unwrap();
    if let Some(mut verilator) = verilator(&design) {
        let columns = agreement::run(&mut verilator, &stimulus, &all).unwrap();
        agreement::assert_same(&design, &reference, &columns, 0, verilator.name());
    }
    if let Some(mut icarus) = if_installed(Icarus::new(&design)) {
        let columns = agreement::run(&mut icarus, &stimulus, &all).unwrap();
        agreement::assert_same(
            &design,
            &reference,
            &columns,
            u64::from(design.latency()),
            icarus.name(),
        );
    }
}

/// With all of the program built for it alone, as `run` has it.
#[test]
fn runs_may_begin_late_and_share_a_build() {
    let frame = few_spans::frame(11, 1, 40);
    let spec = spec(&frame, Method::Lyon);
    let design = elaborated(&spec);
    let packets = packets(&spec, &frame);
    let whole = Stimulus::whole(&packets, &design);
    let window = 120..140;
    let late = whole.leading_to(&window, &design);
    assert!(late.clocks().start > 0);
    let Some(mut verilator) = if_installed(Verilator::new(&design, Effort::FastBuild)) else {
        return;
    };
    let outputs = outputs(&design);
    let all = agreement::run(&mut verilator, &whole, &outputs).unwrap();
    let built = verilator.build_seconds();
    let part = agreement::run(&mut verilator, &late, &outputs).unwrap();
    assert!(built > 0.0 && built == verilator.build_seconds());
    for (all, part) in all.values.iter().zip(&part.values) {
        let late = late.clocks().start;
        let in_part = (window.start - late) as usize..(window.end - late) as usize;
        assert_eq!(all[120..140], part[in_part]);
    }
}

/// Inputs that are constants, or the same as others, or never 0, in every engine and in every
/// clock.
fn specialised_outputs_agree(frame: &Frame, method: Method) {
    let spec = spec(frame, method).specialised(frame);
    let design = elaborated(&spec);
    let packets = packets(&spec, frame);
    let stimulus = Stimulus::whole(&packets, &design);
    let (reference, others) = agreement::run_all(&design, &stimulus, &outputs(&design));
    for (engine, columns) in others {
        let first = if engine == "icarus" { u64::from(design.latency()) } else { 0 };
        agreement::assert_same(&design, &reference, &columns, first, engine);
    }
}

#[test]
fn cores_for_one_frame_agree() {
    for method in [Method::Lyon, Method::Slerp] {
        specialised_outputs_agree(&few_spans::frame(1993, 2, 12), method);
    }
}

#[test]
fn cores_whose_pixels_are_all_the_same_agree() {
    let mut frame = few_spans::frame(1993, 1, 1);
    let triangle = &mut frame.triangles[0];
    triangle.normals = [triangle.normals[0]; 3];
    triangle.facet.normal = triangle.normals[0];
    specialised_outputs_agree(&frame, Method::Lyon);
}
