//! The netlist of a core, for simulators.
use specula_datapath::Design;
use specula_sim::{Tool, temporary_directory};

use super::{SynthError, SynthTarget, models, yosys};

/// What Yosys has made of a core.
#[derive(Clone, Debug)]
pub struct Netlist {
    /// Verilog of the core's module: cells of the device, and wires between them.
    pub core: String,
    yosys: Tool,
    target: SynthTarget,
}

impl Netlist {
    /// Synthesises a design for a target, without placing it.
    ///
    /// # Errors
    /// [`SynthError::Tool`] if Yosys is not installed or fails.
    pub fn of(design: &Design, target: &SynthTarget) -> Result<Netlist, SynthError> {
        let (yosys, directory) = (yosys::program()?, temporary_directory()?);
        Ok(yosys::run(&yosys, directory.path(), design, target)?.1)
    }

    /// The netlist that Yosys wrote for a target.
    pub(super) fn written(core: String, yosys: &Tool, target: &SynthTarget) -> Netlist {
        Netlist { core, yosys: *yosys, target: *target }
    }

    /// The netlist with a model of each kind of cell in it, which is all that a simulator needs.
    /// Models are Yosys's own, and Specula's of the blocks that Yosys has none of.
    ///
    /// # Errors
    /// [`SynthError::NoModels`] if Yosys comes without its models.
    pub fn with_models(&self) -> Result<String, SynthError> {
        let models = models::of_cells(&self.core, &self.yosys, &self.target)?;
        Ok(format!("{}\n{models}", self.core))
    }
}
