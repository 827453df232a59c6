//! Pieces of text.

/// The longest line of generated code that is broken at blanks.
const LONGEST_LINE: usize = 100;

/// A text as a comment: the first line begins with `first`, the others with `next`, and the last
/// ends with `end`.
pub fn commented(text: &str, first: &str, next: &str, end: &str) -> String {
    let mut lines = vec![first.to_owned()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().map(|line| line.len()).unwrap_or_default();
        let begins = lines.last().is_some_and(|line| line == first || line == next);
        if !begins && line + 1 + word.len() + end.len() > LONGEST_LINE {
            lines.push(next.to_owned());
        } else if !begins {
            push(&mut lines, " ");
        }
        push(&mut lines, word);
    }
    push(&mut lines, end);
    lines.join("\n")
}

fn push(lines: &mut [String], text: &str) {
    if let Some(line) = lines.last_mut() {
        line.push_str(text);
    }
}

/// Pieces of code with a blank line between those that have any.
pub fn joined(pieces: [String; 3]) -> String {
    let pieces: Vec<String> = pieces.into_iter().filter(|piece| !piece.is_empty()).collect();
    pieces.join("\n")
}
