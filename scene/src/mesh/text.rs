//! Text of mesh files: whatever its encoding and line ends.
use std::borrow::Cow;

/// The bytes of a text without a byte order mark; UTF-16, which is known by its mark, becomes UTF-8.
pub(super) fn unmarked(bytes: &[u8]) -> Cow<'_, [u8]> {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_be_bytes)),
        _ => Cow::Borrowed(bytes),
    }
}

fn from_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let units = bytes.as_chunks::<2>().0.iter().map(|&pair| unit(pair));
    let characters = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
    characters.collect::<String>().into_bytes()
}

/// Lines without their ends, which are LF, CR LF or CR alone.
pub(super) fn lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(text).filter(|text| !text.is_empty());
    std::iter::from_fn(move || {
        let text = rest?;
        let end = text.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(text.len());
        let behind = match &text[end..] {
            [b'\r', b'\n', behind @ ..] | [_, behind @ ..] => behind,
            [] => &[],
        };
        rest = Some(behind).filter(|behind| !behind.is_empty());
        Some(&text[..end])
    })
}

/// Words of a line, with blanks or control characters between them.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|&b| is_blank(b)).filter(|word| !word.is_empty())
}

/// Whether a byte stands between words: a blank or a control character.
pub(super) fn is_blank(byte: u8) -> bool {
    byte <= b' '
}

/// A word as a decimal number, which may also be `inf` or `nan`.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_left_out() {
        let utf16 = |mark: [u8; 2], bytes: fn(u16) -> [u8; 2]| [&mark[..], &"v \u{e9}".encode_utf16().flat_map(bytes).collect::<Vec<u8>>()].concat();
        for bytes in [
            "v \u{e9}".as_bytes().to_vec(),
            [b"\xef\xbb\xbf", "v \u{e9}".as_bytes()].concat(),
            utf16([0xff, 0xfe], u16::to_le_bytes),
            utf16([0xfe, 0xff], u16::to_be_bytes),
        ] {
            assert_eq!(unmarked(&bytes), "v \u{e9}".as_bytes());
        }
    }

    #[test]
    fn every_line_end_ends_one_line() {
        let all = |text: &'static [u8]| lines(text).map(|line| str::from_utf8(line).unwrap_or_default()).collect::<Vec<_>>();
        for text in [b"a b\n\nc\n".as_slice(), b"a b\r\n\r\nc\r\n", b"a b\r\rc\r", b"a b\n\nc"] {
            assert_eq!(all(text), ["a b", "", "c"]);
        }
        assert_eq!(all(b"").len(), 0);
        assert_eq!(words(b" a\tb\0c  ").collect::<Vec<_>>(), [b"a", b"b", b"c"]);
    }
}
