//! Set-up of a span for `consistent`.
use glam::DVec3;
use specula_datapath::Format;
use specula_scene::frame::{DirectionalLight, Frame, Span, halfway};

use super::{ConsistentLight, ConsistentSpan, ConsistentSpec, Highlight};
use crate::method_set_up::MethodSetUp;
use crate::ways::Ways;

/// Sets up the spans of a frame.
pub(super) struct ConsistentSetUp<'a> {
    consistent: &'a ConsistentSpec,
    frame: &'a Frame,
    lights: Vec<Vectors>,
}

/// What is the same of a light in every span.
struct Vectors {
    /// L.
    direction: [i64; 3],
    /// H, where the highlight asks for it.
    halfway: Option<[i64; 3]>,
    /// Whether there is what the highlight asks for: not where L = -V and Blinn's asks for H
    /// (extremes row 12).
    has_highlight: bool,
}

impl Vectors {
    fn new(consistent: &ConsistentSpec, light: &DirectionalLight) -> Vectors {
        let (vector, h) = (consistent.formats.vector, halfway(light.direction));
        let asked = consistent.highlight == Highlight::Blinn;
        Vectors {
            direction: vector.quantise_vector(light.direction),
            halfway: asked.then(|| vector.quantise_vector(h)),
            has_highlight: !asked || h != DVec3::ZERO,
        }
    }
}

impl<'a> ConsistentSetUp<'a> {
    pub fn new(consistent: &'a ConsistentSpec, frame: &'a Frame) -> ConsistentSetUp<'a> {
        let lights = frame.lights.iter().map(|light| Vectors::new(consistent, light)).collect();
        ConsistentSetUp { consistent, frame, lights }
    }

    fn sends_ways(&self) -> bool {
        self.consistent.places.sends_ways(self.frame)
    }

    fn ways<'b>(&'b self, span: &'b Span) -> Ways<'b> {
        Ways { frame: self.frame, span, accumulator: self.consistent.formats.way_accumulator }
    }

    /// t at the first pixel and its step, from the angles at the triangle's vertices.
    fn angle(&self, span: &Span) -> [f64; 2] {
        let at_vertices = self.frame.triangles[span.triangle]
            .cones
            .map(|cone| self.consistent.curve.quarter_turns(cone.cosine));
        let at = |weights: [f64; 3]| (0..3).map(|v| weights[v] * at_vertices[v]).sum::<f64>();
        let (start, end) = (at(span.start), at(span.end));
        [start, (end - start) / f64::from(span.steps().max(1))]
    }
}

impl MethodSetUp for ConsistentSetUp<'_> {
    type SpanGroup = ConsistentSpan<i64>;
    type LightGroup = ConsistentLight<i64>;
    type Geometry = ();

    fn geometry(&self, _span: &Span) {}

    fn span_inputs(&self, span: &Span, (): &()) -> ConsistentSpan<i64> {
        let f = &self.consistent.formats;
        let [start, end] = self.frame.end_axes(span).map(|n| f.vector.quantise_vector(n));
        let [angle_start, angle_step] =
            self.angle(span).map(|t| rounded_up(f.angle_accumulator, t));
        ConsistentSpan {
            normal_start: start,
            normal_delta: std::array::from_fn(|i| end[i] - start[i]),
            weight_step: f.weight_accumulator.quantise(span.weight_step()),
            angle_start,
            angle_step,
            eye: self.ways(span).vector_eye().filter(|_| self.sends_ways()),
            exponent: self.consistent.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, (): &(), index: usize) -> ConsistentLight<i64> {
        if self.sends_ways() {
            let way = self.ways(span).vector_light(index, self.consistent.formats.vector);
            return ConsistentLight { direction: None, way: Some(way), halfway: None };
        }
        let &Vectors { direction, halfway, .. } = &self.lights[index];
        ConsistentLight { direction: Some(direction), way: None, halfway }
    }

    fn has_highlight(&self, index: usize) -> bool {
        self.sends_ways() || self.lights[index].has_highlight
    }
}

/// The smallest raw value above `value`, at most one unit of the last place away: a larger angle is
/// the safe side.
fn rounded_up(format: Format, value: f64) -> i64 {
    format.quantise(value + 0.5 * format.ulp())
}
