//! A rotation about an axis through a point, or a shift.
use glam::{DAffine3, DMat3, DVec3};

use crate::angle::cos_sin;

/// A rigid movement of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Movement(DAffine3);

impl Movement {
    /// The shift by `way`.
    pub fn shift(way: DVec3) -> Movement {
        Movement(DAffine3::from_translation(way))
    }

    /// The rotation by an angle in degrees, counter-clockwise as the end of the unit vector `axis`
    /// sees it, about the line along `axis` through `centre`.
    ///
    /// It is Rodrigues' R v = cos v + sin a × v + (1 - cos) (a·v) a, and p ↦ c + R (p - c).
    pub fn rotation(degrees: f64, axis: DVec3, centre: DVec3) -> Movement {
        let (cos, sin) = cos_sin(degrees);
        let column = |unit: DVec3| {
            unit * cos + axis.cross(unit) * sin + axis * (axis.dot(unit) * (1.0 - cos))
        };
        let rotation = DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z));
        Movement(DAffine3::from_mat3_translation(rotation, centre - rotation * centre))
    }

    /// Where a point goes.
    pub fn of_point(self, point: DVec3) -> DVec3 {
        self.0.transform_point3(point)
    }

    /// What becomes of a direction.
    pub fn of_direction(self, direction: DVec3) -> DVec3 {
        self.0.matrix3 * direction
    }

    /// What becomes of an object's place.
    pub fn of_place(self, place: DAffine3) -> DAffine3 {
        self.0 * place
    }
}
