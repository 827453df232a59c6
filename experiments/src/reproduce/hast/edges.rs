//! Normals along edges: interpolated without normalisation, as the hybrid and Duff's scheme have
//! them, and by reflection, as figure 3 has them.
use glam::DVec3;
use specula_golden::exact::PhongSpan;
use specula_golden::exact::formula::quadratic::Quadratic;
use specula_golden::exact::formula::wrap::wrap;
use specula_golden::loops::{Linear, Second};
use specula_scene::{Frame, Span};
use specula_testbench::ErrorFigures;

use super::super::claim::{Claim, Ruling, exact};
use super::super::differences::differences;
use super::super::stepped::{largest_off, small};

/// The largest difference between q = N·N by second differences of normals that are stepped along
/// edges, and that of weights.
fn duffs_square(frame: &Frame) -> f64 {
    largest_off(frame, |normal| normal.to_array(), |span, along| square_off(frame, span, along))
}

fn square_off(frame: &Frame, span: &Span, mut along: [Linear<f64>; 3]) -> f64 {
    let mut normal = || DVec3::from_array(along.each_mut().map(Linear::pixel));
    let (first, second) = (normal(), normal());
    let mut square = Second::<f64>::new(Quadratic::square(first, second - first));
    let of_pixel =
        |i: u32| square.pixel() - frame.normal_at(span, span.weights(i)).length_squared();
    (0..span.length).map(of_pixel).fold(0.0, |off, here| f64::max(off, here.abs()))
}

/// What it changes to wrap the normals along edges too, before those between them: figure 3, whose
/// normals are wrapped around the polygon's.
fn wrapped_edges(frame: &Frame) -> ErrorFigures {
    differences(frame, |span| {
        let phong = PhongSpan::new(frame, span);
        [frame.unit_end_normals(span), wrapped_ends(frame, span)].map(|[first, last]| {
            let normal = |i| around_facet(frame, span, first.lerp(last, span.parameter(i)));
            (0..span.length).map(|i| phong.pixel_with(normal(i), i)).collect()
        })
    })
}

/// Normals at a span's ends that are interpolated between those where its scan line meets the
/// triangle's edges, which are wrapped.
fn wrapped_ends(frame: &Frame, span: &Span) -> [DVec3; 2] {
    let line = frame.scan_line(span);
    let [left, right] =
        line.edges.map(|weights| around_facet(frame, span, frame.normal_at(span, weights)));
    line.shares.map(|share| left.lerp(right, share))
}

/// A normal wrapped around the polygon's; where that fails, its direction.
fn around_facet(frame: &Frame, span: &Span, normal: DVec3) -> DVec3 {
    wrap(frame.facet_normal(span), normal).unwrap_or_else(|| normal.normalize_or_zero())
}

const fn change(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    let what = "figure 3: normals along edges by reflection too make no difference (half an LSB; our question, not a claim)";
    exact(what, quantity, expected, measure, |lsb| {
        Ruling::of(lsb < 0.5, "along wide edges they are wrapped too near to the polygon's normal")
    })
}

fn figure(scene: &str) -> f64 {
    small(scene).map_or(f64::NAN, |frame| wrapped_edges(&frame).max_lsb)
}

/// Claims about edges. Numbers of pictures are those that were first measured.
pub(super) const CLAIMS: [Claim; 4] = [
    exact(
        "normals along edges need not be normalised: Duff's q from those by additions is N.N",
        "largest difference, teapot",
        (0.0, 1e-12),
        || small("teapot").map_or(f64::NAN, |frame| duffs_square(&frame)),
        |off| Ruling::of(off < 1e-12, "it drifts"),
    ),
    change("largest change in LSB, teapot", (7.390, 5e-3), || figure("teapot")),
    change("largest change in LSB, torus", (0.2433, 5e-5), || figure("torus")),
    change("largest change in LSB, icosahedron", (25.801, 5e-3), || figure("icosahedron")),
];
