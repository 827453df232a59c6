//! The report for programs.
use super::Report;

/// `report.json`.
///
/// # Errors
/// Those of [`serde_json`], which a report does not cause.
pub fn json(report: &Report) -> serde_json::Result<String> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}
