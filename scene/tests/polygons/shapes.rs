//! Polygons to be split, as corners in a plane.
use specula_fixtures::Draw;

/// A place in the plane.
pub type Place = [f64; 2];

/// A polygon around the middle, its corners on a grid, so that edges may run through corners
/// exactly.
pub fn star(draw: &mut Draw, corners: usize, middle: Place, radius: f64) -> Vec<Place> {
    let turn = draw.unit() * std::f64::consts::TAU;
    let corner = |k: usize, draw: &mut Draw| {
        let angle = turn + (k as f64 + 0.8 * draw.unit()) / corners as f64 * std::f64::consts::TAU;
        let length = radius * (0.3 + 0.7 * draw.unit());
        on_grid([middle[0] + length * angle.cos(), middle[1] + length * angle.sin()])
    };
    (0..corners).map(|k| corner(k, draw)).collect()
}

/// A band that winds inwards; no corner of it sees all others.
pub fn spiral(corners: usize, turns: f64, radius: f64) -> Vec<Place> {
    let half = corners / 2;
    let between_turns = 0.8 * radius / turns;
    let place = |k: usize, inset: f64| {
        let along = k as f64 / half as f64;
        let (angle, length) =
            (along * turns * std::f64::consts::TAU, radius * (0.2 + 0.8 * along) - inset);
        [length * angle.cos(), length * angle.sin()]
    };
    (0..half)
        .map(|k| place(k, 0.0))
        .chain((0..half).rev().map(|k| place(k, 0.4 * between_turns)))
        .collect()
}

/// A comb with its teeth upwards.
pub fn comb(teeth: usize) -> Vec<Place> {
    let tooth = |k: usize| [[2 * k, 2], [2 * k, 9], [2 * k + 1, 9], [2 * k + 1, 2]];
    let teeth =
        (0..teeth).rev().flat_map(|k| tooth(k).into_iter().rev()).map(|p| p.map(|x| x as f64));
    let right = 2.0 * teeth.clone().count() as f64 / 4.0 - 1.0;
    [[0.0, 0.0], [right, 0.0]].into_iter().chain(teeth).collect()
}

/// A square with square holes in a row, each joined to the rim, or to the hole before, by a bridge.
pub fn with_holes(draw: &mut Draw, holes: usize) -> Vec<Place> {
    let width = 4.0 * holes as f64 + 2.0;
    let mut polygon = vec![[0.0, 0.0], [width, 0.0], [width, 6.0], [0.0, 6.0]];
    for k in 0..holes {
        let (x, bottom) = (4.0 * k as f64 + 2.0, 2.0 + draw.unit().round() * 0.5);
        let mut hole = vec![[x, bottom], [x, 4.0], [x + 2.0, 4.0], [x + 2.0, bottom]];
        // A hole that turns the same way as the rim is a hole all the same.
        if draw.below(4) == 0 {
            hole.reverse();
        }
        polygon = bridged(draw, &polygon, &hole);
    }
    polygon
}

/// A polygon with a hole put into it by a bridge between two corners that see each other.
pub fn bridged(draw: &mut Draw, polygon: &[Place], hole: &[Place]) -> Vec<Place> {
    let (n, m) = (polygon.len(), hole.len());
    let start = draw.below(n * m);
    let pairs = (0..n * m).map(|k| (start + k) % (n * m)).map(|k| (k / m, k % m));
    let sees = |&(i, j): &(usize, usize)| {
        let bridge = [polygon[i], hole[j]];
        edges(polygon).chain(edges(hole)).all(|edge| !meet_between(bridge, edge))
    };
    let (i, j) = pairs.into_iter().find(sees).expect("one of the corners sees one of the hole's");
    let around = (0..=m).map(|k| hole[(j + k) % m]);
    polygon[..=i].iter().copied().chain(around).chain(polygon[i..].iter().copied()).collect()
}

/// Corners put on edges, corners stated twice in a row, and slits that go along an edge inwards and
/// back.
pub fn roughened(draw: &mut Draw, polygon: &[Place]) -> Vec<Place> {
    let mut rough = Vec::new();
    for [a, b] in edges(polygon) {
        rough.push(a);
        match draw.below(4) {
            0 => rough.push(a),
            1 => rough.extend([0.25, 0.5].map(|t| between(a, b, t))),
            2 => rough.extend([between(a, b, 0.5), between(a, b, 0.25), between(a, b, 0.75)]),
            _ => {}
        }
    }
    rough
}

/// Corners anywhere on a small grid: the polygon crosses, touches and covers itself.
pub fn tangled(draw: &mut Draw, corners: usize) -> Vec<Place> {
    (0..corners).map(|_| [draw.below(7) as f64, draw.below(7) as f64]).collect()
}

/// The edges of a polygon.
pub fn edges(polygon: &[Place]) -> impl Iterator<Item = [Place; 2]> + '_ {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Twice the area of a triangle, positive where it turns to the left.
pub fn turn(a: Place, b: Place, c: Place) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn between(a: Place, b: Place, t: f64) -> Place {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

fn on_grid(place: Place) -> Place {
    place.map(|x| (x * 64.0).round() / 64.0)
}

/// Whether a bridge meets an edge anywhere but at the bridge's ends.
fn meet_between(bridge: [Place; 2], edge: [Place; 2]) -> bool {
    let [a, b] = bridge;
    let [c, d] = edge;
    let (from_bridge, from_edge) = ([turn(a, b, c), turn(a, b, d)], [turn(c, d, a), turn(c, d, b)]);
    let crosses = from_bridge[0] * from_bridge[1] < 0.0 && from_edge[0] * from_edge[1] < 0.0;
    // A corner of the edge on the bridge, its ends left out.
    let on_bridge = |p: Place| {
        turn(a, b, p) == 0.0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) < 0.0
    };
    crosses || on_bridge(c) || on_bridge(d)
}
