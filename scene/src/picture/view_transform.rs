//! Lights in view space.
use glam::{DMat3, DVec3};

use super::scene::{Light, LightSource, LightSpace};
use crate::{DirectionalLight, LocalLight, Spot};

/// The transformation from the world to view space.
#[derive(Clone, Copy)]
pub(super) struct ViewTransform {
    pub rotation: DMat3,
    /// The point at the picture's centre, in view space.
    pub centre: DVec3,
}

impl ViewTransform {
    /// The view of a world that is already in view space.
    pub const NONE: ViewTransform =
        ViewTransform { rotation: DMat3::IDENTITY, centre: DVec3::ZERO };

    /// A direction in view space, of length 1.
    fn direction(self, space: LightSpace, direction: DVec3) -> DVec3 {
        let largest = direction.abs().max_element();
        let unit = (direction / largest).normalize_or(DVec3::Z);
        match space {
            LightSpace::World => (self.rotation * unit).normalize(),
            LightSpace::View => unit,
        }
    }

    /// A position in view space; one that is given in view space is relative to the picture's
    /// centre.
    fn place(self, space: LightSpace, position: DVec3) -> DVec3 {
        match space {
            LightSpace::World => self.rotation * position,
            LightSpace::View => self.centre + position,
        }
    }
}

impl Light {
    pub(super) fn at_infinity(&self, view: ViewTransform) -> Option<DirectionalLight> {
        match self.source {
            LightSource::Directional { direction } => Some(DirectionalLight {
                direction: view.direction(self.space, direction),
                colour: self.colour,
            }),
            LightSource::Point { .. } | LightSource::Spot { .. } => None,
        }
    }

    pub(super) fn at_a_place(&self, view: ViewTransform) -> Option<LocalLight> {
        let (position, spot, attenuation) = match self.source {
            LightSource::Directional { .. } => return None,
            LightSource::Point { position, attenuation } => (position, None, attenuation),
            LightSource::Spot { position, axis, exponent, attenuation } => {
                let spot = Spot { axis: view.direction(self.space, axis), exponent };
                (position, Some(spot), attenuation)
            }
        };
        Some(LocalLight {
            position: view.place(self.space, position),
            spot,
            attenuation,
            colour: self.colour,
        })
    }
}
