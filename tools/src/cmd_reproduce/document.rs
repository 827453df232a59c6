//! The whole document.
use super::section::Section;

/// Name of the file with the text.
pub const NAME: &str = "reproduction.md";
/// How it begins.
pub const HEAD: &str = "\
# What the papers claim and show

Written by `specula reproduce`. *On* says what was measured: `f64` is exact shading, `core` is hardware, by the bit-true model that the
simulated core equals on every pixel, or by the simulated core. *Before* is the project's independent measurement (docs/numerics.md); the
tests compare. LSB is 1/255 of full scale.

";

/// The sections, preceded by what is common to them.
pub fn text(sections: &[Section]) -> String {
    let body: String = sections.iter().map(|section| section.text.as_str()).collect();
    format!("{HEAD}{}\n", body.trim_end())
}
