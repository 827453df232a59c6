//! The unit sphere.
use glam::DVec3;

use super::grid::{Grid, empty};
use crate::angle::cos_sin_of_turn;
use crate::mesh::Mesh;

/// 4 `level` cells around the y axis, 2 `level` from the pole at y = 1 to the one at y = -1.
pub(super) fn mesh(level: u32) -> Mesh {
    let (rows, columns) = (2 * level, 4 * level);
    let grid = Grid::sample(rows, columns, |i, j| {
        let (cos_polar, sin_polar) = cos_sin_of_turn(i, 2 * rows);
        let (cos, sin) = cos_sin_of_turn(j % columns, columns);
        let place = DVec3::new(sin_polar * cos, cos_polar, sin_polar * sin);
        (place, place.normalize())
    });
    let mut mesh = empty();
    grid.append_to(&mut mesh);
    mesh
}
