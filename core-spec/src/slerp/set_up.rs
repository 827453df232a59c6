//! Set-up of a span for `slerp`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{ArcRotation, Axes, Form, OnArc, SlerpLight, SlerpSpan, SlerpSpec};
use crate::method_set_up::MethodSetUp;

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
        let [start, other] = rotation.axes.map(|axis| f.vector.quantise_vector(axis));
        SlerpSpan {
            turn_cosine,
            turn_sine,
            turn_back: ends.then_some(turn_back),
            rising_cosine: ends.then(|| f.scaled_state.quantise(rotation.rising_cosine)),
            falling_cosine: ends.then(|| f.scaled_state.quantise(rotation.falling_cosine)),
            view: self.on_arc(rotation, EYE),
            normal: (self.slerp.form == Form::Vector).then_some(Axes { start, other }),
            exponent: self.slerp.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, _span: &Span, rotation: &ArcRotation, index: usize) -> SlerpLight<i64> {
        let (f, l) = (&self.slerp.formats, self.frame.lights[index].direction);
        let l_dot_v = if rotation.axes[0] == DVec3::ZERO { 1.0 } else { l.dot(EYE) };
        SlerpLight {
            light: self.on_arc(rotation, l),
            direction: (self.slerp.form == Form::Vector).then(|| f.vector.quantise_vector(l)),
            light_dot_view: f.component.quantise(l_dot_v),
        }
    }
}

impl SlerpSetUp<'_> {
    fn on_arc(&self, rotation: &ArcRotation, x: DVec3) -> Option<OnArc<i64>> {
        let [start, across] =
            rotation.axes.map(|axis| self.slerp.formats.component.quantise(axis.dot(x)));
        (self.slerp.form == Form::Scalar).then_some(OnArc { start, across })
    }
}
