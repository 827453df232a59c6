//! External tools in tests: in CI they must be there, elsewhere a test without its tool is skipped.
use std::path::Path;
use std::process::Command;

use specula_datapath::Design;
use specula_sim::{Effort, Library, SimError, Verilator};

/// Verilator for a short run; what all programs have in common is compiled once for all test
/// programs.
pub fn verilator(design: &Design) -> Option<Verilator<'_>> {
    let library = Library::new(Path::new(env!("CARGO_TARGET_TMPDIR")).join("verilator"));
    Some(installed(Verilator::new(design, Effort::FastBuild))?.with_library(library))
}

/// What needs a tool; `None` if the tool is absent and this is not CI.
pub fn installed<T>(result: Result<T, SimError>) -> Option<T> {
    match result {
        Err(absent @ SimError::ToolAbsent { .. }) => skipped(&absent.to_string()),
        other => Some(other.unwrap()),
    }
}

/// Whether there is such a program; if not, and this is not CI, what needs it is skipped.
pub fn program(command: &str) -> bool {
    match Command::new(command).arg("--version").output() {
        Ok(_) => true,
        Err(error) => skipped::<()>(&format!("`{command}` cannot be run: {error}")).is_some(),
    }
}

fn skipped<T>(why: &str) -> Option<T> {
    assert!(std::env::var_os("CI").is_none(), "in CI every tool must be there: {why}");
    println!("skipped: {why}");
    None
}
