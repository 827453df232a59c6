//! What is said about a run: `report.json` for programs, `report.md` for people.
mod json;
mod markdown;
mod ports;

pub use json::json;
pub use markdown::markdown;
