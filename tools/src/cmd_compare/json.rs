//! The result of a comparison as JSON.
use serde::Serialize;
use specula_experiments::tradeoff::software::Software;
use specula_experiments::tradeoff::{Measured, WORD_BITS};
use specula_spec::CoreSpec;
use specula_testbench::ErrorFigures;

use super::result::{Compared, Core, size};
use crate::clock::ClockSource;
use crate::output::PROGRAM;

/// `report.json`. Errors are in LSBs of the 8-bit output.
#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    version: &'static str,
    scene: &'a str,
    width: u32,
    height: u32,
    agrees: bool,
    /// The clock of all cores; `None` where each has the one that its target's delays predict.
    clock_mhz: Option<f64>,
    /// Whether that clock is assumed rather than given by the user.
    clock_is_assumed: bool,
    /// Bits of a span's set-up that the host transfers in a clock.
    set_up_word_bits: u64,
    cores: Vec<CoreFacts<'a>>,
    not_built: &'a [String],
    /// Error of exact shading with interpolated normals against exact shading of the true surface;
    /// `None` where no surface is known.
    interpolation: Option<&'a ErrorFigures>,
    /// The processor on which the papers' loops were measured.
    processor: &'a str,
    software: &'a [Software],
    files: &'a [String],
}

#[derive(Serialize)]
struct CoreFacts<'a> {
    method: &'static str,
    formats: String,
    added_fraction_bits: i32,
    /// Whether the core is on the front of error against full adders.
    on_front_of_size: bool,
    /// Whether the core is on the front of error against time.
    on_front_of_time: bool,
    #[serde(flatten)]
    measured: &'a Measured,
    full_adders: u64,
    cycles_per_pixel: f64,
    cycles_per_pixel_with_set_up: f64,
    /// The clock at which the core is counted to run, in MHz.
    clock_mhz: f64,
    ns_per_pixel: f64,
    frames_per_second: f64,
    /// The software loop that does the same.
    software: Option<&'static str>,
    spec: &'a CoreSpec,
}

/// The report as JSON text.
pub fn text(compared: &Compared, files: &[String]) -> serde_json::Result<String> {
    let (small, quick) = (compared.on_front(size), compared.on_front(Core::pixel_ns));
    let clock = compared.clocks.of_all();
    let report = Report {
        program: PROGRAM,
        version: env!("CARGO_PKG_VERSION"),
        scene: &compared.scene,
        width: compared.size.0,
        height: compared.size.1,
        agrees: compared.agrees(),
        clock_mhz: clock.map(|clock| clock.mhz),
        clock_is_assumed: clock.is_some_and(|clock| clock.source == ClockSource::Assumed),
        set_up_word_bits: WORD_BITS,
        cores: compared
            .cores
            .iter()
            .zip(small.iter().zip(&quick))
            .map(|(core, front)| of_core(compared, core, front))
            .collect(),
        not_built: &compared.refusals,
        interpolation: compared.interpolation.as_ref(),
        processor: &compared.machine.cpu,
        software: &compared.software,
        files,
    };
    let mut text = serde_json::to_string_pretty(&report)?;
    text.push('\n');
    Ok(text)
}

fn of_core<'a>(
    compared: &'a Compared,
    core: &'a Core,
    (small, quick): (&bool, &bool),
) -> CoreFacts<'a> {
    let measured = core.measured();
    CoreFacts {
        method: core.configuration.method.name(),
        formats: core.configuration.formats.to_string(),
        added_fraction_bits: core.configuration.formats.added(),
        on_front_of_size: *small,
        on_front_of_time: *quick,
        measured,
        full_adders: measured.full_adders(),
        cycles_per_pixel: measured.cycles.per_pixel(),
        cycles_per_pixel_with_set_up: measured.cycles.per_pixel_with_set_up(),
        clock_mhz: core.clock.mhz,
        ns_per_pixel: core.pixel_ns(),
        frames_per_second: core.frames_per_second(),
        software: compared.software_of(core).map(|software| software.name),
        spec: &core.measurement.spec,
    }
}
