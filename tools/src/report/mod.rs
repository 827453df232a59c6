//! What is said about a run: `report.json` for programs, `report.md` for people.
mod facts;
mod json;
mod markdown;
mod ports;
mod units;

pub use json::json;
pub use markdown::markdown;
