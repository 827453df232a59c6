//! Where the scan line of a span enters its triangle and leaves it, and normals by slerp along the
//! edges there [lecture, §4.4, steps ii and iii].
use glam::DVec3;

use crate::arc::Arc;
use crate::frame::{Frame, Span};
use crate::perspective::centre;

/// The line through the centres of a span's pixels, as far as it is inside of the triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanLine {
    /// Barycentric weights where it meets the triangle's edges, left and right: 0 to 1, and 0 for the
    /// vertex across the edge.
    ///
    /// Where no line is known, both are the span's pixel itself: that of a single pixel of a
    /// triangle without an outline.
    pub edges: [[f64; 3]; 2],
    /// The shares of the way between them at which the first pixel's centre and the last's are: 0 to
    /// 1.
    pub shares: [f64; 2],
}

impl Frame {
    /// The scan line of a span. Hidden pixels beside the span belong to it.
    pub fn scan_line(&self, span: &Span) -> ScanLine {
        let (pixels, last) = if span.start == span.end {
            (self.triangles[span.triangle].steps_across(centre(span.x, span.y)), 0.0)
        } else {
            ([0, 1, 2].map(|k| span.end[k] - span.start[k]), 1.0)
        };
        // How far it is to the line on which the weight of vertex k is 0.
        let zeros = |is_wanted: fn(f64) -> bool| {
            (0..3)
                .filter(move |&k| is_wanted(pixels[k]))
                .map(move |k| (k, -span.start[k] / pixels[k]))
        };
        let left = zeros(|weight| weight > 0.0).max_by(|one, other| one.1.total_cmp(&other.1));
        let right = zeros(|weight| weight < 0.0).min_by(|one, other| one.1.total_cmp(&other.1));
        let (Some((left, from)), Some((right, to))) = (left, right) else {
            return ScanLine { edges: [span.start; 2], shares: [0.0; 2] };
        };
        // Pixels' centres are inside of the triangle, but for roundings.
        let (from, to) = (from.min(0.0), to.max(last));
        let at = |place: f64, vertex: usize| {
            std::array::from_fn(|k| {
                let weight = span.start[k] + place * pixels[k];
                if k == vertex { 0.0 } else { weight.clamp(0.0, 1.0) }
            })
        };
        let share = |place: f64| if to > from { (place - from) / (to - from) } else { 0.0 };
        ScanLine { edges: [at(from, left), at(to, right)], shares: [share(0.0), share(last)] }
    }

    /// The arc from the normal at a span's first pixel to that at its last, by slerp along the
    /// triangle's edges and then along the scan line between them.
    pub fn arc_between_edges(&self, span: &Span) -> Arc {
        let ScanLine { edges, shares } = self.scan_line(span);
        let normals = self.triangles[span.triangle].normals;
        Arc::between(edges.map(|weights| normal_on_edge(normals, weights))).part(shares)
    }
}

/// The unit normal at barycentric weights of which one is 0, by slerp of the two vertices of that
/// edge: of the first two vertices, and then of that and the third. Inside of the triangle that is
/// between all three.
pub fn normal_on_edge([a, b, c]: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    let share = if weights[1] > 0.0 { weights[1] / (weights[0] + weights[1]) } else { 0.0 };
    Arc::between([Arc::between([a, b]).at(share), c]).at(weights[2])
}
