//! The catalogue as a page: for each row the requirements on each method, the results, and the
//! limits.
use super::catalogue::CATALOGUE;
use super::cell::Cell;
use super::limits::Reason;
use super::raw;
use super::requirement::{Requirement, RowVerdict};

const HEAD: &str = "\
# What is asked of each method in each row of the catalogue of extremes, and what came

Rows are numbered as in the project's list of stiff and extreme cases; those with a letter and those
with names were added. `experiments/src/stress/catalogue` has the rows as scenes, `specula stress` tries
them with every option and more random spans, and `experiments/tests/stress.rs` compares this page with
what happens, with default options and those of the row.

Of every method it is asked everywhere that no pixel is other than the bit-true model's, that each
comes in its clock, that stated facts hold, that every shade is a number from 0 to 255, that no error
of quantisation is beyond its proven bound (one of 255 LSB or more says nothing, and counts as none),
and that no pixel is farther from exact shading than 1 LSB or than the documented limits below. What a
row asks besides, and of which methods, stands under `asked besides`.

A method *holds* if all of that happens and no pixel is more than 1 LSB off. It is at its *limit* if
it is farther off, for a reason that is listed below and by no more than that allows: `came of most`
are LSBs of the pixel that came nearest to its limit, `no limit` those of the worst pixel for which
there is none. Anything else is a *fault*, of which there is none. *Refused* are scenes that a method
has no core for, which the user is told with the reason. What is done instead where a formula has no
value stands in the pages about [arithmetic](arithmetic.md).

## Limits

kd and ks are what a surface sends back of a light, diffusely and in its highlight, n is the exponent,
N the interpolated normal. The limits of several reasons add up. `experiments/src/stress/limits` works
them out for each pixel, from its geometry alone.

";

const ROWS: &str = "\n## Rows\n\n";

/// The page about a sweep of every method.
pub fn page(cells: &[Cell]) -> String {
    let reason = |reason: &Reason| line(&[reason.name(), reason.text()]);
    let reasons = [line(&["reason", "by how much"]), "|---|---|\n".to_owned()]
        .into_iter()
        .chain(Reason::ALL.iter().map(reason));
    let rows = CATALOGUE.iter().map(|row| (row.id, row.input)).chain([(raw::ID, raw::INPUT)]);
    let of_row = |(id, input)| {
        let cells: Vec<&Cell> = cells.iter().filter(|cell| cell.row == id).collect();
        line(&[
            id,
            input,
            &row_requirements(&cells),
            &methods_with_verdict(&cells, RowVerdict::Holds),
            &limits(&cells),
        ])
    };
    let titles = line(&["row", "input", "asked besides", "holds", "limit: came of most, and why"]);
    [HEAD.to_owned()]
        .into_iter()
        .chain(reasons)
        .chain([ROWS.to_owned(), titles, "|---|---|---|---|---|\n".to_owned()])
        .chain(rows.map(of_row))
        .collect()
}

fn line(texts: &[&str]) -> String {
    let texts: Vec<String> = texts.iter().map(|text| text.replace('|', "\\|")).collect();
    format!("| {} |\n", texts.join(" | "))
}

/// The row's own requirements, and the methods that they apply to if not all.
pub fn row_requirements(cells: &[&Cell]) -> String {
    let mut asked: Vec<(&str, Vec<&str>)> = Vec::new();
    for cell in cells {
        for what in cell.asked.iter().filter(|asked| asked.of_row).map(|asked| asked.what.as_str())
        {
            match asked.iter_mut().find(|(known, _)| *known == what) {
                Some((_, methods)) => methods.extend(cell.method),
                None => asked.push((what, cell.method.into_iter().collect())),
            }
        }
    }
    let in_words = |(what, methods): &(&str, Vec<&str>)| match methods.len() {
        0 => format!("host: {what}"),
        number if number == cells.len() => (*what).to_owned(),
        _ => format!("{}: {what}", methods.join(", ")),
    };
    asked.iter().map(in_words).collect::<Vec<_>>().join("; ")
}

/// The methods with a verdict.
pub fn methods_with_verdict(cells: &[&Cell], verdict: RowVerdict) -> String {
    let methods =
        cells.iter().filter(|cell| cell.verdict() == Some(verdict)).filter_map(|cell| cell.method);
    let refused = cells
        .iter()
        .filter(|cell| cell.verdict().is_none() && verdict == RowVerdict::Holds)
        .filter_map(|cell| cell.method);
    let methods: Vec<&str> = methods.collect();
    let refused: Vec<&str> = refused.collect();
    let refused =
        if refused.is_empty() { String::new() } else { format!("refused: {}", refused.join(", ")) };
    [methods.join(", "), refused]
        .into_iter()
        .filter(|text| !text.is_empty())
        .collect::<Vec<_>>()
        .join("; ")
}

/// The methods at their limits, with the figures.
pub fn limits(cells: &[&Cell]) -> String {
    let at = |cell: &&Cell| {
        let figures: Vec<String> = cell
            .asked
            .iter()
            .filter(|asked| asked.verdict() == RowVerdict::Limit)
            .map(with_reasons)
            .collect();
        let method = cell.method.filter(|_| cell.verdict() == Some(RowVerdict::Limit))?;
        Some(format!("{method} {}", figures.join(", ")))
    };
    cells.iter().filter_map(at).collect::<Vec<_>>().join("; ")
}

fn with_reasons(asked: &Requirement) -> String {
    let reasons: Vec<&str> = asked.reasons.iter().map(|reason| reason.name()).collect();
    format!("{} ({})", asked.figure(), reasons.join(", "))
}
