//! Runs the program in a folder of its own.
use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// An empty folder in which the program runs.
pub struct Place {
    folder: TempDir,
}

/// How a run of the program ended.
#[derive(Debug)]
pub struct Ended {
    pub status: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Ended {
    fn of(Output { status, stdout, stderr }: Output) -> Ended {
        let text = |bytes| String::from_utf8(bytes).expect("the program writes UTF-8");
        Ended { status: status.code(), stdout: text(stdout), stderr: text(stderr) }
    }
}

impl Place {
    pub fn new() -> Place {
        Place { folder: TempDir::new().expect("there is room for a folder") }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).expect("a file can be written");
    }

    /// Runs the program with pipes for its output.
    pub fn specula<S: AsRef<OsStr>>(&self, arguments: &[S]) -> Ended {
        self.specula_in(".", arguments)
    }

    /// Runs the program in a folder inside this one.
    pub fn specula_in<S: AsRef<OsStr>>(&self, folder: &str, arguments: &[S]) -> Ended {
        Ended::of(self.program(folder).args(arguments).output().expect("the program runs"))
    }

    /// Runs the program, which reads a file of this folder from its standard input.
    pub fn specula_reading(&self, file: &str, arguments: &[&str]) -> Ended {
        let input = File::open(self.path(file)).expect("the file is there");
        Ended::of(
            self.program(".").args(arguments).stdin(input).output().expect("the program runs"),
        )
    }

    /// The program in a folder inside this one, which has not been started.
    pub fn program(&self, folder: &str) -> Command {
        let mut program = Command::new(env!("CARGO_BIN_EXE_specula"));
        // The same words on every machine.
        program
            .env("LC_ALL", "C")
            .env("NO_COLOR", "1")
            .env_remove("NO_GRAPHICS")
            .env_remove("CLICOLOR_FORCE");
        program.env_remove("FORCE_COLOR").env_remove("COLUMNS").current_dir(self.path(folder));
        program
    }

    /// Runs the program, which has to succeed and say nothing but its result.
    pub fn succeeds(&self, arguments: &[&str]) -> String {
        let ended = self.specula(arguments);
        assert_eq!(
            (ended.status, ended.stderr.as_str()),
            (Some(0), ""),
            "{arguments:?}: {}",
            ended.stdout
        );
        ended.stdout
    }

    /// Names in a folder, sorted, hidden ones too.
    pub fn names(&self, folder: &str) -> Vec<String> {
        names(&self.path(folder))
    }

    pub fn report(&self, folder: &str) -> Value {
        let text = fs::read(self.path(folder).join("report.json")).expect("there is a report");
        serde_json::from_slice(&text).expect("the report is JSON")
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    let mut names: Vec<String> = entries
        .map(|entry| {
            entry.expect("the folder can be read").file_name().to_string_lossy().into_owned()
        })
        .collect();
    names.sort();
    names
}
