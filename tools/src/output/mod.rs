//! Output of results: everything or nothing.
//!
//! Everything is written into a temporary folder next to its place and moved there once it is
//! complete. Whenever the program ends, by a signal, a kill or a power cut, the user's own files
//! are in their place, or the next program that writes there brings them back.
mod atomic_write;
mod core_files;
mod created_dirs;
mod destination;
mod disk;
mod error;
mod folder;
mod hidden;
mod interrupt;
mod leftovers;
mod own;
mod publish;
mod record;
mod temporary;

pub use atomic_write::write_file;
pub use core_files::write_core;
pub use destination::Destination;
pub use error::OutputError;
pub use interrupt::Interrupts;
pub use own::PROGRAM;
pub use publish::Staging;

/// File name of the report for people.
pub const MARKDOWN: &str = "report.md";
/// File name of the report that marks a folder as a run's.
pub const REPORT: &str = "report.json";
/// File name of a sweep's results, written as they come.
pub const JOURNAL: &str = "results.jsonl";
