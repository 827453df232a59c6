//! Look-up tables and flip-flops as they are estimated, against those that Yosys makes.
use specula_datapath::resources::Resources;
use specula_fixtures::specs::spec;
use specula_fixtures::{each_method, few_spans, tools};
use specula_flow::synth::{SynthTarget, synthesised};
use specula_spec::{CoreSpec, Method, TargetClock};

/// Targets, with a clock that all methods reach but for their loops.
const TARGETS: [(SynthTarget, f64); 3] =
    [(SynthTarget::ECP5, 150.0), (SynthTarget::ICE40_HX, 60.0), (SynthTarget::ICE40_UP, 30.0)];

/// By how much an estimate may differ from what Yosys 0.23 makes, as a share of it: of look-up tables
/// the largest difference that was measured is LUTS_MEASURED, of flip-flops FFS_MEASURED.
const TOLERANCE: f64 = 0.1;

fn cells_are_estimated(method: Method) {
    if !tools::is_installed("yosys") {
        return;
    }
    let frame = few_spans::frame(1993, 1, 3);
    let core = spec(&frame, method).specialised(&frame);
    for (synth, clock_mhz) in TARGETS {
        let made_for = TargetClock { name: synth.name.to_owned(), clock_mhz };
        let target = made_for.target().unwrap();
        let spec = CoreSpec { target: Some(made_for), ..core.clone() };
        let design = specula_hdl::elaborate(&spec, "core").unwrap();
        let estimated = Resources::of(&design, &target);
        let made = synthesised(&design, &synth).unwrap();
        println!("{method:?} {} {estimated:?} {made:?}", synth.name);
        assert_eq!(estimated.blocks, made.blocks, "{method:?} on {}", synth.name);
        assert_eq!(estimated.memories, made.memories, "{method:?} on {}", synth.name);
        for (estimated, made) in
            [(estimated.luts, made.luts), (estimated.flip_flops, made.flip_flops)]
        {
            let share = (estimated as f64 / made as f64 - 1.0).abs();
            assert!(share < TOLERANCE, "{method:?} on {}: {estimated}, {made}", synth.name);
        }
    }
}

each_method!(cells_are_estimated);
