//! The line that says what a variable has become: `b` with the value's bits, a blank and the variable's code, or for a single bit the
//! bit and the code.
use crate::digits;

/// Room that must be there for a line to be made in.
pub const ROOM: usize = 80;

/// How a variable's lines are made.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    width: u32,
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

    /// Puts the line that says `value` to the beginning of `room`, and gives its length; the rest of the room is spoilt.
    ///
    /// Zeros on the left are left out: readers put them back, as a value that is short is extended by zeros if it begins with a digit
    /// [IEEE 1364-2005, table 18-1]. Ones on the left must stay.
    #[inline]
    pub fn write(&self, value: i64, room: &mut [u8; ROOM]) -> usize {
        room[0] = b'b';
        let begin = usize::from(self.width > 1);
        // The value's bits at the top, so that the digits come from the left.
        let bits = (value as u64) << (64 - self.width);
        let left_out = bits.leading_zeros().min(self.width - 1);
        let bits = (bits << left_out).to_be_bytes();
        let mut put = |byte: usize| room[begin + 8 * byte..][..8].copy_from_slice(&digits::OF_BYTE[usize::from(bits[byte])]);
        // Half of the digits are always made: making only those that are wanted costs more in mispredicted branches.
        (0..4).for_each(&mut put);
        if self.width > 32 {
            (4..8).for_each(put);
        }
        let end = begin + (self.width - left_out) as usize;
        room[end..end + 8].copy_from_slice(&self.tail);
        end + usize::from(self.tail_length)
    }
}

/// The code of a variable: up to five printable characters, the shortest first.
pub fn code(number: u32) -> String {
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
        let length = Record::new(width, "~~~~~").write(value, &mut room);
        String::from_utf8_lossy(&room[..length]).into_owned()
    }

    #[test]
    fn lines_say_the_value_without_zeros_on_the_left() {
        assert_eq!((line(1, 0), line(1, 1), line(1, -1)), ("0~~~~~\n".into(), "1~~~~~\n".into(), "1~~~~~\n".into()));
        assert_eq!((line(2, 0), line(8, 0x25)), ("b0 ~~~~~\n".into(), "b100101 ~~~~~\n".into()));
        assert_eq!((line(8, -1), line(8, -128)), ("b11111111 ~~~~~\n".into(), "b10000000 ~~~~~\n".into()));
        for width in [31, 32, 33, 40, 63, 64] {
            let highest = i64::MAX >> (64 - width);
            assert_eq!(line(width, highest), format!("b{highest:b} ~~~~~\n"));
            assert_eq!(line(width, -2), format!("b{}0 ~~~~~\n", "1".repeat(width as usize - 1)));
            assert_eq!(line(width, i64::MIN >> (64 - width)), format!("b1{} ~~~~~\n", "0".repeat(width as usize - 1)));
        }
    }

    #[test]
    fn codes_differ_and_fit() {
        let numbers = (0..20_000).chain([u32::MAX - 1, u32::MAX]);
        let codes: HashSet<String> = numbers.map(code).collect();
        assert_eq!(codes.len(), 20_002);
        assert!(codes.iter().all(|code| code.len() <= 5 && code.bytes().all(|byte| byte.is_ascii_graphic())));
        assert_eq!([0, 93, 94, 94 + 94 * 94].map(code), ["!", "~", "!!", "!!!"]);
    }
}
