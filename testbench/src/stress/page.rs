//! The catalogue as a page: what each method does in each row.
use specula_scene::Method;

use super::catalogue::CATALOGUE;
use super::raw;
use super::sweep::Cell;

/// Errors of a method in exact arithmetic, in LSBs: what it is called that is off by no more.
const CLASSES: [(f64, &str); 3] = [(1.0, "exact"), (10.0, "near"), (f64::INFINITY, "far")];

const HEAD: &str = "\
# What each method does in each row of the catalogue of extremes

Rows are numbered as in the project's list of stiff and extreme cases; those with a letter and those with names were added. Everywhere it is wanted that core and bit-true \
model give the same code in the clock in which it must come, that stated facts hold, that nothing is other than a number from 0 to 255, and that no error of \
quantisation is beyond its proven bound; `wanted` is what a row wants besides. `testbench/src/stress/catalogue` has the rows as scenes and what is wanted as a test, \
`specula stress` tries them with every option, and `testbench/tests/stress.rs` compares this page with what happens, with default options and those of the row.

A method is *exact* in a row if in exact arithmetic it stays within 1 LSB of exact shading there, in the core with the largest error; *near* within 10, and *far* beyond. Far is no \
fault: it is the method's own answer, such as Gouraud's where a highlight falls between vertices. *Refused* are scenes that a method has no core for, which the user is told \
with the reason. What is done instead where a formula has no value stands in the pages about [arithmetic](arithmetic.md).

";

/// The page, of a sweep of every method.
pub fn page(cells: &[Cell]) -> String {
    let rows = CATALOGUE.iter().map(|row| (row.id, row.input, row.wanted)).chain([(raw::ID, raw::INPUT, raw::WANTED)]);
    let lines = rows.map(|(id, input, wanted)| line(&[id, input, wanted, &did(id, cells)]));
    let titles = line(&["row", "input", "wanted", "what methods do"]);
    [HEAD.to_owned(), titles, "|---|---|---|---|\n".to_owned()].into_iter().chain(lines).collect()
}

fn line(texts: &[&str]) -> String {
    let texts: Vec<String> = texts.iter().map(|text| text.replace('|', "\\|")).collect();
    format!("| {} |\n", texts.join(" | "))
}

/// Methods by what they do in a row.
fn did(id: &str, cells: &[Cell]) -> String {
    let class = |method: &Method| cells.iter().find(|cell| cell.row == id && cell.method == Some(method.name())).map(class);
    let group = |name: &'static str| {
        let methods: Vec<&str> =
            Method::ALL.iter().filter(|method| class(method) == Some(name)).map(|method| method.name()).collect();
        (!methods.is_empty()).then(|| format!("{name}: {}", methods.join(", ")))
    };
    let names = CLASSES.map(|(_, name)| name).into_iter().chain(["agree", "refused"]);
    let groups: Vec<String> = names.filter_map(group).collect();
    if groups.is_empty() { "no core is asked: the host does it".to_owned() } else { groups.join("; ") }
}

/// Packets that no scene makes have no exact shading: there core and model agree, and no more is said.
fn class(cell: &Cell) -> &'static str {
    match &cell.worst {
        Some(worst) => CLASSES.iter().find(|(most, _)| worst.method <= *most).map_or("far", |(_, name)| name),
        None if cell.cores > 0 => "agree",
        None => "refused",
    }
}
