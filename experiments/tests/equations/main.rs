//! docs/equations.md against the source: every equation of docs/methods.md, every figure and every
//! claim of the papers has a row, and what a row names is there, and is called.
mod calls;
mod claims;
mod figures;
mod uses;

use std::path::Path;

use specula_spec::Method;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Folders that a column's files are in, by the column's title, where they are not named from the
/// repository's root.
const FOLDERS: [(&str, &str); 4] = [
    ("exact", "golden/src/exact"),
    ("loop", "golden/src/loops"),
    ("fixed", "golden/src/fixed"),
    ("hdl", "hdl/src"),
];

/// A cell of a table, with its column's title.
struct Cell {
    title: String,
    text: String,
}

impl Cell {
    fn is(&self, title: &str) -> bool {
        self.title.split(' ').next() == Some(title)
    }
}

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(ROOT).join(path))
        .unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The cells of a line of a table.
fn split(line: &str) -> Vec<String> {
    let inner = line.trim().trim_start_matches('|').trim_end_matches('|').replace("\\|", "\u{1}");
    inner.split('|').map(|cell| cell.trim().replace('\u{1}', "|")).collect()
}

/// The rows of the table with these titles.
fn table(titles: &str) -> Vec<Vec<String>> {
    let text = read("docs/equations.md");
    let table = text.split(titles).nth(1).unwrap_or_else(|| panic!("there is no table {titles}"));
    table.lines().skip(2).take_while(|line| line.starts_with('|')).map(split).collect()
}

/// A row of a table that says where equations are.
struct Row {
    /// The heading above it.
    section: String,
    cells: Vec<Cell>,
}

impl Row {
    fn text(&self, title: &str) -> Option<&str> {
        self.cells.iter().find(|cell| cell.is(title)).map(|cell| cell.text.as_str())
    }
}

fn rows() -> Vec<Row> {
    let (mut section, mut titles, mut rows) = (String::new(), Vec::new(), Vec::new());
    for line in read("docs/equations.md").lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            section = heading.to_owned();
        }
        if !line.starts_with('|') {
            titles.clear();
        } else if titles.is_empty() {
            titles = split(line);
        } else if !line.starts_with("|---") && titles.iter().any(|title| title == "hdl") {
            let texts = split(line);
            assert_eq!(texts.len(), titles.len(), "{line}");
            let cells = titles
                .iter()
                .cloned()
                .zip(texts)
                .map(|(title, text)| Cell { title, text })
                .collect();
            rows.push(Row { section: section.clone(), cells });
        }
    }
    rows
}

/// The numbers that a cell such as `17, 29` or `3.2–3.6` has, those between two included.
fn numbers(cell: &str) -> Vec<String> {
    let parse = |number: &str| -> Option<(String, u32)> {
        let (chapter, last) =
            number.rsplit_once('.').map_or(("", number), |(chapter, last)| (chapter, last));
        Some((chapter.to_owned(), last.parse().ok()?))
    };
    let written = |(chapter, last): (&str, u32)| {
        if chapter.is_empty() { last.to_string() } else { format!("{chapter}.{last}") }
    };
    let all = |part: &str| {
        let (first, last) = part.split_once('–').unwrap_or((part, part));
        let (Some((chapter, first)), Some((_, last))) = (parse(first), parse(last)) else {
            return Vec::new();
        };
        (first..=last).map(|last| written((&chapter, last))).collect()
    };
    cell.split(", ").flat_map(all).collect()
}

/// What a text has between backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

fn is_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "rs")
}

/// Whether a source text defines an item of this name, a variant of an enum among them.
fn defines(source: &str, item: &str) -> bool {
    let begins = |line: &str, before: &str| {
        let rest = line.strip_prefix("pub ").unwrap_or(line);
        let rest = rest.strip_prefix("const ").unwrap_or(rest);
        rest.strip_prefix(before)
            .and_then(|rest| rest.strip_prefix(item))
            .is_some_and(|rest| !rest.starts_with(is_of_a_name))
    };
    let visible = |line: &str| {
        line.trim().replacen("pub(super) ", "pub ", 1).replacen("pub(crate) ", "pub ", 1)
    };
    source.lines().map(visible).any(|line| {
        ["fn ", "struct ", "enum ", "trait ", "type "].iter().any(|kind| begins(&line, kind))
            || line == format!("{item},")
    })
}

fn is_of_a_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// What a cell names and is not there.
fn absent(cell: &Cell) -> Vec<String> {
    let folder = FOLDERS.iter().find(|(title, _)| cell.is(title)).map(|(_, folder)| *folder);
    let Some(folder) = folder else { return Vec::new() };
    let mut file = None;
    let mut absent = Vec::new();
    // A column with one file for all has it in its title.
    for name in quoted(&cell.title).into_iter().chain(quoted(&cell.text)) {
        if is_file(name) {
            let from_the_root = Path::new(ROOT).join(name).is_file();
            let path = if from_the_root { name.to_owned() } else { format!("{folder}/{name}") };
            match std::fs::read_to_string(Path::new(ROOT).join(&path)) {
                Ok(source) => file = Some((path, source)),
                Err(error) => absent.push(format!("{path}: {error}")),
            }
        } else {
            match &file {
                Some((path, source)) if !defines(source, name) => {
                    absent.push(format!("{path} defines no `{name}`"))
                }
                Some(_) => (),
                None => absent.push(format!("`{name}` is in no file: {}", cell.text)),
            }
        }
    }
    absent
}

#[test]
fn every_file_and_item_is_there() {
    let rows = rows();
    let absent: Vec<String> = rows.iter().flat_map(|row| &row.cells).flat_map(absent).collect();
    assert!(rows.len() > 60 && absent.is_empty(), "{} rows\n{}", rows.len(), absent.join("\n"));
}

/// A formula that nothing runs says nothing about what is run: those in f64 are called by a method,
/// a loop, a claim or a command.
#[test]
fn every_function_in_f64_is_called() {
    let calls = calls::Calls::read(Path::new(ROOT));
    let uncalled: Vec<_> = calls.functions.difference(&calls.reached).collect();
    assert!(
        calls.functions.len() > 60 && uncalled.is_empty(),
        "{} functions, of which tests alone call {uncalled:?}",
        calls.functions.len()
    );
    let rows = rows();
    let exact = rows.iter().filter_map(|row| row.cells.iter().find(|cell| cell.is("exact")));
    let named =
        exact.flat_map(functions_of).filter(|function| calls.functions.contains(function)).count();
    assert!(named > 40, "docs/equations.md names {named} of them");
}

/// The functions that a cell of the column of f64 names.
fn functions_of(cell: &Cell) -> Vec<(String, String)> {
    let mut module = String::new();
    let mut functions = Vec::new();
    for name in quoted(&cell.title).into_iter().chain(quoted(&cell.text)) {
        match Path::new(name).file_stem().filter(|_| is_file(name)) {
            Some(stem) => module = stem.to_string_lossy().into_owned(),
            None => functions.push((module.clone(), name.to_owned())),
        }
    }
    functions
}

#[test]
fn every_equation_of_methods_has_a_row() {
    let rows = rows();
    let ids: Vec<&str> = rows.iter().map(|row| row.cells[0].text.as_str()).collect();
    for (paper, last) in [("A", 12), ("B", 13), ("C", 18)] {
        let wanted = (1..=last).map(|number| format!("{paper}{number}"));
        let absent: Vec<String> = wanted.filter(|id| !ids.contains(&id.as_str())).collect();
        assert!(absent.is_empty(), "no row for {absent:?}");
    }
    for formulation in 1..=12 {
        assert!(
            ids.contains(&formulation.to_string().as_str()),
            "no row for formulation {formulation}"
        );
    }
}

/// Lyon numbers none.
#[test]
fn every_numbered_equation_has_a_row() {
    let rows = rows();
    let lecture = [(1, 1), (2, 1), (3, 6), (4, 12)];
    let lecture = lecture
        .into_iter()
        .flat_map(|(chapter, last)| (1..=last).map(move |n| format!("{chapter}.{n}")));
    let to = |last: u32| (1..=last).map(|n| n.to_string());
    for (paper, wanted) in
        [("A.", lecture.collect::<Vec<_>>()), ("C.", to(38).collect()), ("D.", to(9).collect())]
    {
        let of_paper = rows.iter().filter(|row| row.section.starts_with(paper));
        let there: Vec<String> =
            of_paper.filter_map(|row| row.text("equation")).flat_map(numbers).collect();
        let absent: Vec<&String> = wanted.iter().filter(|number| !there.contains(number)).collect();
        assert!(absent.is_empty(), "{paper} has no row for {absent:?}");
    }
}

/// Options that are said to run an equation are options of the method, with values it takes.
#[test]
fn every_row_can_be_run_as_it_says() {
    let mut run = 0;
    for cell in rows().iter().flat_map(|row| &row.cells).filter(|cell| cell.is("run")) {
        let methods: Vec<Method> = quoted(&cell.text)
            .into_iter()
            .filter_map(|name| Method::from_name(name).ok())
            .collect();
        for (key, value) in
            quoted(&cell.text).into_iter().filter_map(|option| option.split_once(" = "))
        {
            let known = |method: &Method| {
                let mut all = method.option_domains().iter().chain(method.output_domains());
                all.any(|choice| choice.key == key && choice.values.contains(&value))
            };
            let of_a_light = ["kind", "viewer"].contains(&key);
            let inherited = methods.is_empty() && Method::ALL.iter().any(known);
            assert!(
                of_a_light || inherited || methods.iter().any(known),
                "{key} = {value}: {}",
                cell.text
            );
            run += 1;
        }
    }
    assert!(run > 30, "{run} options");
}

#[test]
fn the_readme_leads_here() {
    let readme = read("README.md");
    assert!(readme.contains("](docs/equations.md)"));
}
