//! Programs that are not ours.
use std::ffi::OsStr;
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
    /// What does without it, as one says it behind `or`.
    pub otherwise: &'static str,
}

/// What does without a simulator.
pub const OTHER_ENGINE: &str = "use an engine that needs no other program: `--engine rust-hdl`";

impl Tool {
    /// Whether it is there.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it.
    pub fn present(&self) -> Result<(), SimError> {
        // What it prints or returns does not matter: Icarus tells its version and then complains
        // that it has no sources.
        self.version().map(drop)
    }

    /// What it prints of its version.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it.
    pub fn version(&self) -> Result<String, SimError> {
        Ok(String::from_utf8_lossy(&self.version_output()?.stdout).into_owned())
    }

    /// Runs it in `directory`.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if it is not installed, [`SimError::ToolFailed`] if it fails or
    /// writes anything to stderr, where compilers put their warnings.
    pub fn run(&self, directory: &Path, arguments: &[String]) -> Result<(), SimError> {
        self.named(run(self.command.as_ref(), directory, arguments))
    }

    /// Runs it in `directory`, whatever it writes to stderr.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if it is not installed, [`SimError::ToolFailed`] if it fails.
    pub fn run_with_warnings(
        &self,
        directory: &Path,
        arguments: &[String],
    ) -> Result<(), SimError> {
        let output = self.named(output(self.command.as_ref(), directory, arguments))?;
        if output.status.success() {
            return Ok(());
        }
        Err(failed(self.command.as_ref(), arguments, &output))
    }

    /// The first of several programs that is there, where each would do.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] names the first if none is there.
    pub fn or_else(self, others: &[Tool]) -> Result<Tool, SimError> {
        let absent = match self.present() {
            Ok(()) => return Ok(self),
            Err(absent) => absent,
        };
        others.iter().find(|tool| tool.present().is_ok()).copied().ok_or(absent)
    }

    /// The first line of what it prints of its version, which some programs write to stderr.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it.
    pub fn version_line(&self) -> Result<String, SimError> {
        let output = self.version_output()?;
        let texts = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        let line = texts.iter().flat_map(|text| text.lines()).find(|line| !line.trim().is_empty());
        Ok(line.unwrap_or(self.command).trim().to_owned())
    }

    /// What it prints when it is asked for its version.
    fn version_output(&self) -> Result<Output, SimError> {
        let arguments = [self.version_argument.to_owned()];
        self.named(output(self.command.as_ref(), Path::new("."), &arguments))
    }

    /// Says how to install the program if that is what is wrong.
    fn named<T>(&self, result: Result<T, SimError>) -> Result<T, SimError> {
        result.map_err(|error| match error {
            SimError::File { source, .. } if source.kind() == ErrorKind::NotFound => {
                let Tool { name: tool, command, install, otherwise, .. } = *self;
                SimError::ToolAbsent { tool, command, install, otherwise }
            }
            other => other,
        })
    }
}

/// Runs a program in `directory`.
///
/// # Errors
/// [`SimError::ToolFailed`] if it fails or writes anything to stderr, [`SimError::File`] if it
/// cannot be started.
pub fn run(program: &OsStr, directory: &Path, arguments: &[String]) -> Result<(), SimError> {
    let output = output(program, directory, arguments)?;
    if output.status.success() && output.stderr.is_empty() {
        return Ok(());
    }
    Err(failed(program, arguments, &output))
}

/// The error that tells what a program printed.
fn failed(program: &OsStr, arguments: &[String], output: &Output) -> SimError {
    let texts = [&output.stderr, &output.stdout]
        .map(|bytes| String::from_utf8_lossy(bytes).trim().to_owned());
    SimError::ToolFailed {
        command: format!("{} {}", program.to_string_lossy(), arguments.join(" ")),
        status: output.status.to_string(),
        output: texts.join("\n").trim().to_owned(),
    }
}

fn output(program: &OsStr, directory: &Path, arguments: &[String]) -> Result<Output, SimError> {
    let mut command = Command::new(program);
    command.current_dir(directory).args(arguments);
    // Messages in one language, and none about the jobs of a `make` that Specula may have been
    // started from.
    command.env("LC_ALL", "C").env_remove("MAKEFLAGS").env_remove("MFLAGS").env_remove("MAKELEVEL");
    command.output().map_err(SimError::file(format!("run `{}`", program.to_string_lossy())))
}

#[cfg(test)]
mod tests {
    use miette::Diagnostic;

    use super::*;

    #[test]
    fn an_absent_tool_is_named_and_its_installation_told() {
        let tool = Tool {
            name: "Nothing",
            command: "specula-has-no-such-tool",
            version_argument: "-V",
            install: "install nothing",
            otherwise: "do without",
        };
        let error = tool.present().unwrap_err();
        assert!(matches!(error, SimError::ToolAbsent { .. }));
        assert!(
            error.to_string().contains("Nothing")
                && error.help().unwrap().to_string() == "install nothing, or do without"
        );
    }

    #[cfg(unix)]
    #[test]
    fn a_warning_is_an_error() {
        let sh = |script: &str| {
            run("sh".as_ref(), Path::new("."), &["-c".to_owned(), script.to_owned()])
        };
        assert!(sh("echo all is well").is_ok());
        assert!(sh("exit 3").unwrap_err().to_string().contains('3'));
        assert!(sh("echo a warning >&2").unwrap_err().to_string().contains("a warning"));
    }
}
