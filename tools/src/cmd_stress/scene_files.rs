//! Names of the scene files that show what came of a row.
use specula_experiments::stress::Cell;

/// The name of a row's scene file for a method, such as `row_breaks_1_lyon.toml`.
pub fn scene_name(row: &str, method: &str) -> String {
    format!("row_{}_{method}.toml", row.replace(' ', "_"))
}

/// The name of a cell's scene file, if it has one.
pub fn scene_of(cell: &Cell) -> Option<String> {
    cell.reproducer.as_ref().and(cell.method).map(|method| scene_name(cell.row, method))
}
