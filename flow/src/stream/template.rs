//! Texts with places that are filled in: Verilog and documents that are written by hand.
//!
//! `@NAME@` is a value. A line that begins with `?flag|` is there where the flag holds, one that
//! begins with `!flag|` where it does not.
use std::collections::BTreeMap;

/// What is filled in.
#[derive(Clone, Debug, Default)]
pub struct Values {
    texts: BTreeMap<&'static str, String>,
    flags: BTreeMap<&'static str, bool>,
}

impl Values {
    /// Sets a value.
    pub fn set(&mut self, name: &'static str, value: impl ToString) {
        self.texts.insert(name, value.to_string());
    }

    /// Sets a flag.
    pub fn flag(&mut self, name: &'static str, holds: bool) {
        self.flags.insert(name, holds);
    }

    /// The text of a template. Of several blank lines in a row one is left, unless the template has
    /// them so.
    pub fn fill(&self, template: &str) -> String {
        let mut text = String::new();
        let mut before = "";
        for line in template.lines() {
            let is_meant = line.is_empty() && before.is_empty();
            before = line;
            let Some(filled) = self.kept(line).map(|line| self.filled(line)) else { continue };
            if is_meant || !(filled.trim().is_empty() && text.ends_with("\n\n")) {
                text.push_str(filled.trim_end());
                text.push('\n');
            }
        }
        text
    }

    /// A line without its condition, if that holds.
    fn kept<'t>(&self, line: &'t str) -> Option<&'t str> {
        for (name, &holds) in &self.flags {
            for (mark, wanted) in [('?', true), ('!', false)] {
                let rest = line.strip_prefix(mark).and_then(|rest| rest.strip_prefix(name));
                if let Some(rest) = rest.and_then(|rest| rest.strip_prefix('|')) {
                    return (holds == wanted).then_some(rest);
                }
            }
        }
        Some(line)
    }

    fn filled(&self, line: &str) -> String {
        let fill = |text: String, (name, value): (&&str, &String)| {
            text.replace(&format!("@{name}@"), value)
        };
        self.texts.iter().fold(line.to_owned(), fill)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_kept_by_flags_and_values_filled_in() {
        let mut values = Values::default();
        values.set("A", "one");
        values.set("AB", 2);
        values.flag("x", true);
        values.flag("y", false);
        let template = "@A@ @AB@ @C@\n?x|  in\n!x|out\n?y|out\n!y|in @A@\n\n?y|\n\nend\n\n\n";
        assert_eq!(values.fill(template), "one 2 @C@\n  in\nin one\n\nend\n\n\n");
    }
}
