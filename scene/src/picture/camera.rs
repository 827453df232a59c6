//! The camera: orthographic, the eye at infinity, unless it has a lens.
use glam::{DMat3, DVec3};

use crate::perspective::Interpolation;

/// Share of the picture's smaller dimension that objects fill when the camera frames them itself.
pub(super) const FILLED: f64 = 0.9;

/// Least sine of the angle between `up` and the eye; below it, the up direction is undefined.
const LEAST_SINE: f64 = 1e-9;

/// The camera's position and orientation.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The direction to the eye, in world coordinates; any length except 0.
    pub direction: DVec3,
    /// The direction that points up in the picture, in world coordinates; not along `direction`.
    pub up: DVec3,
    /// The world point at the picture's centre; if `None`, the middle of the objects, or where a
    /// perspective camera that chooses its distance has to look to see them in the picture's middle.
    pub target: Option<DVec3>,
    /// World units from the picture's bottom to its top; if `None`, what the objects need.
    pub height: Option<f64>,
    /// The position of the eye that sees highlights, in world coordinates; if `None`, it is at
    /// infinity along `direction`.
    pub eye: Option<DVec3>,
    /// What makes it a perspective camera, in which `height` has no meaning; if `None`, lines of
    /// sight are parallel.
    pub lens: Option<Lens>,
}

/// What a perspective camera has in place of a height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// The angle from the picture's bottom to its top in degrees, 1 to 170.
    pub field_of_view: f64,
    /// The position of the eye that lines of sight start at, in world coordinates; if `None`, it is
    /// along the camera's `direction` from its target, so far away that the objects are in the
    /// picture.
    pub eye: Option<DVec3>,
    /// Distance from the eye to the near plane in world units, 1e-30 to 1e30; what is nearer is not
    /// seen. If `None`, a thousandth of the distance to the target.
    pub near: Option<f64>,
    /// How weights of vertices go along spans.
    pub interpolation: Interpolation,
}

impl Lens {
    /// The field of view in degrees of a camera that does not state one.
    pub const FIELD_OF_VIEW: f64 = 40.0;
}

impl Default for Camera {
    /// The camera looks from the front, a little to the right and above; y is up.
    fn default() -> Camera {
        Camera {
            direction: DVec3::new(0.5, 0.45, 1.0),
            up: DVec3::Y,
            target: None,
            height: None,
            eye: None,
            lens: None,
        }
    }
}

impl Camera {
    /// Whether it takes position and scale of the picture from the objects.
    pub fn frames_objects(&self) -> bool {
        let has_distance = self.lens.map_or(self.height.is_some(), |lens| lens.eye.is_some());
        self.target.is_none() && !has_distance
    }

    /// The rotation from world to view space; `None` if `up` is along `direction`, or either has no
    /// direction.
    pub fn rotation(&self) -> Option<DMat3> {
        let backward = unit(self.direction)?;
        let across = unit(self.up)?.cross(backward);
        if across.length() < LEAST_SINE {
            return None;
        }
        let right = across.normalize();
        let up = backward.cross(right);
        Some(DMat3::from_cols(right, up, backward).transpose())
    }
}

/// A vector of length 1 along `v`, unless it is 0 or not finite.
fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    // The vector is scaled first, so that squares neither vanish nor overflow.
    (largest > 0.0 && largest.is_finite()).then(|| (v / largest).normalize())
}

/// The window of view space that the picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The point at the picture's centre, in view space.
    pub centre: DVec3,
    /// Units of view space for a pixel.
    pub pixel: f64,
}

impl Window {
    /// The window of a picture of `size` pixels.
    ///
    /// `bounds` are the smallest and largest view-space coordinates of all objects; `rotation` is
    /// the camera's. The result is `None` if the objects have no extent from which the height could
    /// be computed.
    pub fn new(
        camera: &Camera,
        rotation: DMat3,
        bounds: [DVec3; 2],
        size: (u32, u32),
    ) -> Option<Window> {
        let (width, height) = (f64::from(size.0), f64::from(size.1));
        let centre = match camera.target {
            Some(target) => rotation * target,
            None => (bounds[0] + bounds[1]) / 2.0,
        };
        // Half of the extent that has to fit, measured from the centre to the farther side.
        let half = (bounds[1] - centre).abs().max((bounds[0] - centre).abs());
        let needed = (half.y / height).max(half.x / width) * 2.0 / FILLED;
        let pixel = camera.height.map_or(needed, |units| units / height);
        (pixel > 0.0 && pixel.is_finite()).then_some(Window { centre, pixel })
    }

    /// The window moved by at most half a pixel in either direction, so that a point of view space
    /// is at the middle of a pixel.
    pub fn with_on_a_pixel(self, point: DVec3, size: (u32, u32)) -> Window {
        let [x, y] = self.place(point, size);
        let [column, row] = nearest_centre([x, y], size);
        let right = (x - column) * self.pixel;
        let up = (row - y) * self.pixel;
        Window { centre: self.centre + DVec3::new(right, up, 0.0), ..self }
    }

    /// The place of a point of view space in a picture of `size`, in pixels from its top left
    /// corner.
    pub fn place(&self, point: DVec3, size: (u32, u32)) -> [f64; 2] {
        let x = f64::from(size.0) / 2.0 + (point.x - self.centre.x) / self.pixel;
        let y = f64::from(size.1) / 2.0 - (point.y - self.centre.y) / self.pixel;
        [x, y]
    }
}

/// The centre of the pixel of a picture of `size` that is nearest to a place in pixels.
pub(super) fn nearest_centre([x, y]: [f64; 2], size: (u32, u32)) -> [f64; 2] {
    let middle = |at: f64, pixels: u32| (at.floor() + 0.5).clamp(0.5, f64::from(pixels) - 0.5);
    [middle(x, size.0), middle(y, size.1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_camera_looks_from_the_front_with_y_up() {
        let rotation = Camera::default().rotation().unwrap_or_default();
        assert!(
            (rotation * DVec3::Y).y > 0.8
                && (rotation * DVec3::Z).z > 0.8
                && (rotation * DVec3::X).x > 0.8
        );
        assert!((rotation.determinant() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_camera_without_direction_has_no_rotation() {
        let camera = |direction, up| Camera { direction, up, ..Camera::default() };
        for (direction, up) in
            [(DVec3::ZERO, DVec3::Y), (DVec3::Y, DVec3::Y * 2.0), (DVec3::Z, DVec3::ZERO)]
        {
            assert_eq!(camera(direction, up).rotation(), None);
        }
        assert!(camera(DVec3::Z * 1e-200, DVec3::Y * 1e200).rotation().is_some());
    }
}
