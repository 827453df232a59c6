//! The torus.
use glam::DVec3;

use super::grid::{Grid, empty};
use crate::angle::cos_sin_of_turn;
use crate::mesh::Mesh;

/// 4 `level` cells around the y axis, 2 `level` around the tube of radius `tube`.
pub(super) fn mesh(level: u32, tube: f64) -> Mesh {
    let (around, about) = (4 * level, 2 * level);
    let grid = Grid::sample(around, about, |i, j| {
        let (cos, sin) = cos_sin_of_turn(i % around, around);
        let (cos_tube, sin_tube) = cos_sin_of_turn(j % about, about);
        let outward = DVec3::new(cos, 0.0, sin);
        let normal = outward * cos_tube + DVec3::Y * sin_tube;
        (outward + normal * tube, normal.normalize())
    });
    let mut mesh = empty();
    grid.append_to(&mut mesh);
    mesh
}
