//! Rays, and where they meet triangles.
use glam::DVec3;

/// A half line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it begins.
    pub origin: DVec3,
    /// Its direction, a unit vector.
    pub direction: DVec3,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The distance from the ray's origin.
    pub distance: f64,
    /// Barycentric weights there.
    pub weights: [f64; 3],
}

impl Ray {
    /// The point at a distance from the origin.
    pub fn at(self, distance: f64) -> DVec3 {
        self.origin + distance * self.direction
    }

    /// Where it meets a triangle, seen from either side, farther than `nearest` from its origin
    /// [Möller and Trumbore].
    pub fn crossing(self, [a, b, c]: [DVec3; 3], nearest: f64) -> Option<Crossing> {
        let (ab, ac) = (b - a, c - a);
        let across = self.direction.cross(ac);
        let determinant = ab.dot(across);
        if determinant == 0.0 {
            return None;
        }
        let from = self.origin - a;
        let beside = from.cross(ab);
        let v = from.dot(across) / determinant;
        let w = self.direction.dot(beside) / determinant;
        let distance = ac.dot(beside) / determinant;
        let meets = v >= 0.0 && w >= 0.0 && v + w <= 1.0 && distance > nearest;
        meets.then_some(Crossing { distance, weights: [1.0 - v - w, v, w] })
    }

    /// The distance at which it enters the box between two corners; `None` if it misses the box or
    /// enters it no nearer than `farthest`.
    pub fn entry(self, [low, high]: [DVec3; 2], farthest: f64) -> Option<f64> {
        let (to_low, to_high) =
            ((low - self.origin) / self.direction, (high - self.origin) / self.direction);
        let enters = to_low.min(to_high).max_element().max(0.0);
        let leaves = to_low.max(to_high).min_element();
        (enters <= leaves && enters < farthest).then_some(enters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_meets_a_triangle_where_it_should() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let ray = |x: f64, y: f64| Ray { origin: DVec3::new(x, y, 2.0), direction: DVec3::NEG_Z };
        let crossing = ray(0.25, 0.5).crossing(triangle, 0.0).unwrap();
        assert_eq!(crossing, Crossing { distance: 2.0, weights: [0.25, 0.25, 0.5] });
        assert_eq!(ray(0.25, 0.5).at(crossing.distance), DVec3::new(0.25, 0.5, 0.0));
        assert!(ray(0.25, 0.5).crossing(triangle, 2.0).is_none());
        assert!(ray(0.75, 0.5).crossing(triangle, 0.0).is_none());
    }

    #[test]
    fn a_ray_enters_a_box_in_front_of_it_only() {
        let unit = [DVec3::ZERO, DVec3::ONE];
        let ray = |z: f64| Ray { origin: DVec3::new(0.5, 0.5, z), direction: DVec3::NEG_Z };
        assert_eq!(ray(3.0).entry(unit, f64::INFINITY), Some(2.0));
        assert_eq!(ray(3.0).entry(unit, 2.0), None);
        assert_eq!(ray(0.5).entry(unit, f64::INFINITY), Some(0.0));
        assert_eq!(ray(-1.0).entry(unit, f64::INFINITY), None);
    }
}
