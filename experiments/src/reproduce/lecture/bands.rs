//! Mach bands: intensity and its slope across the facets of a cylinder.
use glam::DVec3;
use specula_golden::exact::formula::diffuse::{gouraud, lambert};
use specula_golden::exact::formula::normalisation::unit;
use specula_spec::FULL_SCALE;

use super::super::claim::{Claim, Ruling, exact};
use super::super::figure::{Figure, FigureCurve};
use crate::stress::draw::tilted;

/// Degrees of the cylinder's edges, seen from the front.
const EDGES: [f64; 4] = [-45.0, -15.0, 15.0, 45.0];
/// Degrees from the eye to the light.
const LIGHT: f64 = 20.0;

/// The way a facet is shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shading {
    Uniform,
    Gouraud,
    Phong,
}

impl Shading {
    const ALL: [Shading; 3] = [Shading::Uniform, Shading::Gouraud, Shading::Phong];

    const fn name(self) -> &'static str {
        match self {
            Shading::Uniform => "uniform",
            Shading::Gouraud => "Gouraud",
            Shading::Phong => "Phong",
        }
    }

    /// The intensity at column `x` of facet number `facet`, 0 to 1.
    fn at(self, facet: usize, x: f64) -> f64 {
        let light = tilted(LIGHT);
        let ends = [EDGES[facet], EDGES[facet + 1]].map(tilted);
        let t = (x - ends[0].x) / (ends[1].x - ends[0].x);
        let or_none = |normal: Option<DVec3>| normal.map_or(0.0, |normal| lambert(normal, light));
        match self {
            Shading::Uniform => or_none(unit(ends[0] + ends[1])),
            Shading::Gouraud => {
                let [start, end] = ends.map(|normal| lambert(normal, light));
                gouraud([start, end, 0.0], [1.0 - t, t, 0.0])
            }
            Shading::Phong => or_none(unit(ends[0].lerp(ends[1], t))),
        }
    }

    /// The change of intensity with each unit of `x`, in the facet.
    fn slope(self, facet: usize, x: f64) -> f64 {
        (self.at(facet, x + STEP) - self.at(facet, x - STEP)) / (2.0 * STEP)
    }
}

/// The radius of difference quotients: half of a double's digits.
const STEP: f64 = 1e-6;

/// The column of an edge.
fn column(edge: usize) -> f64 {
    tilted(EDGES[edge]).x
}

/// The jump of a quantity of both facets at an edge between them.
fn jump_at(edge: usize, of: fn(Shading, usize, f64) -> f64, shading: Shading) -> f64 {
    (of(shading, edge, column(edge)) - of(shading, edge - 1, column(edge))).abs()
}

/// The larger jump of the two edges, which are 35 degrees from the light and 5.
fn jump(of: fn(Shading, usize, f64) -> f64, shading: Shading) -> f64 {
    f64::max(jump_at(1, of, shading), jump_at(2, of, shading))
}

const BLURRED: &str =
    "interpolation along scan lines takes away jumps of intensity at edges (Mach bands)";
const FEWER: &str = "Gouraud shading tends to more Mach bands than Phong shading (Hast, §1)";

const fn at_edge(quantity: &'static str, lsb: f64, measure: fn() -> f64) -> Claim {
    exact(BLURRED, quantity, (lsb, 5e-4), measure, |lsb| {
        Ruling::of(lsb < 0.5, "there is a step, which uniform shading does not blur")
    })
}

const fn of_slope(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(FEWER, quantity, expected, measure, |ratio| {
        Ruling::of(ratio < 0.5, "the slope of Phong shading jumps by as much")
    })
}

/// The jump of Phong shading's slope at an edge, over that of Gouraud shading's.
fn ratio_of_slopes(edge: usize) -> f64 {
    let of = |shading| jump_at(edge, Shading::slope, shading);
    of(Shading::Phong) / of(Shading::Gouraud)
}

/// Claims about the bands; the numbers are from the formulas of a cylinder, in Python.
pub const CLAIMS: [Claim; 5] = [
    exact(
        "uniform shading has steps of intensity at edges (Mach bands)",
        "largest jump at an edge in LSB, uniform",
        (75.7108, 5e-4),
        || FULL_SCALE * jump(Shading::at, Shading::Uniform),
        |lsb| Ruling::of(lsb >= 0.5, "there is none"),
    ),
    at_edge("largest jump at an edge in LSB, Gouraud", 0.0, || {
        FULL_SCALE * jump(Shading::at, Shading::Gouraud)
    }),
    at_edge("largest jump at an edge in LSB, Phong", 0.0, || {
        FULL_SCALE * jump(Shading::at, Shading::Phong)
    }),
    of_slope(
        "jump of the slope, Phong's over Gouraud's, edge 35 degrees from the light",
        (0.157_98, 5e-6),
        || ratio_of_slopes(1),
    ),
    of_slope("the same, edge 5 degrees from the light", (0.024_01, 5e-6), || ratio_of_slopes(2)),
];

/// Intensity and its slope across three facets.
pub fn figures() -> Vec<Figure> {
    let x = "distance from the cylinder's middle in radii; edges at -0.26 and 0.26";
    vec![
        Figure {
            name: "lecture_bands",
            title: "Mach bands: intensity across the facets of a cylinder".to_owned(),
            x,
            y: "intensity in LSB",
            curves: curves(|shading, facet, x| FULL_SCALE * shading.at(facet, x)),
            notes: vec!["Facets of 30 degrees, the light 20 degrees to the right.".to_owned()],
        },
        Figure {
            name: "lecture_band_slopes",
            title: "Mach bands: the slope of intensity across the same facets".to_owned(),
            x,
            y: "slope in LSB for each hundredth of a radius",
            curves: curves(|shading, facet, x| FULL_SCALE / 100.0 * shading.slope(facet, x)),
            notes: vec![
                "Where a slope jumps the eye sees a band, though no step is left.".to_owned(),
            ],
        },
    ]
}

/// A curve for each shading and facet, since a jump is no line; the name stands at the last.
fn curves(of: impl Fn(Shading, usize, f64) -> f64 + Copy) -> Vec<FigureCurve> {
    let facets = || 0..EDGES.len() - 1;
    let named = |(colour, shading): (usize, Shading)| {
        facets().map(move |facet| {
            let within = (column(facet), column(facet + 1));
            let curve = FigureCurve::formula(shading.name(), colour, within, 0.5, |x| {
                of(shading, facet, x)
            });
            FigureCurve { label: curve.label.filter(|_| facet == colour), ..curve }
        })
    };
    Shading::ALL.into_iter().enumerate().flat_map(named).collect()
}
