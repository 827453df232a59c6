//! What a perspective camera sees of a triangle, and how barycentric weights go along its spans
//! [Heckbert and Moreton].
use glam::DVec2;
use serde::Serialize;

use crate::frame::{Frame, Span, Triangle};

/// How weights go along a span that is seen in perspective. Between the span's ends they are linear
/// in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// They are linear on the screen, as the papers have them.
    #[default]
    Screen,
    /// They are perspective-correct at both ends.
    Perspective,
}

impl Interpolation {
    /// What a perspective camera with it does, in words.
    pub fn in_words(self) -> &'static str {
        match self {
            Interpolation::Screen => "perspective; along spans, weights are linear on the screen",
            Interpolation::Perspective => {
                "perspective; weights are perspective-correct at the ends of spans"
            }
        }
    }
}

/// What a perspective camera sees of a triangle: the whole of it, or a piece that is left of it
/// between the near plane and the sides of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Perspective {
    /// Barycentric weights of the piece's corners in the triangle: those of its vertices, if it is
    /// whole. They are 0 to 1 and add up to 1.
    pub corners: [[f64; 3]; 3],
    /// The reciprocal distances of these corners from the eye, along the direction in which it
    /// looks; above 0.
    pub nearness: [f64; 3],
    /// How weights go along the triangle's spans.
    pub interpolation: Interpolation,
}

impl Perspective {
    /// Barycentric weights of the vertices of a triangle that is seen as a whole.
    pub const WHOLE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    /// Weights in the triangle, as a span has them at its ends, where the weights of the piece are
    /// `on_screen`.
    pub fn interpolated(&self, on_screen: [f64; 3]) -> [f64; 3] {
        match self.interpolation {
            Interpolation::Screen => self.in_triangle(on_screen),
            Interpolation::Perspective => self.correct(on_screen),
        }
    }

    /// Perspective-correct weights in the triangle where the weights of the piece are `on_screen`.
    ///
    /// A point P = Σ b_k P_k of the piece is at the distance z = Σ b_k z_k, and its image is
    /// Σ b_k P_k/z = Σ (b_k z_k/z) P_k/z_k.
    /// So weights on the screen are w_k = b_k z_k/z, and b_k = z w_k/z_k, where Σ b_k = 1 says z.
    pub fn correct(&self, on_screen: [f64; 3]) -> [f64; 3] {
        let shares: [f64; 3] = std::array::from_fn(|k| on_screen[k] * self.nearness[k]);
        let all: f64 = shares.iter().sum();
        self.in_triangle(shares).map(|weight| weight / all)
    }

    /// The direction, of any length, in which perspective-correct weights change where those on the
    /// screen change by `step`.
    ///
    /// The derivative of n/s, n and s linear, is (n' - (n/s) s')/s.
    fn direction(&self, on_screen: [f64; 3], step: [f64; 3]) -> [f64; 3] {
        let steps: [f64; 3] = std::array::from_fn(|k| step[k] * self.nearness[k]);
        let (all, weights) = (steps.iter().sum::<f64>(), self.correct(on_screen));
        let steps = self.in_triangle(steps);
        std::array::from_fn(|k| steps[k] - weights[k] * all)
    }

    /// Σ w_k c_k of the piece's corners c_k.
    fn in_triangle(&self, weights: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|v| (0..3).map(|k| weights[k] * self.corners[k][v]).sum())
    }
}

impl Triangle {
    /// The three vertices in the picture, if they are there and weights are linear between them on
    /// the screen.
    pub fn linear_outline(&self) -> Option<[DVec2; 3]> {
        let is_linear = |seen: &Perspective| {
            seen.interpolation == Interpolation::Screen && seen.corners == Perspective::WHOLE
        };
        self.outline.filter(|_| self.perspective.as_ref().is_none_or(is_linear))
    }

    /// What barycentric weights grow by from the pixel whose centre is at `place` to the next on its
    /// right, or in perspective a multiple of it; 0 without an outline.
    pub(crate) fn steps_across(&self, place: DVec2) -> [f64; 3] {
        let Some(outline) = self.outline else { return [0.0; 3] };
        let step = across(outline);
        match &self.perspective {
            None => step,
            Some(seen) => match seen.interpolation {
                Interpolation::Screen => seen.in_triangle(step),
                Interpolation::Perspective => seen.direction(weights_at(outline, place), step),
            },
        }
    }
}

impl Frame {
    /// How weights go along spans that are seen in perspective; `None` where lines of sight are
    /// parallel.
    pub fn interpolation(&self) -> Option<Interpolation> {
        Some(self.triangles.first()?.perspective?.interpolation)
    }

    /// Barycentric weights of the point that is seen at pixel `i` of a span: perspective-correct ones
    /// in perspective, else those that the span has there.
    pub fn seen_weights(&self, span: &Span, i: u32) -> [f64; 3] {
        let triangle = &self.triangles[span.triangle];
        match triangle.perspective.as_ref().zip(triangle.outline) {
            Some((seen, outline)) => seen.correct(weights_at(outline, centre(span.x + i, span.y))),
            None => span.weights(i),
        }
    }
}

/// The centre of a pixel, in pixels from the picture's top left corner.
pub(crate) fn centre(column: u32, row: u32) -> DVec2 {
    DVec2::new(f64::from(column), f64::from(row)) + 0.5
}

/// Barycentric weights of a place in the picture. Corners on the grid of
/// [`coverage`](crate::picture::coverage), at most 2^14 pixels apart, have exact areas.
fn weights_at(outline: [DVec2; 3], place: DVec2) -> [f64; 3] {
    let [a, b, c] = outline;
    let area = (b - a).perp_dot(c - a);
    [[b, c], [c, a], [a, b]].map(|[from, to]| (to - from).perp_dot(place - from) / area)
}

/// What barycentric weights grow by from a pixel to the next on its right.
fn across([a, b, c]: [DVec2; 3]) -> [f64; 3] {
    let area = (b - a).perp_dot(c - a);
    // The area is not 0, unless f64 cannot tell the sides of a triangle of millions of pixels apart.
    let per_area = if area == 0.0 { 0.0 } else { area.recip() };
    [b.y - c.y, c.y - a.y, a.y - b.y].map(|height| height * per_area)
}
