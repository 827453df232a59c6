//! Default values of a scene.
use glam::DVec3;

use crate::picture::{Light, LightSource, LightSpace};
use crate::{Colour, Material};

/// Width and height of a picture in pixels.
pub const SIZE: (u32, u32) = (640, 480);

/// Background colour, 8 bits a component.
pub const BACKGROUND: [u8; 3] = [0, 0, 0];

/// Colour of the ambient light.
pub const AMBIENT: Colour = [0.15; 3];

/// The material of an object without one: light grey with a soft highlight.
pub fn material() -> Material {
    Material { ambient: [0.7; 3], diffuse: [0.7; 3], specular: [0.4; 3], shininess: 32 }
}

/// The light of a scene without one: white, from the left above the eye.
pub fn light() -> Light {
    let source = LightSource::Directional { direction: DVec3::new(-0.5, 0.8, 1.0) };
    Light { source, space: LightSpace::View, colour: [1.0; 3] }
}
