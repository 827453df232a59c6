//! Determines which triangle is visible at each pixel, row by row.
use std::ops::Range;

use super::coverage::Coverage;
use crate::Span;
use crate::grouped::Grouped;

/// A triangle projected to the picture.
#[derive(Clone, Debug)]
pub(super) struct Projected {
    /// The pixels that it covers.
    pub coverage: Coverage,
    /// Nearness of its corners, in the order of `coverage`'s weights; larger is nearer.
    pub nearness: [f64; 3],
}

/// The visible runs of `triangles`, from top to bottom and left to right; [`Span::triangle`] is an
/// index of `triangles`.
///
/// At each pixel centre the nearest triangle is visible, and of equally near ones the first. Rows
/// are processed one at a time with the triangles that reach them, so that memory does not grow
/// with the picture.
pub(super) fn visible_spans(triangles: &[Projected], width: u32, height: u32) -> Vec<Span> {
    let by_row = by_first_row(triangles, height);
    let mut row = PixelRow::new(width);
    let mut active: Vec<u32> = Vec::new();
    let mut spans = Vec::new();
    for y in 0..height {
        active.extend(by_row.of(y));
        active.retain(|&t| {
            let triangle = &triangles[t as usize];
            row.draw(t as usize, triangle, y);
            triangle.coverage.rows(height).end > y + 1
        });
        row.finish(y, triangles, &mut spans);
    }
    spans
}

/// Triangles by the row that they start in.
fn by_first_row(triangles: &[Projected], height: u32) -> Grouped {
    // Memory ends long before 2^32 triangles.
    let rows = (0..).zip(triangles).map(|(t, triangle)| (triangle.coverage.rows(height), t));
    let starting = rows.filter(|(rows, _)| !rows.is_empty()).map(|(rows, t)| (rows.start, t));
    Grouped::new(height as usize, starting)
}

/// The nearest triangle at each pixel of the current row.
struct PixelRow {
    nearness: Vec<f64>,
    /// The visible triangle, or `NOTHING`.
    seen: Vec<usize>,
}

const NOTHING: usize = usize::MAX;

impl PixelRow {
    fn new(width: u32) -> PixelRow {
        PixelRow {
            nearness: vec![f64::NEG_INFINITY; width as usize],
            seen: vec![NOTHING; width as usize],
        }
    }

    fn draw(&mut self, index: usize, triangle: &Projected, y: u32) {
        let columns = triangle.coverage.columns(y, self.seen.len() as u32);
        if columns.is_empty() {
            return;
        }
        let (start, step) = nearness_along(triangle, &columns, y);
        let run = columns.start as usize..columns.end as usize;
        let pixels = self.nearness[run.clone()].iter_mut().zip(&mut self.seen[run]);
        for (k, (nearest, seen)) in pixels.enumerate() {
            let nearness = start + step * k as f64;
            // Triangles do not come in the order of their indices here, so the index decides
            // between equals.
            if nearness > *nearest || (nearness == *nearest && index < *seen) {
                (*nearest, *seen) = (nearness, index);
            }
        }
    }

    /// Adds the row's spans and clears it for the next.
    fn finish(&mut self, y: u32, triangles: &[Projected], spans: &mut Vec<Span>) {
        let mut x = 0;
        for run in self.seen.chunk_by(|a, b| a == b) {
            // A row has at most 8192 pixels.
            let length = run.len() as u32;
            if run[0] != NOTHING {
                let weights = |column| triangles[run[0]].coverage.weights(column, y);
                let start = weights(x);
                let end = if length == 1 { start } else { weights(x + length - 1) };
                spans.push(Span { x, y, length, triangle: run[0], start, end });
            }
            x += length;
        }
        self.seen.fill(NOTHING);
        self.nearness.fill(f64::NEG_INFINITY);
    }
}

/// Nearness at the first pixel of a run and its change from pixel to pixel.
fn nearness_along(triangle: &Projected, columns: &Range<u32>, y: u32) -> (f64, f64) {
    let at = |column: u32| {
        let weights = triangle.coverage.weights(column, y);
        weights.iter().zip(triangle.nearness).map(|(w, n)| w * n).sum::<f64>()
    };
    let first = at(columns.start);
    match columns.len() - 1 {
        0 => (first, 0.0),
        steps => (first, (at(columns.end - 1) - first) / steps as f64),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::picture::coverage::Point;

    const SIZE: u32 = 12;

    /// The triangle visible at each pixel, found by testing all of them.
    fn by_asking_all(triangles: &[Projected], column: u32, row: u32) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        for (index, triangle) in triangles.iter().enumerate() {
            if !triangle.coverage.columns(row, SIZE).contains(&column)
                || !triangle.coverage.rows(SIZE).contains(&row)
            {
                continue;
            }
            let weights = triangle.coverage.weights(column, row);
            let nearness = weights.iter().zip(triangle.nearness).map(|(w, n)| w * n).sum::<f64>();
            if best.is_none_or(|(nearest, _)| nearness > nearest) {
                best = Some((nearness, index));
            }
        }
        best.map(|(_, index)| index)
    }

    fn triangle(corners: [(i64, i64); 3], nearness: [f64; 3]) -> Option<Projected> {
        Coverage::new(corners.map(|(x, y)| Point { x, y }))
            .map(|coverage| Projected { coverage, nearness })
    }

    proptest! {
        #[test]
        fn spans_show_the_nearest_triangle_at_each_pixel(
            corners in prop::collection::vec(prop::array::uniform3((-500..4000_i64, -500..4000_i64)), 1..12),
            nearness in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 12),
        ) {
            let made = corners.iter().zip(nearness).filter_map(|(&c, n)| triangle(c, n));
            let triangles: Vec<Projected> = made.collect();
            let mut seen = vec![None; (SIZE * SIZE) as usize];
            for span in visible_spans(&triangles, SIZE, SIZE) {
                for x in span.x..span.x + span.length {
                    let pixel = &mut seen[(span.y * SIZE + x) as usize];
                    prop_assert_eq!(*pixel, None);
                    *pixel = Some(span.triangle);
                }
            }
            for (k, seen) in (0..).zip(seen) {
                prop_assert_eq!(seen, by_asking_all(&triangles, k % SIZE, k / SIZE));
            }
        }
    }

    #[test]
    fn of_equally_near_triangles_the_first_is_seen() {
        let low = triangle([(0, 1000), (3000, 1000), (0, 4000)], [0.5; 3]);
        let high = triangle([(0, 0), (3000, 0), (0, 3000)], [0.5; 3]);
        // The first starts in a later row, so that the second is drawn before it.
        let triangles: Vec<Projected> = [low, high].into_iter().flatten().collect();
        let spans = visible_spans(&triangles, SIZE, SIZE);
        let at =
            |y: u32| spans.iter().find(|span| span.y == y && span.x == 0).map(|span| span.triangle);
        assert_eq!((triangles.len(), at(1), at(6)), (2, Some(1), Some(0)));
    }
}
