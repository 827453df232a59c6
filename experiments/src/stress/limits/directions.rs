//! The difference between the directions to lights and eye that a method uses and those that a
//! pixel sees.
use glam::DVec3;
use specula_golden::exact::formula::illumination::{
    self, Illumination, attenuation, attenuation_along,
};
use specula_scene::{Frame, LocalLight, Span, Wrap};

use super::lobe::power_turn_change;
use super::normal::{angle, wrap_turn};

/// The knowledge about the direction to a light or to the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// The direction is wrong by `turn` radians at most, and what a spot and distance leave by `share`.
    Known { turn: f64, share: f64 },
    /// Nothing is known, since there is no direction somewhere.
    Unknown,
}

/// The exact direction.
const TRUE: Direction = Direction::Known { turn: 0.0, share: 0.0 };

/// Directions at one pixel.
pub struct Directions {
    /// The direction to each light.
    pub lights: Vec<Direction>,
    /// The direction to the eye.
    pub view: Direction,
}

impl Directions {
    /// The directions that the pixel sees.
    pub fn exact(frame: &Frame, span: &Span, i: u32) -> Directions {
        let far = frame.lights.iter().map(|_| TRUE);
        let near = frame.local_lights.iter().map(|light| {
            let (here, along) = attenuations(frame, span, light, i);
            Direction::Known { turn: 0.0, share: (here - along).abs() }
        });
        Directions { lights: far.chain(near).collect(), view: TRUE }
    }

    /// The directions that the middle of the span sees.
    pub fn of_the_middle(frame: &Frame, span: &Span, i: u32) -> Directions {
        let (here, middle) = (span.weights(i), span.middle());
        let pairs =
            illumination::lights(frame, span, here).zip(illumination::lights(frame, span, middle));
        let far = frame.lights.iter().map(|_| (1.0, 1.0));
        let near = frame.local_lights.iter().map(|light| {
            let of_middle = attenuation(light, frame.position_at(span, middle));
            (of_middle, attenuations(frame, span, light, i).1)
        });
        let light = |(pair, (of_middle, along)): (
            (Option<Illumination>, Option<Illumination>),
            (f64, f64),
        )| match pair {
            (Some(here), Some(middle)) if of_middle > 0.0 => Direction::Known {
                turn: angle(here.direction, middle.direction),
                share: (here.share - middle.share / of_middle * along).abs(),
            },
            _ => Direction::Unknown,
        };
        let views =
            illumination::view(frame, span, here).zip(illumination::view(frame, span, middle));
        Directions {
            lights: pairs.zip(far.chain(near)).map(light).collect(),
            view: views.map_or(Direction::Unknown, |(here, middle)| Direction::Known {
                turn: angle(here, middle),
                share: 0.0,
            }),
        }
    }

    /// The directions wrapped along the span.
    pub fn wrapped(frame: &Frame, span: &Span, i: u32) -> Directions {
        let (t, position) = (span.parameter(i), frame.position_at(span, span.weights(i)));
        let far = frame.lights.iter().map(|_| TRUE);
        let near = frame.local_lights.iter().map(|light| {
            let off = wrap_error(&Wrap::to_light(frame, span, light), t, light.position - position);
            let Direction::Known { turn, .. } = off else { return off };
            let of_spot =
                light.spot.as_ref().map_or(0.0, |spot| power_turn_change(turn, spot.exponent));
            let (here, along) = attenuations(frame, span, light, i);
            Direction::Known { turn, share: of_spot + (here - along).abs() }
        });
        let view = frame
            .eye
            .map_or(TRUE, |eye| wrap_error(&Wrap::to_eye(frame, span, eye), t, eye - position));
        Directions { lights: far.chain(near).collect(), view }
    }
}

/// What distance leaves of a light at a pixel, and what methods have for it along the span.
fn attenuations(frame: &Frame, span: &Span, light: &LocalLight, i: u32) -> (f64, f64) {
    let here = attenuation(light, frame.position_at(span, span.weights(i)));
    let along = attenuation_along(frame, span, light).at(span.parameter(i)).clamp(0.0, 1.0);
    (here, along)
}

/// The difference between a wrap and `truth` at parameter `t`.
fn wrap_error(wrap: &Wrap, t: f64, truth: DVec3) -> Direction {
    let interpolated = wrap.chord(t);
    match wrap_turn(interpolated, Some(wrap.axis)) {
        Some(turn) if truth != DVec3::ZERO => {
            Direction::Known { turn: turn + angle(interpolated, truth), share: 0.0 }
        }
        _ => Direction::Unknown,
    }
}
