//! Normals and what is made of them, stepped along edges and scan lines instead of interpolated by
//! weights.
use glam::DVec3;
use specula_golden::loops::{Edge, Linear, Plane};
use specula_scene::{Frame, Span, load};

/// A built-in scene as a small picture; `None` if there is none of that name.
pub fn small(scene: &str) -> Option<Frame> {
    load(scene, Some((320, 240))).ok().map(|scene| scene.frame)
}

/// The largest difference that `off` finds on a frame's spans, between linear quantities stepped along
/// edges from scan line to scan line and the span's own; `values` makes the quantities of a vertex
/// normal.
pub fn largest_off<const N: usize>(
    frame: &Frame,
    values: impl Fn(DVec3) -> [f64; N],
    off: impl Fn(&Span, [Linear<f64>; N]) -> f64,
) -> f64 {
    let mut largest = 0.0;
    along_edges(frame, values, |span, along| largest = f64::max(largest, off(span, along)));
    largest
}

/// Gives each span of a frame, with its linear quantities stepped along edges from scan line to scan
/// line; `values` makes the quantities of a vertex normal.
pub fn along_edges<const N: usize>(
    frame: &Frame,
    values: impl Fn(DVec3) -> [f64; N],
    mut give: impl FnMut(&Span, [Linear<f64>; N]),
) {
    let mut triangles: Vec<(Edge, [Plane; N])> = Vec::new();
    for triangle in &frame.triangles {
        let edge = triangle.linear_outline().map_or_else(Edge::default, Edge::of_outline);
        let corners = triangle.normals.map(&values);
        let plane = |k: usize| Plane::new(&edge, corners.map(|corner| corner[k]));
        triangles.push((edge, std::array::from_fn(plane)));
    }
    for span in &frame.spans {
        let (edge, planes) = &mut triangles[span.triangle];
        let step = edge.to_span(span);
        give(span, planes.each_mut().map(|plane| plane.to_span(step)));
    }
}
