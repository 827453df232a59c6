//! The files of a run's folder.
use std::fs;
use std::io;

use specula_drawing as drawing;
use specula_spec::SpecFile;
use specula_testbench::Image;

use crate::error::ToolError;
use crate::output::{MARKDOWN, REPORT, Staging};
use crate::report::{self, ERROR, EXACT, EXPECTED, Report, SIMULATED};
use crate::run::Run;
use crate::sequence::{ANIMATION, PLOT, TABLE, picture_name, plot, table, write_animation};
use crate::trace_file::TraceFormat;
use crate::{html, picture, verilog, waveform, worst_pixel};

/// A file of a run's folder.
pub struct Artifact {
    /// Its name.
    pub name: String,
    /// Whether a run has this file.
    pub is_of: fn(&Run) -> bool,
    /// Writes the file under the given name. Files that precede it in the table have been written.
    write: fn(&Report, &Staging, &str) -> Result<(), ToolError>,
}

impl Artifact {
    /// Writes the file.
    pub fn write(&self, report: &Report, staging: &Staging) -> Result<(), ToolError> {
        (self.write)(report, staging, &self.name)
    }

    fn optional(self, is_of: fn(&Run) -> bool) -> Artifact {
        Artifact { is_of, ..self }
    }
}

/// Every file that a run with this module can have, in the order in which people want to see them
/// and in which they are written: the page embeds pictures that precede it, and `report.json` makes
/// the folder complete.
pub fn artifacts(module: &str) -> [Artifact; 16] {
    let always = |name: &str, write| Artifact { name: name.to_owned(), is_of: |_| true, write };
    [
        always(&verilog::file_name(module), write_verilog),
        always(SIMULATED, |report, staging, name| {
            image(&report.run.outcome.simulated, staging, name)
        }),
        always(EXPECTED, |report, staging, name| {
            image(&report.run.outcome.comparison.expected, staging, name)
        }),
        always(EXACT, |report, staging, name| {
            image(&report.run.outcome.comparison.exact, staging, name)
        }),
        always(ERROR, write_heat_map),
        always(TraceFormat::Vcd.file_name(), write_waveform)
            .optional(|run| run.window.is_some() && run.trace_format == TraceFormat::Vcd),
        always(TraceFormat::Fst.file_name(), write_waveform)
            .optional(|run| run.window.is_some() && run.trace_format == TraceFormat::Fst),
        always(waveform::SAVE_FILE, |report, staging, name| {
            waveform::write_save_file(report.run, staging, name)
        })
        .optional(|run| run.window.is_some()),
        always(worst_pixel::PICTURE, |report, staging, name| {
            worst_pixel::write(report.run, staging, name)
        })
        .optional(|run| run.window.is_some() && run.clock_to_look_at().is_some()),
        always(ANIMATION, |report, staging, name| {
            let frames = report.sequence.map_or(0, |sequence| sequence.frames);
            Ok(write_animation(staging, name, frames).map_err(staging.failed(name))?)
        })
        .optional(|run| run.sequence.is_some()),
        always(PLOT, write_plot).optional(|run| run.sequence.is_some()),
        always(TABLE, |report, staging, name| {
            text(&report.sequence.map(table).unwrap_or_default(), staging, name)
        })
        .optional(|run| run.sequence.is_some()),
        always(SpecFile::NAME, |report, staging, name| {
            text(&report.run.job.file.text(), staging, name)
        }),
        always(MARKDOWN, |report, staging, name| text(&report::markdown(report), staging, name)),
        always(html::FILE, write_page),
        always(REPORT, write_json),
    ]
}

/// The names of all files of a run over so many frames; 0 of a scene that does not move.
pub fn names(module: &str, frames: u32) -> Vec<String> {
    let pictures = (0..frames).map(picture_name);
    artifacts(module).into_iter().map(|artifact| artifact.name).chain(pictures).collect()
}

fn write_plot(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let Some(sequence) = report.sequence else { return Ok(()) };
    let bound = report.run.bench.design.error_bound();
    let sheet = plot(sequence, report.scene, bound).render()?;
    text(&drawing::svg(&sheet), staging, name)
}

fn write_verilog(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let Run { job, bench, .. } = report.run;
    text(&verilog::text(&job.origin, bench.spec, &bench.design), staging, name)
}

fn write_heat_map(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let map = picture::heat_map(&report.run.outcome.comparison);
    Ok(picture::write_drawing(&staging.file(name), &map).map_err(staging.failed(name))?)
}

fn write_waveform(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    waveform::write(report.run, staging, name)
}

fn write_page(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    text(&report::html(report, staging).map_err(staging.failed(name))?, staging, name)
}

fn write_json(report: &Report, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let json = report.json().map_err(io::Error::other).map_err(staging.failed(name))?;
    text(&json, staging, name)
}

fn image(image: &Image, staging: &Staging, name: &str) -> Result<(), ToolError> {
    Ok(picture::write_image(&staging.file(name), image).map_err(staging.failed(name))?)
}

fn text(text: &str, staging: &Staging, name: &str) -> Result<(), ToolError> {
    Ok(fs::write(staging.file(name), text).map_err(staging.failed(name))?)
}
