//! Failures of the past, a file each in `sim/tests/regressions/`: adding a test is adding a file.
use std::path::Path;

use crate::netlists::case::Case;
use crate::netlists::text;

/// Reads every file and says what fails.
pub fn replay(failure: impl Fn(&Case) -> Option<String>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/regressions");
    let entries = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|e| e == "netlist")).collect();
    files.sort();
    let mut failed = vec![];
    for path in &files {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let case = text::parse(&std::fs::read_to_string(path).unwrap())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        case.expected().unwrap_or_else(|untrue| panic!("{name}: the netlist is wrong: {untrue}"));
        failed.extend(failure(&case).map(|failure| format!("{name}: {failure}")));
    }
    println!("{} files", files.len());
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
