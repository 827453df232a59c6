//! The perspective camera: what it sees through a point.
use glam::{DMat3, DVec3};

use super::camera::{Camera, FILLED, Lens, nearest_centre};
use super::clip::{Corner, HalfSpace, cut, of_triangle};
use crate::angle::cos_sin;
use crate::perspective::{Interpolation, Perspective};

/// The distance to the near plane, in units of that to the target.
const NEAR: f64 = 1e-3;

/// The smallest such distance in world units.
const NEAREST: f64 = 1e-30;

/// The distance from the target to an eye that frames the objects, in units of that to their nearest
/// point, at least.
const BEFORE: f64 = 1.125;

/// How far triangles reach beyond the picture, in pixels: what is farther is cut off.
const MARGIN: f64 = 1.0;

/// The perspective projection of view space to a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinhole {
    /// The position of the eye in view space; it looks along -z.
    pub eye: DVec3,
    /// The point that it looks at, in view space.
    pub target: DVec3,
    /// Units of view space for a pixel, at the distance 1 from the eye.
    pixel: f64,
    /// The place of the target in the picture, in pixels from its top left corner.
    middle: [f64; 2],
    /// Distance from the eye to the near plane.
    near: f64,
    interpolation: Interpolation,
}

impl Pinhole {
    /// The projection to a picture of `size` pixels through a camera's `lens`.
    ///
    /// `bounds` are the smallest and largest view-space coordinates of all objects, `corners` those
    /// of their triangles; `rotation` is the camera's. The result is `None` if the objects have no
    /// extent from which a distance could be computed.
    pub fn new(
        (camera, lens): (&Camera, &Lens),
        rotation: DMat3,
        (bounds, corners): ([DVec3; 2], impl Iterator<Item = DVec3>),
        size: (u32, u32),
    ) -> Option<Pinhole> {
        let (width, height) = (f64::from(size.0), f64::from(size.1));
        let target = camera.target.map_or((bounds[0] + bounds[1]) / 2.0, |place| rotation * place);
        let (cos, sin) = cos_sin(lens.field_of_view / 2.0);
        let pixel = 2.0 * sin / (cos * height);
        let eye = match lens.eye {
            Some(eye) => rotation * eye,
            None => {
                let half = [width, height].map(|pixels| FILLED * pixel * pixels / 2.0);
                target + DVec3::Z * distance(corners.map(|corner| corner - target), half)?
            }
        };
        let near = lens.near.unwrap_or(NEAR * eye.distance(target)).max(NEAREST);
        let middle = [width / 2.0, height / 2.0];
        Some(Pinhole { eye, target, pixel, middle, near, interpolation: lens.interpolation })
    }

    /// The projection moved by at most half a pixel in either direction, so that a point of view
    /// space is at the middle of a pixel.
    pub fn with_on_a_pixel(self, point: DVec3, size: (u32, u32)) -> Pinhole {
        let [x, y] = self.place(point - self.eye);
        let [column, row] = nearest_centre([x, y], size);
        Pinhole { middle: [self.middle[0] + column - x, self.middle[1] + row - y], ..self }
    }

    /// Whether a point of view space is at least as far away as the near plane.
    pub fn is_in_front(&self, point: DVec3) -> bool {
        self.eye.z - point.z >= self.near
    }

    /// What is seen of a triangle of view space in a picture of `size`: pieces, with the places of
    /// their corners in pixels. A piece is the triangle itself, if it need not be cut.
    pub fn pieces(
        &self,
        corners: [DVec3; 3],
        size: (u32, u32),
    ) -> impl Iterator<Item = ([[f64; 2]; 3], Perspective)> + use<> {
        let whole = of_triangle(corners.map(|corner| corner - self.eye));
        let polygon = self.sight(size).iter().fold(whole, cut);
        let (this, [right, bottom]) = (*self, [size.0, size.1].map(|n| f64::from(n) + MARGIN));
        // Where a corner is cut off, it may be beyond by a rounding.
        let place = move |corner: &Corner| {
            let [x, y] = this.place(corner.place);
            [x.clamp(-MARGIN, right), y.clamp(-MARGIN, bottom)]
        };
        (1..polygon.len().saturating_sub(1)).map(move |k| {
            let piece = [polygon[0], polygon[k], polygon[k + 1]];
            let seen = Perspective {
                corners: piece.map(|corner| corner.weights.to_array()),
                nearness: piece.map(|corner| this.distance(corner.place).recip()),
                interpolation: this.interpolation,
            };
            (piece.map(|corner| place(&corner)), seen)
        })
    }

    /// What the picture shows of the space around the eye, with a margin.
    fn sight(&self, size: (u32, u32)) -> [HalfSpace; 5] {
        // A plane through the eye and a side of the picture, so many pixels away from its middle.
        let side = |across: DVec3, pixels: f64| HalfSpace {
            normal: across - DVec3::Z * (pixels + MARGIN) * self.pixel,
            offset: 0.0,
        };
        let [x, y] = self.middle;
        [
            HalfSpace { normal: DVec3::NEG_Z, offset: self.near },
            side(DVec3::X, x),
            side(DVec3::NEG_X, f64::from(size.0) - x),
            side(DVec3::NEG_Y, y),
            side(DVec3::Y, f64::from(size.1) - y),
        ]
    }

    /// The distance of a place, given from the eye, along the direction in which the eye looks. Places
    /// on the near plane may be nearer by a rounding.
    fn distance(&self, place: DVec3) -> f64 {
        (-place.z).max(self.near)
    }

    /// A place, given from the eye, in the picture, in pixels from its top left corner.
    fn place(&self, place: DVec3) -> [f64; 2] {
        let [x, y] = self.middle;
        let unit = self.distance(place) * self.pixel;
        [x + place.x / unit, y - place.y / unit]
    }
}

/// The smallest distance of an eye from the target at which places, given from the target, are in the
/// picture, `half` of whose width and height at the distance 1 is given; `None` if they have no extent.
///
/// A place is in the picture if |x| ≤ h (d - z), so d is z + |x|/h at least.
fn distance(places: impl Iterator<Item = DVec3>, half: [f64; 2]) -> Option<f64> {
    let needed = |place: DVec3| {
        let beside = (place.x.abs() / half[0]).max(place.y.abs() / half[1]);
        (place.z + beside).max(BEFORE * place.z)
    };
    let distance = places.map(needed).fold(0.0, f64::max);
    (distance > 0.0 && distance.is_finite()).then_some(distance)
}
