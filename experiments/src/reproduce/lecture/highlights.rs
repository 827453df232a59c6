//! Highlights on one facet of a cylinder: what the interpolation of intensities does to them, and of
//! normals. Eye and light are in front; the polygon's normal for a remark on its length.
use glam::DVec3;
use specula_golden::exact::formula::diffuse::gouraud;
use specula_golden::exact::formula::normalisation::unit;
use specula_golden::exact::formula::shape::power;
use specula_golden::exact::formula::slerp::slerp;
use specula_golden::exact::formula::specular::textbook;
use specula_scene::frame::EYE;

use super::super::claim::{Claim, Ruling, exact};
use super::super::maximum::largest;
use crate::stress::draw::tilted;

/// Degrees between the normals at both ends of the facet.
const FACET: f64 = 30.0;
const SHININESS: u32 = 100;

/// A facet that has its highlight somewhere.
#[derive(Clone, Copy, Debug)]
pub(in crate::reproduce) struct Facet {
    ends: [DVec3; 2],
}

impl Facet {
    /// With the highlight at `place`, from 0 at one end to 1 at the other.
    pub fn with_highlight_at(place: f64) -> Facet {
        Facet { ends: [-place, 1.0 - place].map(|share| tilted(share * FACET)) }
    }

    /// Of the surface itself, 0 to 1.
    fn exact(self, t: f64) -> f64 {
        highlight(slerp(self.ends, t))
    }

    /// Of the interpolated normal.
    pub fn phong(self, t: f64) -> f64 {
        highlight(unit(self.ends[0].lerp(self.ends[1], t)))
    }

    /// Interpolated between the ends.
    pub fn gouraud(self, t: f64) -> f64 {
        let [start, end] = self.ends.map(|normal| highlight(Some(normal)));
        gouraud([start, end, 0.0], [1.0 - t, t, 0.0])
    }

    fn error(self, shading: fn(Facet, f64) -> f64) -> f64 {
        largest(|t| (shading(self, t) - self.exact(t)).abs())
    }
}

fn highlight(normal: Option<DVec3>) -> f64 {
    normal.map_or(0.0, |normal| power(textbook(normal, EYE), SHININESS))
}

const fn sharper(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "Phong shading is considerably better for specular reflections",
        quantity,
        expected,
        measure,
        |ratio| Ruling::of(ratio < 0.5, "its highlights are as far from the surface's"),
    )
}

fn ratio(place: f64) -> f64 {
    let facet = Facet::with_highlight_at(place);
    facet.error(Facet::phong) / facet.error(Facet::gouraud)
}

/// The length of Newell's sum for a polygon of an odd outline, over twice its area, less 1.
fn newell_over_area() -> f64 {
    let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.5], [1.5, 2.0], [0.5, 1.5], [0.0, 2.0]];
    let corners = outline.map(|[x, y]| DVec3::new(x, y, x - y));
    let next = |k: usize| corners[(k + 1) % corners.len()];
    let sum: DVec3 = (0..corners.len()).map(|k| corners[k].cross(next(k))).sum();
    sum.length() / (2.0 * AREA * libm::sqrt(3.0)) - 1.0
}

/// The area of the outline in the plane, a square of 4 without two triangles of 1/8 and 3/8; the slope
/// z = x - y makes it √3 times as large.
const AREA: f64 = 3.5;

/// Claims about highlights; the numbers are from the same formulas in Python.
pub(super) const CLAIMS: [Claim; 3] = [
    sharper(
        "largest error over Gouraud's, n = 100, in the middle of 30 degrees",
        (0.015_93, 5e-6),
        || ratio(0.5),
    ),
    sharper("largest error over Gouraud's, n = 100, at an end", (0.030_94, 5e-6), || ratio(0.0)),
    exact(
        "|N| of Newell's formula is twice the polygon's area",
        "|N| over it, less 1, for a polygon that is not convex",
        (0.0, 1e-15),
        newell_over_area,
        |off| Ruling::of(off.abs() < 1e-15, "it is not"),
    ),
];

/// Gouraud's highlight in the middle of a facet that has it there, 0 to 1.
pub(in crate::reproduce) fn gouraud_in_the_middle() -> f64 {
    Facet::with_highlight_at(0.5).gouraud(0.5)
}

/// The share of a facet, with the highlight at its end, over which a shading has half of it or more.
pub(in crate::reproduce) fn half_width(shading: fn(Facet, f64) -> f64) -> f64 {
    let facet = Facet::with_highlight_at(0.0);
    largest(|t| if shading(facet, t) >= 0.5 { t } else { 0.0 })
}
