//! Every figure, table and exercise of the papers has a row that says what shows it.
use super::table;

/// Papers, with what they number beside equations and how many of it they have. Counted by captions
/// and headings: "Figure 1" to "Figure 6", "Exercises" and "Programming Project" of the lecture;
/// "Figure 1" to "Figure 9" of Lyon's report, of which 7 is drawn as 7a to 7d; "Figure 1" to "Figure
/// 3" of Hast, Barrera and Bengtsson; "Figure 1" to "Figure 13" and "Table 1" of Reshetov, Soupikov
/// and Mark. No paper numbers algorithms: that of Reshetov et al. is their equation 8, Lyon's twelve
/// are the rows of figure 9.
const NUMBERED: [(&str, &str, u32); 7] = [
    ("lecture", "figure", 6),
    ("lecture", "exercise", 2),
    ("lecture", "project", 1),
    ("Lyon", "figure", 9),
    ("Hast", "figure", 3),
    ("Reshetov", "figure", 13),
    ("Reshetov", "table", 1),
];

/// Algorithms of the papers by the heading that the section of their equations begins with, each by
/// words of its row: those that §5 of the lecture sums up, and the schemes of Hast et al. by their
/// sections 1.2 to 4.3 and 5 to 6.
const ALGORITHMS: [(&str, &[&str]); 2] = [
    (
        "A.",
        &[
            "Gouraud: interpolated intensities",
            "Phong: interpolated and normalised normal",
            "fast Phong, diffuse",
            "fast Phong, specular",
            "slerp by two rotations",
            "slerp along edges",
            "slerp of N·L and N·V along the scan line",
        ],
    ),
    (
        "C.",
        &[
            "Duff",
            "hybrid",
            "reflection shading, diffuse",
            "Duff and Blinn's N·H",
            "Duff and the quotient of 17",
            "Lz − 2Nz p/q",
            "Lz − (rs)(ps)",
            "reflection shading and Blinn's N'·H",
            "reflection shading and the hybrid's highlight",
            "reflection shading and 34",
            "light at a place",
            "the same without a root",
            "eye at a place",
        ],
    ),
];

/// Rows of the table of figures: paper, what, and by what it is shown.
fn rows() -> Vec<[String; 3]> {
    let rows = table("| paper | what | shown by | with cores |").into_iter();
    rows.map(|cells| [0, 1, 2].map(|column| cells[column].clone())).collect()
}

/// The numbers behind `kind` in texts such as `figures 2 to 4 and 6, edges`.
pub fn numbers(kind: &str, what: &str) -> Vec<u32> {
    let mut words = what.split([' ', ',', ':']).filter(|word| !word.is_empty());
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

#[test]
fn every_algorithm_has_a_row() {
    let rows = super::rows();
    for (section, algorithms) in ALGORITHMS {
        let of_paper = rows.iter().filter(|row| row.section.starts_with(section));
        let there: Vec<&str> = of_paper.filter_map(|row| row.text("what")).collect();
        let is_absent = |name: &&&str| !there.iter().any(|what| what.starts_with(**name));
        let absent: Vec<&&str> = algorithms.iter().filter(is_absent).collect();
        assert!(absent.is_empty(), "{section} has no row for {absent:?}");
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
    assert_eq!(numbers("goal", "goal 7: the same (q~)"), [7]);
    assert_eq!(numbers("figure", "Mach bands"), [0; 0]);
}
