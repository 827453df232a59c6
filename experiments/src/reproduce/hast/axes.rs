//! What normals are wrapped around: the polygon's normal, or L or V, of which the paper warns.
use glam::DVec3;
use specula_golden::exact::PhongSpan;
use specula_golden::exact::formula::wrap::wrap;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};
use specula_testbench::{ErrorFigures, Image};

use super::super::angle::angle_between;
use super::super::claim::{Claim, HALF_LSB, Ruling, exact};
use super::super::differences::{self, differences};
use super::super::painted::{painted, rounded};
use crate::stress::draw::tilted;

/// The angle in degrees by which the normal in the middle of a span of `span` degrees is wrong, if
/// it is wrapped around a unit vector that is `aside` degrees from it.
fn wrong(span: f64, aside: f64) -> f64 {
    let length = libm::cos(span.to_radians() / 2.0);
    let wrapped = wrap(tilted(aside), length * DVec3::Z);
    wrapped.map_or(180.0, |n| angle_between(n, DVec3::Z).to_degrees())
}

const fn bad(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "L or V as n is a bad choice where n + N comes close to 0 (more than half an LSB)",
        quantity,
        expected,
        measure,
        |degrees| Ruling::of(degrees.to_radians() > HALF_LSB, "it is as good as any"),
    )
}

/// Claims about L or V as n. The numbers are θ - 2 atan2(l sin θ, 1 + l cos θ) in Python; those of
/// 90 degrees are also in numerics N2b.
pub(in crate::reproduce) const CLAIMS: [Claim; 6] = [
    bad("degrees off, span of 10, L 90 degrees from N", (0.218_44, 5e-6), || wrong(10.0, 90.0)),
    bad("degrees off, span of 30, L 90 degrees from N", (1.985_95, 5e-6), || wrong(30.0, 90.0)),
    bad("degrees off, span of 90, L 90 degrees from N", (19.471_22, 5e-6), || wrong(90.0, 90.0)),
    bad("degrees off, span of 30, L 150 degrees from N", (7.402_08, 5e-6), || wrong(30.0, 150.0)),
    bad("degrees off, span of 30, L 170 degrees from N", (22.411_54, 5e-6), || wrong(30.0, 170.0)),
    bad("degrees off, span of 30, L 179 degrees from N", (126.549_41, 5e-6), || wrong(30.0, 179.0)),
];

/// What normals are wrapped around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The polygon's normal.
    Face,
    /// The direction to the first light.
    Light,
    /// The direction to the eye.
    Eye,
}

impl Axis {
    /// All of them.
    pub const ALL: [Axis; 3] = [Axis::Face, Axis::Light, Axis::Eye];

    /// The name in tables and pictures.
    pub const fn name(self) -> &'static str {
        match self {
            Axis::Face => "n = the polygon's normal",
            Axis::Light => "n = L",
            Axis::Eye => "n = V",
        }
    }

    fn of(self, frame: &Frame, span: &Span) -> DVec3 {
        match self {
            Axis::Face => frame.facet_normal(span),
            Axis::Light => frame.lights.first().map_or(EYE, |light| light.direction),
            Axis::Eye => EYE,
        }
    }
}

/// A frame shaded in f64 with normals wrapped around an axis, and its error against exact Phong
/// shading.
pub fn wrapped_picture(frame: &Frame, axis: Axis) -> (Image, ErrorFigures) {
    let colour = |span: &Span, i: u32| {
        let normal = frame.normal_at(span, span.weights(i));
        let phong = PhongSpan::new(frame, span);
        let wrapped = wrap(axis.of(frame, span), normal);
        wrapped.map_or_else(|| phong.pixel(i), |normal| phong.pixel_with(normal, i))
    };
    let image = painted(frame, |span, i| rounded(colour(span, i)));
    let error = differences(frame, |span| {
        let wrapped = (0..span.length).map(|i| colour(span, i)).collect();
        [differences::exact(frame, span), wrapped]
    });
    (image, error)
}
