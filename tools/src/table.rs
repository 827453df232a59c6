//! Rows of text in columns.
use std::fmt::Write;

/// Rows with their columns lined up by blanks, a line each.
pub fn lines<const N: usize>(rows: &[[String; N]]) -> String {
    let widths: [usize; N] = std::array::from_fn(|c| rows.iter().map(|row| row[c].chars().count()).max().unwrap_or(0));
    let line = |row: &[String; N]| {
        let cells: Vec<String> = row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        format!("{}\n", cells.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

/// A table as Markdown has it.
pub fn markdown<const N: usize>(titles: [&str; N], rows: &[[String; N]]) -> String {
    let line = |cells: &[String; N]| format!("| {} |\n", cells.each_ref().map(|cell| cell.replace('|', "\\|")).join(" | "));
    let mut table = line(&titles.map(str::to_owned));
    // Writing to a String cannot fail.
    let _ = writeln!(table, "|{}", alignments(rows).concat());
    table.extend(rows.iter().map(line));
    table
}

/// Columns of numbers end at the right.
fn alignments<const N: usize>(rows: &[[String; N]]) -> [&'static str; N] {
    let is_number = |cell: &String| cell.parse::<f64>().is_ok();
    std::array::from_fn(|c| {
        let numbers = rows.iter().filter(|row| is_number(&row[c])).count();
        let others = rows.iter().filter(|row| !is_number(&row[c]) && !row[c].is_empty()).count();
        if numbers > others { "---:|" } else { "---|" }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(a: &str, b: &str) -> [String; 2] {
        [a.to_owned(), b.to_owned()]
    }

    #[test]
    fn columns_line_up() {
        assert_eq!(lines(&[row("a", "one"), row("long", "")]), "a     one\nlong\n");
    }

    #[test]
    fn bars_in_cells_do_not_split_them() {
        assert_eq!(markdown(["fact", "n"], &[row("|N| <= 1", "2")]), "| fact | n |\n|---|---:|\n| \\|N\\| <= 1 | 2 |\n");
    }
}
