//! Face and vertex normals (Lecture 21: methods A1, A2).
use glam::{DMat3, DVec3};

/// A face counts as degenerate if its area is below this share of its extent squared, where it may
/// be rounding error alone.
const THINNEST: f64 = 1e-13;

/// The direction of a sum of unit normals shorter than this is not used.
const SHORTEST_SUM: f64 = 1e-9;

/// The unit normal of a polygon by Newell's method, or `None` for a polygon without area.
///
/// N = Σ Pₖ × Pₖ₊₁ [Lecture 21, (1.1)], computed relative to P₀, so that a polygon far from the
/// origin does not lose digits, and divided by the polygon's extent, so that its size does not
/// matter.
pub fn newell(polygon: &[DVec3]) -> Option<DVec3> {
    let origin = *polygon.first()?;
    let extent = polygon.iter().fold(0.0_f64, |e, &p| e.max((p - origin).abs().max_element()));
    // The condition is also false for NaN.
    if !(extent > 0.0 && extent.is_finite()) {
        return None;
    }
    let relative = |p: DVec3| (p - origin) / extent;
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let sum: DVec3 = edges.map(|(&a, &b)| relative(a).cross(relative(b))).sum();
    let length = sum.length();
    (length > THINNEST).then(|| sum / length)
}

/// Unit normals at vertices: the normalised sum of the *unit* normals of the faces around each
/// [Lecture 21, (3.1)].
///
/// `faces` gives each face's corners and its unit normal; faces without a normal are skipped. A
/// vertex where the normals cancel, or without faces, has no normal: there the caller uses the
/// face's own.
pub fn vertex_normals<'a>(
    vertices: usize,
    faces: impl Iterator<Item = (&'a [u32], Option<DVec3>)>,
) -> Vec<Option<DVec3>> {
    let mut sums = vec![DVec3::ZERO; vertices];
    for (corners, normal) in faces {
        let Some(normal) = normal else { continue };
        for &corner in corners {
            sums[corner as usize] += normal;
        }
    }
    sums.into_iter().map(direction).collect()
}

/// The unit vector along `sum`, if it is long enough to have a direction.
pub fn direction(sum: DVec3) -> Option<DVec3> {
    let length = sum.length();
    (length > SHORTEST_SUM).then(|| sum / length)
}

/// A unit vector along a vector of any length except 0.
pub fn direction_of(normal: DVec3) -> Option<DVec3> {
    let largest = normal.abs().max_element();
    if largest > 0.0 { direction(normal / largest) } else { None }
}

/// The matrix that transforms normals where `linear` transforms the surface: its inverse
/// transposed, up to a positive factor.
///
/// It is built from cofactors, so that a matrix without inverse (a projection to a plane) still
/// gives normals where they exist.
pub fn normal_matrix(linear: DMat3) -> DMat3 {
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let side = if linear.determinant() < 0.0 { -1.0 } else { 1.0 };
    DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * side
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(at: DVec3, side: f64) -> Vec<DVec3> {
        [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y].map(|p| at + p * side).to_vec()
    }

    #[test]
    fn newell_finds_the_normal_far_from_the_origin() {
        for at in [0.0, 1e6, 1e9] {
            assert_eq!(newell(&square(DVec3::splat(at), 1.0)), Some(DVec3::Z));
        }
    }

    #[test]
    fn newell_does_not_depend_on_size() {
        for side in [1e-25, 1.0, 1e25] {
            assert_eq!(newell(&square(DVec3::ZERO, side)), Some(DVec3::Z));
        }
    }

    #[test]
    fn polygons_without_area_have_no_normal() {
        let bow_tie = [DVec3::ZERO, DVec3::ONE, DVec3::X, DVec3::new(0.0, 1.0, 1.0)];
        assert_eq!(newell(&[]), None);
        assert_eq!(newell(&[DVec3::ONE; 3]), None);
        assert_eq!(newell(&[DVec3::ZERO, DVec3::ONE, DVec3::ONE * 3.0]), None);
        assert_eq!(newell(&[bow_tie[0], DVec3::new(1.0, 1.0, 0.0), DVec3::X, DVec3::Y]), None);
        assert_eq!(newell(&[DVec3::splat(f64::NAN); 3]), None);
    }

    #[test]
    fn a_vertex_normal_is_the_unit_sum_of_unit_face_normals_whatever_the_areas() {
        let faces =
            [([0_u32, 1, 2], Some(DVec3::X)), ([0, 3, 4], Some(DVec3::Y)), ([0, 1, 3], None)];
        let normals = vertex_normals(6, faces.iter().map(|(c, n)| (c.as_slice(), *n)));
        let half = 0.5_f64.sqrt();
        assert!((normals[0].unwrap_or_default() - DVec3::new(half, half, 0.0)).length() < 1e-15);
        assert_eq!(normals[1], Some(DVec3::X));
        assert_eq!(normals[5], None);
    }

    #[test]
    fn normals_that_cancel_leave_no_vertex_normal() {
        let faces = [([0_u32, 1, 2], Some(DVec3::X)), ([0, 2, 1], Some(-DVec3::X))];
        assert_eq!(vertex_normals(3, faces.iter().map(|(c, n)| (c.as_slice(), *n))), [None; 3]);
    }

    #[test]
    fn normals_stay_perpendicular_and_outside_under_stretching_and_mirroring() {
        for scale in
            [DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, 2.0, 3.0), DVec3::new(-1.0, -2.0, -0.5)]
        {
            let linear = DMat3::from_diagonal(scale);
            let (along, normal) = (DVec3::new(1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 0.0));
            let moved = normal_matrix(linear) * normal;
            assert_eq!((linear * along).dot(moved), 0.0);
            assert!((linear * normal).dot(moved) > 0.0);
        }
    }
}
