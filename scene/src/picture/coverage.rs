//! The exact pixels that a triangle covers.
//!
//! Corners are snapped to a grid of 1/256 pixel; edge functions are integers, so nothing is
//! rounded. A pixel is covered if its centre is inside, or on an edge that is a left or top edge of
//! the triangle. Of two triangles on either side of an edge, exactly one owns the centres on it:
//! meshes have neither gaps nor pixels drawn twice.
use std::ops::Range;

use glam::DVec2;

/// Grid steps a pixel.
pub const STEPS: i64 = 256;

/// Corners farther than this from the picture's corner, in grid steps, are refused: 2^21 pixels.
/// Differences then have 30 bits and edge functions 61, so `i64` holds them.
pub const FARTHEST_STEP: i64 = 1 << 29;

/// Columns of a triangle up to which each is asked whether it is covered.
const FEW: usize = 6;

/// A point on the grid: x to the right, y down, in 1/256 pixel from the picture's top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Steps to the right.
    pub x: i64,
    /// Steps down.
    pub y: i64,
}

impl Point {
    /// The grid point nearest to a place in pixels; `None` beyond [`FARTHEST_STEP`] and for NaN.
    pub fn snap(x: f64, y: f64) -> Option<Point> {
        let step = |pixels: f64| {
            let steps = (pixels * STEPS as f64 + 0.5).floor();
            (steps.abs() <= FARTHEST_STEP as f64).then_some(steps as i64)
        };
        Some(Point { x: step(x)?, y: step(y)? })
    }

    /// Its place in pixels.
    pub fn in_pixels(self) -> DVec2 {
        DVec2::new(self.x as f64, self.y as f64) / STEPS as f64
    }

    /// The centre of a pixel.
    pub fn centre(column: u32, row: u32) -> Point {
        let centre = |pixel: u32| i64::from(pixel) * STEPS + STEPS / 2;
        Point { x: centre(column), y: centre(row) }
    }
}

/// Twice the signed area of the triangle a, b, p; it is above 0 if p is to the right of a → b as
/// seen in the picture.
fn edge(a: Point, b: Point, p: Point) -> i64 {
    (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)
}

/// A triangle on the grid with an area above 0, its corners clockwise as seen in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coverage {
    corners: [Point; 3],
    /// Twice the area in square steps.
    area: i64,
    /// Whether the last two corners were swapped to turn the triangle clockwise.
    swapped: bool,
}

impl Coverage {
    /// The triangle, made clockwise if necessary; `None` if it has no area.
    pub fn new([a, b, c]: [Point; 3]) -> Option<Coverage> {
        match edge(a, b, c) {
            0 => None,
            area if area > 0 => Some(Coverage { corners: [a, b, c], area, swapped: false }),
            area => Some(Coverage { corners: [a, c, b], area: -area, swapped: true }),
        }
    }

    /// Whether the rectangle around a triangle's corners holds the centre of a pixel of a picture: if
    /// not, the triangle covers none.
    pub fn may_cover(corners: &[Point; 3], width: u32, height: u32) -> bool {
        let holds = |along: fn(&Point) -> i64, pixels: u32| {
            let [a, b, c] = corners.each_ref().map(along);
            !centres_between(a.min(b).min(c), a.max(b).max(c), pixels).is_empty()
        };
        holds(|point| point.y, height) && holds(|point| point.x, width)
    }

    /// The edge opposite to each corner.
    fn edges(&self) -> [(Point, Point); 3] {
        let [a, b, c] = self.corners;
        [(b, c), (c, a), (a, b)]
    }

    /// The rows of a picture of `height` rows that may hold covered pixels.
    pub fn rows(&self, height: u32) -> Range<u32> {
        let [a, b, c] = self.corners.map(|p| p.y);
        centres_between(a.min(b).min(c), a.max(b).max(c), height)
    }

    /// The columns covered in `row` of a picture of `width` columns: one run, which may be empty.
    pub fn columns(&self, row: u32, width: u32) -> Range<u32> {
        let [a, b, c] = self.corners.map(|p| p.x);
        let around = centres_between(a.min(b).min(c), a.max(b).max(c), width);
        if around.len() <= FEW {
            self.few_columns(row, around)
        } else {
            self.many_columns(row, width)
        }
    }

    /// The same, each edge asked about each column.
    fn few_columns(&self, row: u32, around: Range<u32>) -> Range<u32> {
        let start = Point::centre(around.start, row);
        let edges = self.edges().map(|(a, b)| (edge(a, b, start), a.y - b.y, least(a, b)));
        let is_covered = |column: &u32| {
            let across = i64::from(column - around.start) * STEPS;
            edges.iter().all(|(at_start, per_step, least)| at_start + across * per_step >= *least)
        };
        let Some(first) = around.clone().find(is_covered) else { return 0..0 };
        // What a triangle covers of a row is one run.
        let end = (first + 1..around.end).find(|column| !is_covered(column));
        first..end.unwrap_or(around.end)
    }

    /// The same, each edge asked where it is crossed.
    fn many_columns(&self, row: u32, width: u32) -> Range<u32> {
        let start = Point::centre(0, row);
        let (mut first, mut end) = (0, i64::from(width));
        for (a, b) in self.edges() {
            let least = least(a, b);
            let (at_start, per_pixel) = (edge(a, b, start), (a.y - b.y) * STEPS);
            // The condition is at_start + k * per_pixel >= least.
            match per_pixel.signum() {
                1 => first = first.max(ceiling(least - at_start, per_pixel)),
                -1 => end = end.min((at_start - least).div_euclid(-per_pixel) + 1),
                _ if at_start < least => return 0..0,
                _ => {}
            }
        }
        // Both are within 0..=width where the run is not empty.
        if first < end { first as u32..end as u32 } else { 0..0 }
    }

    /// The covered pixels of a picture, as rows, each with its run of columns.
    pub fn runs(&self, width: u32, height: u32) -> impl Iterator<Item = (u32, Range<u32>)> + '_ {
        let run = move |row| (row, self.columns(row, width));
        self.rows(height).map(run).filter(|(_, columns)| !columns.is_empty())
    }

    /// Barycentric weights at a pixel's centre, in the order in which the corners were given. They
    /// are 0 or more at covered pixels, and add up to 1 to within rounding.
    pub fn weights(&self, column: u32, row: u32) -> [f64; 3] {
        let p = Point::centre(column, row);
        let [a, b, c] = self.edges().map(|(from, to)| edge(from, to, p) as f64 / self.area as f64);
        if self.swapped { [a, c, b] } else { [a, b, c] }
    }
}

/// The least value of an edge's function that the edge owns: a left edge goes up, a top edge to the
/// right; they own the centres on them.
fn least(a: Point, b: Point) -> i64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    i64::from(!(dy < 0 || (dy == 0 && dx > 0)))
}

/// The pixels of a picture, of so many in a row or column, whose centres are not beyond either end.
fn centres_between(low: i64, high: i64, pixels: u32) -> Range<u32> {
    let first = ceiling(low - STEPS / 2, STEPS);
    let last = (high - STEPS / 2).div_euclid(STEPS);
    let within = |pixel: i64| pixel.clamp(0, i64::from(pixels)) as u32;
    within(first)..within(last + 1).max(within(first))
}

/// n / d rounded up, for d above 0.
fn ceiling(n: i64, d: i64) -> i64 {
    -(-n).div_euclid(d)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(corners: [(i64, i64); 3]) -> Vec<(u32, u32)> {
        let triangle =
            Coverage::new(corners.map(|(x, y)| Point { x: x * STEPS / 2, y: y * STEPS / 2 }));
        let runs = triangle.iter().flat_map(|t| t.runs(10, 10).collect::<Vec<_>>());
        runs.flat_map(|(y, xs)| xs.map(move |x| (x, y))).collect()
    }

    #[test]
    fn centres_on_left_and_top_edges_are_covered_and_on_others_not() {
        // Half pixels: corners at the centres of pixels (0,0), (2,0), (0,2).
        assert_eq!(pixels([(1, 1), (5, 1), (1, 5)]), [(0, 0), (1, 0), (0, 1)]);
        assert_eq!(pixels([(5, 5), (5, 1), (1, 5)]), [(1, 1)]);
    }

    #[test]
    fn the_order_of_corners_does_not_matter() {
        let corners = [(1, 0), (17, 5), (6, 15)];
        let expected = pixels(corners);
        let [a, b, c] = corners;
        for turned in [[b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]] {
            assert_eq!(pixels(turned), expected);
        }
    }

    #[test]
    fn runs_are_what_testing_each_pixel_gives() {
        let corners = [(-7, -3), (22, 4), (3, 31)];
        let triangle = corners.map(|(x, y)| Point { x: x * STEPS / 2, y: y * STEPS / 2 });
        let inside = |x: u32, y: u32| {
            let [a, b, c] = triangle;
            let p = Point::centre(x, y);
            [edge(a, b, p), edge(b, c, p), edge(c, a, p)].iter().all(|&e| e > 0)
        };
        let covered = pixels(corners);
        for (x, y) in (0..10).flat_map(|y| (0..10).map(move |x| (x, y))) {
            assert!(!inside(x, y) || covered.contains(&(x, y)), "{x} {y}");
        }
    }

    #[test]
    fn triangles_without_area_cover_nothing() {
        assert_eq!(pixels([(1, 1), (3, 3), (9, 9)]), []);
    }

    #[test]
    fn the_farthest_corners_do_not_overflow() {
        let far = FARTHEST_STEP;
        let points = [(-far, -far), (far, -far), (far, far)].map(|(x, y)| Point { x, y });
        let triangle = Coverage::new(points)
            .map(|t| t.runs(8192, 8192).map(|(_, c)| c.len() as u64).sum::<u64>());
        // The diagonal runs through pixel corners: below it lie 0 + 1 + ... , on it each centre
        // belongs to the left edge.
        assert_eq!(triangle, Some(8192 * 8193 / 2));
    }

    #[test]
    fn weights_follow_the_order_given() {
        let corner = |x: u32, y: u32| Point::centre(x, y);
        for corners in [[(0, 0), (8, 0), (0, 8)], [(0, 0), (0, 8), (8, 0)]] {
            let triangle = Coverage::new(corners.map(|(x, y)| corner(x, y)));
            for (k, (x, y)) in corners.into_iter().enumerate() {
                let weights = triangle.map(|t| t.weights(x, y));
                assert_eq!(weights, Some(std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })));
            }
        }
    }
}
