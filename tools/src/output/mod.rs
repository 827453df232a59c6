//! Where results go: whole, or not at all.
//!
//! Everything is written into a temporary folder beside its place and moved there once it is complete.
mod core_files;
mod folder;
mod made;
mod one_file;
mod publish;

pub use core_files::write_core;
pub use folder::Destination;
pub use one_file::write_file;
pub use publish::Staging;

/// The report that marks a folder as a run's.
pub const REPORT: &str = "report.json";
/// Beginning of the names of temporary folders; what is left of one after a power cut can be deleted.
const TEMPORARY: &str = ".specula-";
