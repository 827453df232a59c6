//! Directions to lights and eyes at places, by a root or without one [Hast, Barrera and Bengtsson,
//! §5 and §6; methods C15 to C18].
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Frame, LocalLight, Span, Wrap};

use super::differences::{Vector, difference, dot, scaled, vector};
use super::{Linear, Number, Second, Walk};
use crate::exact::formula::quadratic::Quadratic;

/// A place as seen from a pixel.
#[derive(Clone, Copy, Debug)]
pub struct SeenPlace<T> {
    /// The unit vector towards it.
    pub direction: Vector<T>,
    /// S·L of a spot.
    pub to_axis: T,
    /// A number above 0 where the place is within 90 degrees of the spot's axis.
    pub lit: T,
}

/// The direction to a place, one pixel after another.
pub trait PlaceDirection<T: Number>: Copy {
    /// The directions to a light.
    fn to_light(frame: &Frame, span: &Span, light: &LocalLight) -> Self;

    /// The directions to the eye.
    fn to_eye(frame: &Frame, span: &Span, eye: DVec3) -> Self;

    /// The direction at this pixel; then advances to the next.
    fn pixel(&mut self) -> SeenPlace<T>;
}

/// F - P by three additions, normalised [eq. 35].
#[derive(Clone, Copy, Debug)]
pub struct Normalised<T> {
    way: Walk<T>,
    axis: Vector<T>,
}

impl<T: Number> Normalised<T> {
    fn new(frame: &Frame, span: &Span, place: DVec3, axis: DVec3) -> Self {
        let [start, end] = frame.end_vectors_to(span, place);
        Normalised { way: Walk::new(start, (end - start) * span.weight_step()), axis: vector(axis) }
    }
}

impl<T: Number> PlaceDirection<T> for Normalised<T> {
    fn to_light(frame: &Frame, span: &Span, light: &LocalLight) -> Self {
        Normalised::new(
            frame,
            span,
            light.position,
            light.spot.as_ref().map_or(DVec3::ZERO, |spot| -spot.axis),
        )
    }

    fn to_eye(frame: &Frame, span: &Span, eye: DVec3) -> Self {
        Normalised::new(frame, span, eye, EYE)
    }

    #[inline(always)]
    fn pixel(&mut self) -> SeenPlace<T> {
        let way = self.way.pixel();
        let direction = scaled(T::of(1.0) / dot(way, way).floored().square_root(), way);
        let to_axis = dot(direction, self.axis);
        SeenPlace { direction, to_axis, lit: to_axis }
    }
}

/// H by three additions, p = H·w by one and q = H·H by two; the direction is 2(p/q)H - w and, for a
/// spot, the cosine 2p²/q - 1 [eq. 36 to 38].
#[derive(Clone, Copy, Debug)]
pub struct Wrapped<T> {
    halfway: Walk<T>,
    p: Linear<T>,
    q: Second<T>,
    axis: Vector<T>,
}

impl<T: Number> Wrapped<T> {
    fn new(span: &Span, wrap: Wrap) -> Self {
        let [start, end] = wrap.ends.map(|x| x + wrap.axis);
        let step = (end - start) * span.weight_step();
        Wrapped {
            halfway: Walk::new(start, step),
            p: Linear::new(start.dot(wrap.axis), step.dot(wrap.axis)),
            q: Second::new(Quadratic::square(start, step)),
            axis: vector(wrap.axis),
        }
    }
}

impl<T: Number> PlaceDirection<T> for Wrapped<T> {
    fn to_light(frame: &Frame, span: &Span, light: &LocalLight) -> Self {
        Wrapped::new(span, Wrap::to_light(frame, span, light))
    }

    fn to_eye(frame: &Frame, span: &Span, eye: DVec3) -> Self {
        Wrapped::new(span, Wrap::to_eye(frame, span, eye))
    }

    #[inline(always)]
    fn pixel(&mut self) -> SeenPlace<T> {
        let p = self.p.pixel();
        let v = p / self.q.pixel().floored();
        let twice = v + v;
        let direction = difference(scaled(twice, self.halfway.pixel()), self.axis);
        // H·w - 1 = (F - P)·w.
        let one = T::of(1.0);
        SeenPlace { direction, to_axis: twice * p - one, lit: p - one }
    }
}
