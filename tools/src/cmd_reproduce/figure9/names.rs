//! Names of the figure, its cores and its files.

/// Name of the figure, its output folder, and its picture.
pub const NAME: &str = "figure9";
/// The picture of what was simulated.
pub const SIMULATED: &str = "figure9.png";
/// The same in f64.
pub const FORMULAS: &str = "formulas.png";

/// Name of the module of a row, counted from 1.
pub fn module(number: usize) -> String {
    format!("{NAME}_row{number:02}")
}
