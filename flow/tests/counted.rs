//! What is counted is what Yosys makes: multiplier blocks exactly, flip-flops but for those that it
//! finds to be constant or alike.
use specula_datapath::verilog::Counted;
use specula_fixtures::specs::spec;
use specula_fixtures::{each_method, few_spans, tools};
use specula_flow::synth::{SynthTarget, synthesised};
use specula_spec::{CoreSpec, Method, TargetClock};

/// Targets whose blocks are instances, with a clock that all methods reach but for their loops.
const TARGETS: [(SynthTarget, f64); 2] =
    [(SynthTarget::ECP5, 150.0), (SynthTarget::ICE40_UP, 30.0)];

fn cells_are_those_that_yosys_makes(method: Method) {
    if !tools::is_installed("yosys") {
        return;
    }
    let frame = few_spans::frame(1993, 1, 3);
    let core = spec(&frame, method).specialised(&frame);
    for (target, clock_mhz) in TARGETS {
        let made_for = Some(TargetClock { name: target.name.to_owned(), clock_mhz });
        let design =
            specula_hdl::elaborate(&CoreSpec { target: made_for, ..core.clone() }, "core").unwrap();
        let counted = Counted::of(&design.to_block());
        let made = synthesised(&design, &target).unwrap();
        println!("{method:?} {} {counted:?} {made:?}", target.name);
        assert_eq!(made.blocks, counted.blocks, "{method:?} on {}", target.name);
        let alike = counted.flip_flops - made.flip_flops.min(counted.flip_flops);
        assert!(made.flip_flops <= counted.flip_flops, "{method:?} on {}", target.name);
        assert!(alike * 5 <= counted.flip_flops, "{method:?} on {}: {alike}", target.name);
    }
}

each_method!(cells_are_those_that_yosys_makes);
