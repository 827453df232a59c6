//! Every figure, table and exercise of the papers has a row that says what shows it.
use super::{read, split};

/// Papers, with what they number and how many of it they have.
const NUMBERED: [(&str, &str, u32); 6] = [
    ("lecture", "figure", 6),
    ("lecture", "exercise", 2),
    ("Lyon", "figure", 9),
    ("Hast", "figure", 3),
    ("Reshetov", "figure", 13),
    ("Reshetov", "table", 1),
];

/// Rows of the table of figures: paper, what, and by what it is shown.
fn rows() -> Vec<[String; 3]> {
    let text = read("docs/equations.md");
    let table = text.split("| paper | what | shown by |").nth(1).unwrap_or_default();
    let lines = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    lines
        .map(|line| {
            let cells = split(line);
            [0, 1, 2].map(|column| cells[column].clone())
        })
        .collect()
}

/// The numbers behind `kind` in texts such as `figures 2 to 4 and 6, edges`.
fn numbers(kind: &str, what: &str) -> Vec<u32> {
    let mut words = what.split([' ', ',']).filter(|word| !word.is_empty());
    let named = [kind.to_owned(), format!("{kind}s")];
    if !words.by_ref().any(|word| named.iter().any(|name| name == word)) {
        return vec![];
    }
    let (mut numbers, mut is_range): (Vec<u32>, bool) = (vec![], false);
    for word in words {
        match (word, word.parse::<u32>()) {
            (_, Ok(number)) => {
                let first = numbers.last().filter(|_| is_range).map_or(number, |last| last + 1);
                numbers.extend(first..=number);
                is_range = false;
            }
            ("to", _) => is_range = true,
            ("and", _) => (),
            _ => break,
        }
    }
    numbers
}

#[test]
fn every_figure_has_a_row() {
    let rows = rows();
    for (paper, kind, last) in NUMBERED {
        let there: Vec<u32> = rows
            .iter()
            .filter(|row| row[0] == paper)
            .flat_map(|row| numbers(kind, &row[1]))
            .collect();
        let absent: Vec<u32> = (1..=last).filter(|number| !there.contains(number)).collect();
        assert!(absent.is_empty(), "{paper}: no row for {kind} {absent:?}");
        let beyond: Vec<&u32> = there.iter().filter(|number| **number > last).collect();
        assert!(beyond.is_empty(), "{paper} has no {kind} {beyond:?}");
    }
}

/// A row without a command or a reason says nothing.
#[test]
fn every_row_says_what_shows_it() {
    let rows = rows();
    let silent: Vec<&[String; 3]> = rows.iter().filter(|row| row[2].len() < 10).collect();
    assert!(rows.len() > 25 && silent.is_empty(), "{} rows, {silent:#?}", rows.len());
}

#[test]
fn numbers_are_read_as_written() {
    assert_eq!(numbers("figure", "figures 2 to 4 and 6, edges and scan lines"), [2, 3, 4, 6]);
    assert_eq!(numbers("figure", "figures 1, 2, 5, 6, block diagrams"), [1, 2, 5, 6]);
    assert_eq!(numbers("exercise", "exercise 1, sin 24.3 degrees"), [1]);
    assert_eq!(numbers("figure", "Mach bands"), [0; 0]);
}
