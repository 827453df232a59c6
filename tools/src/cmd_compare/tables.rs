//! The tables of a comparison: titles and rows.
use specula_experiments::tradeoff::software::Software;
use specula_testbench::ErrorFigures;

use super::result::{Compared, Core, size};

/// Titles of [`errors`].
pub const ERROR_TITLES: [&str; 9] = [
    "core",
    "total: largest",
    "rms",
    "PSNR dB",
    "method: largest",
    "rms",
    "quantisation: largest",
    "rms",
    "proven bound",
];

/// Rows of errors in LSBs.
pub fn errors(compared: &Compared) -> Vec<[String; 9]> {
    let row = |core: &Core| {
        let (errors, measured) = (&core.measured().errors, core.measured());
        [
            core.configuration.to_string(),
            lsb(errors.total.max_lsb),
            lsb(errors.total.rms_lsb),
            decibels(&errors.total),
            lsb(errors.method.max_lsb),
            lsb(errors.method.rms_lsb),
            lsb(errors.quantisation.max_lsb),
            lsb(errors.quantisation.rms_lsb),
            measured.bound_lsb.map_or("none".to_owned(), lsb),
        ]
    };
    compared.cores.iter().map(row).collect()
}

/// Titles of [`surfaces`].
pub const SURFACE_TITLES: [&str; 4] = ["", "largest", "rms", "PSNR dB"];

/// Rows of errors in LSBs against the true surface: interpolation's own, and the cores'. There are
/// none if no surface is known.
pub fn surfaces(compared: &Compared) -> Vec<[String; 4]> {
    let row = |name: String, figures: &ErrorFigures| {
        [name, lsb(figures.max_lsb), lsb(figures.rms_lsb), decibels(figures)]
    };
    let interpolation = compared
        .interpolation
        .iter()
        .map(|figures| row("interpolated normals, shaded exactly".to_owned(), figures));
    let cores = compared.cores.iter().filter_map(|core| {
        Some(row(core.configuration.to_string(), core.measured().surface.as_ref()?))
    });
    interpolation.chain(cores).collect()
}

/// Titles of [`run_times`].
pub const RUN_TIME_TITLES: [&str; 12] = [
    "core",
    "latency",
    "set-up clocks a span",
    "clocks a pixel",
    "with set-up",
    "clocks a frame",
    "with set-up",
    "MHz",
    "ns a pixel",
    "frames/s",
    "loop in software",
    "its ns a pixel",
];

/// Rows of run times in hardware and of the same work in software.
pub fn run_times(compared: &Compared) -> Vec<[String; 12]> {
    let row = |core: &Core| {
        let (cycles, software) = (&core.measured().cycles, compared.software_of(core));
        [
            core.configuration.to_string(),
            cycles.latency.to_string(),
            cycles.set_up.to_string(),
            format!("{:.4}", cycles.per_pixel()),
            format!("{:.4}", cycles.per_pixel_with_set_up()),
            cycles.shading.to_string(),
            cycles.with_set_up.to_string(),
            format!("{:.0}", core.clock.mhz),
            format!("{:.2}", core.pixel_ns()),
            format!("{:.0}", core.frames_per_second()),
            software.map_or(String::new(), |software| software.name.to_owned()),
            software.map_or(String::new(), |software| format!("{:.2}", software.total_ns)),
        ]
    };
    compared.cores.iter().map(row).collect()
}

/// Titles of [`sizes`].
pub const SIZE_TITLES: [&str; 9] = [
    "core",
    "multipliers",
    "their bits",
    "adders",
    "their bits",
    "multiplexers",
    "register bits",
    "ROM bits",
    "full adders",
];

/// Rows of the cores' sizes.
pub fn sizes(compared: &Compared) -> Vec<[String; 9]> {
    let row = |core: &Core| {
        let s = &core.measured().size;
        let numbers = [
            s.multipliers as u64,
            s.multiplier_bits,
            s.adders as u64,
            s.adder_bits,
            s.multiplexers as u64,
            s.register_bits,
            s.table_bits,
            core.measured().full_adders(),
        ];
        let [a, b, c, d, e, f, g, h] = numbers.map(|number| number.to_string());
        [core.configuration.to_string(), a, b, c, d, e, f, g, h]
    };
    compared.cores.iter().map(row).collect()
}

/// Titles of [`software`].
pub const SOFTWARE_TITLES: [&str; 8] = [
    "loop",
    "ns a pixel",
    "set-up ns a span",
    "both, ns a pixel",
    "ratio to naive Phong",
    "largest LSB",
    "rms LSB",
    "PSNR dB",
];

/// Rows of the papers' loops.
pub fn software(compared: &Compared) -> Vec<[String; 8]> {
    let row = |software: &Software| {
        [
            software.name.to_owned(),
            format!("{:.2}", software.pixel_ns),
            format!("{:.0}", software.set_up_ns),
            format!("{:.2}", software.total_ns),
            format!("{:.2}", software.ratio_to_phong),
            lsb(software.error.max_lsb),
            lsb(software.error.rms_lsb),
            decibels(&software.error),
        ]
    };
    compared.software.iter().map(row).collect()
}

/// Titles of [`summary`].
pub const SUMMARY_TITLES: [&str; 11] = [
    "core",
    "front",
    "max LSB",
    "rms LSB",
    "MHz",
    "ns a pixel",
    "frames a second",
    "latency",
    "mult.",
    "their bits",
    "reg. bits",
];

/// Rows of the most important figures, one for each core; `s` and `t` mark cores on the fronts of
/// size and of time.
pub fn summary(compared: &Compared) -> Vec<[String; 11]> {
    let (small, quick) = (compared.on_front(size), compared.on_front(Core::pixel_ns));
    let row = |(core, (small, quick)): (&Core, (&bool, &bool))| {
        let (total, made_of) = (&core.measured().errors.total, &core.measured().size);
        [
            core.configuration.to_string(),
            format!("{}{}", if *small { "s" } else { "" }, if *quick { "t" } else { "" }),
            lsb(total.max_lsb),
            lsb(total.rms_lsb),
            format!("{:.0}", core.clock.mhz),
            format!("{:.2}", core.pixel_ns()),
            format!("{:.0}", core.frames_per_second()),
            core.measured().cycles.latency.to_string(),
            made_of.multipliers.to_string(),
            made_of.multiplier_bits.to_string(),
            made_of.register_bits.to_string(),
        ]
    };
    compared.cores.iter().zip(small.iter().zip(&quick)).map(row).collect()
}

fn lsb(error: f64) -> String {
    format!("{error:.3}")
}

fn decibels(figures: &ErrorFigures) -> String {
    figures.psnr_db.map_or("no error".to_owned(), |db| format!("{db:.2}"))
}

#[cfg(test)]
mod tests {
    use specula_spec::Method;

    use super::*;
    use crate::table;

    #[test]
    fn the_summary_fits_into_80_columns() {
        let numbers =
            ["st", "255.000", "99.999", "999", "99.99", "999999", "999", "999", "99999", "99999"];
        let row = |method: Method| {
            let core = format!("{} default", method.name());
            let cells = std::iter::once(core).chain(numbers.map(str::to_owned));
            cells.collect::<Vec<_>>().try_into().expect("a cell for each title")
        };
        let rows: Vec<[String; 11]> =
            [SUMMARY_TITLES.map(str::to_owned)].into_iter().chain(Method::ALL.map(row)).collect();
        let text = table::folded(&rows, 80);
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    }
}
