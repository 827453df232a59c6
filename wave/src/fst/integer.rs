//! Integers as FST files encode them.
use std::io::{self, Read};

use super::error::wrong;

/// Reads an integer of eight bytes, the most significant first.
///
/// # Errors
/// The operating system's error.
pub fn number(input: &mut impl Read) -> io::Result<u64> {
    let mut bytes = [0; 8];
    input.read_exact(&mut bytes)?;
    Ok(u64::from_be_bytes(bytes))
}

/// Reads an integer in groups of seven bits, the least significant first; the eighth bit of a byte
/// says that more follow.
///
/// # Errors
/// An integer without an end, or the operating system's error.
pub fn variable(input: &mut impl Read) -> io::Result<u64> {
    let mut number = 0;
    for shift in (0..64).step_by(7) {
        let byte = byte(input)?;
        number |= u64::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            return Ok(number);
        }
    }
    Err(wrong("a number in it has no end"))
}

/// Reads a signed integer in the same encoding: the highest bit counts negative.
///
/// # Errors
/// An integer without an end, or the operating system's error.
pub fn signed(input: &mut impl Read) -> io::Result<i64> {
    let mut number = 0;
    for shift in (0..64).step_by(7) {
        let byte = byte(input)?;
        number |= i64::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            let above = 64 - (shift + 7).min(64);
            return Ok(number << above >> above);
        }
    }
    Err(wrong("a number in it has no end"))
}

fn byte(input: &mut impl Read) -> io::Result<u8> {
    let mut byte = [0];
    input.read_exact(&mut byte)?;
    Ok(byte[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_seven_bits_each() {
        assert_eq!(variable(&mut [0x7f].as_slice()).ok(), Some(127));
        assert_eq!(variable(&mut [0x80, 0x01].as_slice()).ok(), Some(128));
        assert_eq!(signed(&mut [0x13].as_slice()).ok(), Some(19));
        assert_eq!(signed(&mut [0x7b].as_slice()).ok(), Some(-5));
        assert_eq!(signed(&mut [0x80, 0x01].as_slice()).ok(), Some(128));
        assert!(
            variable(&mut [0xff; 11].as_slice()).is_err()
                && signed(&mut [0xff].as_slice()).is_err()
        );
    }
}
