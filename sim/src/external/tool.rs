//! Programs that are not ours.
use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, Output};

use crate::SimError;

/// A program on the search path.
#[derive(Clone, Copy, Debug)]
pub struct Tool {
    /// What people call it.
    pub name: &'static str,
    /// The program.
    pub command: &'static str,
    /// The argument that makes it print its version.
    pub version_argument: &'static str,
    /// How to get it.
    pub install: &'static str,
}

impl Tool {
    /// Whether it can be run.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it, [`SimError::ToolFailed`] what it printed if it does not even tell its version.
    pub fn present(&self) -> Result<(), SimError> {
        // Icarus prints its version and then complains on stderr, so only the exit status counts here.
        let output = self.output(Path::new("."), &[self.version_argument.to_owned()])?;
        if output.status.success() { Ok(()) } else { Err(self.failed(&[self.version_argument.to_owned()], &output)) }
    }

    /// Runs it in `directory`.
    ///
    /// # Errors
    /// [`SimError::ToolFailed`] if it fails or writes anything to stderr, where compilers put their warnings.
    pub fn run(&self, directory: &Path, arguments: &[String]) -> Result<(), SimError> {
        let output = self.output(directory, arguments)?;
        if output.status.success() && output.stderr.is_empty() { Ok(()) } else { Err(self.failed(arguments, &output)) }
    }

    fn output(&self, directory: &Path, arguments: &[String]) -> Result<Output, SimError> {
        let mut command = Command::new(self.command);
        command.current_dir(directory).args(arguments);
        // Messages in one language, and none about the jobs of a `make` that Specula may have been started from.
        command.env("LC_ALL", "C").env_remove("MAKEFLAGS").env_remove("MFLAGS").env_remove("MAKELEVEL");
        command.output().map_err(|error| match error.kind() {
            ErrorKind::NotFound => {
                SimError::ToolAbsent { tool: self.name, command: self.command, install: self.install }
            }
            _ => SimError::File { doing: format!("run `{}`", self.command), source: error },
        })
    }

    fn failed(&self, arguments: &[String], output: &Output) -> SimError {
        let texts = [&output.stderr, &output.stdout].map(|bytes| String::from_utf8_lossy(bytes).trim_end().to_owned());
        SimError::ToolFailed {
            command: format!("{} {}", self.command, arguments.join(" ")),
            status: output.status.to_string(),
            output: texts.join("\n").trim().to_owned(),
        }
    }
}
