//! Additions along edges, and slerp along them.
use glam::DVec3;
use specula_golden::exact::formula::diffuse::lambert;
use specula_golden::loops::Linear;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Needs, Span};
use specula_spec::{CoreSpec, Method};
use specula_testbench::ErrorFigures;

use super::super::claim::{Claim, Ruling, exact};
use super::super::differences::{self, by_method, differences};
use super::super::stepped::{largest_off, small};

/// The largest difference over the teapot's pixels between what is stepped along edges and scan lines
/// and the same by weights.
fn stepped<const N: usize>(values: impl Fn(DVec3, DVec3) -> [f64; N]) -> Option<f64> {
    let frame = small("teapot")?;
    let light = frame.lights.first()?.direction;
    let of_vertex = |normal: DVec3| values(normal, light);
    let off = |span: &Span, mut along: [Linear<f64>; N]| {
        let corners = frame.triangles[span.triangle].normals.map(of_vertex);
        let of_pixel = |i: u32| {
            let weights = span.weights(i);
            let wanted = |k: usize| (0..3).map(|v| weights[v] * corners[v][k]).sum::<f64>();
            along
                .iter_mut()
                .enumerate()
                .fold(0.0, |off, (k, value)| f64::max(off, (value.pixel() - wanted(k)).abs()))
        };
        (0..span.length).map(of_pixel).fold(0.0, f64::max)
    };
    Some(largest_off(&frame, of_vertex, off))
}

/// Slerp along edges beside linear edges, in f64.
#[derive(Clone, Debug, PartialEq)]
struct EdgesCompared {
    /// What slerp along edges changes.
    change: ErrorFigures,
    /// The method with linear edges against exact Phong shading.
    linear: ErrorFigures,
    /// With slerp along edges, against the same.
    slerp: ErrorFigures,
}

/// Shades a frame by slerp along scan lines with both ways along edges; `None` if it has no core.
fn compared(frame: &Frame) -> Option<EdgesCompared> {
    let needs = Needs::of(frame);
    let spec = |edges: &str| {
        let table = format!("[slerp]\nedges = \"{edges}\"").parse().ok()?;
        CoreSpec::for_scene(&needs, Some(&table), Some(Method::Slerp)).ok()
    };
    let (linear, slerp) = (spec("linear")?, spec("slerp")?);
    let by = |spec, span: &Span| by_method(spec, frame, span);
    Some(EdgesCompared {
        change: differences(frame, |span| [by(&linear, span), by(&slerp, span)]),
        linear: differences(frame, |span| [differences::exact(frame, span), by(&linear, span)]),
        slerp: differences(frame, |span| [differences::exact(frame, span), by(&slerp, span)]),
    })
}

/// A figure of the comparison on a built-in scene.
fn figure(scene: &str, figure: fn(&EdgesCompared) -> f64) -> f64 {
    small(scene).and_then(|frame| compared(&frame)).map_or(f64::NAN, |edges| figure(&edges))
}

const fn additions(quantity: &'static str, measure: fn() -> f64) -> Claim {
    let what =
        "additions along edges and scan lines are linear interpolation (3.2 to 3.6, 4.1 to 4.3)";
    exact(what, quantity, (0.0, 1e-12), measure, |off| Ruling::of(off < 1e-12, "they drift"))
}

const fn change(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    let what =
        "slerp along edges, step ii, makes a difference (half an LSB; our question, not a claim)";
    exact(what, quantity, expected, measure, |lsb| {
        Ruling::of(lsb > 0.5, "small triangles' edges are arcs of few degrees")
    })
}

const fn nearer(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    let what =
        "and is nearer to normals that are interpolated and normalised (our question, not a claim)";
    exact(what, quantity, expected, measure, |ratio| {
        Ruling::of(ratio < 1.0, "arcs along edges too leave them farther behind")
    })
}

fn ratio(edges: &EdgesCompared) -> f64 {
    edges.slerp.rms_lsb / edges.linear.rms_lsb
}

/// Claims about edges. Numbers of pictures are those that were first measured.
pub(super) const CLAIMS: [Claim; 9] = [
    additions("largest difference, I of the teapot", || {
        stepped(|n, l| [lambert(n, l)]).unwrap_or(f64::NAN)
    }),
    additions("largest difference, N", || stepped(|n, _| n.to_array()).unwrap_or(f64::NAN)),
    additions("largest difference, J and K", || {
        stepped(|n, l| [n.dot(l), n.dot(EYE)]).unwrap_or(f64::NAN)
    }),
    change("largest change in LSB, teapot", (10.540, 5e-3), || {
        figure("teapot", |edges| edges.change.max_lsb)
    }),
    change("largest change in LSB, torus", (0.3114, 5e-5), || {
        figure("torus", |edges| edges.change.max_lsb)
    }),
    change("largest change in LSB, icosahedron", (19.786, 5e-3), || {
        figure("icosahedron", |edges| edges.change.max_lsb)
    }),
    nearer("rms error with it over that without, teapot", (7.181, 5e-3), || {
        figure("teapot", ratio)
    }),
    nearer("rms error with it over that without, torus", (3.084, 5e-3), || figure("torus", ratio)),
    nearer("rms error with it over that without, icosahedron", (2.330, 5e-3), || {
        figure("icosahedron", ratio)
    }),
];
