//! The loop of `phong` with lights and an eye at places.
use specula_scene::frame::EYE;
use specula_scene::spec::FULL_SCALE;
use specula_scene::{Colour, Frame, Span};

use super::Software;
use super::looped::{power, product};
use crate::recurrence::{Line, Number, Place, Seen, Vector, Walk, dot, vector};

/// A span's normal, eye and lights, each a recurrence.
pub struct PlacedLoop<P> {
    ambient: [f32; 3],
    exponent: u32,
    normal: Walk<f32>,
    eye: Towards<P>,
    lights: Vec<Lit<P>>,
}

/// A direction that is the same all along the span, or not.
#[derive(Clone, Copy)]
enum Towards<P> {
    Infinity(Vector<f32>),
    Place(P),
}

#[derive(Clone, Copy)]
struct Lit<P> {
    towards: Towards<P>,
    /// The exponent of a spot.
    spot: Option<u32>,
    diffuse: [f32; 3],
    specular: [f32; 3],
}

impl<P: Place<f32>> Towards<P> {
    #[inline(always)]
    fn pixel(&mut self) -> Seen<f32> {
        match self {
            Towards::Infinity(direction) => Seen { direction: *direction, to_axis: 1.0, lit: 1.0 },
            Towards::Place(place) => place.pixel(),
        }
    }
}

impl<P: Place<f32>> PlacedLoop<P> {
    /// Sets up a span of a frame.
    pub fn new(frame: &Frame, span: &Span) -> Self {
        let (line, material) = (Line::new(frame, span), frame.material(span));
        let lit = |towards, spot, colour: Colour| Lit {
            towards,
            spot,
            diffuse: product(material.diffuse, colour),
            specular: product(material.specular, colour),
        };
        let at_infinity = frame.lights.iter().map(|light| lit(Towards::Infinity(vector(light.direction)), None, light.colour));
        let at_places = frame.local_lights.iter().map(|light| {
            let exponent = light.spot.as_ref().map(|spot| spot.exponent);
            lit(Towards::Place(P::to_light(frame, span, light)), exponent, light.colour)
        });
        PlacedLoop {
            ambient: product(material.ambient, frame.ambient),
            exponent: material.shininess,
            normal: Walk::new(line.ends[0], line.step()),
            eye: match frame.eye {
                Some(eye) => Towards::Place(P::to_eye(frame, span, eye)),
                None => Towards::Infinity(vector(EYE)),
            },
            lights: at_infinity.chain(at_places).collect(),
        }
    }
}

impl<P: Place<f32>> Software for PlacedLoop<P> {
    fn shade(&self, out: &mut [[f32; 3]]) {
        // Copies: the span can be shaded again.
        let (mut normal, mut eye, mut lights) = (self.normal, self.eye, self.lights.clone());
        for pixel in out {
            let n = normal.pixel();
            let per_length = 1.0 / dot(n, n).floored().square_root();
            let (n, v) = (n.map(|c| c * per_length), eye.pixel().direction);
            let n_dot_v = dot(n, v);
            *pixel = self.ambient;
            for light in &mut lights {
                let Seen { direction: l, to_axis, lit } = light.towards.pixel();
                let share = match light.spot {
                    Some(exponent) if lit > 0.0 => power(to_axis.clamp(0.0, 1.0), exponent),
                    Some(_) => 0.0,
                    None => 1.0,
                };
                let n_dot_l = dot(n, l);
                let base = 2.0 * n_dot_l * n_dot_v - dot(l, v);
                let (diffuse, specular) = (share * n_dot_l.clamp(0.0, 1.0), share * power(base.clamp(0.0, 1.0), self.exponent));
                for (c, channel) in pixel.iter_mut().enumerate() {
                    *channel += light.diffuse[c] * diffuse + light.specular[c] * specular;
                }
            }
            *pixel = pixel.map(|channel| channel.min(FULL_SCALE as f32));
        }
    }
}
