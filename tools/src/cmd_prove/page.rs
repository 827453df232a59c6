//! The page that says what is proven by which program.
use super::proven::Proven;
use super::tables::{self, BOUNDS, FACTS, METHODS};
use crate::table::markdown;

/// The page.
pub fn text(scene: &str, proven: &[Proven]) -> String {
    format!(
        "{}## Goals of each method\n\nCores for `{scene}`.\n\n{}\n## Facts\n\n{}\n## Bounds on errors\n\n{}",
        include_str!("page.md"),
        markdown(METHODS, &tables::methods(proven)),
        markdown(FACTS, &tables::facts(proven)),
        markdown(BOUNDS, &tables::bounds(proven)),
    )
}
