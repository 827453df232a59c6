//! The report of a comparison, for people.
use super::plots::PLOTS;
use super::result::Compared;
use super::tables::{
    self, ERROR_TITLES, RUN_TIME_TITLES, SIZE_TITLES, SOFTWARE_TITLES, SURFACE_TITLES,
};
use crate::table::markdown as table;

/// Explains how set-up is counted.
pub const SET_UP: &str = "\
Set-up: the host hands a span's inputs over in words of 32 bits, one a clock, while the span before is shaded; a span
shorter than that waits. Inputs that the scene holds constant are not handed over.
";

/// Explains what full adders are.
pub const FULL_ADDERS: &str = "\
Full adders: one for each bit of an adder, w1 w2 for a product of w1 and w2 bits, as an array multiplier has. Registers and
ROMs stand apart. Counted in the design, before any FPGA tool has seen it.
";

/// The text of `report.md`.
pub fn markdown(compared: &Compared) -> String {
    let sections = [
        head(compared),
        plots(compared),
        errors(compared),
        surfaces(compared),
        run_times(compared),
        sizes(compared),
        software(compared),
    ];
    sections.join("\n")
}

fn head(compared: &Compared) -> String {
    let verdict = if compared.agrees() {
        "Every pixel of every core is the bit-true model's, and no quantisation error is above its bound.\n".to_owned()
    } else {
        let wrong = |core: &super::result::Core| {
            Some(format!("- {}: {}\n", core.configuration, core.measured().disagreement()?))
        };
        format!(
            "**These cores are not as they must be:**\n\n{}",
            compared.cores.iter().filter_map(wrong).collect::<String>()
        )
    };
    let refusals: String =
        compared.refusals.iter().map(|refusal| format!("- not built: {refusal}\n")).collect();
    format!(
        "# {}: methods and formats compared\n\n{} x {} pixels. Made by Specula {}. {verdict}\n\
         *Default* formats are those that each method recommends for the scene; numbers are fraction bits more or fewer at every narrowing\n\
         point, as far as it can have them.\n\n{refusals}",
        compared.scene,
        compared.size.0,
        compared.size.1,
        env!("CARGO_PKG_VERSION")
    )
}

fn plots(compared: &Compared) -> String {
    let of = |plot: &&super::plots::TradeoffPlot| plot.has_places(compared);
    PLOTS
        .iter()
        .filter(of)
        .map(|plot| format!("![{}]({}.svg)\n\n", plot.title, plot.file))
        .collect()
}

fn errors(compared: &Compared) -> String {
    format!(
        "## Errors\n\nIn LSBs of the 8-bit output, over the three channels of all shaded pixels. *Total* is the core against exact shading, *method* its\n\
         method in exact arithmetic against exact shading, *quantisation* the core against its method; half an LSB of it is the rounding\n\
         to 8 bits.\n\n{}",
        table(ERROR_TITLES, &tables::errors(compared))
    )
}

/// The section about true surfaces; empty where no surface is known.
fn surfaces(compared: &Compared) -> String {
    let rows = tables::surfaces(compared);
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "## Errors against the true surface\n\nIn LSBs, against exact shading with the normals of the sphere or torus that a mesh stands for, over the pixels of such\n\
         meshes. Interpolation itself is off from it.\n\n{}",
        table(SURFACE_TITLES, &rows)
    )
}

fn run_times(compared: &Compared) -> String {
    let processor = format!(" Loops ran on one thread of: {}.", compared.machine.cpu);
    format!(
        "## Run time\n\nAt {}; set-up is counted in ns a pixel and in frames.{processor}\n\n{SET_UP}\n{}",
        compared.clocks.in_words(),
        table(RUN_TIME_TITLES, &tables::run_times(compared))
    )
}

fn sizes(compared: &Compared) -> String {
    format!("## Size\n\n{FULL_ADDERS}\n{}", table(SIZE_TITLES, &tables::sizes(compared)))
}

fn software(compared: &Compared) -> String {
    format!(
        "## Software\n\nThe papers' loops in f32, one thread, in time that it has a processor: medians of rounds in which all run one after\n\
         another. The lecture's project is `gouraud`, `phong` (naive: a root and three divisions a pixel), `fast-phong` (Newton steps from the\n\
         pixel before) and `slerp`. Where lights or the eye are at places, `phong-places` is the naive one, the loops for lights at infinity\n\
         are left out, and those of eq. 35 to 38 are there. Set-up has what is worked out once for the frame (intensities of vertices) in\n\
         it, shared out over its spans. Errors are against exact shading, before rounding to 8 bits.\n\n{}",
        table(SOFTWARE_TITLES, &tables::software(compared))
    )
}
