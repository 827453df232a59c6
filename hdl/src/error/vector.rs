//! What a unit knows of a vector that comes in.

/// Bounds on the lengths of a vector and on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorBounds {
    /// s: the real vector is no shorter.
    pub shortest: f64,
    /// The fixed vector is no longer.
    pub longest: f64,
    /// e: both are no further apart, as a whole.
    pub error: f64,
}

impl VectorBounds {
    /// s - e: fixed and real vector are both no shorter, where it is above 0.
    pub fn surely(self) -> f64 {
        self.shortest - self.error
    }

    /// t, how far the directions of fixed and real vector are apart, as the distance of unit
    /// vectors; for e < s.
    ///
    /// ```text
    /// |â - b̂|² = 2 - 2 â·b̂
    ///          = (|a - b|² - (|a| - |b|)²) / (|a||b|)
    ///          ≤ e² / (s (s - e))
    /// ```
    pub fn turn(self) -> f64 {
        self.error / (self.shortest * self.surely()).sqrt()
    }
}
