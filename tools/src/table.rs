//! Rows of text in aligned columns.
use std::borrow::Cow;
use std::fmt::Write;
use std::io;

use textwrap::{Options, WordSeparator, WordSplitter};

/// Blanks between columns.
const GAP: &str = "  ";
/// The gap if the longest words leave no room for more.
const NARROW_GAP: &str = " ";

/// Rows as text for standard output: on a terminal of its width, with cells wrapped at blanks if
/// necessary; elsewhere one line each.
pub fn shown<const N: usize>(rows: &[[String; N]]) -> String {
    match terminal_size::terminal_size_of(io::stdout()) {
        Some((columns, _)) => folded(rows, columns.0.into()),
        None => lines(rows),
    }
}

/// Text for standard output: on a terminal of its width, with lines wrapped at blanks if necessary.
pub fn paragraphs(text: &str) -> String {
    match terminal_size::terminal_size_of(io::stdout()) {
        Some((columns, _)) => filled(text, columns.0.into()),
        None => text.to_owned(),
    }
}

fn filled(text: &str, room: usize) -> String {
    let line = |line: &str| textwrap::fill(line, wrap_options(room));
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Rows as text of `room` columns, or as few more as the longest words need.
pub fn folded<const N: usize>(rows: &[[String; N]], room: usize) -> String {
    let beside = |gap: &str| room.saturating_sub(gap.len() * N.saturating_sub(1));
    let least: usize = longest_words(rows).iter().sum();
    let gap = if least > beside(GAP) { NARROW_GAP } else { GAP };
    let widths = narrowed(rows, beside(gap));
    let pieces: Vec<[String; N]> = rows.iter().flat_map(|row| pieces(row, widths)).collect();
    lines_apart(&pieces, gap)
}

fn longest_words<const N: usize>(rows: &[[String; N]]) -> [usize; N] {
    let longest =
        |c: usize| rows.iter().flat_map(|row| row[c].split(' ')).map(width).max().unwrap_or(0);
    std::array::from_fn(longest)
}

/// Widths of columns that take `room` together: the widest columns are narrowed, but not below
/// their longest word.
fn narrowed<const N: usize>(rows: &[[String; N]], room: usize) -> [usize; N] {
    let least = longest_words(rows);
    let mut widths = widths(rows);
    while widths.iter().sum::<usize>() > room {
        let widest = (0..N).filter(|&c| widths[c] > least[c]).max_by_key(|&c| (widths[c], c));
        let Some(widest) = widest else { break };
        widths[widest] -= 1;
    }
    widths
}

/// A row, split into several rows in which each cell fits the width of its column.
fn pieces<const N: usize>(row: &[String; N], widths: [usize; N]) -> Vec<[String; N]> {
    let cells: [Vec<String>; N] = std::array::from_fn(|c| {
        textwrap::wrap(&row[c], wrap_options(widths[c])).into_iter().map(Cow::into_owned).collect()
    });
    let height = cells.iter().map(Vec::len).max().unwrap_or(0);
    (0..height)
        .map(|line| std::array::from_fn(|c| cells[c].get(line).cloned().unwrap_or_default()))
        .collect()
}

/// Options that wrap lines only at blanks: a broken path can be neither copied nor searched for.
fn wrap_options(width: usize) -> Options<'static> {
    let options = Options::new(width).break_words(false).word_separator(WordSeparator::AsciiSpace);
    options.word_splitter(WordSplitter::NoHyphenation)
}

fn widths<const N: usize>(rows: &[[String; N]]) -> [usize; N] {
    std::array::from_fn(|c| rows.iter().map(|row| width(&row[c])).max().unwrap_or(0))
}

fn width(text: &str) -> usize {
    text.chars().count()
}

/// Rows as text, a line each, with columns aligned by blanks.
pub fn lines<const N: usize>(rows: &[[String; N]]) -> String {
    lines_apart(rows, GAP)
}

fn lines_apart<const N: usize>(rows: &[[String; N]], gap: &str) -> String {
    let widths = widths(rows);
    let line = |row: &[String; N]| {
        let cells: Vec<String> =
            row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        format!("{}\n", cells.join(gap).trim_end())
    };
    rows.iter().map(line).collect()
}

/// The table as Markdown.
pub fn markdown<const N: usize>(titles: [&str; N], rows: &[[String; N]]) -> String {
    let line = |cells: &[String; N]| {
        format!("| {} |\n", cells.each_ref().map(|cell| cell.replace('|', "\\|")).join(" | "))
    };
    let mut table = line(&titles.map(str::to_owned));
    // Writing to a String cannot fail.
    let _ = writeln!(table, "|{}", alignments(rows).concat());
    table.extend(rows.iter().map(line));
    table
}

/// The alignment of each column: columns of numbers are aligned at the right.
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
        assert_eq!(
            markdown(["fact", "n"], &[row("|N| <= 1", "2")]),
            "| fact | n |\n|---|---:|\n| \\|N\\| <= 1 | 2 |\n"
        );
    }

    #[test]
    fn wide_tables_are_folded_at_blanks() {
        let rows = [
            row("need", "what is left out or narrowed"),
            row("lights-and-eye", "3 of 4 pipelines, widths/../of-all"),
        ];
        let expected = "\
need            what is left out
                or narrowed
lights-and-eye  3 of 4
                pipelines,
                widths/../of-all
";
        assert_eq!(folded(&rows, 32), expected);
        let narrow = expected.replace("lights-and-eye  ", "lights-and-eye ");
        let narrow = narrow.replace("\n                ", "\n               ");
        let narrow = narrow.replace("need            ", "need           ");
        for room in [0, 31] {
            assert_eq!(folded(&rows, room), narrow);
        }
        assert_eq!(folded(&rows, 1000), lines(&rows));
    }

    #[test]
    fn text_is_broken_at_blanks_and_paths_are_whole() {
        assert_eq!(
            filled("known from a/long-path/to-it\n\nthe end\n", 12),
            "known from\na/long-path/to-it\n\nthe end\n"
        );
    }

    #[test]
    fn no_line_is_longer_than_the_room_and_no_word_is_broken() {
        let rows =
            [row("one two three", "four five six seven eight"), row("  nine", "ten"), row("", "")];
        for room in 11..45 {
            let text = folded(&rows, room);
            assert!(text.lines().all(|line| line.len() <= room), "{room}:\n{text}");
            let words = |text: &str| {
                let mut words: Vec<_> = text.split_whitespace().map(str::to_owned).collect();
                words.sort();
                words
            };
            assert_eq!(words(&text), words(&lines(&rows)));
        }
    }
}
