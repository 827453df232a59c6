//! Every engine on one stimulus.
use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::fast::{InstructionSet, Settings};
use specula_sim::{Columns, Engine, Fast, Flow, Icarus, RustHdl, SimError, Stimulus};

use crate::installed::{if_installed, verilator};

/// All that an engine gives.
pub fn run(
    engine: &mut dyn Engine,
    stimulus: &Stimulus,
    watched: &[NodeId],
) -> Result<Columns, SimError> {
    let mut all = Columns::new(watched);
    engine.run(stimulus, watched, &mut |columns| {
        assert_eq!(
            columns.first_clock(),
            if all.clocks() == 0 { stimulus.clocks().start } else { all.span().end }
        );
        all.extend(columns);
        Flow::Continue
    })?;
    assert_eq!(all.span(), stimulus.clocks(), "{}", engine.name());
    Ok(all)
}

/// What rust-hdl gives, and then the name and columns of each external engine that is there.
pub fn run_all(
    design: &Design,
    stimulus: &Stimulus,
    watched: &[NodeId],
) -> (Columns, Vec<(&'static str, Columns)>) {
    let reference = run(&mut RustHdl::new(design).unwrap(), stimulus, watched).unwrap();
    let mut others = vec![];
    for instruction_set in [InstructionSet::BASELINE, InstructionSet::best()] {
        let mut fast = Fast::with_settings(
            design,
            Settings { batch: 61, instruction_set, threads: 2, piece: 100 },
        );
        others.push((fast.name(), run(&mut fast, stimulus, watched).unwrap()));
    }
    if let Some(mut verilator) = verilator(design) {
        others.push((verilator.name(), run(&mut verilator, stimulus, watched).unwrap()));
        println!("Verilator: built in {:.1} s", verilator.build_seconds());
    }
    if let Some(mut icarus) = if_installed(Icarus::new(design)) {
        others.push((icarus.name(), run(&mut icarus, stimulus, watched).unwrap()));
        println!("Icarus: built in {:.1} s", icarus.build_seconds());
    }
    (reference, others)
}

/// Asserts that `got` is equal to `wanted` from `first` on.
pub fn assert_same(design: &Design, wanted: &Columns, got: &Columns, first: u64, engine: &str) {
    assert_eq!((wanted.span(), &wanted.nodes), (got.span(), &got.nodes));
    for ((&node, wanted_column), got_column) in
        wanted.nodes.iter().zip(&wanted.values).zip(&got.values)
    {
        for (clock, (w, g)) in wanted
            .span()
            .zip(wanted_column.iter().zip(got_column))
            .filter(|&(clock, _)| clock >= first)
        {
            assert_eq!(
                g,
                w,
                "{engine}: {} ({:?}) at clock {clock}",
                design.full_name(node),
                design.node(node).op
            );
        }
    }
}
