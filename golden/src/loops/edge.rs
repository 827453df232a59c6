//! Steps along the edge of a triangle from scan line to scan line, and from it into each scan line
//! [lecture, eq. 3.2 to 3.6; methods A4].
use glam::DVec2;
use specula_scene::Span;

use super::{Line, Linear, Number};

/// The edge of a triangle that goes from its top to its bottom, so that every scan line meets it.
///
/// What is linear in a triangle grows along the edge by ΔI = (I2 - I1)/(y2 - y1) with each line,
/// and by ΔI = (I2 - I1)/(x2 - x1) with each pixel, which is the same on all lines of a triangle:
/// steps along the other edges are not needed. Both are computed once for the triangle, for all
/// lights.
///
/// The next span of a triangle is usually one line further, so that Δy = 1 [eq. 3.4]. Lines on
/// which the triangle is hidden make Δy larger; a second run on a line makes it 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    /// The current scan line, counted from the top.
    line: f64,
    /// The point where the edge meets the line, in pixels from the left, and Δx.
    x: f64,
    x_step: f64,
    /// Barycentric weights of the first two vertices.
    weights: LinearSteps<[f64; 2]>,
}

/// A linear quantity of a triangle: its value at the edge, and its increments.
#[derive(Clone, Copy, Debug, Default)]
struct LinearSteps<V> {
    at_edge: V,
    /// Increment with each line, along the edge.
    down: V,
    /// Increment with each pixel, along a line.
    across: V,
}

/// The step from the previous place on an edge: down to the line of a span, and from there across
/// to its first pixel.
#[derive(Clone, Copy, Debug)]
pub struct EdgeStep {
    lines: f64,
    pixels: f64,
}

impl Edge {
    /// The edge of a triangle in the picture, before its first line. `outline` is in pixels to the
    /// right and down.
    pub fn of_outline(outline: [DVec2; 3]) -> Edge {
        let [a, b, c] = outline;
        // The area is not 0, unless f64 cannot tell the sides of a triangle of millions of pixels
        // apart.
        let area = (b - a).perp_dot(c - a);
        let per_area = if area == 0.0 { 0.0 } else { area.recip() };
        let higher = |k: usize, l: usize| if outline[l].y < outline[k].y { l } else { k };
        let lower = |k: usize, l: usize| if outline[l].y > outline[k].y { l } else { k };
        let (top, bottom) = (higher(higher(0, 1), 2), lower(lower(0, 1), 2));
        let (from, down) = (outline[top], outline[bottom] - outline[top]);
        let line = (from.y - 0.5).ceil();
        let t = (line + 0.5 - from.y) / down.y;
        let [at_top, at_bottom] =
            [top, bottom].map(|k| [0, 1].map(|v| f64::from(u8::from(k == v))));
        let edge = [0, 1].map(|v| at_bottom[v] - at_top[v]);
        Edge {
            line,
            x: from.x + t * down.x,
            x_step: down.x / down.y,
            weights: LinearSteps {
                at_edge: [0, 1].map(|v| at_top[v] + t * edge[v]),
                down: edge.map(|weight| weight / down.y),
                // This is (I2 - I1)/(x2 - x1) for each weight, with x2 where the line through the
                // middle vertex meets the edge, and the divisor expressed by the area.
                across: [(b.y - c.y) * per_area, (c.y - a.y) * per_area],
            },
        }
    }

    /// The first pixel of a span for which only the weights at its ends are known.
    pub fn of_span(span: &Span) -> Edge {
        Edge {
            line: f64::from(span.y),
            x: centre(span.x),
            x_step: 0.0,
            weights: LinearSteps::along([span.start, span.end], span.weight_step()),
        }
    }

    /// Steps to the line of any span of the triangle.
    #[inline]
    pub fn to_span(&mut self, span: &Span) -> EdgeStep {
        let lines = f64::from(span.y) - self.line;
        self.line = f64::from(span.y);
        self.x += lines * self.x_step;
        EdgeStep { lines, pixels: centre(span.x) - self.x }
    }
}

fn centre(column: u32) -> f64 {
    f64::from(column) + 0.5
}

impl LinearSteps<[f64; 2]> {
    /// The quantity from weights at the first pixel of a line to those at its last; pixels are 1/S
    /// apart.
    fn along([start, end]: [[f64; 3]; 2], per_step: f64) -> Self {
        LinearSteps {
            at_edge: [start[0], start[1]],
            down: [0.0; 2],
            across: [0, 1].map(|v| (end[v] - start[v]) * per_step),
        }
    }
}

/// A value that is linear between a triangle's three vertices, stepped along with its [`Edge`].
#[derive(Clone, Copy, Debug)]
pub struct Plane(LinearSteps<f64>);

impl Plane {
    /// The quantity with these values at the vertices, before the edge's first line.
    pub fn new(edge: &Edge, at_vertices: [f64; 3]) -> Plane {
        Plane::of(&edge.weights, at_vertices)
    }

    /// The values from the first pixel of a span to its last, without its triangle.
    pub fn along<T: Number>(line: &Line, at_vertices: [f64; 3]) -> Linear<T> {
        let Plane(value) =
            Plane::of(&LinearSteps::along(line.weights, line.per_step()), at_vertices);
        Linear::new(value.at_edge, value.across)
    }

    fn of(weights: &LinearSteps<[f64; 2]>, [first, second, last]: [f64; 3]) -> Plane {
        let more = |by: [f64; 2]| by[0] * (first - last) + by[1] * (second - last);
        Plane(LinearSteps {
            at_edge: last + more(weights.at_edge),
            down: more(weights.down),
            across: more(weights.across),
        })
    }

    /// Steps to the line of a span, I += Δy ΔI; the result are the values along it from the span's
    /// first pixel on, which may be anywhere on the line.
    #[inline]
    pub fn to_span<T: Number>(&mut self, step: EdgeStep) -> Linear<T> {
        let Plane(value) = self;
        value.at_edge += step.lines * value.down;
        Linear::new(value.at_edge + step.pixels * value.across, value.across)
    }
}
