//! What there is of Lyon's beside claims and plots.
use super::section::Section;

/// Adds it.
pub fn add(section: &mut Section) {
    section.paragraph(
        "Figure 9, the twelve formulations on five spheres, is the scene of [the built-in `spheres`](../scenes/spheres.toml); \
         `experiments/src/figure9.rs` adds its picture up.",
    );
}
