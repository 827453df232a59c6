//! Warnings about skipped parts of a mesh file.
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

/// Largest number of kinds of warnings for a file; further ones are only counted.
const MAX_KINDS: usize = 20;

/// Number of a file's characters that a warning quotes.
const LONGEST_QUOTE: usize = 40;

/// A part of a mesh file that was skipped; the mesh can be drawn without it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The file.
    pub path: String,
    /// The line where it first occurs, counted from 1, if it is known.
    pub line: Option<usize>,
    /// What was found, what is done about it, and on how many more lines it occurs.
    pub text: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(out, "{}, line {line}: {}", self.path, self.text),
            None => write!(out, "{}: {}", self.path, self.text),
        }
    }
}

/// Notes about what a reader has skipped so far, one of each kind.
#[derive(Debug, Default)]
pub struct Notices {
    kinds: BTreeMap<String, usize>,
    first: Vec<Notice>,
    /// Number of notes of kinds beyond [`MAX_KINDS`].
    untold: usize,
    /// Warnings about files that belong to the mesh.
    beside: Vec<Warning>,
}

/// The first note of a kind, and the number of further ones.
#[derive(Debug)]
struct Notice {
    line: Option<usize>,
    text: String,
    more: usize,
}

impl Notices {
    /// Adds a note about `line`, counted from 1; `text`, a sentence without its full stop, is made
    /// only for the first of a `kind`.
    pub fn add(&mut self, kind: &str, line: Option<usize>, text: impl FnOnce() -> String) {
        match self.kinds.get(kind) {
            Some(&index) => self.first[index].more += 1,
            None if self.first.len() < MAX_KINDS => {
                self.kinds.insert(kind.to_owned(), self.first.len());
                self.first.push(Notice { line, text: text(), more: 0 });
            }
            None => self.untold += 1,
        }
    }

    /// Adds the warnings about another file that belongs to the mesh.
    pub fn append(&mut self, warnings: Vec<Warning>) {
        self.beside.extend(warnings);
    }

    /// The warnings about the file `path`, in the order in which the kinds occurred, and those about
    /// other files.
    pub fn into_warnings(self, path: &Path) -> Vec<Warning> {
        let path = path.display().to_string();
        let rest = (self.untold > 0)
            .then(|| (None, format!("{} things of other kinds are passed over", self.untold)));
        let told = self.first.into_iter().map(|notice| (notice.line, notice.told()));
        let own = told.chain(rest).map(|(line, text)| Warning { path: path.clone(), line, text });
        own.chain(self.beside).collect()
    }
}

impl Notice {
    fn told(self) -> String {
        match (self.more, self.line) {
            (0, _) => self.text,
            (1, Some(_)) => format!("{} (and 1 more line)", self.text),
            (more, Some(_)) => format!("{} (and {more} more lines)", self.text),
            (more, None) => format!("{} (and {more} more)", self.text),
        }
    }
}

/// The start of a file's own text in backquotes, on one line and without control characters.
pub(super) fn quoted(words: &[u8]) -> String {
    // A character takes at most four bytes.
    let start = &words[..words.len().min(4 * LONGEST_QUOTE)];
    let plain = String::from_utf8_lossy(start);
    let shown =
        plain.trim().chars().take(LONGEST_QUOTE).map(|c| if c.is_control() { ' ' } else { c });
    format!("`{}`", shown.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(notices: Notices) -> Vec<String> {
        notices.into_warnings(Path::new("a.obj")).iter().map(Warning::to_string).collect()
    }

    #[test]
    fn each_kind_is_told_once_with_its_first_line() {
        let mut notices = Notices::default();
        for line in [7, 9, 12] {
            notices.add("short", Some(line), || format!("a face of {line} corners is left out"));
        }
        notices.add("normal", Some(8), || "a normal is missing".into());
        notices.add("normal", Some(9), || unreachable!("it is told of the first alone"));
        notices.add("extension", None, || "`EXT_x` is not read".into());
        assert_eq!(
            told(notices),
            [
                "a.obj, line 7: a face of 7 corners is left out (and 2 more lines)",
                "a.obj, line 8: a normal is missing (and 1 more line)",
                "a.obj: `EXT_x` is not read",
            ]
        );
    }

    #[test]
    fn a_file_of_countless_kinds_is_warned_of_some() {
        let mut notices = Notices::default();
        (0..1000).for_each(|kind| notices.add(&format!("{kind}"), None, || format!("kind {kind}")));
        let all = told(notices);
        assert_eq!(
            (all.len(), all[20].as_str()),
            (21, "a.obj: 980 things of other kinds are passed over")
        );
    }

    #[test]
    fn quotes_are_short_and_plain() {
        assert_eq!(quoted(b" a\x1b[31m\xffb\r\n"), "`a [31m\u{fffd}b`");
        assert_eq!(quoted("\u{e9}".repeat(100).as_bytes()), format!("`{}`", "\u{e9}".repeat(40)));
    }
}
