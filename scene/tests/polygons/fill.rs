//! What a polygon covers, and what triangles do, without a line of the code that is tested.
use specula_fixtures::Draw;

use super::shapes::{Place, edges, turn};

/// Points nearer than this share of the polygon's extent to an edge say nothing: they are on it but
/// for rounding.
const NEAR: f64 = 1e-6;

/// Points over a polygon's bounds, none of them on an edge.
pub fn probes(draw: &mut Draw, polygon: &[Place], count: usize) -> Vec<Place> {
    let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
        polygon.iter().map(|p| p[axis]).reduce(pick).expect("it has corners")
    };
    let (low, high) =
        ([bound(0, f64::min), bound(1, f64::min)], [bound(0, f64::max), bound(1, f64::max)]);
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    let mut point = || [0, 1].map(|axis| low[axis] + (high[axis] - low[axis]) * draw.unit());
    let points: Vec<Place> = (0..count).map(|_| point()).collect();
    points
        .into_iter()
        .filter(|&p| edges(polygon).all(|edge| distance(p, edge) > NEAR * extent))
        .collect()
}

/// Whether an odd number of a polygon's edges cross the ray from a point to the right.
pub fn is_inside(polygon: &[Place], [x, y]: Place) -> bool {
    let crossed = edges(polygon).filter(|&[a, b]| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

/// How many triangles hold a point.
pub fn covers(triangles: &[[Place; 3]], point: Place) -> usize {
    let holds = |&&[a, b, c]: &&[Place; 3]| {
        let sides = [turn(a, b, point), turn(b, c, point), turn(c, a, point)];
        sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0)
    };
    triangles.iter().filter(holds).count()
}

/// The area of triangles.
pub fn area(triangles: &[[Place; 3]]) -> f64 {
    triangles.iter().map(|&[a, b, c]| turn(a, b, c).abs() / 2.0).sum()
}

/// The area that a polygon goes around.
pub fn area_around(polygon: &[Place]) -> f64 {
    edges(polygon).map(|[a, b]| turn([0.0; 2], a, b) / 2.0).sum::<f64>().abs()
}

fn distance(p: Place, [a, b]: [Place; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let length_squared = along[0] * along[0] + along[1] * along[1];
    let t = if length_squared > 0.0 {
        (((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p[0] - a[0] - t * along[0]).hypot(p[1] - a[1] - t * along[1])
}
