//! Set-up of a span for `gouraud`.
use specula_scene::frame::{Facet, Frame, Span};

use super::lit_point::LitPoint;
use super::{GouraudLight, GouraudSpec, Intensity, Interpolation};
use crate::inputs::NoInputs;
use crate::method_set_up::MethodSetUp;

/// Sets up the spans of a frame.
pub(super) struct GouraudSetUp<'a> {
    pub gouraud: &'a GouraudSpec,
    pub frame: &'a Frame,
}

/// Where intensities are computed.
#[expect(
    clippy::large_enum_variant,
    reason = "it is made for each span, where a box would allocate"
)]
pub(super) enum Points {
    Vertices([LitPoint; 3]),
    /// The middle of the polygon.
    Middle(LitPoint),
}

impl MethodSetUp for GouraudSetUp<'_> {
    type SpanGroup = NoInputs<i64>;
    type LightGroup = GouraudLight<i64>;
    type Geometry = Points;

    fn geometry(&self, span: &Span) -> Points {
        self.points(span)
    }

    fn span_inputs(&self, _span: &Span, _points: &Points) -> NoInputs<i64> {
        NoInputs::default()
    }

    fn light_inputs(&self, span: &Span, points: &Points, index: usize) -> GouraudLight<i64> {
        let highlight = self.gouraud.vertex_highlight(self.frame.material(span).shininess);
        GouraudLight {
            diffuse_intensity: self
                .intensity(span, points, |point| point.attenuation(index) * point.diffuse(index)),
            specular_intensity: self.intensity(span, points, |point| {
                point.attenuation(index) * point.highlight(index, highlight)
            }),
        }
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
