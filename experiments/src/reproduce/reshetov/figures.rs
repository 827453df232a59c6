//! Figures 6, 7, 11 and 12.
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use specula_golden::exact::formula::consistent::{cosine, q, rational_q, reflection};
use specula_spec::Method;

use super::super::figure::{Figure, FigureCurve};
use super::super::span_core::{SpanCore, frame, value};
use crate::stress::draw::tilted;
use crate::stress::scene::matt;
use crate::stress::variant::Variant;

/// Figure 6, the four plots of figure 7, and those of the appendix.
pub fn figures() -> Vec<Figure> {
    let seven = [
        (5, "reshetov_figure7_05"),
        (25, "reshetov_figure7_25"),
        (45, "reshetov_figure7_45"),
        (65, "reshetov_figure7_65"),
    ];
    std::iter::once(curves())
        .chain(seven.map(|(degrees, name)| cosines(name, degrees.into())))
        .chain(super::appendix::figures())
        .collect()
}

fn curves() -> Figure {
    let range = (0.0, 90.0);
    Figure {
        name: "reshetov_figure6",
        title: "Reshetov's figure 6: q and the rational q~".to_owned(),
        x: "alpha in degrees",
        y: "q, weight of Phong's reflection",
        curves: vec![
            FigureCurve::formula("q = (1 - sin a)/(1 + sin a)", 0, range, 0.2, |a| {
                q(a.to_radians())
            }),
            FigureCurve::formula("q~, rational", 1, range, 0.5, |a| rational_q(a.to_radians())),
            FigureCurve::formula("10 (q - q~)", 2, range, 0.6, |a| {
                10.0 * (q(a.to_radians()) - rational_q(a.to_radians()))
            }),
        ],
        notes: vec!["q - q~ is 0.0127 at most, at 40.2 degrees.".to_owned()],
    }
}

/// Number of positions at which the core is evaluated.
const PLACES: u32 = 12;

/// Dot products of I with Phong's and with the consistent normal, at β degrees from Phong's normal,
/// which is `alpha` degrees from the face's.
fn cosines(name: &'static str, alpha: f64) -> Figure {
    let range = (0.0, 90.0 + alpha);
    let consistent = |curve: fn(f64) -> f64| move |beta: f64| consistent_cosine(curve, alpha, beta);
    let mut curves = vec![
        FigureCurve::formula("N.I", 0, range, 0.3, |beta| libm::cos(beta.to_radians())),
        FigureCurve::formula("N_c.I", 3, range, 0.62, consistent(q)),
        FigureCurve::formula("N_c.I, q~", 1, range, 0.82, consistent(rational_q)),
    ];
    curves.extend(core_cosines(alpha));
    Figure {
        name,
        title: format!(
            "Reshetov's figure 7: {alpha:.0} degrees between the face's normal and Phong's"
        ),
        x: "beta, between I and Phong's normal, in degrees",
        y: "dot product with I",
        curves,
        notes: vec!["Lines: f64. Dots: what a core with the rational curve has.".to_owned()],
    }
}

fn consistent_cosine(curve: fn(f64) -> f64, alpha: f64, beta: f64) -> f64 {
    let incoming = tilted(beta);
    cosine(incoming, reflection(DVec3::Z, incoming, curve(alpha.to_radians())))
}

/// N_c·L of the core with consistent diffuse light, up to where L leaves the face.
fn core_cosines(alpha: f64) -> Option<FigureCurve> {
    let at = |k: u32| {
        let beta = (90.0 + alpha) * f64::from(k) / f64::from(PLACES);
        Some((beta, core_cosine(alpha, beta)?))
    };
    Some(FigureCurve::core("", 1, (0..=PLACES).map(at).collect::<Option<Vec<_>>>()?))
}

fn core_cosine(alpha: f64, beta: f64) -> Option<f64> {
    let mut frame = frame([DVec3::Z; 2], 1, tilted(beta), matt())?;
    let table = "diffuse = \"consistent\"\n".to_owned();
    // The interpolated angle itself is to be `alpha`. The constant enlarges angles at vertices, so
    // smaller ones are given there.
    let least = least_cosine(alpha.to_radians());
    frame.triangles[0].cones.iter_mut().for_each(|cone| cone.cosine = least);
    let core = SpanCore::new(&frame, &Variant { method: Method::Consistent, table })?;
    value(&core.trace(&frame, 0)?, "light0_diffuse")
}

/// The cosine m whose enlarged angle is `alpha` radians, found by bisection: the angle falls as m
/// grows.
fn least_cosine(alpha: f64) -> f64 {
    use specula_golden::exact::formula::consistent::{Scaling, vertex_angle};
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if vertex_angle(middle, Scaling::RATIONAL) > alpha.min(FRAC_PI_2) {
            low = middle
        } else {
            high = middle
        }
    }
    low
}
