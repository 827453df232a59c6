//! What is reproduced of Lyon's report besides claims and plots.
use super::section::Section;

/// Adds it.
pub fn add(section: &mut Section) {
    section.paragraph(
        "`specula reproduce figure9` shades figure 9, the twelve formulations on five spheres, with a core for each row: [figure9.md](figure9.md).",
    );
}
