//! Curved surfaces that meshes stand for: the yardstick for normals that are interpolated.
use glam::{DAffine3, DMat3, DVec3};

use crate::primitive::Primitive;

/// A surface whose normal is known everywhere, placed in view space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    shape: Shape,
    /// From view space to the shape's own coordinates.
    to_own: DAffine3,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    /// The unit sphere.
    Sphere,
    /// The tube round the unit circle about the y axis; its radius does not change the nearest point's normal.
    Torus,
}

impl Surface {
    /// The surface that a primitive's vertices lie on, if its normals are known in closed form; `to_view` leads from its own coordinates to
    /// view space.
    pub fn of(primitive: Primitive, to_view: DAffine3) -> Option<Surface> {
        let shape = match primitive {
            Primitive::Sphere { .. } | Primitive::Icosahedron { .. } => Shape::Sphere,
            Primitive::Torus { .. } => Shape::Torus,
            // Bicubic patches have no closed form of the point nearest to a place.
            Primitive::Teapot { .. } => return None,
        };
        Some(Surface { shape, to_own: to_view.inverse() })
    }

    /// The unit normal in view space at the surface's point that is nearest to `place` in its own coordinates, turned to the side of
    /// `towards`. None where every point is as near: at the centre of the sphere, on the axis or the circle of the torus.
    pub fn normal(&self, place: DVec3, towards: DVec3) -> Option<DVec3> {
        let own = self.to_own.transform_point3(place);
        let outward = match self.shape {
            Shape::Sphere => own,
            Shape::Torus => own - DVec3::new(own.x, 0.0, own.z).try_normalize()?,
        };
        // Normals go by the inverse transpose of the way to view space.
        let normal = (DMat3::transpose(&self.to_own.matrix3) * outward).try_normalize()?;
        Some(if normal.dot(towards) < 0.0 { -normal } else { normal })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turned, squeezed, mirrored and moved.
    fn to_view() -> DAffine3 {
        DAffine3::from_scale_rotation_translation(
            DVec3::new(-0.5, 2.0, 3.0),
            glam::DQuat::from_rotation_x(0.7),
            DVec3::new(4.0, -1.0, 2.0),
        )
    }

    /// Vertices of these meshes have exact normals.
    #[test]
    fn normals_at_vertices_are_the_meshes() {
        for primitive in
            [Primitive::Sphere { level: 4 }, Primitive::Torus { level: 4, tube: 0.3 }, Primitive::Icosahedron { level: 2 }]
        {
            let (mesh, to_view) = (primitive.mesh(), to_view());
            let surface = Surface::of(primitive, to_view).expect("it has a surface");
            let to_normals = to_view.matrix3.inverse().transpose();
            for (corners, normals) in mesh.triangles.iter().zip(&mesh.normals) {
                for (&corner, &normal) in corners.iter().zip(normals) {
                    let (place, normal) =
                        (to_view.transform_point3(mesh.positions[corner as usize]), (to_normals * normal).normalize());
                    let found = surface.normal(place, normal).expect("it has one");
                    assert!(found.distance(normal) < 1e-12, "{primitive:?}: {found} for {normal}");
                }
            }
        }
    }

    #[test]
    fn where_everything_is_as_near_there_is_no_normal() {
        for primitive in [Primitive::Sphere { level: 4 }, Primitive::Torus { level: 4, tube: 0.3 }] {
            let surface = Surface::of(primitive, DAffine3::IDENTITY).expect("it has a surface");
            assert_eq!(surface.normal(DVec3::ZERO, DVec3::Z), None);
        }
        assert_eq!(Surface::of(Primitive::Teapot { level: 4 }, DAffine3::IDENTITY), None);
    }
}
