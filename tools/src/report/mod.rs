//! What is said about a run: `report.json` for programs, `report.md` and `report.html` for people.
mod facts;
mod json;
mod markdown;
mod page;
mod ports;
mod units;

pub use json::json;
pub use markdown::markdown;
pub use page::html;

/// Name of the report for people.
pub const MARKDOWN: &str = "report.md";
