//! Recognises the files in a folder that Specula wrote: those that its report lists or, without a
//! report, those that begin as Specula's files do.
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;

use serde::Deserialize;
use specula_experiments::tradeoff::Journal;
use specula_scene::regular::read_regular;
use specula_spec::SpecFile;

use super::{JOURNAL, REPORT};

/// The name of the program in reports.
pub const PROGRAM: &str = "Specula";

/// Largest report that is read, in bytes.
const LONGEST_REPORT: u64 = 64 << 20;
/// Largest file whose beginning is read, in bytes.
const LONGEST_FILE: u64 = 256 << 20;

/// The files in a folder, by who wrote them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// Whether the folder has a report of Specula's.
    pub has_report: bool,
    /// Names of files that Specula wrote.
    pub own: BTreeSet<String>,
    /// Names of everything else; characters of a name that are not valid are replaced.
    pub foreign: BTreeSet<String>,
}

impl Contents {
    /// Reads the contents of a folder; a folder that does not exist is empty.
    ///
    /// # Errors
    /// The operating system's error if the folder cannot be listed.
    pub fn of(folder: &Path) -> io::Result<Contents> {
        let listed = listed_files(&folder.join(REPORT));
        let mut contents = Contents { has_report: listed.is_some(), ..Contents::default() };
        let entries = match fs::read_dir(folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(contents),
            entries => entries?,
        };
        for entry in entries {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let is_own_file = || match &listed {
                Some(names) if names.contains(&name) => true,
                // A sweep that was killed has written it since the report.
                Some(_) => is_journal(&name) && begins_like_ours(&name, &entry.path()),
                None => begins_like_ours(&name, &entry.path()),
            };
            // Specula makes no links and folders.
            let is_own = entry.file_type()?.is_file() && is_own_file();
            if is_own { &mut contents.own } else { &mut contents.foreign }.insert(name);
        }
        Ok(contents)
    }

    /// The first of `names` that a foreign file has.
    pub fn clash<'a>(&self, names: impl IntoIterator<Item = &'a String>) -> Option<&'a String> {
        names.into_iter().find(|name| self.foreign.contains(*name))
    }
}

/// The part of a report that is read again.
#[derive(Deserialize)]
struct Report {
    program: String,
    files: BTreeSet<String>,
}

/// The files that a report lists; `None` if Specula did not write it, or if it is not a report.
fn listed_files(report: &Path) -> Option<BTreeSet<String>> {
    let is_file = report.symlink_metadata().is_ok_and(|about| about.is_file());
    let bytes = is_file.then(|| read_regular(report, LONGEST_REPORT).ok()).flatten()?;
    let report: Report = serde_json::from_slice(&bytes).ok()?;
    (report.program == PROGRAM).then_some(report.files)
}

/// What files' names end with, and what their first line begins with.
const COMMENTS: [(&[&str], &str); 3] = [
    (&[".lpf", ".xdc", ".sdc", ".tcl", ".py"], "#"),
    (&[".md", ".html", ".svg"], "<!--"),
    (&[".v", ".h", ".c", ".rdl", ".hex"], "//"),
];

/// Whether a file begins as a file does that Specula writes without a report.
fn begins_like_ours(name: &str, path: &Path) -> bool {
    let read = || read_regular(path, LONGEST_FILE);
    let begins = |with: &str| read().is_ok_and(|bytes| bytes.starts_with(with.as_bytes()));
    match name {
        SpecFile::NAME => begins(SpecFile::ABOUT),
        _ if is_journal(name) => read().is_ok_and(|bytes| Journal::has_written(&bytes)),
        "Makefile" => begins("# Specula "),
        _ if name.ends_with(".core") => begins("CAPI=2:\n# Specula "),
        _ if name.ends_with(".sh") => begins("#!/bin/sh\n# Specula "),
        _ => {
            let comment =
                COMMENTS.iter().find(|(ends, _)| ends.iter().any(|end| name.ends_with(end)));
            comment.is_some_and(|(_, comment)| begins(&format!("{comment} Specula ")))
        }
    }
}

/// Whether a name is that of a journal, or of one that was to replace it.
fn is_journal(name: &str) -> bool {
    name == JOURNAL || name.starts_with(&Journal::replacement_prefix(JOURNAL))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_counts_if_it_is_speculas() {
        let place = tempfile::tempdir().unwrap();
        let contents = |report: &str| {
            fs::write(place.path().join(REPORT), report).unwrap();
            fs::write(place.path().join("thesis.tex"), "mine").unwrap();
            Contents::of(place.path()).unwrap()
        };
        let foreign = contents("{\"version\":\"1\",\"files\":[\"thesis.tex\",\"report.json\"]}");
        assert!(!foreign.has_report && foreign.own.is_empty() && foreign.foreign.len() == 2);
        let ours = contents("{\"program\":\"Specula\",\"files\":[\"report.json\"]}");
        assert!(
            ours.has_report && ours.own.contains(REPORT) && ours.foreign.contains("thesis.tex")
        );
        fs::write(place.path().join("results.jsonl"), "{\"key\":{\"version\":\"0").unwrap();
        let swept = contents("{\"program\":\"Specula\",\"files\":[\"report.json\"]}");
        assert!(swept.own.contains("results.jsonl") && swept.foreign.len() == 1, "{swept:?}");
        for damaged in ["", "{", "[]", "{\"program\":\"Specula\"}", "{\"program\":1,\"files\":[]}"]
        {
            assert!(!contents(damaged).has_report, "{damaged}");
        }
    }

    #[test]
    fn without_a_report_files_tell_by_how_they_begin() {
        let place = tempfile::tempdir().unwrap();
        let is_own = |name: &str, text: &str| {
            fs::write(place.path().join(name), text).unwrap();
            Contents::of(place.path()).unwrap().own.contains(name)
        };
        assert!(is_own("spec.toml", &format!("{}version = 1\n", SpecFile::ABOUT)));
        assert!(!is_own("spec.toml", "[package]\nname = \"mine\"\n"));
        assert!(is_own("teapot.v", "// Specula 0.1.0: the shading core for the scene teapot.\n"));
        assert!(!is_own("teapot.v", "module teapot;\nendmodule\n"));
        assert!(
            is_own("results.jsonl", "")
                && is_own("results.jsonl", "damaged\n{\"key\":{\"version\":\"0")
        );
        assert!(!is_own("results.jsonl", "{\"accuracy\":1}\n"));
        assert!(!is_own("report.md", "# teapot\n"));
        assert!(is_own("README.md", "<!-- Specula 0.1.0: a shading core -->\n"));
        assert!(is_own("Makefile", "# Specula 0.1.0: simulation\n"));
        assert!(is_own("teapot_host.c", "// Specula 0.1.0: makes the first packet\n"));
        assert!(is_own("teapot_ip.py", "# Specula 0.1.0: what a host sends\n"));
        assert!(!is_own("mine.py", "import numpy\n") && !is_own("mine.c", "int main;\n"));
        assert!(is_own("teapot_pixels.hex", "// Specula 0.1.0: vectors\n"));
        assert!(is_own("prove.sh", "#!/bin/sh\n# Specula 0.1.0: proves\n"));
        assert!(is_own("test_teapot.py", "# Specula 0.1.0: a test\n"));
        assert!(is_own("teapot.html", "<!-- Specula 0.1.0: a data sheet -->\n<!DOCTYPE html>\n"));
        assert!(!is_own("mine.py", "import cocotb\n") && !is_own("mine.svg", "<svg/>\n"));
        assert!(!is_own("Makefile", "all: mine\n") && !is_own("mine.hex", "00\n"));
        let result = "{\"key\":{\"version\":\"0.1.0\"";
        assert!(is_own(".results.jsonl-a1B2c3", "") && is_own(".results.jsonl-a1B2c3", result));
        assert!(!is_own(".results.jsonl-a1B2c3", "mine\n") && !is_own(".tmpa1B2c3", result));
    }
}
