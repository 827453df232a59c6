//! The files that `compare` writes.
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
/// Files that are always written.
const FIXED: [&str; 6] = [MARKDOWN, html::FILE, REPORT, CORES, SOFTWARE, JOURNAL];

/// Every file that may be written.
pub fn names() -> Vec<String> {
    let fixed = FIXED.map(str::to_owned);
    fixed.into_iter().chain(plots::PLOTS.iter().flat_map(plots::TradeoffPlot::names)).collect()
}

/// Writes all files and returns the JSON report.
pub fn write(
    destination: &Destination,
    compared: &Compared,
    journal: &Journal,
) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let drawn: Vec<&plots::TradeoffPlot> =
        plots::PLOTS.iter().filter(|plot| plot.has_places(compared)).collect();
    drawn.iter().try_for_each(|plot| draw(&staging, plot, compared))?;
    let put =
        |name: &str, text: &str| fs::write(staging.file(name), text).map_err(staging.failed(name));
    let text = markdown::markdown(compared);
    put(MARKDOWN, &text)?;
    put(CORES, &csv::cores(compared))?;
    put(SOFTWARE, &csv::software(compared))?;
    put(JOURNAL, &journal.text()?)?;
    let page = page(compared, &text, &staging).map_err(staging.failed(html::FILE))?;
    put(html::FILE, &page)?;
    let plots = drawn.iter().flat_map(|plot| plot.names());
    let files: Vec<String> = FIXED.map(str::to_owned).into_iter().chain(plots).collect();
    let report = json::text(compared, &files)
        .map_err(|error| staging.failed(REPORT)(io::Error::other(error)))?;
    put(REPORT, &report)?;
    staging.publish()?;
    Ok(report)
}

/// The HTML page: the report for people with the written pictures embedded.
fn page(compared: &Compared, text: &str, staging: &Staging) -> io::Result<String> {
    let title = format!("{}: methods and formats compared", compared.scene);
    Ok(html::page(&title, &html::render(text, staging)?))
}

fn draw(
    staging: &Staging,
    plot: &plots::TradeoffPlot,
    compared: &Compared,
) -> Result<(), ToolError> {
    let sheet = plot.plot(compared).render()?;
    let [svg, png] = plot.names();
    fs::write(staging.file(&svg), specula_drawing::svg(&sheet)).map_err(staging.failed(&svg))?;
    // A plot is never too large for a picture.
    if let Some(drawing) = specula_drawing::png(&sheet) {
        picture::write_line_drawing(&staging.file(&png), &drawing).map_err(staging.failed(&png))?;
    }
    Ok(())
}
