//! The report about a run: one [`Report`], and its renderings: `report.json` for programs,
//! `report.md` and `report.html` for people, and the summary that `run` prints.
mod contents;
mod facts;
mod markdown;
mod page;
mod pictures;
mod rows;
mod summary;
mod units;

pub use contents::Report;
pub use markdown::markdown;
pub use page::html;
pub use pictures::{ERROR, EXACT, EXPECTED, SIMULATED};
pub use summary::summary;
