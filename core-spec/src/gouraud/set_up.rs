//! Set-up of a span for `gouraud`.
use specula_scene::frame::{Facet, Frame, Span};

use super::lit_point::LitPoint;
use super::{GouraudInputs, GouraudLight, GouraudSpec, Intensity, Interpolation};
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct GouraudSetUp<'a> {
    pub gouraud: &'a GouraudSpec,
    pub frame: &'a Frame,
}

/// Where intensities are worked out.
#[expect(
    clippy::large_enum_variant,
    reason = "it is made for each span, where a box would allocate"
)]
enum Points {
    Vertices([LitPoint; 3]),
    /// The middle of the polygon.
    Middle(LitPoint),
}

impl SetUpSpan for GouraudSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let (points, n) = (self.points(span), self.frame.material(span).shininess);
        let light =
            |(index, &Coefficients { diffuse, specular }): (usize, &Coefficients)| GouraudLight {
                diffuse_intensity: self.intensity(span, &points, |point| point.diffuse(index)),
                specular_intensity: self
                    .intensity(span, &points, |point| point.highlight(index, n)),
                diffuse,
                specular,
            };
        let inputs = GouraudInputs {
            ambient: material.ambient,
            lights: material.lights.iter().enumerate().map(light).collect(),
        };
        inputs.append_to(out);
    }
}

impl GouraudSetUp<'_> {
    fn points(&self, span: &Span) -> Points {
        let triangle = &self.frame.triangles[span.triangle];
        let vertex =
            |v: usize| LitPoint::new(self.frame, triangle.normals[v], triangle.positions[v]);
        match self.gouraud.interpolation {
            Interpolation::Linear => Points::Vertices([0, 1, 2].map(vertex)),
            Interpolation::Uniform => {
                let Facet { normal, middle } = triangle.facet;
                Points::Middle(LitPoint::new(self.frame, normal, middle))
            }
        }
    }

    fn intensity(
        &self,
        span: &Span,
        points: &Points,
        of: impl Fn(&LitPoint) -> f64,
    ) -> Intensity<i64> {
        let formats = &self.gouraud.formats;
        match points {
            Points::Vertices(vertices) => {
                let at_vertices = vertices.each_ref().map(of);
                let [start, step] = self
                    .frame
                    .interpolated(span, at_vertices)
                    .map(|x| formats.accumulator.quantise(x));
                Intensity { start, step: Some(step) }
            }
            Points::Middle(point) => {
                Intensity { start: formats.intensity.quantise(of(point)), step: None }
            }
        }
    }
}
