//! The README and docs/ against the repository: links lead somewhere, and the table of methods
//! promises nothing.
use std::path::{Path, PathBuf};

use specula_spec::Method;

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
                .option_domains()
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

/// The ids of formulas (`methods B8`), measurements (`numerics N3b`) and extreme cases
/// (`extremes row 12`) that a text cites.
fn citations(text: &str) -> Vec<(Page, String)> {
    const STARTS: [(&str, Page); 3] = [
        ("methods ", Page::Methods),
        ("numerics ", Page::Numerics),
        ("extremes row", Page::Extremes),
    ];
    // A citation may be broken over lines of a comment.
    let words = text.split_whitespace().filter(|word| !matches!(*word, "//" | "///" | "//!"));
    let text = words.collect::<Vec<_>>().join(" ");
    let cited = STARTS.into_iter().flat_map(|(start, page)| {
        let ends = text.match_indices(start).map(move |(at, _)| at + start.len());
        ends.map(move |end| (page, end)).collect::<Vec<_>>()
    });
    cited
        .flat_map(|(page, end)| page.ids(&text[end..]).into_iter().map(move |id| (page, id)))
        .collect()
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Page {
    Methods,
    Numerics,
    Extremes,
}

impl Page {
    fn file(self) -> &'static str {
        match self {
            Page::Methods => "docs/methods.md",
            Page::Numerics => "docs/numerics.md",
            Page::Extremes => "docs/extremes.md",
        }
    }

    /// The ids that a list begins with: `B8, B9 and C1 to C3;` has five or, of a range, its ends.
    fn ids(self, behind: &str) -> Vec<String> {
        let mut ids = Vec::new();
        for word in behind.trim_start_matches('s').split(' ').filter(|word| !word.is_empty()) {
            let id = word.trim_matches(|c: char| !c.is_alphanumeric());
            let ends: Vec<&str> = id.split('–').collect();
            match ends.iter().all(|end| self.is_id(end)) {
                true => ids.extend(ends.iter().map(|&end| end.to_owned())),
                false if ["and", "to", "or"].contains(&id) => continue,
                false => break,
            }
            let goes_on = word.ends_with(',') || word.ends_with(|c: char| c.is_alphanumeric());
            if !goes_on {
                break;
            }
        }
        ids
    }

    fn is_id(self, word: &str) -> bool {
        let number =
            |digits: &str| !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit());
        match self {
            Page::Methods => {
                word.len() > 1 && word.starts_with(['A', 'B', 'C', 'D']) && number(&word[1..])
            }
            Page::Numerics => word.strip_prefix('N').is_some_and(|rest| {
                number(rest.trim_end_matches(|c: char| c.is_ascii_lowercase()))
            }),
            Page::Extremes => number(word),
        }
    }

    /// The ids that the page defines.
    fn defined(self) -> Vec<String> {
        let text = std::fs::read_to_string(Path::new(ROOT).join(self.file())).unwrap();
        let of_row = |line: &str| line.strip_prefix("| ")?.split(' ').next().map(str::to_owned);
        let of_heading = |line: &str| {
            let words = line.strip_prefix("## ")?;
            words.split(['.', ' ']).next().map(str::to_owned)
        };
        let defined: Vec<String> = match self {
            Page::Methods | Page::Extremes => text.lines().filter_map(of_row).collect(),
            Page::Numerics => text.lines().filter_map(of_heading).collect(),
        };
        defined.into_iter().filter(|id| self.is_id(id)).collect()
    }
}

/// Source files and pages that may cite.
fn citing() -> Vec<PathBuf> {
    let crates =
        ["scene", "golden", "hdl", "sim", "testbench", "experiments", "drawing", "wave", "tools"];
    let mut files = pages();
    let mut folders: Vec<PathBuf> =
        crates.iter().map(|folder| Path::new(ROOT).join(folder)).collect();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if entry.extension().is_some_and(|extension| extension == "rs") {
                files.push(entry);
            }
        }
    }
    files
}

/// Pages that are in no repository are no authority.
#[test]
fn nothing_cites_a_page_that_is_not_here() {
    let absent =
        ["METHODS", "NUMERICS", "EXTREMES"].map(|page| [format!("{page}.md"), format!("{page} ")]);
    let mut citing_them = Vec::new();
    for file in citing() {
        let text = std::fs::read_to_string(&file).unwrap();
        let lines = text.lines().zip(1..).filter(|(line, _)| {
            let comment = line.find("//").map_or("", |at| &line[at..]);
            let prose = if file.extension().is_some_and(|e| e == "rs") { comment } else { line };
            absent.as_flattened().iter().any(|page| prose.contains(page))
        });
        citing_them
            .extend(lines.map(|(line, number)| format!("{}:{number}: {line}", file.display())));
    }
    assert!(citing_them.is_empty(), "{citing_them:#?}");
}

#[test]
fn every_id_that_is_cited_is_on_its_page() {
    let defined =
        [Page::Methods, Page::Numerics, Page::Extremes].map(|page| (page, page.defined()));
    assert!(defined.iter().all(|(_, ids)| ids.len() > 4), "{defined:?}");
    let (mut found, mut dangling) = (0, Vec::new());
    for file in citing() {
        let text = std::fs::read_to_string(&file).unwrap();
        for (page, id) in citations(&text) {
            found += 1;
            let ids = defined.iter().find(|(other, _)| *other == page).map(|(_, ids)| ids);
            if !ids.is_some_and(|ids| ids.contains(&id)) {
                dangling.push(format!("{}: {} {id}", file.display(), page.file()));
            }
        }
    }
    assert!(found > 300, "{found} citations were found");
    assert!(dangling.is_empty(), "{dangling:#?}");
}
