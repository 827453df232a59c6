//! Shapes for the corpus: as polygons, and cut into triangles by hand.
use crate::shape::{Shape, wedge};

/// A shape with its faces.
#[derive(Clone, Debug)]
pub struct Solid {
    pub name: &'static str,
    /// Its triangles.
    pub shape: Shape,
    /// The same surface in polygons; they lie in planes.
    pub faces: Vec<Vec<u32>>,
}

impl Solid {
    fn of_triangles(name: &'static str, shape: Shape) -> Solid {
        let faces = shape.triangles.iter().map(|t| t.to_vec()).collect();
        Solid { name, shape, faces }
    }
}

/// All of them.
pub fn all() -> Vec<Solid> {
    vec![
        Solid::of_triangles("wedge", wedge()),
        Solid::of_triangles("hills", hills()),
        Solid::of_triangles("two wedges", two_wedges()),
        prism("box", &[[0, 0], [4, 0], [4, 3], [0, 3]], &[0, 1, 2, 3], &[[0, 1, 2], [0, 2, 3]]),
        prism("arrow", &[[0, 0], [5, 2], [0, 4], [1, 2]], &[0, 1, 2, 3], &[[3, 0, 1], [3, 1, 2]]),
        prism(
            "angle",
            &[[3, 1], [1, 1], [1, 3], [0, 3], [0, 0], [3, 0]],
            &[0, 1, 2, 3, 4, 5],
            &[[4, 5, 0], [4, 0, 1], [4, 1, 2], [4, 2, 3]],
        ),
        prism("window", &WINDOW, &[0, 1, 2, 3, 0, 4, 5, 6, 7, 4], &AROUND_WINDOW),
        prism(
            "window the same way round",
            &WINDOW,
            &[0, 1, 2, 3, 0, 4, 7, 6, 5, 4],
            &AROUND_WINDOW,
        ),
        prism("comb", &COMB, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], &COMB_TRIANGLES),
    ]
}

/// A square with a square hole, which a bridge from corner 0 to corner 4 opens.
const WINDOW: [[i16; 2]; 8] = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [1, 3], [3, 3], [3, 1]];

const AROUND_WINDOW: [[u32; 3]; 8] =
    [[0, 1, 7], [0, 7, 4], [1, 2, 6], [1, 6, 7], [2, 3, 5], [2, 5, 6], [3, 0, 4], [3, 4, 5]];

/// Three teeth upwards.
const COMB: [[i16; 2]; 12] = [
    [0, 0],
    [5, 0],
    [5, 4],
    [4, 4],
    [4, 1],
    [3, 1],
    [3, 4],
    [2, 4],
    [2, 1],
    [1, 1],
    [1, 4],
    [0, 4],
];

const COMB_TRIANGLES: [[u32; 3]; 10] = [
    [0, 1, 4],
    [0, 4, 5],
    [0, 5, 8],
    [0, 8, 9],
    [0, 9, 10],
    [0, 10, 11],
    [5, 6, 7],
    [5, 7, 8],
    [1, 2, 3],
    [1, 3, 4],
];

/// A body between two copies of an outline, which goes around `corners` of some places and is
/// covered by `triangles` of them. An edge that is gone along both ways is a bridge, and has no
/// side.
fn prism(
    name: &'static str,
    places: &[[i16; 2]],
    outline: &[u32],
    triangles: &[[u32; 3]],
) -> Solid {
    let count = places.len() as u32;
    let level =
        |z: f32| places.iter().map(move |&[x, y]| [f32::from(x) / 2.0, f32::from(y) / 2.0, z]);
    let positions = level(0.75).chain(level(0.0)).collect();
    let edges: Vec<[u32; 2]> =
        outline.iter().zip(outline.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect();
    let sides = edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a]));
    let sides: Vec<[u32; 4]> = sides.map(|&[a, b]| [b, a, a + count, b + count]).collect();
    let behind = |&[a, b, c]: &[u32; 3]| [a + count, c + count, b + count];
    let cut = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let triangles =
        triangles.iter().copied().chain(triangles.iter().map(behind)).chain(cut).collect();
    let back = outline.iter().rev().map(|k| k + count).collect();
    let faces = [outline.to_vec(), back]
        .into_iter()
        .chain(sides.iter().map(|side| side.to_vec()))
        .collect();
    Solid { name, shape: Shape { positions, triangles }, faces }
}

/// A hilly square of 4 x 4 cells.
fn hills() -> Shape {
    let height = |i: u16, j: u16| f32::from((7 * i + 3 * j * j) % 5) / 4.0;
    let positions = (0..5)
        .flat_map(|i| (0..5).map(move |j| [f32::from(j), f32::from(i) / 2.0, height(i, j)]))
        .collect();
    let cells = (0..4).flat_map(|i| (0..4).map(move |j| 5 * i + j));
    Shape {
        positions,
        triangles: cells.flat_map(|k| [[k, k + 1, k + 6], [k, k + 6, k + 5]]).collect(),
    }
}

fn two_wedges() -> Shape {
    let one = wedge();
    let away = one.positions.iter().map(|[x, y, z]| [x - 3.0, y + 0.5, z - 0.25]);
    let positions: Vec<[f32; 3]> = one.positions.iter().copied().chain(away).collect();
    let other = one.triangles.iter().map(|t| t.map(|k| k + one.positions.len() as u32));
    Shape { positions, triangles: one.triangles.iter().copied().chain(other).collect() }
}
