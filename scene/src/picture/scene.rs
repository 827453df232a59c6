//! Objects in the world, and what lights them.
use glam::{DAffine3, DVec3};

use super::camera::Camera;
use crate::mesh::Mesh;
use crate::primitive::Primitive;
use crate::{Colour, Material};

/// A mesh put somewhere in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its shape, in its own coordinates.
    pub mesh: Mesh,
    /// The primitive that the mesh was made from, if it was.
    pub primitive: Option<Primitive>,
    /// From its own coordinates to the world's.
    pub place: DAffine3,
    /// How it answers light.
    pub material: Material,
}

/// The coordinates a light's direction is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSpace {
    /// Those of the objects: the light stays when the camera moves.
    World,
    /// Those of the picture, x right, y up, z to the eye: the light moves with the camera.
    View,
}

/// A light, as a scene gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Where it shines from.
    pub source: LightSource,
    /// What `source` is measured in.
    pub space: LightSpace,
    /// Its colour and strength.
    pub colour: Colour,
}

/// Where a light shines from.
#[derive(Clone, Debug, PartialEq)]
pub enum LightSource {
    /// From infinity.
    Directional {
        /// Towards the light; any length but 0.
        direction: DVec3,
    },
    /// From a place, to all sides.
    Point {
        /// The place.
        position: DVec3,
    },
    /// From a place, most of all along one direction.
    Spot {
        /// The place.
        position: DVec3,
        /// The direction along which it shines; any length but 0.
        axis: DVec3,
        /// Warn's exponent, 1 to 8191.
        exponent: u32,
    },
}

/// Everything a picture is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// 8-bit colour of pixels without object.
    pub background: [u8; 3],
    /// How the world is looked at.
    pub camera: Camera,
    /// Colour of the ambient light.
    pub ambient: Colour,
    /// Lights.
    pub lights: Vec<Light>,
    /// What is to be seen.
    pub objects: Vec<Object>,
}
