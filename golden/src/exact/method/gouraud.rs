//! Intensities of the vertices or of the polygon, without rounding [lecture, eq. 2.1 and 3.2 to
//! 3.6; Lyon, figure 1; methods A3, A4 and B].
use glam::DVec3;
use specula_scene::{Facet, Frame, Span};
use specula_spec::GouraudSpec;
use specula_spec::gouraud::{Highlight, Interpolation};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::illumination::{self, Illumination};
use crate::exact::formula::shape::{f_k, power};

/// One span, shaded by `gouraud`.
pub struct GouraudSpan<'a> {
    span: &'a Span,
    /// Amounts of each light at the points where they are computed: the vertices, or the middle of
    /// the polygon.
    lights: Vec<Vec<Amounts>>,
    /// The weights of these points at the first and at the last pixel.
    ends: [Vec<f64>; 2],
    coefficients: Coefficients,
}

impl<'a> GouraudSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &GouraudSpec, frame: &Frame, span: &'a Span) -> Self {
        let (triangle, shininess) =
            (&frame.triangles[span.triangle], frame.material(span).shininess);
        let vertex = |v: usize| (triangle.normals[v], triangle.positions[v]);
        let (points, ends) = match spec.interpolation {
            Interpolation::Linear => {
                ([0, 1, 2].map(vertex).to_vec(), [span.start, span.end].map(Vec::from))
            }
            Interpolation::Uniform => {
                let Facet { normal, middle } = triangle.facet;
                (vec![(normal, middle)], [1.0; 2].map(|weight| vec![weight]))
            }
        };
        let at_points: Vec<Vec<Amounts>> = points
            .into_iter()
            .map(|(n, place)| amounts(spec, frame, shininess, n, place).collect())
            .collect();
        let lights = (0..frame.light_colours().count())
            .map(|light| at_points.iter().map(|point| point[light]).collect());
        GouraudSpan {
            span,
            lights: lights.collect(),
            ends,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// Σ weight · amount, clamped to 0 to 1.
    fn interpolated(&self, i: u32, at_points: impl Iterator<Item = f64>) -> f64 {
        let t = self.span.parameter(i);
        let weights =
            self.ends[0].iter().zip(&self.ends[1]).map(|(start, end)| start + t * (end - start));
        at_points.zip(weights).map(|(amount, weight)| weight * amount).sum::<f64>().clamp(0.0, 1.0)
    }
}

impl ShadeSpan for GouraudSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        self.coefficients.sum_of(self.lights.iter().map(|points| Amounts {
            diffuse: self.interpolated(i, points.iter().map(|point| point.diffuse)),
            specular: self.interpolated(i, points.iter().map(|point| point.specular)),
        }))
    }
}

/// The amounts of each light at a place with the normal `normal`.
fn amounts(
    spec: &GouraudSpec,
    frame: &Frame,
    shininess: u32,
    normal: DVec3,
    place: DVec3,
) -> impl Iterator<Item = Amounts> {
    let view = illumination::view_from(frame, place);
    let of = move |light: Option<Illumination>| match light {
        Some(Illumination { direction, share }) => Amounts {
            diffuse: share * lambert(normal, direction),
            specular: share
                * view.map_or(0.0, |view| highlight(spec, normal, direction, view, shininess)),
        },
        None => Amounts::default(),
    };
    illumination::lights_from(frame, place).map(of)
}

/// max(R·L, 0)^n, or f_k(n/2 D·D) of D = R - L; 0 where there is no normal.
fn highlight(spec: &GouraudSpec, normal: DVec3, light: DVec3, view: DVec3, shininess: u32) -> f64 {
    let reflection = 2.0 * normal.dot(view) * normal - view;
    if normal == DVec3::ZERO {
        return 0.0;
    }
    match spec.highlight {
        Highlight::Power => power(reflection.dot(light).min(1.0), shininess),
        Highlight::FK => {
            let x = f64::from(shininess) / 2.0 * (reflection - light).length_squared();
            f_k(x, spec.squarings)
        }
    }
}
