//! Limits of a picture's size.

/// Largest width or height in pixels.
pub const LONGEST_SIDE: u32 = 8192;

/// Largest number of pixels; a square with the longest side is just within it.
pub const MAX_PIXELS: u64 = 64 << 20;

/// Whether a picture of that size can be made.
pub fn is_allowed((width, height): (u32, u32)) -> bool {
    let side = 1..=LONGEST_SIDE;
    side.contains(&width)
        && side.contains(&height)
        && u64::from(width) * u64::from(height) <= MAX_PIXELS
}

/// The limits as text.
pub fn described() -> String {
    format!("width and height are 1 to {LONGEST_SIDE} pixels, and at most {MAX_PIXELS} in all")
}
