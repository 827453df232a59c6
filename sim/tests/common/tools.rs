//! External tools in tests: in CI they must be there, elsewhere a test without its tool is skipped.
use std::process::Command;

use specula_sim::SimError;

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
