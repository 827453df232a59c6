//! How large a picture may be.

/// The most pixels across or down.
pub const LONGEST_SIDE: u32 = 8192;

/// The most pixels in all; a full square of the longest side is just within it.
pub const MOST_PIXELS: u64 = 64 << 20;

/// Whether a picture of that size can be made.
pub fn is_allowed((width, height): (u32, u32)) -> bool {
    let side = 1..=LONGEST_SIDE;
    side.contains(&width)
        && side.contains(&height)
        && u64::from(width) * u64::from(height) <= MOST_PIXELS
}

/// The limits in words.
pub fn described() -> String {
    format!("width and height are 1 to {LONGEST_SIDE} pixels, and at most {MOST_PIXELS} in all")
}
