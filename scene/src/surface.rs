//! Curved surfaces that meshes represent: the reference for interpolated normals.
use glam::{DAffine3, DMat3, DVec3};

use crate::frame::EYE;
use crate::primitive::Primitive;

/// A surface whose normal is known everywhere, placed in view space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    shape: Shape,
    /// The eye that lines of sight meet in, in view space; `None` where they are parallel to z.
    eye: Option<DVec3>,
    /// The transformation from view space to the shape's own coordinates.
    to_own: DAffine3,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    /// The unit sphere.
    Sphere,
    /// The tube of this radius around the unit circle about the y axis.
    Torus { tube: f64 },
}

/// The value and gradient at a point of a function that is 0 on a surface.
struct Implicit {
    value: f64,
    /// The gradient, which points outward.
    gradient: DVec3,
}

impl Shape {
    /// The function at a point; `None` where it has no gradient: on the axis and the circle of the
    /// torus.
    fn implicit(self, point: DVec3) -> Option<Implicit> {
        match self {
            Shape::Sphere => {
                Some(Implicit { value: (point.length_squared() - 1.0) / 2.0, gradient: point })
            }
            Shape::Torus { tube } => {
                let gradient = point - DVec3::new(point.x, 0.0, point.z).try_normalize()?;
                Some(Implicit { value: (gradient.length_squared() - tube * tube) / 2.0, gradient })
            }
        }
    }
}

/// Number of Newton steps; starting at the mesh's distance from the surface, each doubles the
/// number of exact digits.
const STEPS: u32 = 16;
/// A distance below this counts as 0: it is a length in the surface's own coordinates, in which the
/// surface is about 1 wide.
const MET: f64 = 1e-13;

impl Surface {
    /// The surface on which a primitive's vertices lie, if its normals are known in closed form;
    /// `to_view` transforms from its own coordinates to view space.
    pub fn of(primitive: Primitive, to_view: DAffine3) -> Option<Surface> {
        let shape = match primitive {
            Primitive::Sphere { .. } | Primitive::Icosahedron { .. } => Shape::Sphere,
            Primitive::Torus { tube, .. } => Shape::Torus { tube },
            // Bicubic patches are not the zeros of a function that could be written down.
            Primitive::Teapot { .. } => return None,
        };
        Some(Surface { shape, eye: None, to_own: to_view.inverse() })
    }

    /// The surface as an eye in view space sees it; without one, along lines parallel to z.
    pub fn seen_from(self, eye: Option<DVec3>) -> Surface {
        Surface { eye, ..self }
    }

    /// The unit normal in view space where the line of sight through `place` meets the surface near
    /// it, on the side of `towards`. The result is `None` if the line misses the surface, as it may
    /// near an outline.
    pub fn normal(&self, place: DVec3, towards: DVec3) -> Option<DVec3> {
        let sight = self.eye.map_or(EYE, |eye| eye - place);
        let outward =
            self.met(self.to_own.transform_point3(place), self.to_own.transform_vector3(sight))?;
        // Normals transform by the inverse transpose of the transformation to view space.
        let normal = (DMat3::transpose(&self.to_own.matrix3) * outward).try_normalize()?;
        Some(if normal.dot(towards) < 0.0 { -normal } else { normal })
    }

    /// The gradient at the point where a line meets the surface, in its own coordinates, found by
    /// Newton's method along the line.
    fn met(&self, mut point: DVec3, along: DVec3) -> Option<DVec3> {
        for _ in 0..STEPS {
            let Implicit { value, gradient } = self.shape.implicit(point)?;
            if value.abs() < MET {
                return Some(gradient);
            }
            point -= along * (value / gradient.dot(along));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A transformation that rotates, scales, mirrors and moves.
    fn to_view() -> DAffine3 {
        DAffine3::from_scale_rotation_translation(
            DVec3::new(-0.5, 2.0, 3.0),
            glam::DQuat::from_rotation_x(0.7),
            DVec3::new(4.0, -1.0, 2.0),
        )
    }

    /// A point inside the sphere, and the one in front of it.
    #[test]
    fn normals_are_those_of_what_is_seen() {
        let surface = Surface::of(Primitive::Sphere { level: 4 }, DAffine3::IDENTITY)
            .expect("it has a surface");
        let seen = surface.normal(DVec3::new(0.6, 0.0, 0.7), DVec3::Z).expect("it is met");
        assert!(seen.distance(DVec3::new(0.6, 0.0, 0.8)) < 1e-12, "{seen}");
    }

    /// A point inside the sphere, and the one that an eye sees before it.
    #[test]
    fn an_eye_at_a_place_sees_along_its_own_lines() {
        let eye = DVec3::new(1.0, 0.5, 3.0);
        let surface = Surface::of(Primitive::Sphere { level: 4 }, DAffine3::IDENTITY)
            .expect("it has a surface")
            .seen_from(Some(eye));
        let met = DVec3::new(0.6, 0.0, 0.8);
        let seen = surface.normal(met + 0.05 * (met - eye), DVec3::Z).expect("it is met");
        assert!(seen.distance(met) < 1e-12, "{seen}");
    }

    /// Vertices of these meshes have exact normals.
    #[test]
    fn normals_at_vertices_are_the_meshes() {
        for primitive in [
            Primitive::Sphere { level: 4 },
            Primitive::Torus { level: 4, tube: 0.3 },
            Primitive::Icosahedron { level: 2 },
        ] {
            let (mesh, to_view) = (primitive.mesh(), to_view());
            let surface = Surface::of(primitive, to_view).expect("it has a surface");
            let to_normals = to_view.matrix3.inverse().transpose();
            for (corners, normals) in mesh.triangles.iter().zip(&mesh.normals) {
                for (&corner, &normal) in corners.iter().zip(normals) {
                    let (place, normal) = (
                        to_view.transform_point3(mesh.positions[corner as usize]),
                        (to_normals * normal).normalize(),
                    );
                    let found = surface.normal(place, normal).expect("it has one");
                    assert!(found.distance(normal) < 1e-12, "{primitive:?}: {found} for {normal}");
                }
            }
        }
    }

    #[test]
    fn lines_that_pass_by_meet_nothing() {
        for primitive in [Primitive::Sphere { level: 4 }, Primitive::Torus { level: 4, tube: 0.3 }]
        {
            let surface = Surface::of(primitive, DAffine3::IDENTITY).expect("it has a surface");
            for place in [DVec3::ZERO, DVec3::new(1.4, 0.0, 0.1), DVec3::new(0.3, 5.0, 0.0)] {
                assert_eq!(surface.normal(place, DVec3::Z), None, "{primitive:?} {place}");
            }
        }
        assert_eq!(Surface::of(Primitive::Teapot { level: 4 }, DAffine3::IDENTITY), None);
    }
}
