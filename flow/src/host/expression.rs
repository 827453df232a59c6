//! Expressions of statements, which are those of C and of Python but for names of functions.

/// A piece of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token<'t> {
    /// A function, without its `@`.
    Function(&'t str),
    /// A value.
    Name(&'t str),
    /// A number.
    Literal(&'t str),
    /// Operators, brackets, blanks.
    Other(&'t str),
}

/// The pieces of an expression, or of a text with functions in it.
pub fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut all = vec![];
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let (token, length) = if first == '@' {
            let length = 1 + leading(&rest[1..], is_word);
            (Token::Function(&rest[1..length]), length)
        } else if first.is_ascii_digit() {
            let length = leading(rest, |c| is_word(c) || c == '.');
            (Token::Literal(&rest[..length]), length)
        } else if is_word(first) {
            let length = leading(rest, is_word);
            (Token::Name(&rest[..length]), length)
        } else {
            let length = leading(rest, |c| !is_word(c) && c != '@').max(first.len_utf8());
            (Token::Other(&rest[..length]), length)
        };
        all.push(token);
        rest = &rest[length..];
    }
    all
}

/// Bytes of the characters at the beginning of a text that are such.
fn leading(text: &str, is_such: impl Fn(char) -> bool) -> usize {
    text.find(|c| !is_such(c)).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_come_apart() {
        use Token::{Function, Literal, Name, Other};
        let text = "@dot(a_1, b)*0.25 - c[2]";
        let expected = [
            Function("dot"),
            Other("("),
            Name("a_1"),
            Other(", "),
            Name("b"),
            Other(")*"),
            Literal("0.25"),
            Other(" - "),
            Name("c"),
            Other("["),
            Literal("2"),
            Other("]"),
        ];
        assert_eq!(tokens(text), expected);
    }
}
