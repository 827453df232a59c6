//! Lights that become weaker with distance, along a span [Hast, Barrera and Bengtsson, §1].
use specula_scene::{Frame, LocalLight, Span, Triangle};
use specula_spec::{CoreSpec, Viewpoint};

use super::{MethodSpan, ShadeSpan};
use crate::exact::formula::illumination::attenuation_along;
use crate::exact::formula::quadratic::Quadratic;

/// A span whose lights' strengths are quadratics in the pixel number, through what distance leaves
/// of them at both ends and half-way.
pub(super) struct Attenuated<'a> {
    spec: &'a CoreSpec,
    /// The span by itself, under lights that do not become weaker.
    frame: Frame,
    /// What distance leaves of each light at a place, over t = 0 to 1.
    along: Vec<Quadratic>,
}

impl<'a> Attenuated<'a> {
    /// Sets up a span of a frame; `None` where no light becomes weaker, or where that is part of what
    /// vertices send back.
    pub fn new(spec: &'a CoreSpec, frame: &Frame, span: &Span) -> Option<Attenuated<'a>> {
        let becomes_weaker = |light: &LocalLight| light.attenuation.is_some();
        if spec.places_seen_from() == Viewpoint::Vertex
            || !frame.local_lights.iter().any(becomes_weaker)
        {
            return None;
        }
        let of_light = |light: &LocalLight| attenuation_along(frame, span, light);
        let along = frame.local_lights.iter().map(of_light).collect();
        Some(Attenuated { spec, frame: by_itself(frame, span), along })
    }
}

impl ShadeSpan for Attenuated<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let mut frame = self.frame.clone();
        let t = frame.spans[0].parameter(i);
        for (light, along) in frame.local_lights.iter_mut().zip(&self.along) {
            let share = along.at(t).clamp(0.0, 1.0);
            light.colour = light.colour.map(|component| share * component);
        }
        MethodSpan::new(self.spec, &frame, &frame.spans[0]).pixel(i)
    }
}

/// A frame with this span alone, whose lights do not become weaker.
fn by_itself(frame: &Frame, span: &Span) -> Frame {
    let local = |light: &LocalLight| LocalLight { attenuation: None, ..light.clone() };
    Frame {
        lights: frame.lights.clone(),
        local_lights: frame.local_lights.iter().map(local).collect(),
        materials: vec![frame.material(span).clone()],
        triangles: vec![Triangle { material: 0, ..frame.triangles[span.triangle].clone() }],
        spans: vec![Span { triangle: 0, ..span.clone() }],
        ..*frame
    }
}
