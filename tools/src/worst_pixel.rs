//! The picture of a pixel's path through the core: that of the worst pixel, of the first one that
//! disagrees, or of one whose error is above its bound.
use std::fs;

use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op, ScopeId};
use specula_sim::gtkw;
use specula_testbench::trace::Choice;

use crate::error::ToolError;
use crate::output::Staging;
use crate::run::Run;
use crate::waveform;
use specula_wave::{self as wave, DumpView, WindowRequest};

/// Name of the picture.
pub const PICTURE: &str = "worst.svg";

/// Largest number of rows; if there are more, only the results of units are shown.
const MAX_ROWS: usize = 26;
/// Clocks shown before the pixel enters and after it leaves.
const AROUND: u64 = 2;

/// Draws the pixel's path through the core into the file `name`. The clocks are read from a
/// waveform of their own, since that of the run may contain others, or be very long.
pub fn write(run: &Run, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let Some(leaves) = run.clock_to_look_at() else { return Ok(()) };
    let design = &run.bench.design;
    // With shared light pipelines this is the entry of the pixel's last time slot.
    let enters = leaves.saturating_sub(design.depth().into());
    let (first, last) = (enters.saturating_sub(AROUND), leaves + AROUND);
    let dump = staging.scratch(run.trace_format.file_name());
    waveform::dump(&dump, run, &Choice::Cycles(first..last + 1))?.map_err(staging.failed(name))?;
    let mut view = DumpView::open(&dump)?;
    let choice = view.signals_by_name(&pixel_path(design, enters));
    let mut figure = view.figure(
        &choice,
        &WindowRequest { from: Some(first), to: Some(last), default_columns: 0 },
    )?;
    figure.notes =
        vec!["A pixel's path through the core: marked values belong to the pixel that leaves in the marked clock.".to_owned()];
    let svg = wave::svg(&figure, None);
    Ok(fs::write(staging.file(name), svg).map_err(staging.failed(name))?)
}

/// Names of the signals along a pixel's way, and the clock in which each has that pixel's value.
fn pixel_path(design: &Design, enters: u64) -> Vec<(String, u64)> {
    let core = [design.valid_out].into_iter().chain(design.outputs.iter().copied());
    let nodes = [design.valid].into_iter().chain(in_units(design)).chain(core);
    nodes.map(|id| (design.full_name(id), enters + u64::from(design.node(id).stage))).collect()
}

/// The values that the core's units compute, unit by unit and in the order of time.
fn in_units(design: &Design) -> Vec<NodeId> {
    let of_unit = |id: &NodeId| design.scope(design.node(*id).scope).parent == Some(ScopeId::TOP);
    // Ports and delays repeat what another row shows; results of inner units have no other row.
    let scope = |id: NodeId| design.node(id).scope;
    let computed = |id: &NodeId| match design.node(*id).op {
        Op::Copy(of) => design.scope(scope(of)).parent == Some(scope(*id)),
        _ => true,
    };
    let mut nodes: Vec<NodeId> =
        gtkw::interesting(design).into_iter().filter(|id| of_unit(id) && computed(id)).collect();
    let results = |id: &NodeId| design.node(*id).stage == design.scope(design.node(*id).scope).exit;
    if nodes.len() > MAX_ROWS {
        nodes.retain(results);
    }
    nodes.truncate(2 * MAX_ROWS);
    nodes.sort_by_key(|id| {
        (
            design.scope(design.node(*id).scope).entry,
            design.node(*id).scope,
            design.node(*id).stage,
            *id,
        )
    });
    nodes
}
