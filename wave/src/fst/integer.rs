//! Integers as FST files have them.
use std::io::{self, Read};

use super::check::wrong;

/// Eight bytes, the highest first.
///
/// # Errors
/// What the system says.
pub fn number(input: &mut impl Read) -> io::Result<u64> {
    let mut bytes = [0; 8];
    input.read_exact(&mut bytes)?;
    Ok(u64::from_be_bytes(bytes))
}

/// A number in bytes of seven bits, the lowest first; the eighth says that more follow.
///
/// # Errors
/// If it has no end, or what the system says.
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

/// The same, of which the highest bit counts negative.
///
/// # Errors
/// If it has no end, or what the system says.
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
