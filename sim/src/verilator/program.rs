//! How a program is built round a core.
use super::{Common, Effort, VERILATOR};
use crate::SimError;
use crate::external::Workshop;

/// A program to be built.
pub struct Program<'a> {
    /// Directory of its object files, in the workshop.
    pub directory: &'a str,
    /// The core's Verilog.
    pub source: &'a str,
    /// Its C++ source, which includes `ports.h`.
    pub main: &'a str,
    /// What the C++ compiler is to spend its time on.
    pub effort: Effort,
    /// Verilator's options beside those that all programs have.
    pub options: &'a [&'a str],
    /// What is compiled already.
    pub common: Option<&'a Common>,
}

/// What programs are called, in their directory.
pub const PROGRAM: &str = "run";

impl Program<'_> {
    /// Translates the core and compiles the program.
    ///
    /// # Errors
    /// [`SimError::ToolFailed`] with what Verilator or the C++ compiler printed, warnings included.
    pub fn build(&self, workshop: &Workshop) -> Result<(), SimError> {
        VERILATOR.run(workshop.path(), &self.arguments(workshop))
    }

    fn arguments(&self, workshop: &Workshop) -> Vec<String> {
        // Registers begin as rust-hdl's do, without a call for each that would ask at run time what
        // they are to begin with.
        let fixed = "--cc --exe --build -j 0 -O3 -Wall --x-initial 0 --prefix Vcore";
        let mut arguments: Vec<String> = fixed.split(' ').map(str::to_owned).collect();
        arguments.extend(
            self.effort
                .make_variables()
                .into_iter()
                .flat_map(|variable| ["-MAKEFLAGS".to_owned(), variable]),
        );
        arguments.extend(
            ["-o", PROGRAM, "--top-module", &workshop.ports.core, "-Mdir", self.directory]
                .map(str::to_owned),
        );
        arguments.extend(self.options.iter().map(|&option| option.to_owned()));
        arguments.extend([self.source, self.main].map(str::to_owned));
        // ports.h stands beside the source, not in the directory of the object files.
        arguments.extend(["-CFLAGS".into(), format!("-I.. {}", self.effort.option())]);
        arguments.extend(self.common.into_iter().flat_map(Common::arguments));
        arguments
    }
}
