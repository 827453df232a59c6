//! What `compare` writes.
use std::fs;
use std::io;

use specula_experiments::tradeoff::Journal;

use super::result::Compared;
use super::{csv, json, markdown, plots};
use crate::error::ToolError;
use crate::output::{Destination, JOURNAL, MARKDOWN, REPORT, Staging};
use crate::{html, picture};

const CORES: &str = "cores.csv";
const SOFTWARE: &str = "software.csv";
/// Files that are always there.
const FIXED: [&str; 6] = [MARKDOWN, html::FILE, REPORT, CORES, SOFTWARE, JOURNAL];

/// Every file that may be written.
pub fn names() -> Vec<String> {
    let fixed = FIXED.map(str::to_owned);
    fixed.into_iter().chain(plots::SUBJECTS.iter().flat_map(plots::Subject::names)).collect()
}

/// Writes everything; gives the JSON report.
pub fn write(
    destination: &Destination,
    compared: &Compared,
    journal: &Journal,
) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let drawn: Vec<&plots::Subject> =
        plots::SUBJECTS.iter().filter(|subject| subject.has_places(compared)).collect();
    drawn.iter().try_for_each(|subject| draw(&staging, subject, compared))?;
    let put =
        |name: &str, text: &str| fs::write(staging.file(name), text).map_err(staging.failed(name));
    let text = markdown::markdown(compared);
    put(MARKDOWN, &text)?;
    put(CORES, &csv::cores(compared))?;
    put(SOFTWARE, &csv::software(compared))?;
    put(JOURNAL, &journal.text()?)?;
    let page = page(compared, &text, &staging).map_err(staging.failed(html::FILE))?;
    put(html::FILE, &page)?;
    let plots = drawn.iter().flat_map(|subject| subject.names());
    let files: Vec<String> = FIXED.map(str::to_owned).into_iter().chain(plots).collect();
    let report = json::text(compared, &files)
        .map_err(|error| staging.failed(REPORT)(io::Error::other(error)))?;
    put(REPORT, &report)?;
    staging.publish()?;
    Ok(report)
}

/// The report for browsers: that for people, with what has been written in it.
fn page(compared: &Compared, text: &str, staging: &Staging) -> io::Result<String> {
    let title = format!("{}: methods and formats compared", compared.scene);
    Ok(html::page(&title, &html::render(text, staging)?))
}

fn draw(staging: &Staging, subject: &plots::Subject, compared: &Compared) -> Result<(), ToolError> {
    let sheet = subject.plot(compared).render()?;
    let [svg, png] = subject.names();
    fs::write(staging.file(&svg), specula_drawing::svg(&sheet)).map_err(staging.failed(&svg))?;
    // A plot is never too large for a picture.
    if let Some(drawing) = specula_drawing::png(&sheet) {
        picture::write_line_drawing(&staging.file(&png), &drawing).map_err(staging.failed(&png))?;
    }
    Ok(())
}
