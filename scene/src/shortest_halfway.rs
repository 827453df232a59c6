//! How short half-way vectors get where lights or the eye are at places.
use crate::frame::{Frame, Span};

/// Length of the shortest L + V of any light at any pixel, 0 to 2; 2 in a frame without places. A
/// light or an eye at the very pixel has no such vector.
pub(crate) fn of(frame: &Frame) -> f64 {
    if frame.local_lights.is_empty() && frame.eye.is_none() {
        return LONGEST;
    }
    frame.spans.iter().map(|span| in_span(frame, span)).fold(LONGEST, f64::min)
}

/// L + V of L = V.
const LONGEST: f64 = 2.0;

fn in_span(frame: &Frame, span: &Span) -> f64 {
    let at = |i: u32| {
        let position = frame.position_at(span, span.weights(i));
        let view = frame.view_from(position)?;
        let lights = frame.lights_from(position).flatten();
        lights.map(|light| (light.direction + view).length()).reduce(f64::min)
    };
    (0..span.length).filter_map(at).fold(LONGEST, f64::min)
}
