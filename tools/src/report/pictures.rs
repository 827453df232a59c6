//! Names of the pictures of a run, which reports show.

/// The picture that the core gave.
pub const SIMULATED: &str = "simulated.png";
/// The picture that the bit-true model gives.
pub const EXPECTED: &str = "expected.png";
/// Exact Phong shading.
pub const EXACT: &str = "exact.png";
/// The total error of each pixel, as a heat map with its scale.
pub const ERROR: &str = "error.png";

/// A picture that the page lays over another one.
pub struct Shown {
    /// Its name in the page.
    pub name: &'static str,
    /// Its file.
    pub file: &'static str,
    /// Its meaning.
    pub about: &'static str,
}

/// Pictures of the frame in the page's order.
pub const SHOWN: [Shown; 3] = [
    Shown { name: "simulated", file: SIMULATED, about: "what the core gave" },
    Shown { name: "expected", file: EXPECTED, about: "what the bit-true model gives" },
    Shown { name: "exact", file: EXACT, about: "exact Phong shading" },
];
