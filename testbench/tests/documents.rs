//! The README and docs/ against the repository: links lead somewhere, and the table of methods
//! promises nothing.
use std::path::{Path, PathBuf};

use specula_scene::Method;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn readme() -> String {
    std::fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap()
}

/// README.md and every page under docs/.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![Path::new(ROOT).join("README.md")];
    let mut folders = vec![Path::new(ROOT).join("docs")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            match entry.extension() {
                None if entry.is_dir() => folders.push(entry),
                Some(extension) if extension == "md" => pages.push(entry),
                _ => (),
            }
        }
    }
    pages
}

/// Where a page's links to other files lead, without what stands behind `#`.
fn links(text: &str) -> impl Iterator<Item = &str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let files = targets.filter(|target| !target.contains("://") && !target.starts_with('#'));
    files.filter_map(|target| target.split('#').next())
}

#[test]
fn every_link_leads_to_a_file() {
    let pages = pages();
    let mut dead = Vec::new();
    for page in &pages {
        let (text, folder) = (std::fs::read_to_string(page).unwrap(), page.parent().unwrap());
        dead.extend(
            links(&text)
                .filter(|link| !folder.join(link).exists())
                .map(|link| format!("{}: {link}", page.display())),
        );
    }
    assert!(pages.len() > 20 && dead.is_empty(), "{} pages, dead links {dead:#?}", pages.len());
}

/// What a text has between backticks.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// Each method has a row, each row's core is a file, and what a row has in backticks is a value of
/// one of the method's options.
#[test]
fn the_readme_has_the_methods_that_there_are() {
    let text = readme();
    let table = text.split("| `--method` |").nth(1).unwrap();
    let rows: Vec<Vec<&str>> =
        table.lines().skip(2).take_while(|line| line.starts_with('|')).map(cells).collect();
    let mut names: Vec<&str> = rows.iter().map(|row| row[0].trim_matches('`')).collect();
    let mut all = Method::ALL.map(Method::name);
    names.sort_unstable();
    all.sort_unstable();
    assert_eq!(names, all);
    for row in rows {
        let method = Method::from_name(row[0].trim_matches('`')).unwrap();
        for value in row[1..4].iter().flat_map(|cell| quoted(cell)) {
            let known = method
                .choices()
                .iter()
                .any(|choice| choice.values.contains(&format!("\"{value}\"").as_str()));
            assert!(known, "{} has no option {value}", method.name());
        }
        assert_eq!(links(row[4]).count(), 1, "{}", method.name());
    }
}

fn cells(line: &str) -> Vec<&str> {
    line.trim_matches('|').split(" | ").map(str::trim).collect()
}
