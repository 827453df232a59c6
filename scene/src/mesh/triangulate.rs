//! Splitting polygons into triangles, by the `i_triangle` crate
//! (docs/decisions/0012-polygons-are-split-by-a-sweep.md).
use std::collections::BTreeMap;

use glam::DVec3;
use i_triangle::i_overlay::core::fill_rule::FillRule;
use i_triangle::i_overlay::core::overlay::IntOverlayOptions;
use i_triangle::i_overlay::i_float::int::point::IntPoint;
use i_triangle::int::custom::IntCustomTriangulatable;
use i_triangle::int::triangulation::IntTriangulation;
use i_triangle::int::validation::Validation;

/// Steps in a polygon's extent of the grid to which corners are rounded to find triangles. It is
/// finer than what [`super::normals::newell`] counts as rounding. Coordinates stay below 2^45 in
/// magnitude (√3 extents), twice a triangle's area below 2^93, and sums of it over any polygon that
/// a file can contain (2^29 corners) within 127 bits.
const GRID: f64 = (1_u64 << 44) as f64;

/// Number of corners that are tried as the first of a fan, before the sweep.
const FANS_TRIED: usize = 8;

/// Largest number of crossings of all polygons of a file.
pub const MAX_CROSSINGS: usize = 250_000;

/// Least number of pairs of edges from which crossings are estimated.
const FEWEST_PAIRS: usize = 4096;

/// Number of pairs of edges, for each corner, from which crossings are estimated: enough to notice
/// a few edges with many crossings among countless others.
const PAIRS_A_CORNER: usize = 4;

/// Areas that differ by less than this share of them differ by rounding.
const LEAST_DIFFERENCE: i128 = 1_000_000;

/// A polygon split into triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangulation {
    /// Triangles with the orientation of the polygon's normal. Each is three indices: of the
    /// polygon's corners or, from their number on, of `crossings`.
    pub triangles: Vec<[usize; 3]>,
    /// Points where edges cross each other.
    pub crossings: Vec<DVec3>,
    /// Whether the area of the triangles differs from the polygon's, since it crosses or covers
    /// itself.
    pub overlaps: bool,
}

/// Splits a polygon into triangles that cover what an odd number of its edges surrounds, as seen
/// along `normal`, a unit vector.
///
/// A polygon with a bridge to a hole, whose corners are stated twice, keeps the hole. Of corners at
/// the same place, a triangle uses the one in whose angle it lies. If one of the first corners sees
/// all others, the polygon becomes a fan from it. The time is of order n log n for n corners and
/// crossings. The result is `None` for a polygon whose edges, by an estimate, cross or cover each
/// other more than `most_crossings` times.
pub fn triangulate(
    polygon: &[DVec3],
    normal: DVec3,
    most_crossings: usize,
) -> Option<Triangulation> {
    if polygon.len() == 3 {
        return Some(Triangulation { triangles: vec![[0, 1, 2]], ..Triangulation::default() });
    }
    let Some(plane) = Plane::of(polygon, normal) else { return Some(Triangulation::default()) };
    let ring = Ring::new(polygon, &plane);
    match ring.fan() {
        Some(triangles) => Some(Triangulation { triangles, ..Triangulation::default() }),
        None => {
            let is_bearable = ring.crossings_expected(most_crossings) <= most_crossings;
            is_bearable.then(|| ring.swept(polygon.len(), &plane))
        }
    }
}

/// A polygon's plane with a grid on it.
struct Plane {
    origin: DVec3,
    across: DVec3,
    up: DVec3,
    normal: DVec3,
    /// The largest coordinate of a corner, from `origin`.
    extent: f64,
    /// The corners' mean distance from `origin` along `normal`, in extents.
    height: f64,
}

impl Plane {
    /// The plane of a polygon; `None` if all corners are at one place.
    fn of(polygon: &[DVec3], normal: DVec3) -> Option<Plane> {
        let origin = *polygon.first()?;
        let extent = polygon.iter().fold(0.0_f64, |e, &p| e.max((p - origin).abs().max_element()));
        if !(extent > 0.0 && extent.is_finite()) {
            return None;
        }
        let (across, up) = normal.any_orthonormal_pair();
        let height = polygon.iter().map(|&p| ((p - origin) / extent).dot(normal)).sum::<f64>()
            / polygon.len() as f64;
        Some(Plane { origin, across, up, normal, extent, height })
    }

    fn grid(&self, point: DVec3) -> GridPoint {
        let relative = (point - self.origin) / self.extent;
        let step = |axis: DVec3| (relative.dot(axis) * GRID).round() as i64;
        GridPoint::new(step(self.across), step(self.up))
    }

    fn point(&self, place: GridPoint) -> DVec3 {
        let [x, y] = [place.x, place.y].map(|steps| steps as f64 / GRID);
        self.origin + (self.across * x + self.up * y + self.normal * self.height) * self.extent
    }
}

type GridPoint = IntPoint<i64>;

/// A polygon in its plane, without corners at the same place as the previous one.
struct Ring {
    /// Indices of corners.
    corners: Vec<usize>,
    /// Their places.
    places: Vec<GridPoint>,
}

impl Ring {
    fn new(polygon: &[DVec3], plane: &Plane) -> Ring {
        let (mut corners, mut places) =
            (Vec::with_capacity(polygon.len()), Vec::with_capacity(polygon.len()));
        for (corner, &point) in polygon.iter().enumerate() {
            let place = plane.grid(point);
            if places.last() != Some(&place) {
                corners.push(corner);
                places.push(place);
            }
        }
        while places.len() > 1 && places.last() == places.first() {
            corners.pop();
            places.pop();
        }
        Ring { corners, places }
    }

    fn len(&self) -> usize {
        self.places.len()
    }

    /// Triangles from one corner to all edges that do not touch it, if one of the first corners
    /// sees all others.
    fn fan(&self) -> Option<Vec<[usize; 3]>> {
        let n = self.len();
        if n < 3 {
            return None;
        }
        let first = (0..n.min(FANS_TRIED)).find(|&first| self.sees_all(first))?;
        let corner = |k: usize| self.corners[(first + k) % n];
        Some((1..n - 1).map(|k| [corner(0), corner(k), corner(k + 1)]).collect())
    }

    /// Whether the edges, as seen from a corner, follow each other in order within the angle at it,
    /// which is below 180 degrees: then the triangles between the corner and the edges do not
    /// overlap.
    fn sees_all(&self, first: usize) -> bool {
        let (n, last) = (self.len(), self.len() - 1);
        let at = |k: usize| self.places[(first + k) % n];
        let left = |a: usize, b: usize| turn(at(0), at(a), at(b)) > 0;
        (1..last).all(|k| left(k, k + 1) && left(k, last) && (k == 1 || left(1, k)))
    }

    /// An estimate of how often edges meet, from some pairs of them that are the same in every run;
    /// 0 for polygons with too few edges to reach `most`.
    fn crossings_expected(&self, most: usize) -> usize {
        let n = self.len();
        let pairs = n * n / 2;
        if pairs <= most {
            return 0;
        }
        let tried = FEWEST_PAIRS.max(PAIRS_A_CORNER * n);
        let mut state = 1_u64;
        let mut edge = || {
            // The sequence is Knuth's MMIX generator, whose upper bits are the random ones.
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let from = (state >> 33) as usize % n;
            [self.places[from], self.places[(from + 1) % n]]
        };
        let crossing = (0..tried).filter(|_| meet(edge(), edge())).count();
        // A polygon of 2^29 corners has fewer than 2^58 pairs, of which 2^31 are tried.
        (crossing as u128 * pairs as u128 / tried as u128) as usize
    }

    /// Finds triangles by a sweep over the plane.
    fn swept(&self, corners: usize, plane: &Plane) -> Triangulation {
        // Corners on a straight edge have normals, and neighbours that share them.
        let options = IntOverlayOptions::keep_all_points();
        let validation = Validation { fill_rule: FillRule::EvenOdd, options };
        let found: IntTriangulation<i64, u32> =
            self.places.custom_triangulate(validation).into_triangulation();
        let corners_by_place = CornersByPlace::new(self);
        // The sweep reports a crossing once for each of the parts that meet there.
        let (mut crossings, mut known) = (Vec::new(), BTreeMap::new());
        let mut area = 0;
        let mut triangles = Vec::with_capacity(found.indices.len() / 3);
        for &[a, b, c] in found.indices.as_chunks::<3>().0 {
            let twice_area =
                turn(found.points[a as usize], found.points[b as usize], found.points[c as usize]);
            if twice_area == 0 {
                continue;
            }
            area += twice_area.abs();
            let places = if twice_area < 0 { [a, c, b] } else { [a, b, c] }
                .map(|k| found.points[k as usize]);
            triangles.push(places.map(|place| {
                corners_by_place.corner(place, places).unwrap_or_else(|| {
                    *known.entry((place.x, place.y)).or_insert_with(|| {
                        crossings.push(plane.point(place));
                        corners + crossings.len() - 1
                    })
                })
            }));
        }
        let difference = (area - self.twice_area().abs()).abs();
        Triangulation {
            triangles,
            crossings,
            overlaps: difference > area.max(self.twice_area().abs()) / LEAST_DIFFERENCE,
        }
    }

    /// Twice the area that the ring surrounds counter-clockwise, minus what it surrounds clockwise.
    fn twice_area(&self) -> i128 {
        let edges = self.places.iter().zip(self.places.iter().cycle().skip(1));
        edges.map(|(&a, &b)| turn(GridPoint::new(0, 0), a, b)).sum()
    }

    /// Whether a triangle that has a corner of the ring lies in the angle there, to the left of the
    /// ring.
    fn has_in_angle(&self, position: usize, triangle: [GridPoint; 3]) -> bool {
        let n = self.len();
        let [before, here, after] =
            [position + n - 1, position, position + 1].map(|k| self.places[k % n]);
        // This is three times the triangle's centre minus three times `here`, which has the same
        // direction.
        let centre = triangle.iter().fold((0, 0), |(x, y), p| (x + p.x - here.x, y + p.y - here.y));
        let inside = GridPoint::new(here.x + centre.0, here.y + centre.1);
        let (after_left, before_right) =
            (turn(here, after, inside) >= 0, turn(here, inside, before) >= 0);
        if turn(here, after, before) > 0 {
            after_left && before_right
        } else {
            after_left || before_right
        }
    }
}

/// The corners of a ring, sorted by place.
struct CornersByPlace<'a> {
    ring: &'a Ring,
    /// Positions in the ring, sorted by place.
    order: Vec<usize>,
}

impl CornersByPlace<'_> {
    fn new(ring: &Ring) -> CornersByPlace<'_> {
        let mut order: Vec<usize> = (0..ring.len()).collect();
        order.sort_unstable_by_key(|&k| (ring.places[k].x, ring.places[k].y, k));
        CornersByPlace { ring, order }
    }

    /// The corner at a place of a triangle; of several, the first one in whose angle the triangle
    /// lies.
    fn corner(&self, place: GridPoint, triangle: [GridPoint; 3]) -> Option<usize> {
        let key = |&k: &usize| (self.ring.places[k].x, self.ring.places[k].y);
        let first = self.order.partition_point(|k| key(k) < (place.x, place.y));
        let here = self.order[first..].iter().take_while(|k| key(k) == (place.x, place.y));
        let mut here = here.copied().peekable();
        let any = *here.peek()?;
        let fitting = here.find(|&position| self.ring.has_in_angle(position, triangle));
        Some(self.ring.corners[fitting.unwrap_or(any)])
    }
}

/// Twice the area of a counter-clockwise triangle; negative for a clockwise one.
fn turn(a: GridPoint, b: GridPoint, c: GridPoint) -> i128 {
    let [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].map(i128::from);
    bx * cy - by * cx
}

/// Whether two edges cross, or one ends between the ends of the other.
fn meet([a, b]: [GridPoint; 2], [c, d]: [GridPoint; 2]) -> bool {
    let sides = |a, b, c, d| turn(a, b, c).signum() * turn(a, b, d).signum() < 0;
    let crosses = sides(a, b, c, d) && sides(c, d, a, b);
    crosses
        || [c, d].into_iter().any(|end| is_between(a, b, end))
        || [a, b].into_iter().any(|end| is_between(c, d, end))
}

/// Whether a place is on an edge and not at its ends.
fn is_between(a: GridPoint, b: GridPoint, place: GridPoint) -> bool {
    let [ax, ay, bx, by] =
        [a.x - place.x, a.y - place.y, b.x - place.x, b.y - place.y].map(i128::from);
    ax * bx + ay * by < 0 && ax * by == ay * bx
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
        points.iter().map(|&(x, y)| DVec3::new(x, y, 7.0)).collect()
    }

    fn split(polygon: &[DVec3]) -> Triangulation {
        triangulate(polygon, DVec3::Z, MAX_CROSSINGS).expect("it does not cross itself often")
    }

    #[test]
    fn a_convex_polygon_becomes_a_fan() {
        let square = flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        assert_eq!(split(&square).triangles, [[0, 1, 2], [0, 2, 3]]);
    }

    /// Each of the two corners at either end of a bridge has the triangles on its own side of it.
    #[test]
    fn corners_at_one_place_keep_their_triangles_apart() {
        let rim = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (0.0, 6.0)];
        let bridge = [(0.0, 0.0), (2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0), (2.0, 2.0)];
        let polygon = flat(&[&rim[..], &bridge].concat());
        let Triangulation { triangles, crossings, overlaps } = split(&polygon);
        assert!(crossings.is_empty() && !overlaps);
        // The bridge lies on the diagonal: the first corner and the last are the rim's below it,
        // the others those above it.
        let centre_below =
            |t: &[usize; 3]| t.iter().map(|&k| polygon[k].x - polygon[k].y).sum::<f64>() > 0.0;
        for triangle in &triangles {
            let above = [4, 5].iter().any(|k| triangle.contains(k));
            let below = [0, 9].iter().any(|k| triangle.contains(k));
            assert!(!(above && below), "{triangle:?}");
            assert!(above || below || triangle.iter().all(|&k| !matches!(k, 0 | 4 | 5 | 9)));
            assert!(!above || !centre_below(triangle), "{triangle:?}");
            assert!(!below || centre_below(triangle), "{triangle:?}");
        }
    }

    #[test]
    fn a_bow_tie_is_two_triangles_that_meet_where_it_crosses() {
        let bow_tie = flat(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 1.0)]);
        let Triangulation { triangles, crossings, overlaps } = split(&bow_tie);
        assert_eq!((triangles.len(), crossings.len(), overlaps), (2, 1, true));
        let crossing = DVec3::new(2.0 / 3.0, 2.0 / 3.0, 7.0);
        assert!((crossings[0] - crossing).length() < 1e-12, "{crossings:?}");
    }

    #[test]
    fn what_is_gone_around_twice_is_not_covered() {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let twice = split(&flat(&[square, square].concat()));
        assert_eq!((twice.triangles.len(), twice.overlaps), (0, true));
    }

    #[test]
    fn a_polygon_that_crosses_itself_everywhere_is_refused() {
        // A star, each edge of which crosses about half of the others.
        let star = |corners: u32| {
            let corner =
                |k: u32| f64::from(k * (corners / 2)) * std::f64::consts::TAU / f64::from(corners);
            (0..corners)
                .map(|k| DVec3::new(corner(k).cos(), corner(k).sin(), 0.0))
                .collect::<Vec<_>>()
        };
        assert!(triangulate(&star(501), DVec3::Z, MAX_CROSSINGS).is_some());
        assert_eq!(triangulate(&star(501), DVec3::Z, MAX_CROSSINGS / 10), None);
        assert_eq!(triangulate(&star(20_001), DVec3::Z, MAX_CROSSINGS), None);
    }

    /// Many long edges on one line, in no order: each is covered by thousands of others.
    #[test]
    fn a_polygon_that_covers_itself_everywhere_is_refused() {
        let on_line = |k: u32| (f64::from(k * 7919 % 20_011), 0.0);
        let polygon = |corners: u32| {
            flat(&(0..corners).map(on_line).chain([(5000.0, 7000.0)]).collect::<Vec<_>>())
        };
        assert!(triangulate(&polygon(300), DVec3::Z, MAX_CROSSINGS).is_some());
        assert_eq!(triangulate(&polygon(20_000), DVec3::Z, MAX_CROSSINGS), None);
    }

    /// Two zigzags that cross each other everywhere, among a hundred times as many edges that
    /// cross none.
    #[test]
    fn crossings_of_a_few_of_many_edges_are_not_overlooked() {
        let zig = |k: u32| if k.is_multiple_of(2) { 0.0 } else { 10.0 };
        let across = (0..3000).map(|k| (zig(k), f64::from(k) / 300.0));
        let upwards = (0..3000).map(|k| (f64::from(k) / 300.0, zig(k)));
        let outside = (0..600_000).map(|k| (20.0 + f64::from(k), zig(k) * 1e-3 - 1.0));
        let polygon = flat(&across.chain(upwards).chain(outside).collect::<Vec<_>>());
        assert_eq!(triangulate(&polygon, DVec3::Z, MAX_CROSSINGS), None);
    }

    /// Corners on straight edges have normals of their own, and neighbours that share them.
    #[test]
    fn corners_on_straight_edges_are_kept() {
        let square =
            [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0)];
        for polygon in [
            flat(&[&square[..], &[(0.0, 1.0)]].concat()),
            // Concave: a notch with corners on its sides.
            flat(
                &[&square[..5], &[(1.5, 2.0), (1.25, 1.25), (1.0, 0.5), (0.5, 1.25)], &square[6..]]
                    .concat(),
            ),
        ] {
            let Triangulation { triangles, crossings, overlaps } = split(&polygon);
            assert_eq!((triangles.len(), crossings.len(), overlaps), (polygon.len() - 2, 0, false));
            for corner in 0..polygon.len() {
                assert!(triangles.iter().any(|t| t.contains(&corner)), "{corner} of {polygon:?}");
            }
        }
    }
}
