//! The perspective camera: what it sees through a point.
use glam::{DMat3, DVec3};

use super::camera::{Camera, FILLED, Lens, nearest_centre};
use super::clip::{HalfSpace, cut, of_triangle};
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
        let (cos, sin) = cos_sin(lens.field_of_view / 2.0);
        let pixel = 2.0 * sin / (cos * height);
        let target = camera.target.map(|place| rotation * place);
        let middle = (bounds[0] + bounds[1]) / 2.0;
        let (eye, target) = match lens.eye {
            Some(eye) => (rotation * eye, target.unwrap_or(middle)),
            None => {
                let half = [width, height].map(|pixels| FILLED * pixel * pixels / 2.0);
                Frustum::around(corners, half).placed(target, middle)?
            }
        };
        let near = lens.near.unwrap_or(NEAR * eye.distance(target)).max(NEAREST);
        let middle = [width, height].map(|pixels| pixels / 2.0);
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
        let this = *self;
        (1..polygon.len().saturating_sub(1)).map(move |k| {
            let piece = [polygon[0], polygon[k], polygon[k + 1]];
            let seen = Perspective {
                corners: piece.map(|corner| corner.weights.to_array()),
                nearness: piece.map(|corner| this.nearness(corner.place)),
                interpolation: this.interpolation,
            };
            (piece.map(|corner| this.place_in(corner.place, size)), seen)
        })
    }

    /// What is seen of a triangle within the `Pinhole::sight` whose corners are so near.
    pub fn whole(&self, nearness: [f64; 3]) -> Perspective {
        Perspective { corners: Perspective::WHOLE, nearness, interpolation: self.interpolation }
    }

    /// The reciprocal distance of a place, given from the eye.
    pub fn nearness(&self, place: DVec3) -> f64 {
        self.distance(place).recip()
    }

    /// The place in a picture of `size`, in pixels, of a point within the `Pinhole::sight`, which
    /// is given from the eye. Where an edge is cut off, it may be beyond by a rounding.
    pub fn place_in(&self, point: DVec3, size: (u32, u32)) -> [f64; 2] {
        let [x, y] = self.place(point);
        let [right, bottom] = [size.0, size.1].map(|n| f64::from(n) + MARGIN);
        [x.clamp(-MARGIN, right), y.clamp(-MARGIN, bottom)]
    }

    /// What the picture shows of the space around the eye, with a margin.
    pub(super) fn sight(&self, size: (u32, u32)) -> [HalfSpace; 5] {
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

/// The sides of the picture about places: planes that they are all within, as an eye sees them that
/// looks along -z.
///
/// A place p is within if |p_i - e_i| ≤ h_i (e_z - p_z) for the eye e, i either of x and y. So
/// e_z ≥ (p_i + h_i p_z - e_i)/h_i and e_z ≥ (e_i - (p_i - h_i p_z))/h_i.
struct Frustum {
    /// Half of the picture's width and height at the distance 1: h.
    half: [f64; 2],
    /// The largest p_i + h_i p_z.
    high: [f64; 2],
    /// The smallest p_i - h_i p_z.
    low: [f64; 2],
    /// The largest p_z.
    front: f64,
}

impl Frustum {
    fn around(places: impl Iterator<Item = DVec3>, half: [f64; 2]) -> Frustum {
        let none = [f64::INFINITY; 2];
        let nothing = Frustum { half, high: none.map(|x| -x), low: none, front: -f64::INFINITY };
        places.fold(nothing, |about, place| Frustum {
            half,
            high: [0, 1].map(|i| about.high[i].max(place[i] + half[i] * place.z)),
            low: [0, 1].map(|i| about.low[i].min(place[i] - half[i] * place.z)),
            front: about.front.max(place.z),
        })
    }

    /// The nearest eye that sees all places, and its target, which is as deep as `middle` if it is not
    /// given: the eye is then where the places are in the middle of the picture. `None` if all of them
    /// are at the target.
    fn placed(&self, target: Option<DVec3>, middle: DVec3) -> Option<(DVec3, DVec3)> {
        let Frustum { half, high, low, front } = self;
        let between = |i: usize| f64::midpoint(low[i], high[i]);
        let target = target.unwrap_or(DVec3::new(between(0), between(1), middle.z));
        let sides = [0, 1].map(|i| (high[i] - target[i]).max(target[i] - low[i]) / half[i]);
        let before = target.z + BEFORE * (front - target.z);
        let z = sides[0].max(sides[1]).max(before);
        let is_apart = z > target.z && z.is_finite();
        is_apart.then_some((DVec3::new(target.x, target.y, z), target))
    }
}
