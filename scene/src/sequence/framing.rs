//! What a camera shows in all frames, where it chooses that by itself.
use glam::DVec3;

use crate::picture::Scene;
use crate::picture::camera::{Camera, Lens, Window};
use crate::picture::pinhole::Pinhole;
use crate::picture::project::PictureError;

/// What a camera shows in all frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Framing {
    /// The smallest and largest coordinates of all objects of all frames, each in its own view space.
    bounds: [DVec3; 2],
    /// The point at the picture's centre in view space, where the camera has no target.
    centre: DVec3,
    /// World units from the picture's bottom to its top, of parallel lines of sight.
    height: f64,
    /// World units from the target to the eye of a perspective camera.
    distance: f64,
}

impl Framing {
    /// Whether a camera leaves something open that is to be the same in all frames.
    pub fn is_needed(camera: &Camera) -> bool {
        let is_placed = match &camera.lens {
            None => camera.height.is_some(),
            Some(lens) => lens.eye.is_some(),
        };
        camera.target.is_none() || !is_placed
    }

    /// Nothing yet, within a box that the objects of a frame are in.
    pub fn around(bounds: [DVec3; 2]) -> Framing {
        Framing { bounds, centre: middle(bounds), height: 0.0, distance: 0.0 }
    }

    /// The same of the boxes of both.
    pub fn and(self, other: Framing) -> Framing {
        let ([low, high], [other_low, other_high]) = (self.bounds, other.bounds);
        Framing::around([low.min(other_low), high.max(other_high)])
    }

    /// The same, high or far enough for a scene, of which the camera shows the middle of everything
    /// that is seen over time, in the picture's own directions, unless it has a target.
    pub fn enough_for(self, scene: &Scene) -> Result<Framing, PictureError> {
        match &scene.camera.lens {
            None => self.high_enough_for(scene),
            Some(lens) => self.far_enough_for(scene, lens),
        }
    }

    fn high_enough_for(self, scene: &Scene) -> Result<Framing, PictureError> {
        let rotation = scene.camera.rotation().ok_or(PictureError::Up)?;
        let window = Window::new(&scene.camera, rotation, self.bounds, scene.size)
            .ok_or(PictureError::NoExtent)?;
        Ok(Framing { height: self.height.max(window.pixel * f64::from(scene.size.1)), ..self })
    }

    fn far_enough_for(self, scene: &Scene, lens: &Lens) -> Result<Framing, PictureError> {
        let rotation = scene.camera.rotation().ok_or(PictureError::Up)?;
        let seen = (self.bounds, corners(self.bounds));
        let pinhole = Pinhole::new((&scene.camera, lens), rotation, seen, scene.size)
            .ok_or(PictureError::NoDistance)?;
        let distance = self.distance.max(pinhole.eye.distance(pinhole.target));
        Ok(Framing { centre: pinhole.target, distance, ..self })
    }

    /// The camera with what it left open.
    pub fn applied(self, camera: Camera) -> Camera {
        // A camera without a rotation is refused where its frame is made.
        let to_world = camera.rotation().unwrap_or_default().transpose();
        let target = camera.target.unwrap_or(to_world * self.centre);
        let eye = target + to_world * (DVec3::Z * self.distance);
        Camera {
            target: Some(target),
            height: camera.lens.map_or(camera.height.or(Some(self.height)), |_| None),
            lens: camera.lens.map(|lens| Lens { eye: lens.eye.or(Some(eye)), ..lens }),
            ..camera
        }
    }
}

fn middle([low, high]: [DVec3; 2]) -> DVec3 {
    (low + high) / 2.0
}

/// The corners of a box.
fn corners(bounds: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    let end = move |number: usize, axis: usize| bounds[number >> axis & 1][axis];
    (0..8).map(move |number| DVec3::new(end(number, 0), end(number, 1), end(number, 2)))
}
