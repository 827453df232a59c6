//! What Yosys's `stat` says: a line for each kind of cell.

/// How many cells of a kind there are: the number stands before or behind its name, as versions of
/// Yosys have it; 0 if no line names it.
pub fn cells(text: &str, kind: &str) -> u64 {
    let line = text.lines().find(|line| line.split_whitespace().any(|word| word == kind));
    line.and_then(|line| line.split_whitespace().find_map(|word| word.parse().ok())).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_counted_in_either_column() {
        let text = "   Number of cells:  9\n     LUT4                         1721\n     12   5.0 MULT18X18D\n";
        assert_eq!(
            ["LUT4", "MULT18X18D", "TRELLIS_FF"].map(|kind| cells(text, kind)),
            [1721, 12, 0]
        );
    }
}
