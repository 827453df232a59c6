//! What a row names is used: what is public by another file than its own, what is not by its own.
use std::path::{Path, PathBuf};

use super::{FOLDERS, ROOT, is_file, is_of_a_name, quoted, rows};

/// A source file, its comments left out.
struct Source {
    path: PathBuf,
    text: String,
}

/// Sources that are no tests.
fn sources() -> Vec<Source> {
    let crates =
        ["scene", "core-spec", "golden", "hdl", "testbench", "flow", "experiments", "tools"];
    let mut folders: Vec<PathBuf> =
        crates.iter().map(|folder| Path::new(ROOT).join(folder).join("src")).collect();
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                sources.push(Source { text: without_comments(&text), path });
            }
        }
    }
    sources
}

/// The text up to its tests, without comments.
fn without_comments(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    code.lines().map(|line| line.split("//").next().unwrap_or_default().to_owned() + "\n").collect()
}

/// How often a text has a name as a whole word.
fn count(text: &str, name: &str) -> usize {
    let whole = |at: usize| {
        let (before, behind) = (&text[..at], &text[at + name.len()..]);
        !before.ends_with(is_of_a_name) && !behind.starts_with(is_of_a_name)
    };
    text.match_indices(name).filter(|(at, _)| whole(*at)).count()
}

/// Whether a name that a file defines is used: beside its definition in that file, or elsewhere, not
/// counting `use` and the lists by which modules hand it on.
fn is_used(sources: &[Source], own: &Path, name: &str) -> bool {
    let is_own = |source: &&Source| source.path == own;
    let in_own: usize = sources.iter().filter(is_own).map(|source| count(&source.text, name)).sum();
    in_own > 1
        || sources.iter().filter(|source| source.path != own).any(|source| {
            let calls = source.text.split(';').filter(|item| !is_list(item));
            calls.map(|item| count(item, name)).sum::<usize>() > 0
        })
}

fn is_list(item: &str) -> bool {
    let item = item.trim_start();
    ["use ", "pub use ", "pub(crate) use ", "pub(super) use ", "mod ", "pub mod "]
        .iter()
        .any(|start| item.starts_with(start))
}

#[test]
fn everything_that_is_named_is_used() {
    let sources = sources();
    let (mut named, mut unused) = (0, Vec::new());
    for cell in rows().iter().flat_map(|row| &row.cells) {
        let folder = FOLDERS.iter().find(|(title, _)| cell.is(title)).map(|(_, folder)| *folder);
        let Some(folder) = folder else { continue };
        let mut file = None;
        for name in quoted(&cell.title).into_iter().chain(quoted(&cell.text)) {
            match (is_file(name), &file) {
                (true, _) => {
                    let from_the_root = Path::new(ROOT).join(name);
                    let of_column = Path::new(ROOT).join(folder).join(name);
                    file = Some(if from_the_root.is_file() { from_the_root } else { of_column });
                }
                (false, Some(own)) => {
                    named += 1;
                    if !is_used(&sources, own, name) {
                        unused.push(format!("{}: {name}", own.display()));
                    }
                }
                (false, None) => (),
            }
        }
    }
    assert!(named > 200 && unused.is_empty(), "{named} names, of which nothing uses {unused:#?}");
}

/// A name in a comment, in a longer name or in an import counts for nothing.
#[test]
fn uses_are_told_from_names() {
    let source =
        |path: &str, text: &str| Source { path: PathBuf::from(path), text: without_comments(text) };
    let own = source("a.rs", "/// wrap\npub fn wrap() {}\npub fn wrapped() {}\n");
    let other = |text: &str| [source("b.rs", text), source("a.rs", "pub fn wrap() {}")];
    assert_eq!(count(&own.text, "wrap"), 1);
    assert!(!is_used(
        &other("use a::wrap;\nfn f() { wrapped(1) } // wrap\n"),
        Path::new("a.rs"),
        "wrap"
    ));
    assert!(is_used(&other("use a::wrap;\nfn f() { wrap(1) }\n"), Path::new("a.rs"), "wrap"));
}
