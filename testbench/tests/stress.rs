//! The stress catalogue, small: every row on every method.
use specula_scene::Method;
use specula_testbench::stress::{self, CATALOGUE, Cell, Extent, RAW, sweep};

fn complaints(cells: &[Cell]) -> Vec<String> {
    let complaint = |cell: &Cell| {
        let fault = cell.fault.as_ref()?;
        let core = cell.faulty.as_deref().unwrap_or("");
        let text = cell.reproducer.as_deref().unwrap_or("");
        Some(format!("row {} {core}: {}, span {} pixel {}\n{text}", cell.row, fault.what, fault.span, fault.pixel))
    };
    cells.iter().filter_map(complaint).collect()
}

#[test]
fn every_row_holds_on_every_method() {
    let cells = sweep(1, &Method::ALL, Extent::SMALL, &|_, _| ());
    let complaints = complaints(&cells);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    for method in Method::ALL {
        let tried = |row: &str| cells.iter().find(|cell| cell.row == row && cell.method == Some(method.name()));
        let shaded = |row: &str| tried(row).is_some_and(|cell| cell.pixels > 0);
        assert!(shaded("1") && shaded("38") && shaded("any") && shaded(RAW), "{}", method.name());
    }
    assert_page_is_up_to_date(&cells);
}

/// docs/extremes.md says what happens.
fn assert_page_is_up_to_date(cells: &[Cell]) {
    let [page, of_now] =
        [concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/extremes.md"), concat!(env!("CARGO_TARGET_TMPDIR"), "/extremes.md")];
    let text = stress::page(cells);
    std::fs::write(of_now, &text).unwrap();
    let written = std::fs::read_to_string(page).unwrap_or_default();
    let first = written.lines().zip(text.lines()).find(|(written, now)| written != now);
    assert!(written == text, "docs/extremes.md is not what happens, which is in {of_now}; first {first:#?}");
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
