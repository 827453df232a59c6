//! The line that says what a variable has become: `b` with the value's bits, a blank and the
//! variable's code, or for a single bit the bit and the code.
use crate::digits;

/// Room that must be there for a line to be made in.
pub const ROOM: usize = 80;

/// How a variable's lines are made.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Bits of a value.
    pub width: u32,
    /// What comes behind the bits, and its length.
    tail: [u8; 8],
    tail_length: u8,
}

impl Record {
    /// A variable of so many bits, up to 64, with this [`code`].
    pub fn new(width: u32, code: &str) -> Record {
        let text = if width > 1 { format!(" {code}\n") } else { format!("{code}\n") };
        let mut tail = [0; 8];
        tail.iter_mut().zip(text.bytes()).for_each(|(place, byte)| *place = byte);
        Record { width, tail, tail_length: text.len() as u8 }
    }

    /// Bytes of its longest line.
    pub fn longest(&self) -> usize {
        usize::from(self.width > 1) + self.width as usize + usize::from(self.tail_length)
    }

    /// The line of a single bit, as [`vector`](Record::vector) makes one of many.
    #[inline(always)]
    pub fn bit(&self, value: i64, room: &mut [u8; ROOM]) -> usize {
        room[0] = b'0' + (value & 1) as u8;
        room[1..9].copy_from_slice(&self.tail);
        1 + usize::from(self.tail_length)
    }

    /// Puts the line that says `value` to the beginning of `room`, and gives its length; the rest
    /// of the room is spoilt. The value has at least 2 bits and at most `BYTES` bytes.
    ///
    /// Zeros on the left are left out: readers put them back, as a value that is short is extended
    /// by zeros if it begins with a digit [IEEE 1364-2005, table 18-1]. Ones on the left must stay.
    #[inline(always)]
    pub fn vector<const BYTES: usize>(&self, value: i64, room: &mut [u8; ROOM]) -> usize {
        room[0] = b'b';
        // The value's bits at the top, so that the digits come from the left; the last of them
        // stays, whatever it is.
        let bits = (value as u64) << (64 - self.width);
        let left_out = (bits | 1 << (64 - self.width)).leading_zeros();
        let bits = (bits << left_out).to_be_bytes();
        // All digits are made, wanted or not: to make only some costs more, in branches that are
        // not foreseen.
        for (place, &byte) in room[1..].chunks_exact_mut(8).zip(&bits[..BYTES]) {
            place.copy_from_slice(&digits::OF_BYTE[usize::from(byte)]);
        }
        let end = 1 + (self.width - left_out) as usize;
        room[end..end + 8].copy_from_slice(&self.tail);
        end + usize::from(self.tail_length)
    }
}

/// The code of a variable: printable characters, the shortest first; up to five, as numbers of
/// signals have 32 bits.
pub fn code(number: usize) -> String {
    let mut code = String::new();
    let mut rest = Some(number);
    while let Some(number) = rest {
        code.push(char::from(b'!' + (number % 94) as u8));
        rest = (number / 94).checked_sub(1);
    }
    code
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    fn line(width: u32, value: i64) -> String {
        let mut room = [0; ROOM];
        let record = Record::new(width, "~~~~~");
        let length = match width {
            1 => record.bit(value, &mut room),
            2..=32 => record.vector::<4>(value, &mut room),
            _ => record.vector::<8>(value, &mut room),
        };
        String::from_utf8_lossy(&room[..length]).into_owned()
    }

    #[test]
    fn lines_say_the_value_without_zeros_on_the_left() {
        assert_eq!(
            (line(1, 0), line(1, 1), line(1, -1)),
            ("0~~~~~\n".into(), "1~~~~~\n".into(), "1~~~~~\n".into())
        );
        assert_eq!((line(2, 0), line(8, 0x25)), ("b0 ~~~~~\n".into(), "b100101 ~~~~~\n".into()));
        assert_eq!(
            (line(8, -1), line(8, -128)),
            ("b11111111 ~~~~~\n".into(), "b10000000 ~~~~~\n".into())
        );
        for width in [31, 32, 33, 40, 63, 64] {
            let highest = i64::MAX >> (64 - width);
            assert_eq!(line(width, highest), format!("b{highest:b} ~~~~~\n"));
            assert_eq!(line(width, -2), format!("b{}0 ~~~~~\n", "1".repeat(width as usize - 1)));
            assert_eq!(
                line(width, i64::MIN >> (64 - width)),
                format!("b1{} ~~~~~\n", "0".repeat(width as usize - 1))
            );
        }
    }

    #[test]
    fn codes_differ_and_fit() {
        let numbers = (0..20_000).chain([0xFFFF_FFFE, 0xFFFF_FFFF]);
        let codes: HashSet<String> = numbers.map(code).collect();
        assert_eq!(codes.len(), 20_002);
        assert!(
            codes
                .iter()
                .all(|code| code.len() <= 5 && code.bytes().all(|byte| byte.is_ascii_graphic()))
        );
        assert_eq!([0, 93, 94, 94 + 94 * 94].map(code), ["!", "~", "!!", "!!!"]);
    }
}
