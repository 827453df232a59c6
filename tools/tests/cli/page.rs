//! `report.html`, of `run` and of `compare`.
use std::fs;

use crate::program::Place;

/// Elements without an end.
const VOID: [&str; 5] = ["meta", "img", "input", "br", "hr"];
/// Elements whose content is no markup.
const RAW: [&str; 2] = ["style", "script"];

/// Checks that every element ends, in the order in which they begin.
fn assert_well_formed(page: &str) {
    assert!(page.starts_with("<!DOCTYPE html>\n"), "{}", &page[..80]);
    let (mut open, mut rest): (Vec<&str>, &str) = (vec![], &page["<!DOCTYPE html>".len()..]);
    while let Some((_, from)) = rest.split_once('<') {
        let (tag, behind) = from.split_once('>').expect("a tag has an end");
        rest = behind;
        let name = tag
            .trim_start_matches('/')
            .split(|c: char| c.is_whitespace() || c == '/')
            .next()
            .unwrap_or_default();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "before {}", &behind[..behind.len().min(60)]);
        } else if !tag.ends_with('/') && !VOID.contains(&name) {
            open.push(name);
        }
        if RAW.contains(&name) && !tag.starts_with('/') {
            rest = &rest[rest.find(&format!("</{name}>")).expect("it ends")..];
        }
    }
    assert_eq!(open, [""; 0]);
}

/// Checks that a page needs nothing beside itself.
fn assert_stands_alone(page: &str) {
    for reference in ["src=\"", "href=\"", "url(", "@import"] {
        for (place, _) in page.match_indices(reference) {
            let to = &page[place + reference.len()..];
            assert!(
                to.starts_with("data:image/png;base64,"),
                "{reference}{}",
                &to[..to.len().min(60)]
            );
        }
    }
}

fn page(place: &Place, folder: &str) -> String {
    fs::read_to_string(place.path(folder).join("report.html")).expect("there is a page")
}

#[test]
fn the_page_of_a_run_has_everything_in_it() {
    let place = Place::new();
    place.succeeds(&["run", "teapot", "--size", "64x48", "-o", "r"]);
    let page = page(&place, "r");
    assert_well_formed(&page);
    assert_stands_alone(&page);
    // Simulated, expected, exact and error, and the heat map with its scale.
    assert_eq!(page.matches("<img src=\"data:").count(), 5);
    for words in ["<svg ", "What the scene does not need", "PSNR", "directions of lights"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn the_page_of_a_comparison_has_its_plots_in_it() {
    let place = Place::new();
    let words = [
        "compare",
        "icosahedron",
        "--size",
        "48x36",
        "--methods",
        "gouraud,hybrid",
        "--formats",
        "default",
        "-o",
        "c",
    ];
    place.succeeds(&words);
    let page = page(&place, "c");
    assert_well_formed(&page);
    assert_stands_alone(&page);
    assert_eq!(page.matches("<svg ").count(), 3);
    assert!(
        page.contains("hybrid default") && page.contains("Errors against the true surface"),
        "{page}"
    );
}

/// Names of files are the user's.
#[cfg(unix)]
#[test]
fn names_are_no_markup() {
    let place = Place::new();
    let name = "<b onclick='x'>&amp;`*.obj";
    place.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    place.succeeds(&["run", name, "--method", "lyon", "--size", "32x24", "-o", "r"]);
    let page = page(&place, "r");
    assert_well_formed(&page);
    assert_stands_alone(&page);
    assert!(!page.contains("<b on") && page.contains("&lt;b on"), "{}", &page[..2000]);
}
