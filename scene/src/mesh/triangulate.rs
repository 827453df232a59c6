//! Splitting polygons into triangles.
use glam::DVec3;

/// Concave polygons with more corners than this are refused: clipping ears takes a time that grows with the cube.
pub const MOST_CORNERS: usize = 1000;

/// Splits a polygon into triangles, each three indices into `polygon`, all turning the way of `normal`.
///
/// Convex polygons become a fan from corner 0; concave ones are clipped ear by ear. A polygon that is neither (one that
/// crosses itself) ends as a fan of what is left. `None` for a concave polygon with more than [`MOST_CORNERS`] corners.
pub fn triangulate(polygon: &[DVec3], normal: DVec3) -> Option<Vec<[usize; 3]>> {
    let all: Vec<usize> = (0..polygon.len()).collect();
    if polygon.len() <= 3 || (0..polygon.len()).all(|i| !is_reflex(polygon, &all, i, normal)) {
        return Some(fan(&all));
    }
    (polygon.len() <= MOST_CORNERS).then(|| clip_ears(polygon, normal, all))
}

/// Triangles from the first corner to each edge that does not touch it.
fn fan(corners: &[usize]) -> Vec<[usize; 3]> {
    let Some((&first, rest)) = corners.split_first() else { return Vec::new() };
    rest.windows(2).map(|edge| [first, edge[0], edge[1]]).collect()
}

/// Clips ears until three corners are left, or none can be clipped any more.
fn clip_ears(polygon: &[DVec3], normal: DVec3, mut corners: Vec<usize>) -> Vec<[usize; 3]> {
    let mut triangles = Vec::with_capacity(polygon.len());
    while corners.len() > 3 {
        let Some(ear) = (0..corners.len()).find(|&i| is_ear(polygon, &corners, i, normal)) else { break };
        triangles.push(around(&corners, ear));
        corners.remove(ear);
    }
    triangles.extend(fan(&corners));
    triangles
}

/// Corner `i` with the one before and the one after it.
fn around(corners: &[usize], i: usize) -> [usize; 3] {
    let n = corners.len();
    [corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]]
}

/// Twice the signed area of a triangle, seen along `normal`.
fn turn(a: DVec3, b: DVec3, c: DVec3, normal: DVec3) -> f64 {
    (b - a).cross(c - a).dot(normal)
}

fn is_reflex(polygon: &[DVec3], corners: &[usize], i: usize, normal: DVec3) -> bool {
    let [a, b, c] = around(corners, i).map(|k| polygon[k]);
    turn(a, b, c, normal) < 0.0
}

/// Whether the triangle at corner `i` holds no other corner and can be cut off.
fn is_ear(polygon: &[DVec3], corners: &[usize], i: usize, normal: DVec3) -> bool {
    let ear = around(corners, i);
    let [a, b, c] = ear.map(|k| polygon[k]);
    let inside = |p: DVec3| turn(a, b, p, normal) >= 0.0 && turn(b, c, p, normal) >= 0.0 && turn(c, a, p, normal) >= 0.0;
    turn(a, b, c, normal) > 0.0 && corners.iter().all(|k| ear.contains(k) || !inside(polygon[*k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[DVec3], triangles: &[[usize; 3]]) -> Vec<f64> {
        triangles.iter().map(|t| turn(polygon[t[0]], polygon[t[1]], polygon[t[2]], DVec3::Z) / 2.0).collect()
    }

    fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
        points.iter().map(|&(x, y)| DVec3::new(x, y, 7.0)).collect()
    }

    #[test]
    fn a_convex_polygon_becomes_a_fan() {
        let square = flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        assert_eq!(triangulate(&square, DVec3::Z), Some(vec![[0, 1, 2], [0, 2, 3]]));
    }

    #[test]
    fn a_concave_polygon_is_covered_once() {
        // An arrow head whose fan from corner 0 would stick out, and an L.
        let arrow = flat(&[(0.0, 0.0), (4.0, 2.0), (0.0, 4.0), (1.0, 2.0)]);
        let l = flat(&[(3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0), (0.0, 0.0), (3.0, 0.0)]);
        for (polygon, expected) in [(arrow, 6.0), (l, 5.0)] {
            let triangles = triangulate(&polygon, DVec3::Z).unwrap_or_default();
            let areas = area(&polygon, &triangles);
            assert_eq!(triangles.len(), polygon.len() - 2);
            assert!(areas.iter().all(|&a| a >= 0.0), "{areas:?}");
            assert_eq!(areas.iter().sum::<f64>(), expected);
        }
    }

    #[test]
    fn a_polygon_that_crosses_itself_still_ends() {
        let bow_tie = flat(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 1.0)]);
        assert_eq!(triangulate(&bow_tie, DVec3::Z).map(|t| t.len()), Some(2));
    }
}
