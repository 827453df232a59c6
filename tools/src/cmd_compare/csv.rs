//! The figures of a comparison as CSV, one line for each core or loop. No field contains a comma or
//! a quotation mark.
use specula_experiments::tradeoff::software::Software;
use specula_testbench::ErrorFigures;

use super::result::{Compared, Core};

/// A column: its name, and the function that gives its fields.
type Column<T> = (&'static str, fn(&T) -> String);

const CORES: [Column<Core>; 31] = [
    ("method", |core| core.configuration.method.name().to_owned()),
    ("formats", |core| core.configuration.formats.to_string()),
    ("added_fraction_bits", |core| core.configuration.formats.added().to_string()),
    ("agrees", |core| core.measured().agrees.to_string()),
    ("total_max_lsb", |core| core.measured().errors.total.max_lsb.to_string()),
    ("total_rms_lsb", |core| core.measured().errors.total.rms_lsb.to_string()),
    ("total_psnr_db", |core| decibels(&core.measured().errors.total)),
    ("method_max_lsb", |core| core.measured().errors.method.max_lsb.to_string()),
    ("method_rms_lsb", |core| core.measured().errors.method.rms_lsb.to_string()),
    ("method_psnr_db", |core| decibels(&core.measured().errors.method)),
    ("quantisation_max_lsb", |core| core.measured().errors.quantisation.max_lsb.to_string()),
    ("quantisation_rms_lsb", |core| core.measured().errors.quantisation.rms_lsb.to_string()),
    ("quantisation_psnr_db", |core| decibels(&core.measured().errors.quantisation)),
    ("bound_lsb", |core| optional(core.measured().bound_lsb)),
    ("surface_max_lsb", |core| {
        optional(core.measured().surface.as_ref().map(|figures| figures.max_lsb))
    }),
    ("surface_rms_lsb", |core| {
        optional(core.measured().surface.as_ref().map(|figures| figures.rms_lsb))
    }),
    ("latency_clocks", |core| core.measured().cycles.latency.to_string()),
    ("set_up_clocks_per_span", |core| core.measured().cycles.set_up.to_string()),
    ("frame_clocks", |core| core.measured().cycles.shading.to_string()),
    ("frame_clocks_with_set_up", |core| core.measured().cycles.with_set_up.to_string()),
    ("clock_mhz", |core| core.clock.mhz.to_string()),
    ("ns_per_pixel", |core| core.pixel_ns().to_string()),
    ("frames_per_second", |core| core.frames_per_second().to_string()),
    ("multipliers", |core| core.measured().size.multipliers.to_string()),
    ("multiplier_bits", |core| core.measured().size.multiplier_bits.to_string()),
    ("adders", |core| core.measured().size.adders.to_string()),
    ("adder_bits", |core| core.measured().size.adder_bits.to_string()),
    ("multiplexers", |core| core.measured().size.multiplexers.to_string()),
    ("register_bits", |core| core.measured().size.register_bits.to_string()),
    ("rom_bits", |core| core.measured().size.table_bits.to_string()),
    ("full_adders", |core| core.measured().full_adders().to_string()),
];

const LOOPS: [Column<Software>; 8] = [
    ("loop", |software| software.name.to_owned()),
    ("ns_per_pixel", |software| software.pixel_ns.to_string()),
    ("set_up_ns_per_span", |software| software.set_up_ns.to_string()),
    ("total_ns_per_pixel", |software| software.total_ns.to_string()),
    ("ratio_to_phong", |software| software.ratio_to_phong.to_string()),
    ("max_lsb", |software| software.error.max_lsb.to_string()),
    ("rms_lsb", |software| software.error.rms_lsb.to_string()),
    ("psnr_db", |software| decibels(&software.error)),
];

/// The table of cores.
pub fn cores(compared: &Compared) -> String {
    lines(&CORES, &compared.cores)
}

/// The table of software loops.
pub fn software(compared: &Compared) -> String {
    lines(&LOOPS, &compared.software)
}

fn lines<T>(columns: &[Column<T>], rows: &[T]) -> String {
    let line = |fields: Vec<String>| fields.join(",") + "\n";
    let titles = line(columns.iter().map(|(name, _)| (*name).to_owned()).collect());
    let rows = rows.iter().map(|row| line(columns.iter().map(|(_, field)| field(row)).collect()));
    [titles].into_iter().chain(rows).collect()
}

/// A number, or an empty field where there is none.
fn optional(number: Option<f64>) -> String {
    number.map_or(String::new(), |number| number.to_string())
}

fn decibels(figures: &ErrorFigures) -> String {
    optional(figures.psnr_db)
}
