//! The waveforms of every engine are the same, signal by signal and clock by clock.
use specula_datapath::design::NodeId;
use specula_fixtures::few_spans;
use specula_fixtures::specs::{packets, spec};
use specula_sim::{Engine, Fast, Icarus, RustHdl, Stimulus};
use specula_spec::Method;

use crate::agreement;
use crate::dump::{Format, read, written};
use crate::elaborated;
use crate::installed::{if_installed, verilator};

#[test]
fn waveforms_of_all_engines_agree() {
    let frame = few_spans::frame(7, 1, 5);
    let spec = spec(&frame, Method::Lyon);
    let design = elaborated(&spec);
    let packets = packets(&spec, &frame);
    let stimulus = Stimulus::whole(&packets, &design);
    let all: Vec<NodeId> = design.variables();
    let file = |engine: &mut dyn Engine| {
        let columns = agreement::run(engine, &stimulus, &all).unwrap();
        written(Format::Vcd, &design, &columns, 1024)
    };
    let reference = file(&mut RustHdl::new(&design).unwrap());
    assert!(
        file(&mut Fast::new(&design)) == reference,
        "the fast engine's waveform differs from rust-hdl's"
    );
    let wanted = read(reference, &design, &all, stimulus.clocks());
    if let Some(mut verilator) = verilator(&design) {
        // Its registers begin as rust-hdl's do.
        let got = read(file(&mut verilator), &design, &all, stimulus.clocks());
        agreement::assert_same(&design, &wanted, &got, 0, verilator.name());
    }
    if let Some(mut icarus) = if_installed(Icarus::new(&design)) {
        // Its registers are X, read as 0, until the first pixel has passed.
        let got = read(file(&mut icarus), &design, &all, stimulus.clocks());
        agreement::assert_same(&design, &wanted, &got, u64::from(design.latency()), icarus.name());
    }
}
