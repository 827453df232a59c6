//! Newell's teapot, 1975: 32 bicubic Bézier patches.
use glam::DVec3;

use super::grid::{Grid, empty};
use crate::mesh::Mesh;

/// Control points, a line each: x, y, z with z up.
const POINTS: &str = include_str!("../../data/teapot-points.csv");

/// Patches, a line each: 16 indices of control points, row by row.
const PATCHES: &str = include_str!("../../data/teapot-patches.csv");

/// A tangent shorter than this belongs to an edge that has degenerated to a point.
const SHORTEST_TANGENT: f64 = 1e-9;

/// The teapot, y up, with `level` by `level` cells a patch and its exact normals.
pub(super) fn mesh(level: u32) -> Mesh {
    let mut mesh = empty();
    for patch in patches() {
        patch.grid(level).append_to(&mut mesh);
    }
    mesh
}

/// The numbers of each line that is not a comment.
fn rows<T: std::str::FromStr>(table: &str) -> impl Iterator<Item = Vec<T>> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    // The tables are part of the program; a test checks their contents.
    lines.map(|line| line.split(',').filter_map(|number| number.trim().parse().ok()).collect())
}

fn points() -> Vec<DVec3> {
    // A quarter turn about x takes z up to y up.
    rows::<f64>(POINTS)
        .filter_map(|row| Some(DVec3::new(*row.first()?, *row.get(2)?, -*row.get(1)?)))
        .collect()
}

fn patches() -> impl Iterator<Item = Patch> {
    let points = points();
    rows::<usize>(PATCHES).map(move |row| {
        let point = |i: usize, j: usize| {
            row.get(4 * i + j).and_then(|&k| points.get(k)).copied().unwrap_or_default()
        };
        Patch(std::array::from_fn(|i| std::array::from_fn(|j| point(i, j))))
    })
}

/// A bicubic Bézier patch: P(u, v) = Σ bᵢ(u) bⱼ(v) Pᵢⱼ.
struct Patch([[DVec3; 4]; 4]);

/// The Bernstein polynomials of degree 3 and their derivatives, at one parameter.
struct Weights {
    value: [f64; 4],
    slope: [f64; 4],
}

impl Weights {
    /// The weights at t = `part`/`whole`. 1 - t is computed from integers, so that an edge is the
    /// same in either direction.
    fn new(part: u32, whole: u32) -> Weights {
        let t = f64::from(part) / f64::from(whole);
        let s = f64::from(whole - part) / f64::from(whole);
        Weights {
            value: [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
            slope: [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
        }
    }
}

impl Patch {
    fn grid(&self, level: u32) -> Grid {
        Grid::sample(level, level, |i, j| {
            let (u, v) = (Weights::new(i, level), Weights::new(j, level));
            // The mixed derivative is used as it is in the lower half, and negated in the upper
            // half, which looks back from u = 1 or v = 1.
            let toward = |k: u32| if 2 * k <= level { 1.0 } else { -1.0 };
            (self.combine(&u.value, &v.value), self.normal(&u, &v, [toward(i), toward(j)]))
        })
    }

    fn combine(&self, u: &[f64; 4], v: &[f64; 4]) -> DVec3 {
        let along = |row: &[DVec3; 4]| row.iter().zip(v).map(|(&p, &w)| p * w).sum::<DVec3>();
        self.0.iter().zip(u).map(|(row, &w)| along(row) * w).sum()
    }

    /// The outward unit normal, ∂P/∂v × ∂P/∂u: all 32 patches turn that way.
    ///
    /// Where an edge has degenerated to a point (the tops of lid and bottom), the derivative along
    /// it is zero, and near it grows as the distance times the mixed derivative, which replaces it;
    /// `toward` is the sign of that distance inside the patch.
    fn normal(&self, u: &Weights, v: &Weights, toward: [f64; 2]) -> DVec3 {
        let mixed = self.combine(&u.slope, &v.slope);
        let [mut along_u, mut along_v] =
            [self.combine(&u.slope, &v.value), self.combine(&u.value, &v.slope)];
        if along_v.length() < SHORTEST_TANGENT {
            along_v = mixed * toward[0];
        }
        if along_u.length() < SHORTEST_TANGENT {
            along_u = mixed * toward[1];
        }
        along_v.cross(along_u).normalize_or_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_are_whole() {
        assert_eq!((points().len(), patches().count()), (290, 32));
        assert!(rows::<f64>(POINTS).all(|row| row.len() == 3));
        assert!(rows::<usize>(PATCHES).all(|row| row.len() == 16 && row.iter().all(|&k| k < 290)));
    }

    #[test]
    fn normals_are_unit_and_point_outwards() {
        for level in [1, 2, 5, 12] {
            for [a, b, c] in mesh(level).normals {
                assert!(
                    [a, b, c].iter().all(|n| (n.length() - 1.0).abs() < 1e-12),
                    "level {level}: {a} {b} {c}"
                );
            }
        }
    }

    #[test]
    fn the_poles_of_lid_and_bottom_point_up_and_down() {
        let mesh = mesh(8);
        let corners = mesh.triangles.iter().flatten().zip(mesh.normals.iter().flatten());
        let (mut up, mut down) = (0, 0);
        for (&k, normal) in corners {
            let place = mesh.positions[k as usize];
            if place.x.abs() < 1e-12 && place.z.abs() < 1e-12 {
                let outward = if place.y > 1.0 { DVec3::Y } else { DVec3::NEG_Y };
                assert!((*normal - outward).length() < 1e-12, "{place} {normal}");
                *if place.y > 1.0 { &mut up } else { &mut down } += 1;
            }
        }
        assert!(up > 0 && down > 0);
    }

    #[test]
    fn normals_agree_with_the_triangles() {
        let mesh = mesh(12);
        for (triangle, normals) in mesh.triangles.iter().zip(&mesh.normals) {
            let face = crate::mesh::normals::newell(&triangle.map(|k| mesh.positions[k as usize]))
                .unwrap_or_default();
            assert!(normals.iter().all(|n| n.dot(face) > 0.5), "{face} {normals:?}");
        }
    }

    #[test]
    fn it_fills_the_box_it_is_known_to_fill() {
        let positions = mesh(12).positions;
        let low = positions.iter().fold(DVec3::INFINITY, |m, &p| m.min(p));
        let high = positions.iter().fold(DVec3::NEG_INFINITY, |m, &p| m.max(p));
        assert!((low - DVec3::new(-3.0, 0.0, -2.0)).abs().max_element() < 0.01, "{low}");
        assert!((high - DVec3::new(3.43, 3.15, 2.0)).abs().max_element() < 0.02, "{high}");
    }
}
