//! Set-up of a span for `slerp`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{
    ArcRotation, Axes, EyeAlongArc, Form, LightAlongArc, OnArc, SlerpLight, SlerpSpan, SlerpSpec,
    WayAlongArc,
};
use crate::method_set_up::MethodSetUp;
use crate::ways::Ways;

/// Sets up the spans of a frame.
pub(super) struct SlerpSetUp<'a> {
    pub slerp: &'a SlerpSpec,
    pub frame: &'a Frame,
}

impl MethodSetUp for SlerpSetUp<'_> {
    type SpanGroup = SlerpSpan<i64>;
    type LightGroup = SlerpLight<i64>;
    type Geometry = ArcRotation;

    fn geometry(&self, span: &Span) -> ArcRotation {
        self.slerp.arc_rotation(self.frame, span)
    }

    fn span_inputs(&self, span: &Span, rotation: &ArcRotation) -> SlerpSpan<i64> {
        let f = &self.slerp.formats;
        let [turn_cosine, turn_sine, turn_back] = rotation.turn.map(|x| f.turn.quantise(x));
        let ends = self.slerp.between_ends();
        let has_eye = self.slerp.places.sends_ways(self.frame) && self.frame.eye.is_some();
        let [start, other] = rotation.axes.map(|axis| f.vector.quantise_vector(axis));
        SlerpSpan {
            turn_cosine,
            turn_sine,
            turn_back: ends.then_some(turn_back),
            rising_cosine: ends.then(|| f.scaled_state.quantise(rotation.rising_cosine)),
            falling_cosine: ends.then(|| f.scaled_state.quantise(rotation.falling_cosine)),
            view: self.on_arc(rotation, EYE).filter(|_| !has_eye),
            eye: has_eye.then(|| {
                let (ways, way) = (self.ways(span), self.ways(span).way_to_eye());
                EyeAlongArc {
                    normal: self.way_along_arc(&ways, rotation, way),
                    squared: ways.product(way, way),
                }
            }),
            normal: (self.slerp.form == Form::Vector).then_some(Axes { start, other }),
            exponent: self.slerp.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, rotation: &ArcRotation, index: usize) -> SlerpLight<i64> {
        if self.slerp.places.sends_ways(self.frame) {
            let ways = self.ways(span);
            // Without a normal there is no light, nor a highlight of L·V alone.
            let is_dark = rotation.axes[0] == DVec3::ZERO;
            let way = if is_dark { [DVec3::ZERO; 2] } else { ways.way_to_light(index) };
            return SlerpLight::of_way(LightAlongArc {
                normal: self.way_along_arc(&ways, rotation, way),
                way: ways.light(index, way),
            });
        }
        let (f, l) = (&self.slerp.formats, self.frame.lights[index].direction);
        let l_dot_v = if rotation.axes[0] == DVec3::ZERO { 1.0 } else { l.dot(EYE) };
        SlerpLight {
            light: self.on_arc(rotation, l),
            direction: (self.slerp.form == Form::Vector).then(|| f.vector.quantise_vector(l)),
            way: None,
            light_dot_view: Some(f.component.quantise(l_dot_v)),
        }
    }
}

impl SlerpSetUp<'_> {
    fn ways<'a>(&'a self, span: &'a Span) -> Ways<'a> {
        Ways { frame: self.frame, span, accumulator: self.slerp.formats.way_accumulator }
    }

    fn way_along_arc(
        &self,
        ways: &Ways,
        rotation: &ArcRotation,
        way: [DVec3; 2],
    ) -> WayAlongArc<i64> {
        let is_scalar = self.slerp.form == Form::Scalar;
        let [start, across] = rotation.axes.map(|axis| is_scalar.then(|| ways.linear(way, axis)));
        WayAlongArc { start, across, vector: (!is_scalar).then(|| ways.vector(way)) }
    }

    fn on_arc(&self, rotation: &ArcRotation, x: DVec3) -> Option<OnArc<i64>> {
        let [start, across] =
            rotation.axes.map(|axis| self.slerp.formats.component.quantise(axis.dot(x)));
        (self.slerp.form == Form::Scalar).then_some(OnArc { start, across })
    }
}
