//! Text values, in which blanks and control characters are escaped as in C.

/// The text without escapes such as `\n`, `\040`, `\x20`, `\'`, which `fst2vcd` and GTKWave write.
pub fn unescaped(text: &[u8]) -> Vec<u8> {
    let (mut plain, mut rest) = (Vec::with_capacity(text.len()), text);
    while let Some((&byte, behind)) = rest.split_first() {
        let escape = if byte == b'\\' { escape(behind) } else { None };
        let (byte, length) = escape.unwrap_or((byte, 0));
        plain.push(byte);
        rest = &behind[length..];
    }
    plain
}

/// The byte that an escape stands for, and the length of the escape without its backslash.
fn escape(behind: &[u8]) -> Option<(u8, usize)> {
    let digits = |from: usize, radix: u32, length: usize| {
        let text = std::str::from_utf8(behind.get(from..from + length)?).ok()?;
        u8::from_str_radix(text, radix).ok().map(|byte| (byte, from + length))
    };
    match behind.first()? {
        b'x' => digits(1, 16, 2),
        b'0'..=b'3' => digits(0, 8, 3),
        b'n' => Some((b'\n', 1)),
        b't' => Some((b'\t', 1)),
        b'r' => Some((b'\r', 1)),
        &byte @ (b'\\' | b'\'' | b'"' | b'?') => Some((byte, 1)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_are_undone_and_other_backslashes_stay() {
        let cases = [
            ("IDLE", "IDLE"),
            ("\\'a\\'", "'a'"),
            ("two\\040words", "two words"),
            ("two\\x20words", "two words"),
            ("\\\\n", "\\n"),
            ("C:\\dir", "C:\\dir"),
            ("\\", "\\"),
            ("\\x2", "\\x2"),
            ("\\+1", "\\+1"),
        ];
        for (text, plain) in cases {
            assert_eq!(unescaped(text.as_bytes()), plain.as_bytes(), "{text}");
        }
    }
}
