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
    let mut triangles: Vec<(Edge, [Plane; N])> = Vec::new();
    for triangle in &frame.triangles {
        let edge = triangle.linear_outline().map_or_else(Edge::default, Edge::of_outline);
        let corners = triangle.normals.map(&values);
        let plane = |k: usize| Plane::new(&edge, corners.map(|corner| corner[k]));
        triangles.push((edge, std::array::from_fn(plane)));
    }
    let of_span = |span: &Span| {
        let (edge, planes) = &mut triangles[span.triangle];
        let step = edge.to_span(span);
        off(span, planes.each_mut().map(|plane| plane.to_span(step)))
    };
    frame.spans.iter().map(of_span).fold(0.0, f64::max)
}
