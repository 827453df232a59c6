//! What a camera shows in all frames, where it chooses that by itself.
use glam::DVec3;

use crate::picture::Scene;
use crate::picture::camera::{Camera, Window};
use crate::picture::project::PictureError;

/// What a camera shows in all frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Framing {
    /// The smallest and largest coordinates of all objects of all frames, each in its own view space.
    bounds: [DVec3; 2],
    /// World units from the picture's bottom to its top.
    height: f64,
}

impl Framing {
    /// Whether a camera leaves something open that is to be the same in all frames.
    pub fn is_needed(camera: &Camera) -> bool {
        camera.target.is_none() || camera.height.is_none()
    }

    /// Nothing yet, within a box that the objects of a frame are in.
    pub fn around(bounds: [DVec3; 2]) -> Framing {
        Framing { bounds, height: 0.0 }
    }

    /// What shows another frame's objects as well.
    pub fn and(self, [low, high]: [DVec3; 2]) -> Framing {
        let bounds = [self.bounds[0].min(low), self.bounds[1].max(high)];
        Framing { bounds, ..self }
    }

    /// The same, high enough for a scene, of which the camera shows the middle of everything that is
    /// seen over time, in the picture's own directions, unless it has a target.
    pub fn high_enough(self, scene: &Scene) -> Result<Framing, PictureError> {
        let rotation = scene.camera.rotation().ok_or(PictureError::Up)?;
        let window = Window::new(&scene.camera, rotation, self.bounds, scene.size)
            .ok_or(PictureError::NoExtent)?;
        Ok(Framing { height: self.height.max(window.pixel * f64::from(scene.size.1)), ..self })
    }

    /// The camera with what it left open.
    pub fn applied(self, camera: Camera) -> Camera {
        let middle = (self.bounds[0] + self.bounds[1]) / 2.0;
        let target = camera.rotation().map(|rotation| rotation.transpose() * middle);
        Camera {
            target: camera.target.or(target),
            height: camera.height.or(Some(self.height)),
            ..camera
        }
    }
}
