//! External engines that are installed.
use std::path::Path;

use specula_datapath::Design;
use specula_fixtures::tools::skipped;
use specula_sim::{Effort, Library, SimError, Verilator};

/// Verilator for a short run; what all programs have in common is compiled once for all tests.
pub fn verilator(design: &Design) -> Option<Verilator<'_>> {
    let library = Library::new(Path::new(env!("CARGO_TARGET_TMPDIR")).join("verilator"));
    Some(if_installed(Verilator::new(design, Effort::FastBuild))?.with_library(library))
}

/// What needs a tool; `None` if the tool is absent and this is not CI.
pub fn if_installed<T>(result: Result<T, SimError>) -> Option<T> {
    match result {
        Err(absent @ SimError::ToolAbsent { .. }) => {
            skipped(&absent.to_string());
            None
        }
        other => Some(other.unwrap()),
    }
}
