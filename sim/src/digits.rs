//! Binary digits.

/// The digits of every byte.
pub const OF_BYTE: [[u8; 8]; 256] = of_bytes();

const fn of_bytes() -> [[u8; 8]; 256] {
    let mut digits = [[b'0'; 8]; 256];
    let mut at = 0;
    while at < 256 * 8 {
        let (byte, digit) = (at / 8, at % 8);
        digits[byte][digit] += (byte >> (7 - digit) & 1) as u8;
        at += 1;
    }
    digits
}

/// The digits of a value of 64 bits, the leftmost first.
pub fn of(value: i64) -> [u8; 64] {
    let mut digits = [0; 64];
    for (place, byte) in digits.as_chunks_mut().0.iter_mut().zip(value.to_be_bytes()) {
        *place = OF_BYTE[usize::from(byte)];
    }
    digits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_of_the_value() {
        for value in [0, 1, -1, 0x0123_4567_89AB_CDEF, i64::MIN, i64::MAX] {
            assert_eq!(String::from_utf8_lossy(&of(value)), format!("{value:064b}"));
        }
    }
}
