//! What is counted is what Yosys makes: multiplier blocks exactly, flip-flops but for those that it
//! finds to be constant or alike; and look-up tables are estimated closely.
use rayon::prelude::*;
use specula_datapath::resources::Resources;
use specula_datapath::verilog::Counted;
use specula_fixtures::specs::spec;
use specula_fixtures::{few_spans, tools};
use specula_flow::synth::{SynthTarget, synthesised};
use specula_spec::{CoreSpec, Method, TargetClock};

/// Targets, with a clock that all methods reach but for their loops. Yosys takes minutes for many
/// products without blocks, and for the 41 blocks of `consistent` on an iCE40 UP, whose devices have 8.
fn targets(method: Method) -> impl Iterator<Item = (SynthTarget, f64)> {
    let up = (method != Method::Consistent).then_some((SynthTarget::ICE40_UP, 30.0));
    let few_products = matches!(method, Method::Gouraud | Method::Hybrid);
    let hx = few_products.then_some((SynthTarget::ICE40_HX, 60.0));
    [Some((SynthTarget::ECP5, 150.0)), up, hx].into_iter().flatten()
}

/// By how much an estimate may differ from what Yosys 0.23 makes, as a share of it. The largest
/// differences that were measured are .11 for look-up tables and .04 for flip-flops, on devices that
/// have enough blocks.
const TOLERANCE: f64 = 0.12;

#[test]
fn cells_for_an_ecp5_are_those_that_yosys_makes() {
    check_each(&[Method::Gouraud, Method::Lyon, Method::Phong], SynthTarget::ECP5);
}

#[test]
fn cells_for_an_ice40_up_are_those_that_yosys_makes() {
    check_each(&[Method::Gouraud, Method::Direct, Method::Slerp], SynthTarget::ICE40_UP);
}

#[test]
fn cells_for_an_ice40_hx_are_those_that_yosys_makes() {
    check_each(&[Method::Gouraud], SynthTarget::ICE40_HX);
}

#[test]
#[ignore = "Yosys takes minutes"]
fn cells_of_every_method_on_every_target_are_those_that_yosys_makes() {
    Method::ALL.into_par_iter().for_each(|method| check_cells(method, targets(method)));
}

/// Checks these methods on one of their targets.
fn check_each(methods: &[Method], target: SynthTarget) {
    for &method in methods {
        check_cells(method, targets(method).filter(|(own, _)| *own == target));
    }
}

fn check_cells(method: Method, targets: impl Iterator<Item = (SynthTarget, f64)>) {
    if !tools::is_installed("yosys") {
        return;
    }
    let frame = few_spans::frame(1993, 1, 3);
    let core = spec(&frame, method).specialised(&frame);
    for (synth, clock_mhz) in targets {
        let made_for = TargetClock { name: synth.name.to_owned(), clock_mhz };
        let target = made_for.target().unwrap();
        let design =
            specula_hdl::elaborate(&CoreSpec { target: Some(made_for), ..core.clone() }, "core")
                .unwrap();
        let counted = Counted::of(&design.to_block());
        let estimated = Resources::of(&design, &target);
        let made = synthesised(&design, &synth).unwrap();
        println!("{method:?} {} {counted:?} {estimated:?} {made:?}", synth.name);
        assert_eq!(made.blocks, counted.blocks, "{method:?} on {}", synth.name);
        assert_eq!(estimated.blocks, counted.blocks, "{method:?} on {}", synth.name);
        assert_eq!(estimated.memories, made.memories, "{method:?} on {}", synth.name);
        assert!(made.flip_flops <= counted.flip_flops, "{method:?} on {}", synth.name);
        let close = |estimate: u64, made: u64| {
            let off = (estimate as f64 / made as f64 - 1.0).abs();
            assert!(off < TOLERANCE, "{method:?} on {}: {estimate}, {made}", synth.name);
        };
        close(estimated.flip_flops, made.flip_flops);
        // Where no device has the blocks, nobody asks for look-up tables.
        if target.devices.iter().any(|device| estimated.blocks <= device.blocks) {
            close(estimated.luts, made.luts);
        }
    }
}
