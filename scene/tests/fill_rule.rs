//! The fill rule: surfaces made of triangles have neither gaps nor pixels drawn twice.
use proptest::prelude::*;
use specula_scene::picture::coverage::{Coverage, Point, STEPS};

const SIZE: u32 = 24;

/// How often each pixel of a picture is covered by triangles.
fn counts(triangles: &[[Point; 3]]) -> Vec<u32> {
    let mut counts = vec![0; (SIZE * SIZE) as usize];
    for triangle in triangles.iter().filter_map(|&corners| Coverage::new(corners)) {
        for (row, columns) in triangle.runs(SIZE, SIZE) {
            columns.for_each(|column| counts[(row * SIZE + column) as usize] += 1);
        }
    }
    counts
}

fn point((x, y): (i64, i64)) -> Point {
    Point { x, y }
}

/// A grid of cells with its inner vertices shifted, cut along diagonals of either kind: (corners,
/// shift, diagonals).
const CELLS: usize = 6;

fn grid(
    cell: i64,
    corner: (i64, i64),
    shifts: &[(i64, i64)],
    diagonals: &[bool],
) -> Vec<[Point; 3]> {
    let vertex = |i: usize, j: usize| {
        let inner = |k: usize| k > 0 && k < CELLS;
        let (dx, dy) = shifts[i * (CELLS + 1) + j];
        // Vertices on the border move along it only, so that the outline stays a rectangle.
        let (dx, dy) = (if inner(j) { dx } else { 0 }, if inner(i) { dy } else { 0 });
        point((
            corner.0 + j as i64 * cell + dx % (cell / 4),
            corner.1 + i as i64 * cell + dy % (cell / 4),
        ))
    };
    let mut triangles = Vec::new();
    for i in 0..CELLS {
        for j in 0..CELLS {
            let [a, b, c, d] =
                [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)];
            let cut = if diagonals[i * CELLS + j] {
                [[a, b, d], [d, c, a]]
            } else {
                [[b, c, a], [b, d, c]]
            };
            triangles.extend(cut);
        }
    }
    triangles
}

/// Pixels whose centre is in a rectangle that owns its left and top sides.
fn rectangle((x, y): (i64, i64), side: i64) -> Vec<u32> {
    let within =
        |low: i64, pixel: u32| (low..low + side).contains(&(i64::from(pixel) * STEPS + STEPS / 2));
    (0..SIZE * SIZE).map(|k| u32::from(within(x, k % SIZE) && within(y, k / SIZE))).collect()
}

proptest! {
    #[test]
    fn a_triangulated_rectangle_is_covered_once(
        cell in prop_oneof![4..20_i64, 128..1500_i64, Just(STEPS), Just(2 * STEPS)],
        corner in (-3000..5000_i64, -3000..5000_i64),
        shifts in prop::collection::vec((-2000..2000_i64, -2000..2000_i64), (CELLS + 1) * (CELLS + 1)),
        diagonals in prop::collection::vec(any::<bool>(), CELLS * CELLS),
    ) {
        let covered = counts(&grid(cell, corner, &shifts, &diagonals));
        prop_assert_eq!(covered, rectangle(corner, cell * CELLS as i64));
    }

    /// With vertices and edges right through pixel centres.
    #[test]
    fn a_rectangle_on_pixel_centres_is_covered_once(
        corner in (-4..8_i64, -4..8_i64),
        shifts in prop::collection::vec((-3..3_i64, -3..3_i64), (CELLS + 1) * (CELLS + 1)),
        diagonals in prop::collection::vec(any::<bool>(), CELLS * CELLS),
    ) {
        let corner = (corner.0 * STEPS + STEPS / 2, corner.1 * STEPS + STEPS / 2);
        let shifts: Vec<_> = shifts.iter().map(|&(x, y)| (x * STEPS, y * STEPS)).collect();
        let cell = 16 * STEPS;
        let covered = counts(&grid(cell, corner, &shifts, &diagonals));
        prop_assert_eq!(covered, rectangle(corner, cell * CELLS as i64));
    }

    /// A fan around a point covers what a fan around another point does, each pixel once.
    #[test]
    fn the_inner_point_of_a_fan_does_not_matter(
        centres in [(5000..7000_i64, 5000..7000_i64), (5000..7000_i64, 5000..7000_i64)],
        mut outline in prop::collection::vec((0..12_000_i64, any::<bool>()), 3..12),
    ) {
        // Points on the sides of a square, in order along it: convex around every inner point.
        let side = 12_000;
        outline.iter_mut().for_each(|(at, second)| *at += if *second { side } else { 0 });
        let mut places: Vec<i64> = outline.iter().map(|(at, _)| *at).chain([0, side, 2 * side, 3 * side]).collect();
        places.sort_unstable();
        let ring: Vec<Point> = places.iter().map(|&at| point(match at / side {
            0 => (at, 0),
            1 => (side, at - side),
            2 => (3 * side - at, side),
            _ => (0, 4 * side - at),
        })).collect();
        let fan = |centre| {
            let edges = ring.iter().zip(ring.iter().cycle().skip(1));
            counts(&edges.map(|(&a, &b)| [point(centre), b, a]).collect::<Vec<_>>())
        };
        let [first, second] = centres.map(fan);
        prop_assert!(first.iter().all(|&n| n <= 1));
        prop_assert_eq!(first, second);
    }

    /// Runs and weights agree: inside the triangle all weights are 0 or more and add up to 1.
    #[test]
    fn weights_at_covered_pixels_are_those_of_an_inner_point(
        corners in prop::array::uniform3((-9000..15_000_i64, -9000..15_000_i64)),
    ) {
        let corners = corners.map(point);
        let Some(triangle) = Coverage::new(corners) else { return Ok(()) };
        for (row, columns) in triangle.runs(SIZE, SIZE) {
            for column in columns {
                let weights = triangle.weights(column, row);
                prop_assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)));
                prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-15 * 4.0);
                let along = |of: fn(&Point) -> i64| -> f64 {
                    corners.iter().zip(weights).map(|(p, w)| of(p) as f64 * w).sum()
                };
                let centre = Point::centre(column, row);
                prop_assert!((along(|p| p.x) - centre.x as f64).abs() < 1e-9);
                prop_assert!((along(|p| p.y) - centre.y as f64).abs() < 1e-9);
            }
        }
    }
}
