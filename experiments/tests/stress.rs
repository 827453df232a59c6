//! The stress catalogue, small: every row on every method.
use specula_experiments::stress::{self, CATALOGUE, Cell, RAW, RowVerdict, TrialExtent, sweep};
use specula_spec::Method;

fn complaints(cells: &[Cell]) -> Vec<String> {
    let complaint = |cell: &Cell| {
        let fault = cell.fault()?;
        let text = cell.reproducer.as_deref().unwrap_or("");
        Some(format!("row {} {}: {fault:?}\n{text}", cell.row, fault.core))
    };
    cells.iter().filter_map(complaint).collect()
}

#[test]
fn no_method_is_at_fault_in_any_row() {
    let cells = sweep(1, &Method::ALL, TrialExtent::SMALL, &|_, _| ());
    let complaints = complaints(&cells);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    for method in Method::ALL {
        let tried = |row: &str| {
            cells.iter().find(|cell| cell.row == row && cell.method == Some(method.name()))
        };
        let shaded = |row: &str| tried(row).is_some_and(|cell| cell.pixels > 0);
        assert!(shaded("1") && shaded("38") && shaded("any") && shaded(RAW), "{}", method.name());
    }
    assert_verdicts_say_what_came(&cells);
    assert_page_is_up_to_date(&cells);
}

/// A method that is more than 1 LSB off does not hold; one that holds is not; a light a quarter of
/// a unit from a wall is at a limit.
fn assert_verdicts_say_what_came(cells: &[Cell]) {
    for cell in cells {
        let Some(worst) = &cell.worst else { continue };
        let wanted = if worst.total > 1.0 { RowVerdict::Limit } else { RowVerdict::Holds };
        assert_eq!(cell.verdict(), Some(wanted), "row {} {:?}", cell.row, cell.method);
    }
    let of = |row: &str, method: &str| {
        cells.iter().find(|cell| cell.row == row && cell.method == Some(method)).unwrap()
    };
    let verdicts = |row| Method::ALL.map(|method| of(row, method.name()).verdict());
    // extremes rows 6, 10 and 53 leave no method anything to be off by; L = -V (25) is what Lyon's
    // H x N cannot see.
    for row in ["6", "10", "53"] {
        assert_eq!(verdicts(row), [Some(RowVerdict::Holds); 9], "row {row}");
    }
    assert_eq!(of("25", "lyon").verdict(), Some(RowVerdict::Limit));
    assert_eq!(of("25", "phong").verdict(), Some(RowVerdict::Holds));
}

/// docs/extremes.md says what happens.
fn assert_page_is_up_to_date(cells: &[Cell]) {
    let [page, of_now] = [
        concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/extremes.md"),
        concat!(env!("CARGO_TARGET_TMPDIR"), "/extremes.md"),
    ];
    let text = stress::page(cells);
    std::fs::write(of_now, &text).unwrap();
    let written = std::fs::read_to_string(page).unwrap_or_default();
    let first = written.lines().zip(text.lines()).find(|(written, now)| written != now);
    assert!(
        written == text,
        "docs/extremes.md is not what happens, which is in {of_now}; first {first:#?}"
    );
}

#[test]
fn rows_have_names_of_their_own() {
    let mut ids: Vec<&str> = CATALOGUE.iter().map(|row| row.id).chain([RAW]).collect();
    for number in 1..=54 {
        assert!(ids.contains(&number.to_string().as_str()), "row {number}");
    }
    let all = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), all);
}
