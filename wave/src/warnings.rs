//! Warnings about skipped contents of a file: one for each kind, with the place where it first
//! occurs.

/// The warnings about a file, collected while it is read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Warnings {
    found: Vec<Found>,
}

/// The first warning of a kind, and the number of further ones.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Found {
    kind: &'static str,
    line: Option<u64>,
    said: String,
    more: u64,
}

/// Largest number of characters that are quoted from a file.
const LONGEST: usize = 40;

impl Warnings {
    /// Adds a warning of a kind about a line; its text is made only for the first of the kind.
    pub fn in_line(&mut self, line: u64, kind: &'static str, words: impl FnOnce() -> String) {
        self.note(Some(line), kind, words);
    }

    /// Adds a warning that concerns the whole file.
    pub fn of_file(&mut self, kind: &'static str, words: impl FnOnce() -> String) {
        self.note(None, kind, words);
    }

    fn note(&mut self, line: Option<u64>, kind: &'static str, words: impl FnOnce() -> String) {
        match self.found.iter_mut().find(|found| found.kind == kind) {
            Some(found) => found.more += 1,
            None => self.found.push(Found { kind, line, said: words(), more: 0 }),
        }
    }

    /// The warnings about the file `name`, a line each.
    pub fn lines(&self, name: &str) -> Vec<String> {
        let place = |line: Option<u64>| line.map_or(String::new(), |line| format!("line {line}: "));
        let more =
            |more: u64| if more > 0 { format!(" ({more} more like it)") } else { String::new() };
        let line = |found: &Found| {
            format!("`{name}`: {}{}{}", place(found.line), found.said, more(found.more))
        };
        self.found.iter().map(line).collect()
    }
}

/// A piece of a file in printable form: short and without control characters.
pub fn quoted(bytes: &[u8]) -> String {
    let text = clean(&decoded(&bytes[..bytes.len().min(4 * LONGEST)]));
    let cut = text.chars().count() > LONGEST;
    let shown: String = text.chars().take(LONGEST).collect();
    if cut { format!("`{shown}...`") } else { format!("`{shown}`") }
}

/// The text read as UTF-8, or if it is not valid, as Latin-1, in which every byte is a character.
pub fn decoded(bytes: &[u8]) -> String {
    let latin = |_| bytes.iter().map(|&byte| char::from(byte)).collect();
    std::str::from_utf8(bytes).map_or_else(latin, str::to_owned)
}

/// The text without control characters, which a terminal would obey and XML does not allow.
pub fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_a_kind_is_told_and_the_others_are_counted() {
        let mut warnings = Warnings::default();
        warnings.in_line(3, "type", || "`a` is no type".to_owned());
        warnings.of_file("cut", || "it is cut off".to_owned());
        warnings.in_line(5, "type", || "`b` is no type".to_owned());
        let lines = warnings.lines("x.vcd");
        assert_eq!(
            lines,
            ["`x.vcd`: line 3: `a` is no type (1 more like it)", "`x.vcd`: it is cut off"]
        );
    }

    #[test]
    fn quotations_are_short_and_harmless() {
        assert_eq!(quoted(b"caf\xe9\x1b[2J"), "`caf\u{e9}\u{fffd}[2J`");
        assert_eq!(quoted(&[b'x'; 1000]), format!("`{}...`", "x".repeat(40)));
    }
}
