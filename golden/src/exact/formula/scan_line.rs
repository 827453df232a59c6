//! Interpolation along two edges of a polygon and then along the scan line between them [lecture,
//! eq. 3.2 to 3.6 and 4.1, figures 2 and 5].
use std::ops::{Add, Mul};

use glam::DVec2;

/// A quantity at a point of a convex polygon, from its values at the corners: along the two edges
/// that the point's horizontal line crosses, then along the line. `None` outside of the polygon.
///
/// For a triangle it is the barycentric mean; for more corners it depends on how the polygon stands
/// to the lines.
pub fn along_scan_line<V>(corners: &[DVec2], values: &[V], point: DVec2) -> Option<V>
where
    V: Copy + Add<Output = V> + Mul<f64, Output = V>,
{
    let next = |k: usize| (k + 1) % corners.len();
    let crossing = |k: usize| {
        let [from, to] = [corners[k], corners[next(k)]];
        // The lower end of an edge belongs to it, the upper does not: a line crosses two edges.
        let is_crossed = (from.y <= point.y) != (to.y <= point.y);
        let t = (point.y - from.y) / (to.y - from.y);
        is_crossed.then(|| (between(from.x, to.x, t), between(values[k], values[next(k)], t)))
    };
    let mut crossings = (0..corners.len()).filter_map(crossing);
    let (one, other) = (crossings.next()?, crossings.next()?);
    let [(left, first), (right, last)] = if one.0 <= other.0 { [one, other] } else { [other, one] };
    let t = if right > left { (point.x - left) / (right - left) } else { 0.0 };
    (left..=right).contains(&point.x).then(|| between(first, last, t))
}

fn between<V>(from: V, to: V, t: f64) -> V
where
    V: Copy + Add<Output = V> + Mul<f64, Output = V>,
{
    from * (1.0 - t) + to * t
}
