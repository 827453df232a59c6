//! What was passed over in a mesh file, beside what was needed of it.
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

/// Kinds of things that one file is warned of; what more there is is counted only.
const MOST_KINDS: usize = 20;

/// Characters of a file's own words that a warning quotes.
const LONGEST_QUOTE: usize = 40;

/// Something in a mesh file that was passed over, and did not keep the mesh from being drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The file.
    pub path: String,
    /// The line it was first met on, counted from 1, where one is known.
    pub line: Option<usize>,
    /// What it is, what is done instead, and on how many more lines it stands.
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

/// What a reader has passed over so far, each kind once.
#[derive(Debug, Default)]
pub struct Notices {
    kinds: BTreeMap<String, usize>,
    first: Vec<Notice>,
    /// Things of kinds beyond [`MOST_KINDS`].
    untold: usize,
}

/// The first thing of a kind, and how many more there are.
#[derive(Debug)]
struct Notice {
    line: Option<usize>,
    text: String,
    more: usize,
}

impl Notices {
    /// Notes a thing on `line`, counted from 1; `text`, a sentence without its full stop, is told
    /// of the first of a `kind` alone.
    pub fn add(&mut self, kind: &str, line: Option<usize>, text: impl FnOnce() -> String) {
        match self.kinds.get(kind) {
            Some(&index) => self.first[index].more += 1,
            None if self.first.len() < MOST_KINDS => {
                self.kinds.insert(kind.to_owned(), self.first.len());
                self.first.push(Notice { line, text: text(), more: 0 });
            }
            None => self.untold += 1,
        }
    }

    /// The warnings about the file `path`, in the order in which the kinds were met.
    pub fn into_warnings(self, path: &Path) -> Vec<Warning> {
        let path = path.display().to_string();
        let rest = (self.untold > 0)
            .then(|| (None, format!("{} things of other kinds are passed over", self.untold)));
        let told = self.first.into_iter().map(|notice| (notice.line, notice.told()));
        told.chain(rest).map(|(line, text)| Warning { path: path.clone(), line, text }).collect()
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

/// The start of a file's own words in backquotes, on one line and without control characters.
pub(super) fn quoted(words: &[u8]) -> String {
    // A character takes four bytes at most.
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
