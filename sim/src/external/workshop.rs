//! A temporary directory in which an external simulator is built and run.
use std::fs::File;
use std::path::Path;

use specula_datapath::Design;
use specula_datapath::verilog::{self, Header, LongDelays};
use tempfile::TempDir;

use super::Ports;
use super::stimulus::write_stimulus;
use crate::{SimError, Stimulus};

/// The file that holds the stimulus of a run.
pub const STIMULUS: &str = "stimulus.hex";
/// The file into which ports are written.
pub const RESULTS: &str = "results.bin";
/// The file into which all signals are written.
pub const TRACE: &str = "trace.vcd";

/// The folder of what is printed to be traced.
const TRACED: &str = "traced";

/// A new temporary directory; it is gone when it is dropped.
///
/// # Errors
/// [`SimError::File`] if it cannot be made.
pub fn temporary_directory() -> Result<TempDir, SimError> {
    tempfile::Builder::new()
        .prefix("specula-")
        .tempdir()
        .map_err(SimError::file("make a temporary directory"))
}

/// A temporary directory that holds a design's Verilog; it is gone when this is dropped.
pub struct Workshop {
    directory: TempDir,
    /// The design's ports.
    pub ports: Ports,
    /// The file that holds the design.
    pub source: String,
    /// The file that holds the design with all delay lines as shift registers, so that each of
    /// their stages can be seen.
    pub traced_source: String,
}

impl Workshop {
    /// A new directory with the Verilog of `design` in it.
    ///
    /// # Errors
    /// [`SimError::File`] if it cannot be written.
    pub fn new(design: &Design) -> Result<Workshop, SimError> {
        let directory = temporary_directory()?;
        let ports = Ports::of(design);
        let source = format!("{}.v", ports.core);
        // Linters want a file to be called after the module in it.
        let traced_source = format!("{TRACED}/{source}");
        let workshop = Workshop { directory, ports, source, traced_source };
        std::fs::create_dir(workshop.path().join(TRACED))
            .map_err(SimError::file("make a folder for a simulator"))?;
        let (block, header) = (design.to_block(), Header::default());
        for (source, long_delays) in [
            (&workshop.source, LongDelays::Memories),
            (&workshop.traced_source, LongDelays::ShiftRegisters),
        ] {
            workshop.write(source, &verilog::print_with(&block, &header, long_delays))?;
        }
        Ok(workshop)
    }

    /// A new directory with another description of what `design` is: Verilog of a module of its name
    /// with its ports, and of all that the module is made of.
    ///
    /// # Errors
    /// [`SimError::File`] if it cannot be written.
    pub fn of_netlist(design: &Design, netlist: &str) -> Result<Workshop, SimError> {
        let directory = temporary_directory()?;
        let ports = Ports::of(design);
        let source = format!("{}.v", ports.core);
        let workshop = Workshop { directory, ports, traced_source: source.clone(), source };
        workshop.write(&workshop.source, netlist)?;
        Ok(workshop)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.directory.path()
    }

    /// Writes a file.
    ///
    /// # Errors
    /// [`SimError::File`] if that fails.
    pub fn write(&self, name: &str, text: &str) -> Result<(), SimError> {
        std::fs::write(self.path().join(name), text)
            .map_err(SimError::file(format!("write {name} for a simulator")))
    }

    /// Writes the file of the stimulus.
    ///
    /// # Errors
    /// [`SimError::File`] if that fails.
    pub fn write_stimulus(&self, stimulus: &Stimulus, design: &Design) -> Result<(), SimError> {
        let doing = format!("write {STIMULUS} for a simulator");
        let file =
            File::create(self.path().join(STIMULUS)).map_err(SimError::file(doing.clone()))?;
        write_stimulus(file, stimulus, design).map_err(SimError::file(doing))
    }

    /// Opens a file that a simulator wrote.
    ///
    /// # Errors
    /// [`SimError::File`] if it is not there.
    pub fn open(&self, name: &str) -> Result<File, SimError> {
        File::open(self.path().join(name))
            .map_err(SimError::file(format!("read {name} from a simulator")))
    }
}
