//! Spans that pause anywhere: every signal at every clock in every engine, with random bubbles
//! before time slots.
use specula_datapath::Design;
use specula_fixtures::specs::{packets, spec};
use specula_fixtures::{each_method, few_spans};
use specula_sim::fast::{InstructionSet, Settings};
use specula_sim::{Columns, Engine, Fast, Icarus, RustHdl, Stimulus};
use specula_spec::{CoreSpec, LightPipelines, Method, TargetClock};

use crate::agreement::{self, assert_same};
use crate::elaborated;
use crate::installed::{if_installed, verilator};

fn sharing_a_pipeline(mut spec: CoreSpec) -> CoreSpec {
    spec.parameters.light_pipelines = LightPipelines::Shared;
    spec
}

fn every_signal_agrees_at_every_clock(method: Method) {
    let seed = 2026 + method as u64;
    println!("seed {seed}");
    let frame = few_spans::frame(seed, 2, 5);
    let check = |spec: &CoreSpec, engines: fn(&Design, &Stimulus)| {
        let (design, packets) = (elaborated(spec), packets(spec, &frame));
        engines(&design, &Stimulus::whole(&packets, &design).with_bubbles(seed));
    };
    let each = spec(&frame, method);
    let target = Some(TargetClock { name: "ecp5".into(), clock_mhz: 250.0 });
    let for_a_clock = CoreSpec { target, ..each.specialised(&frame) };
    check(&for_a_clock, engines_agree);
    check(&each, engines_agree);
    // A program by Verilator takes ten times as long to build as all else here takes.
    check(&sharing_a_pipeline(each), |design, stimulus| {
        let reference = own_engines_agree(design, stimulus);
        in_icarus(design, stimulus, &reference);
    });
}

/// Every signal at every clock, and in windows of the run.
pub fn engines_agree(design: &Design, stimulus: &Stimulus) {
    let reference = own_engines_agree(design, stimulus);
    in_verilator(design, stimulus, &reference);
    in_icarus(design, stimulus, &reference);
}

/// As [`engines_agree`], without external simulators. What rust-hdl gives.
pub fn own_engines_agree(design: &Design, stimulus: &Stimulus) -> Columns {
    let reference = of_rust_hdl(design, stimulus);
    in_the_fast_engine(design, stimulus, &reference);
    late_runs_show_the_same(design, stimulus, &reference);
    reference
}

fn of_rust_hdl(design: &Design, stimulus: &Stimulus) -> Columns {
    agreement::run(&mut RustHdl::new(design).unwrap(), stimulus, &design.variables()).unwrap()
}

/// All signals at once, with short batches and long ones, one thread and several; and outputs
/// alone, fused and in pieces.
fn in_the_fast_engine(design: &Design, stimulus: &Stimulus, reference: &Columns) {
    for (batch, threads, instruction_set) in [
        (1, 1, InstructionSet::BASELINE),
        (7, 3, InstructionSet::best()),
        (64, 2, InstructionSet::BASELINE),
        (512, 1, InstructionSet::best()),
    ] {
        let settings = Settings { batch, threads, instruction_set, piece: 10 };
        let mut fast = Fast::with_settings(design, settings);
        let all = agreement::run(&mut fast, stimulus, &design.variables()).unwrap();
        assert_same(design, reference, &all, 0, "fast");
        let outputs = agreement::run(&mut fast, stimulus, &design.outputs).unwrap();
        for &output in &design.outputs {
            assert_eq!(outputs.of(output), reference.of(output), "{settings:?}");
        }
    }
}

/// Wherever a window begins, in a bubble or in a pixel, every register holds what it does in the
/// whole run.
fn late_runs_show_the_same(design: &Design, stimulus: &Stimulus, reference: &Columns) {
    let end = stimulus.clocks().end;
    for first in (0..end).step_by(7) {
        let window = first..(first + 3).min(end);
        let late = stimulus.leading_to(&window, design);
        let shown = agreement::run(&mut Fast::new(design), &late, &reference.nodes).unwrap();
        let part = |all: &Columns| {
            let mut part = Columns::new(&all.nodes);
            part.extend(&all.batch().within(&window));
            part
        };
        assert_same(design, &part(reference), &part(&shown), 0, "fast, late");
    }
}

fn in_verilator(design: &Design, stimulus: &Stimulus, reference: &Columns) {
    let signals = design.variables();
    if let Some(mut verilator) = verilator(design) {
        let columns = agreement::run(&mut verilator, stimulus, &signals).unwrap();
        assert_same(design, reference, &columns, 0, verilator.name());
        println!("Verilator: built in {:.1} s", verilator.build_seconds());
    }
}

/// Icarus begins with X in every register: it counts from where the first pixel has gone through.
fn in_icarus(design: &Design, stimulus: &Stimulus, reference: &Columns) {
    let signals = design.variables();
    if let Some(mut icarus) = if_installed(Icarus::new(design)) {
        let columns = agreement::run(&mut icarus, stimulus, &signals).unwrap();
        let known = stimulus.completion_of(0, 0) + u64::from(design.latency());
        assert_same(design, reference, &columns, known, icarus.name());
        println!("Icarus: built in {:.1} s", icarus.build_seconds());
    }
}

each_method!(every_signal_agrees_at_every_clock);
