//! Drawn netlists as Verilog, at every clock: every output in Verilator, every signal in Icarus,
//! which compiles faster.
//!
//! They are few and large, since building one takes seconds; every signal of the core leaves it.
mod known;

use specula_datapath::design::NodeId;
use specula_fixtures::Draw;
use specula_sim::{Columns, Engine, Icarus};

use crate::agreement;
use crate::installed::{if_installed, verilator};
use crate::netlists::case::Case;
use crate::netlists::draw;
use crate::netlists::minimise::without_unused;
use crate::netlists::profile::Profile;

const SEED: u64 = 2001;
const NETLISTS: u64 = 2;

#[test]
fn netlists_as_verilog_give_what_the_interpreter_gives() {
    println!("seed {SEED}");
    for number in 0..NETLISTS {
        let case = pruned(draw::case(&mut Draw::new(SEED + number), Profile::verilog()));
        let expected = case.expected().unwrap();
        let signals: Vec<NodeId> = case.design.variables();
        if let Some(mut verilator) = verilator(&case.design) {
            let outputs: Vec<NodeId> =
                [case.design.valid_out].iter().chain(&case.design.outputs).copied().collect();
            compare(&case, &expected, &outputs, &mut verilator, |_, _| true);
            println!("built in {:.1} s", verilator.build_seconds());
        }
        if let Some(mut icarus) = if_installed(Icarus::new(&case.design)) {
            let known = known::known(&case.design, &expected);
            compare(&case, &expected, &signals, &mut icarus, |node, clock| {
                known[node.0 as usize][clock]
            });
        }
    }
}

/// The netlist without the signals that no output needs, which a linter complains of and the
/// builder leaves out.
fn pruned(case: Case) -> Case {
    let outputs = case.design.outputs.iter().chain([&case.design.valid_out]);
    let watched = outputs.chain(case.design.inputs.iter().flatten()).copied().collect();
    without_unused(&Case { watched, ..case })
}

/// Compares the values that count.
fn compare(
    case: &Case,
    expected: &[Vec<i64>],
    signals: &[NodeId],
    engine: &mut dyn Engine,
    counts: impl Fn(NodeId, usize) -> bool,
) {
    let got: Columns = agreement::run(engine, &case.stimulus(), signals).unwrap();
    let (mut compared, mut all) = (0, 0);
    for (&node, column) in signals.iter().zip(&got.values) {
        let wanted = &expected[node.0 as usize];
        for clock in 0..wanted.len() {
            all += 1;
            if counts(node, clock) {
                compared += 1;
                let (name, op) = (case.design.full_name(node), case.design.node(node).op);
                assert_eq!(
                    column[clock],
                    wanted[clock],
                    "{}: {name} ({op:?}) at clock {clock}",
                    engine.name()
                );
            }
        }
    }
    println!("{}: {} signals, {compared} of {all} values", engine.name(), signals.len());
    assert!(compared > all / 3, "hardly anything was compared");
}
