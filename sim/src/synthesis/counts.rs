//! What Yosys's `stat` says: a line for each kind of cell.

/// How many cells of a kind there are: the number stands before or behind its name, as versions of
/// Yosys have it; 0 if no line names it. A kind that ends in `*` stands for all that begin so.
pub fn cells(text: &str, kind: &str) -> u64 {
    let is_of_kind = |word: &str| match kind.strip_suffix('*') {
        Some(beginning) => word.starts_with(beginning),
        None => word == kind,
    };
    let lines = text.lines().filter(|line| line.split_whitespace().any(is_of_kind));
    let number = |line: &str| line.split_whitespace().find_map(|word| word.parse::<u64>().ok());
    lines.filter_map(number).sum()
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

    #[test]
    fn kinds_that_begin_alike_are_counted_together() {
        let text = "  SB_CARRY 7\n  SB_DFF 10\n  SB_DFFE 4\n  SB_DFFSR 2\n";
        assert_eq!(["SB_DFF", "SB_DFF*"].map(|kind| cells(text, kind)), [10, 16]);
    }
}
