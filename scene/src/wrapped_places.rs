//! What wrapped directions to places make of a frame's colours [Hast, Barrera and Bengtsson, eq. 36
//! to 38; methods C16 to C18].
//!
//! A wrap gives true directions at the ends of a span. In between, the chord from end to end has
//! other angles than F - P where these ends are far apart as the place sees them: a lamp a quarter
//! unit from a wall four units wide is off by 191 LSB in the middle between them (extremes row 40).
use glam::DVec3;

use crate::frame::{Frame, LocalLight, Material, Span, Spot};
use crate::wrap::Wrap;

/// Steps from pixel to pixel at which each span is looked at, at most. The angle is smooth along a
/// span: 0 at its ends, and with one extremum or two between them.
const STEPS: u32 = 16;

/// LSBs of full scale.
const FULL_SCALE: f64 = 255.0;

/// By how much colours of a frame are off at most, in LSBs from 0 to 255, where directions to lights
/// and the eye at places are wrapped rather than true; 0 where there are no places.
///
/// An angle δ between a wrapped and the true direction moves N·L by δ at most and (R·L)^n by s(n) δ,
/// where s(n) is the steepest slope of the power of a cosine; an angle of V turns R as far. All of
/// these are added up, so that colours are mostly off by less.
pub(crate) fn most_off(frame: &Frame) -> f64 {
    if frame.local_lights.is_empty() && frame.eye.is_none() {
        return 0.0;
    }
    FULL_SCALE * frame.spans.iter().map(|span| off_in(frame, span)).fold(0.0, f64::max)
}

/// The same of one span, in units of full scale.
fn off_in(frame: &Frame, span: &Span) -> f64 {
    let lights: Vec<Wrap> =
        frame.local_lights.iter().map(|light| Wrap::to_light(frame, span, light)).collect();
    let eye = frame.eye.map(|place| (place, Wrap::to_eye(frame, span, place)));
    let slope = slope(frame.material(span).shininess);
    let at = |i: u32| {
        let (t, position) = (span.parameter(i), frame.position_at(span, span.weights(i)));
        let of_eye = eye.map_or(0.0, |(place, wrap)| turn(&wrap, t, place - position));
        let near = frame.local_lights.iter().zip(&lights).map(|(light, wrap)| {
            let of_light = of_light(light, wrap, t, light.position - position);
            Off { specular: of_light.specular(slope, of_eye), ..of_light }
        });
        let far = frame.lights.iter().map(|_| Off { specular: slope * of_eye, ..Off::default() });
        brightest(frame, frame.material(span), far.chain(near))
    };
    let steps = span.steps();
    let pixel = |step: u32| (u64::from(steps) * u64::from(step) / u64::from(STEPS)) as u32;
    (1..STEPS).map(|step| at(pixel(step))).fold(0.0, f64::max)
}

/// By how much the amounts of a light are off, from 0 to 1.
#[derive(Clone, Copy, Default)]
struct Off {
    diffuse: f64,
    specular: f64,
    /// The angle of the light's direction in radians.
    turn: f64,
    /// What a spot leaves of the light.
    share: f64,
}

impl Off {
    fn specular(&self, slope: f64, of_eye: f64) -> f64 {
        (slope * (self.turn + of_eye) + self.share).min(1.0)
    }
}

fn of_light(light: &LocalLight, wrap: &Wrap, t: f64, way: DVec3) -> Off {
    let is_dark = |spot: &Spot| {
        let reaches = |way: DVec3| spot.axis.dot(way) < 0.0;
        !reaches(way) && !reaches(wrap.chord(t))
    };
    if light.spot.as_ref().is_some_and(is_dark) {
        return Off::default();
    }
    let turn = turn(wrap, t, way);
    let share = light.spot.as_ref().map_or(0.0, |spot| slope(spot.exponent) * turn);
    Off { diffuse: (turn + share).min(1.0), specular: 0.0, turn, share }
}

/// The channel that is off most.
fn brightest(frame: &Frame, material: &Material, off: impl Iterator<Item = Off>) -> f64 {
    let mut channels = [0.0; 3];
    for (colour, Off { diffuse, specular, .. }) in frame.light_colours().zip(off) {
        for (channel, sum) in channels.iter_mut().enumerate() {
            let reflected =
                material.diffuse[channel] * diffuse + material.specular[channel] * specular;
            *sum += colour[channel] * reflected;
        }
    }
    channels.into_iter().fold(0.0, f64::max).min(1.0)
}

/// The angle between a wrapped direction and that of `way`, in radians; π where either has none.
fn turn(wrap: &Wrap, t: f64, way: DVec3) -> f64 {
    let halfway = wrap.axis + wrap.chord(t);
    let square = halfway.length_squared();
    if square == 0.0 || way == DVec3::ZERO {
        return std::f64::consts::PI;
    }
    let wrapped = 2.0 * halfway.dot(wrap.axis) / square * halfway - wrap.axis;
    wrapped.cross(way).length().atan2(wrapped.dot(way))
}

/// The steepest slope of cos^n, √n ((n - 1)/n)^((n - 1)/2), where cos² = (n - 1)/n.
fn slope(exponent: u32) -> f64 {
    let n = f64::from(exponent.max(1));
    n.sqrt() * ((n - 1.0) / n).powf((n - 1.0) / 2.0)
}
