//! How far the directions to lights and eye that a method takes are from what a pixel sees.
use glam::DVec3;
use specula_golden::exact::illumination::{self, Illumination};
use specula_scene::{Frame, Span, Wrap};
use specula_spec::phong::{wrap_to_eye, wrap_to_light};

use super::lobe::power_turned;
use super::normal::{angle, wrap_turn};

/// What is known of the direction to a light or to the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// So many radians off, and so much of a spot's factor.
    Off { turn: f64, share: f64 },
    /// Nothing: it has no direction somewhere.
    Unknown,
}

/// The truth.
const TRUE: Direction = Direction::Off { turn: 0.0, share: 0.0 };

/// Directions at one pixel.
pub struct Directions {
    /// To each light.
    pub lights: Vec<Direction>,
    /// To the eye.
    pub view: Direction,
}

impl Directions {
    /// As the pixel sees them.
    pub fn exact(frame: &Frame) -> Directions {
        Directions { lights: frame.light_colours().map(|_| TRUE).collect(), view: TRUE }
    }

    /// As the middle of the span sees them.
    pub fn of_the_middle(frame: &Frame, span: &Span, i: u32) -> Directions {
        let (here, middle) = (span.weights(i), middle(span));
        let pairs =
            illumination::lights(frame, span, here).zip(illumination::lights(frame, span, middle));
        let light = |pair: (Option<Illumination>, Option<Illumination>)| match pair {
            (Some(here), Some(middle)) => Direction::Off {
                turn: angle(here.direction, middle.direction),
                share: (here.share - middle.share).abs(),
            },
            _ => Direction::Unknown,
        };
        let views =
            illumination::view(frame, span, here).zip(illumination::view(frame, span, middle));
        Directions {
            lights: pairs.map(light).collect(),
            view: views.map_or(Direction::Unknown, |(here, middle)| Direction::Off {
                turn: angle(here, middle),
                share: 0.0,
            }),
        }
    }

    /// Wrapped along the span.
    pub fn wrapped(frame: &Frame, span: &Span, i: u32) -> Directions {
        let (t, position) = (span.parameter(i), frame.position_at(span, span.weights(i)));
        let far = frame.lights.iter().map(|_| TRUE);
        let near = frame.local_lights.iter().map(|light| {
            let off = off(&wrap_to_light(frame, span, light), t, light.position - position);
            match (off, &light.spot) {
                (Direction::Off { turn, .. }, Some(spot)) => {
                    Direction::Off { turn, share: power_turned(turn, spot.exponent) }
                }
                _ => off,
            }
        });
        let view =
            frame.eye.map_or(TRUE, |eye| off(&wrap_to_eye(frame, span, eye), t, eye - position));
        Directions { lights: far.chain(near).collect(), view }
    }
}

/// The middle of a span.
pub fn middle(span: &Span) -> [f64; 3] {
    std::array::from_fn(|v| f64::midpoint(span.start[v], span.end[v]))
}

/// How far a wrap is from `truth` at parameter `t`.
fn off(wrap: &Wrap, t: f64, truth: DVec3) -> Direction {
    let interpolated = wrap.ends[0].lerp(wrap.ends[1], t);
    match wrap_turn(interpolated, Some(wrap.axis)) {
        Some(turn) if truth != DVec3::ZERO => {
            Direction::Off { turn: turn + angle(interpolated, truth), share: 0.0 }
        }
        _ => Direction::Unknown,
    }
}
