//! rust-hdl's own simulator: the reference, slow, and right by definition.
use specula_datapath::Design;
use specula_datapath::block::{Module, check_all, simulate};
use specula_datapath::design::{NodeId, Op};

use crate::stimulus::InputHold;
use crate::{Batch, Columns, Engine, Flow, SimError, Stimulus};

/// Clocks handed over at a time.
const BATCH: usize = 1024;
/// Passes after which a design that still changes is given up; a hierarchy of depth d needs a few
/// more than 2d.
const MOST_PASSES: usize = 1000;

/// Drives the clock of a design's rust-hdl block and lets rust-hdl's `simulate` settle it after
/// each edge.
pub struct RustHdl<'a> {
    design: &'a Design,
}

impl<'a> RustHdl<'a> {
    /// An engine for `design`.
    ///
    /// # Errors
    /// [`SimError::Check`] if rust-hdl's `check_all` finds fault with the design.
    pub fn new(design: &'a Design) -> Result<RustHdl<'a>, SimError> {
        check_all(&design.to_block()).map_err(|e| SimError::Check(format!("{e:?}")))?;
        Ok(RustHdl { design })
    }
}

/// The block with the places of its control and data inputs.
struct Bench {
    block: Module,
    valid: u32,
    start: u32,
    inputs: Vec<Option<u32>>,
}

impl Bench {
    fn new(design: &Design) -> Bench {
        let block = design.to_block();
        let pin = |node: NodeId| {
            block.wires().iter().position(|w| w.wire_type().node == node).unwrap_or(0) as u32
        };
        let (valid, start) = (pin(design.valid), pin(design.start));
        let inputs = design.inputs.iter().map(|input| input.map(pin)).collect();
        Bench { block, valid, start, inputs }
    }

    fn settle(&mut self, clock: u64) -> Result<(), SimError> {
        if simulate(&mut self.block, MOST_PASSES) {
            Ok(())
        } else {
            Err(SimError::Unsettled { clock })
        }
    }

    /// One clock in reset, from which every validity register comes out 0.
    fn reset(&mut self) -> Result<(), SimError> {
        self.block.set_reset(true);
        self.block.set_clock(false);
        self.settle(0)?;
        self.block.set_clock(true);
        self.settle(0)?;
        self.block.set_reset(false);
        self.block.set_clock(false);
        self.settle(0)
    }

    fn apply(&mut self, hold: &InputHold) {
        self.block.set(self.valid, i64::from(hold.valid));
        self.block.set(self.start, i64::from(hold.starts));
        for (pin, &value) in self.inputs.iter().zip(&hold.inputs) {
            if let Some(pin) = *pin {
                self.block.set(pin, value);
            }
        }
    }
}

/// Where a watched signal stands in the tree of modules.
struct Place {
    path: Vec<usize>,
    wire: usize,
}

/// A watched signal.
enum Watched {
    Wire(Place),
    /// A constant has no wire of its own.
    Constant(i64),
}

fn places(design: &Design, block: &Module, watched: &[NodeId]) -> Vec<Watched> {
    fn find(module: &Module, node: NodeId, path: &mut Vec<usize>) -> Option<Place> {
        if let Some(wire) = module.wires().iter().position(|w| w.wire_type().node == node) {
            return Some(Place { path: path.clone(), wire });
        }
        module.children().iter().enumerate().find_map(|(i, child)| {
            path.push(i);
            let found = find(&child.module, node, path);
            path.pop();
            found
        })
    }
    let constant = |node: NodeId| match design.node(node).op {
        Op::Constant(value) => value,
        // Every other signal has a wire.
        _ => 0,
    };
    let place = |&node: &NodeId| {
        find(block, node, &mut vec![])
            .map_or_else(|| Watched::Constant(constant(node)), Watched::Wire)
    };
    watched.iter().map(place).collect()
}

fn value(block: &Module, place: &Place) -> i64 {
    let module = place.path.iter().fold(block, |module, &i| &module.children()[i].module);
    module.wires()[place.wire].value()
}

impl Engine for RustHdl<'_> {
    fn name(&self) -> &'static str {
        "rust-hdl"
    }

    fn run(
        &mut self,
        stimulus: &Stimulus,
        watched: &[NodeId],
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<(), SimError> {
        let mut bench = Bench::new(self.design);
        bench.reset()?;
        let places = places(self.design, &bench.block, watched);
        let mut columns = Columns::new(watched);
        columns.restart(stimulus.clocks().start);
        for hold in stimulus.holds() {
            for clock in hold.clocks.clone() {
                if clock == hold.clocks.start {
                    bench.apply(&hold);
                } else {
                    bench.block.set(bench.start, 0);
                }
                bench.block.set_clock(false);
                bench.settle(clock)?;
                for (column, place) in columns.values.iter_mut().zip(&places) {
                    column.push(match place {
                        Watched::Wire(place) => value(&bench.block, place),
                        Watched::Constant(constant) => *constant,
                    });
                }
                bench.block.set_clock(true);
                bench.settle(clock)?;
                if columns.clocks() == BATCH {
                    if sink(&columns.batch()) == Flow::Stop {
                        return Ok(());
                    }
                    columns.restart(clock + 1);
                }
            }
        }
        if columns.clocks() > 0 {
            sink(&columns.batch());
        }
        Ok(())
    }
}
