//! Objects in the world, and what lights them.
use glam::{DAffine3, DVec3};

use super::camera::Camera;
use crate::mesh::SharedMesh;
use crate::primitive::Primitive;
use crate::{Attenuation, Colour, Material, PartialMaterial};

/// A mesh at a place in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its shape, in its own coordinates; frames of a sequence share it.
    pub mesh: SharedMesh,
    /// The primitive that the mesh was made from, if any.
    pub primitive: Option<Primitive>,
    /// The transformation from its own coordinates to the world's.
    pub place: DAffine3,
    /// What is said about its material; it takes precedence over the mesh's own materials.
    pub material: PartialMaterial,
}

impl Object {
    /// Its materials: one for each of the mesh's, or one for all of its triangles if the mesh has
    /// none.
    pub fn materials(&self) -> Vec<Material> {
        match &self.mesh.materials[..] {
            [] => vec![self.material.complete()],
            own => own.iter().map(|own| self.material.or(own).complete()).collect(),
        }
    }

    /// The material of a triangle, as an index of [`Object::materials`].
    pub fn material_index(&self, triangle: usize) -> usize {
        self.mesh.material_indices.get(triangle).map_or(0, |&index| index as usize)
    }
}

/// The coordinates in which a light's direction is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSpace {
    /// The coordinates of the objects: the light stays when the camera moves.
    World,
    /// The coordinates of the picture, x right, y up, z to the eye: the light moves with the
    /// camera.
    View,
}

/// A light of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The place or direction of the light.
    pub source: LightSource,
    /// The coordinates of `source`.
    pub space: LightSpace,
    /// Its colour and strength.
    pub colour: Colour,
}

/// The place or direction of a light.
#[derive(Clone, Debug, PartialEq)]
pub enum LightSource {
    /// The light is at infinity.
    Directional {
        /// The direction to the light; any length except 0.
        direction: DVec3,
    },
    /// The light is at a place and shines in all directions.
    Point {
        /// The place.
        position: DVec3,
        /// How it becomes weaker with distance, if it does.
        attenuation: Option<Attenuation>,
    },
    /// The light is at a place and shines most strongly along its axis.
    Spot {
        /// The place.
        position: DVec3,
        /// The direction along which it shines; any length except 0.
        axis: DVec3,
        /// Warn's exponent, 1 to 8191.
        exponent: u32,
        /// How it becomes weaker with distance, if it does.
        attenuation: Option<Attenuation>,
    },
}

/// Everything a picture is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// 8-bit colour of pixels without an object.
    pub background: [u8; 3],
    /// The camera.
    pub camera: Camera,
    /// Colour of the ambient light.
    pub ambient: Colour,
    /// Lights.
    pub lights: Vec<Light>,
    /// The objects.
    pub objects: Vec<Object>,
}
