//! What Gouraud shading does to highlights (section 1).
use specula_spec::FULL_SCALE;

use super::super::claim::{Claim, Ruling, exact};
use super::super::lecture::highlights::{Facet, gouraud_in_the_middle, half_width};

/// The numbers are from the same formulas in Python.
pub(super) const CLAIMS: [Claim; 2] = [
    exact(
        "with Gouraud shading a highlight inside a polygon is not seen at all",
        "its height in LSB, 255 on the surface, n = 100, in the middle of 30 degrees",
        (0.000_144, 5e-7),
        || FULL_SCALE * gouraud_in_the_middle(),
        |lsb| Ruling::of(lsb < 0.5, "it is"),
    ),
    exact(
        "and one close to a vertex is smeared out",
        "its width at half its height, over that of Phong shading",
        (4.31, 5e-3),
        || half_width(Facet::gouraud) / half_width(Facet::phong),
        |ratio| Ruling::of(ratio > 1.0, "it is no wider"),
    ),
];
