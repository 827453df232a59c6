//! Figures 3 and 4.
use glam::DVec3;
use specula_golden::exact::formula::normalisation::{g1, g2};
use specula_spec::Method;

use super::super::figure::{Figure, FigureCurve};
use super::super::span_core::{SpanCore, frame};
use super::normalisation::core_lengths;
use super::shapes::{phong, shape};
use crate::stress::draw::tilted;
use crate::stress::scene::mirror;
use crate::stress::variant::Variant;

/// Both figures.
pub fn figures() -> Vec<Figure> {
    vec![shapes(), lengths()]
}

/// The exponent n of figure 3.
const SHININESS: u32 = 100;
/// The angles that figure 3 shows, in radians.
const ANGLES: (f64, f64) = (0.0, 0.4);
/// Number of positions in figures 3 and 4 at which cores are evaluated.
const PLACES: u32 = 16;

fn shapes() -> Figure {
    let lobe = |k: u32, label| {
        FigureCurve::formula(&format!("f_{k}"), k as usize + 1, ANGLES, label, move |a| {
            shape(a, SHININESS, k)
        })
    };
    let cosine = FigureCurve::formula("cos^n", 0, ANGLES, 0.62, |a| phong(a, SHININESS));
    let formulas = [cosine, lobe(0, 0.3), lobe(1, 0.42), lobe(2, 0.52)];
    let cores = [core_shape(0, Method::Phong, String::new())];
    let of_lyon = (0..3).map(|k| core_shape(k as usize + 1, Method::Lyon, lyon_table(k)));
    Figure {
        name: "lyon_figure3",
        title: "Lyon's figure 3: shapes of the highlight, n = 100".to_owned(),
        x: "angle between R and L in radians",
        y: "specular amount, 1 is full scale",
        curves: formulas.into_iter().chain(cores.into_iter().chain(of_lyon).flatten()).collect(),
        notes: vec![
            "Lines: f64. Dots: what cores give, lyon with k = 0, 1, 2 and phong.".to_owned(),
        ],
    }
}

fn lyon_table(k: u32) -> String {
    format!("difference = \"reflection-minus-light\"\nnormalisation = \"exact\"\nsquarings = {k}\n")
}

/// A core's highlight along a span whose normal turns away from eye and light by half of the angle
/// each.
fn core_shape(colour: usize, method: Method, table: String) -> Option<FigureCurve> {
    let frame = frame(
        [tilted(0.0), tilted(ANGLES.1.to_degrees() / 2.0)],
        PLACES + 1,
        DVec3::Z,
        mirror(SHININESS),
    )?;
    let core = SpanCore::new(&frame, &Variant { method, table })?;
    // The span's normals are interpolated linearly, so they do not turn evenly.
    let angle = |i: u32| {
        2.0 * DVec3::Z.angle_between(frame.normal_at(&frame.spans[0], frame.spans[0].weights(i)))
    };
    Some(FigureCurve::core("", colour, (0..).map(angle).zip(core.shades(&frame)?).collect()))
}

/// The lengths that figure 4 shows: those in spans of up to 120 degrees.
const LENGTHS: (f64, f64) = (0.5, 1.0);

fn lengths() -> Figure {
    let behind = |name: &str, colour, label, gain: fn(f64) -> f64| {
        FigureCurve::formula(name, colour, LENGTHS, label, move |l| l * gain(l * l))
    };
    let core = |name, colour| {
        core_lengths(name, 120.0, PLACES).map(|points| FigureCurve::core("", colour, points))
    };
    let formulas = [
        behind("g1", 1, 0.35, g1),
        behind("g2", 2, 0.3, g2),
        FigureCurve::formula("not normalised", 0, LENGTHS, 0.5, |l| l),
    ];
    Figure {
        name: "lyon_figure4",
        title: "Lyon's figure 4: length of a vector behind g1 and g2".to_owned(),
        x: "length before: 0.707 in the middle of a span of 90 degrees, 0.866 of 60",
        y: "length behind",
        curves: formulas
            .into_iter()
            .chain([core("g1", 1), core("g2", 2)].into_iter().flatten())
            .collect(),
        notes: vec!["Lines: f64. Dots: what a core has along a span of 120 degrees.".to_owned()],
    }
}
