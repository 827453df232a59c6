//! The loop of `phong` with lights and an eye at places.
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};

use super::Software;
use super::surface::{Surface, clamped};
use crate::exact::formula::illumination::attenuation_along;
use crate::loops::{
    Line, Number, PlaceDirection, Second, SeenPlace, Vector, Walk, dot, power, vector,
};

/// A frame whose spans have recurrences for the normal, the eye and each light.
pub struct PlacedLoop<'a, P> {
    frame: &'a Frame,
    surfaces: Vec<Surface>,
    /// The exponent of each light that is a spot.
    spots: Vec<Option<u32>>,
    spans: Vec<Along<P>>,
    /// Each light along the first span, along the second, and so on.
    lights: Vec<Lit<P>>,
}

/// A light along a span.
struct Lit<P> {
    towards: Towards<P>,
    /// What distance leaves of it, if it becomes weaker.
    attenuation: Option<Second<f32>>,
}

/// The recurrences of a span, except those of its lights.
struct Along<P> {
    material: usize,
    normal: Walk<f32>,
    eye: Towards<P>,
}

/// A direction that is constant along the span, or one that varies.
#[derive(Clone, Copy)]
enum Towards<P> {
    Infinity(Vector<f32>),
    PlaceDirection(P),
}

impl<P: PlaceDirection<f32>> Towards<P> {
    #[inline(always)]
    fn pixel(&mut self) -> SeenPlace<f32> {
        match self {
            Towards::Infinity(direction) => {
                SeenPlace { direction: *direction, to_axis: 1.0, lit: 1.0 }
            }
            Towards::PlaceDirection(place) => place.pixel(),
        }
    }
}

impl<'a, P: PlaceDirection<f32>> PlacedLoop<'a, P> {
    /// Computes what belongs to the frame.
    pub fn new(frame: &'a Frame) -> Self {
        let local = frame.local_lights.iter();
        let exponents = local.map(|light| light.spot.as_ref().map(|spot| spot.exponent));
        PlacedLoop {
            frame,
            surfaces: Surface::all_of(frame),
            spots: frame.lights.iter().map(|_| None).chain(exponents).collect(),
            spans: Vec::new(),
            lights: Vec::new(),
        }
    }
}

impl<P: PlaceDirection<f32>> Software for PlacedLoop<'_, P> {
    fn set_up(&mut self, spans: &[Span]) {
        let frame = self.frame;
        self.spans.clear();
        self.lights.clear();
        for span in spans {
            let line = Line::new(frame, span);
            self.spans.push(Along {
                material: frame.triangles[span.triangle].material,
                normal: Walk::new(line.ends[0], line.step()),
                eye: match frame.eye {
                    Some(eye) => Towards::PlaceDirection(P::to_eye(frame, span, eye)),
                    None => Towards::Infinity(vector(EYE)),
                },
            });
            self.lights.extend(frame.lights.iter().map(|light| Lit {
                towards: Towards::Infinity(vector(light.direction)),
                attenuation: None,
            }));
            self.lights.extend(frame.local_lights.iter().map(|light| Lit {
                towards: Towards::PlaceDirection(P::to_light(frame, span, light)),
                attenuation: light.attenuation.map(|_| {
                    let along = attenuation_along(frame, span, light);
                    Second::new(along.stretched(f64::from(span.steps().max(1))))
                }),
            }));
        }
    }

    fn shade(&mut self, number: usize, out: &mut [[f32; 3]]) {
        let of_span = self.spots.len();
        let lights = &mut self.lights[number * of_span..][..of_span];
        let Along { material, normal, eye } = &mut self.spans[number];
        let surface = &self.surfaces[*material];
        for pixel in out {
            let n = normal.pixel();
            let per_length = 1.0 / dot(n, n).floored().square_root();
            let (n, v) = (n.map(|c| c * per_length), eye.pixel().direction);
            let n_dot_v = dot(n, v);
            *pixel = surface.ambient;
            for ((light, spot), reflected) in
                lights.iter_mut().zip(&self.spots).zip(&surface.lights)
            {
                let SeenPlace { direction: l, to_axis, lit } = light.towards.pixel();
                let arriving =
                    light.attenuation.as_mut().map_or(1.0, |left| left.pixel().clamp(0.0, 1.0));
                let share = arriving
                    * match spot {
                        Some(exponent) if lit > 0.0 => power(to_axis.clamp(0.0, 1.0), *exponent),
                        Some(_) => 0.0,
                        None => 1.0,
                    };
                let n_dot_l = dot(n, l);
                let base = (2.0 * n_dot_l * n_dot_v - dot(l, v)).clamp(0.0, 1.0);
                let specular = share * power(base, surface.shininess);
                reflected.add(share * n_dot_l.clamp(0.0, 1.0), specular, pixel);
            }
            *pixel = clamped(*pixel);
        }
    }
}
