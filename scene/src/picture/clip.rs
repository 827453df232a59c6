//! Convex polygons cut off at planes [Sutherland and Hodgman].
use glam::DVec3;

/// A corner of a polygon that is cut out of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    /// Its place.
    pub place: DVec3,
    /// Its barycentric weights in the triangle.
    pub weights: DVec3,
}

/// The half of space where p·normal - offset is 0 or more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HalfSpace {
    /// A vector of any length except 0.
    pub normal: DVec3,
    /// Where the plane is.
    pub offset: f64,
}

impl HalfSpace {
    /// Whether a place is in it.
    pub fn contains(&self, place: DVec3) -> bool {
        self.depth(place) >= 0.0
    }

    /// How far inside a place is, in units of the normal's length; below 0 outside.
    fn depth(&self, place: DVec3) -> f64 {
        self.normal.dot(place) - self.offset
    }
}

/// The corners of a triangle, as a polygon.
pub(super) fn of_triangle(places: [DVec3; 3]) -> Vec<Corner> {
    let corners = places.into_iter().zip(DVec3::AXES);
    corners.map(|(place, weights)| Corner { place, weights }).collect()
}

/// What is left of a convex polygon inside of a half-space: its corners in the same order, none if it
/// is outside. A polygon that is inside stays as it is.
pub(super) fn cut(polygon: Vec<Corner>, within: &HalfSpace) -> Vec<Corner> {
    let is_inside = |corner: &Corner| within.contains(corner.place);
    if polygon.iter().all(is_inside) {
        return polygon;
    }
    let mut rest = Vec::with_capacity(polygon.len() + 1);
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        if is_inside(from) {
            rest.push(*from);
        }
        if is_inside(from) != is_inside(to) {
            rest.push(met(within, from, to));
        }
    }
    rest
}

/// The point where the line between two corners on different sides meets a plane: a + t (b - a),
/// where depths d are linear, so that t = d_a/(d_a - d_b).
///
/// It starts at the same end, whichever comes first, so that two triangles that share an edge meet
/// the plane in the same point, bit for bit.
fn met(plane: &HalfSpace, one: &Corner, other: &Corner) -> Corner {
    let (a, b) = if precedes(one.place, other.place) { (one, other) } else { (other, one) };
    let [from, to] = [a, b].map(|corner| plane.depth(corner.place));
    let t = from / (from - to);
    let place = a.place + t * (b.place - a.place);
    Corner { place, weights: a.weights * (1.0 - t) + b.weights * t }
}

/// Whether a place comes before another in some order.
fn precedes(a: DVec3, b: DVec3) -> bool {
    let axes = a.to_array().into_iter().zip(b.to_array());
    axes.map(|(a, b)| a.total_cmp(&b))
        .find(|order| order.is_ne())
        .is_some_and(std::cmp::Ordering::is_lt)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn place() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-10.0..10.0_f64).prop_map(DVec3::from_array)
    }

    fn half_space() -> impl Strategy<Value = HalfSpace> {
        (place(), -5.0..5.0_f64).prop_map(|(normal, offset)| HalfSpace { normal, offset })
    }

    fn area(polygon: &[Corner]) -> DVec3 {
        let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        edges.map(|(a, b)| a.place.cross(b.place)).sum::<DVec3>() / 2.0
    }

    proptest! {
        /// Both sides of a plane together are the triangle, and all corners are where their weights say.
        #[test]
        fn both_sides_of_a_plane_are_the_whole(
            places in prop::array::uniform3(place()),
            plane in half_space(),
        ) {
            let other = HalfSpace { normal: -plane.normal, offset: -plane.offset };
            let whole = of_triangle(places);
            let parts = [plane, other].map(|side| cut(whole.clone(), &side));
            let sum: DVec3 = parts.iter().map(|part| area(part)).sum();
            prop_assert!((sum - area(&whole)).length() < 1e-9, "{parts:?}");
            for corner in parts.iter().flatten() {
                let [a, b, c] = places;
                let weights = corner.weights;
                let expected = a * weights.x + b * weights.y + c * weights.z;
                prop_assert!((corner.place - expected).length() < 1e-12, "{corner:?}");
                prop_assert!((weights.element_sum() - 1.0).abs() < 1e-15, "{corner:?}");
                prop_assert!(weights.min_element() >= 0.0, "{corner:?}");
            }
        }

        /// An edge is cut at one point, from whichever side and in whatever triangle.
        #[test]
        fn a_shared_edge_is_cut_at_one_point(
            edge in prop::array::uniform2(place()),
            tips in prop::array::uniform2(place()),
            planes in prop::collection::vec(half_space(), 1..5),
        ) {
            let [a, b] = edge;
            let cuts = [[a, b, tips[0]], [b, a, tips[1]]].map(|places| {
                let mut polygon = of_triangle(places);
                for plane in &planes {
                    polygon = cut(polygon, plane);
                }
                let third = |corner: &&Corner| corner.weights.z == 0.0;
                let mut on_edge: Vec<[u64; 3]> = polygon
                    .iter()
                    .filter(third)
                    .map(|corner| corner.place.to_array().map(f64::to_bits))
                    .collect();
                on_edge.sort_unstable();
                on_edge
            });
            prop_assert_eq!(&cuts[0], &cuts[1]);
        }
    }
}
