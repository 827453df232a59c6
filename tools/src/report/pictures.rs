//! The file names of a run's pictures, which reports show.

/// The core's picture.
pub const SIMULATED: &str = "simulated.png";
/// The bit-true model's picture.
pub const EXPECTED: &str = "expected.png";
/// The picture of exact Phong shading.
pub const EXACT: &str = "exact.png";
/// The total error of each pixel, as a heat map with its scale.
pub const ERROR: &str = "error.png";

/// A picture that can be laid over another one in the page.
pub struct LayeredPicture {
    /// Its title in the page.
    pub name: &'static str,
    /// Its file name.
    pub file: &'static str,
    /// A sentence that describes it.
    pub description: &'static str,
}

/// The pictures in the page's order.
pub const LAYERED_PICTURES: [LayeredPicture; 3] = [
    LayeredPicture { name: "simulated", file: SIMULATED, description: "what the core gave" },
    LayeredPicture {
        name: "expected",
        file: EXPECTED,
        description: "what the bit-true model gives",
    },
    LayeredPicture { name: "exact", file: EXACT, description: "exact Phong shading" },
];
