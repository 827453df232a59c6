//! The report for people: what was built, how well it does, and how to go on with it.
use specula_experiments::Share;
use specula_testbench::ErrorFigures;

use super::facts::{self, Fact};
use super::{ports, units};
use crate::header::bound;
use crate::run::{Run, Written};
use crate::table::markdown as table;
use crate::{cmd_needs, waveform, worst};

/// `report.md`. It holds no times, so that the same run gives the same bytes.
pub fn markdown(run: &Run, written: &Written) -> String {
    [head(run), pictures(), rest(run, written)].join("\n")
}

/// What comes before the pictures.
pub fn head(run: &Run) -> String {
    [title(run), result(run)].join("\n")
}

/// What comes behind them.
pub fn rest(run: &Run, written: &Written) -> String {
    let sections = [
        errors(run),
        built(run),
        ports_of(run),
        units(run),
        needs(run),
        left_out(run),
        facts(run),
        waves(run, written),
        verilog(run),
    ];
    sections.join("\n")
}

fn title(run: &Run) -> String {
    let (method, latency) = (run.bench.spec.method(), run.bench.design.latency());
    format!(
        "# {}, shaded by `{}`\n\n\
         A pipeline of {latency} clocks that takes a pixel in {}: {}.\n\n\
         Made by Specula {}; `{}` makes the same Verilog.\n",
        run.name(),
        method.name(),
        pace(run.bench.design.interval),
        method.summary(),
        env!("CARGO_PKG_VERSION"),
        run.task.origin.command
    )
}

fn pace(interval: u32) -> String {
    match interval {
        1 => "every clock".to_owned(),
        clocks => format!("{clocks} clocks, one for each light"),
    }
}

fn result(run: &Run) -> String {
    let (outcome, frame) = (run.outcome, run.bench.frame);
    let verdict = match &run.disagreement {
        None => "Every pixel agrees with the bit-true model, each in its clock, every stated fact held, and no quantisation error is above its bound.\n"
            .to_owned(),
        Some(disagreement) => {
            let lines: Vec<String> = disagreement.lines().iter().map(|line| format!("- {line}\n")).collect();
            let verdict = match disagreement.is_of_bound_alone() {
                true => "The quantisation error is above its proven bound.",
                false => "The core does not agree with its models.",
            };
            format!("**{verdict}**\n\n{}", lines.concat())
        }
    };
    let rows = [
        ["picture", &format!("{} x {}, {} spans", frame.width, frame.height, frame.spans.len())],
        ["pixels shaded", &outcome.pixels.to_string()],
        ["pixels that differ", &outcome.comparison.mismatches.to_string()],
        ["cycles", &outcome.cycles.to_string()],
        ["cycles per pixel", &format!("{:.4}", run.cycles_per_pixel())],
        ["latency", &format!("{} clocks", run.bench.design.latency())],
        ["frames per second", &run.frames_per_second_in_words()],
        ["engine", run.engine.name()],
    ];
    let device = run.fitted.map(|fitted| ["device".to_owned(), fitted.in_words()]);
    let rows: Vec<[String; 2]> =
        rows.into_iter().map(|row| row.map(str::to_owned)).chain(device).collect();
    format!("## Result\n\n{verdict}\n{}", table(["", ""], &rows))
}

/// The heat map with its scale.
pub const HEAT_MAP: &str = "![error](error.png)\n";

fn pictures() -> String {
    format!(
        "## Pictures\n\n\
         | simulated core | bit-true model | exact shading |\n|---|---|---|\n\
         | ![simulated](simulated.png) | ![expected](expected.png) | ![exact](exact.png) |\n\n{HEAT_MAP}"
    )
}

fn errors(run: &Run) -> String {
    let comparison = &run.outcome.comparison;
    let errors = &comparison.errors;
    let rows = [
        figures("total: the core against exact shading", &errors.total),
        figures("method: its method in exact arithmetic against exact shading", &errors.method),
        figures(
            "quantisation: the core against its method in exact arithmetic",
            &errors.quantisation,
        ),
    ];
    let worst = comparison.worst_pixel.zip(run.outcome.worst_cycle).map(|(worst, cycle)| {
        format!(
            "The largest total error, {:.2} LSB, is at ({}, {}); that pixel leaves in cycle {cycle}. ",
            worst.error_lsb, worst.x, worst.y
        )
    });
    format!(
        "## Errors\n\nIn LSBs of the 8-bit output, over the three channels of all shaded pixels. {}\
         The quantisation error is proven to stay within {}. Half an LSB of it is the rounding to 8 bits.\n\n{}\n{}",
        worst.unwrap_or_default(),
        bound(run.bench.design.error_bound()),
        table(["error", "largest", "rms", "mean", "PSNR in dB"], &rows),
        bound_shares(run)
    )
}

/// How the proven bound compares with what was measured, and where it comes from; nothing where
/// there is no bound.
fn bound_shares(run: &Run) -> String {
    let Some(ratio) = run.bound_ratio() else { return String::new() };
    let row = |share: &Share| {
        [format!("`{}`", share.name), format!("{:.3}", share.lsb), format!("`{}`", share.value)]
    };
    let rows: Vec<[String; 3]> =
        run.bound_shares.iter().filter(|share| share.lsb >= 0.0005).map(row).collect();
    let text = format!(
        "The bound is {ratio:.1} times the largest quantisation error of this picture. It is for every scene with the same ranges; where formats were\n\
         narrowed for this picture (`--max-error`, `explore`), only what was measured is within that goal.\n"
    );
    if rows.is_empty() {
        return text;
    }
    let table = table(["narrowing point", "share in LSB", "what is rounded"], &rows);
    format!(
        "{text}\nBy how much the bound would be smaller if one place rounded far finer; shares overlap.\n\n{table}"
    )
}

fn figures(name: &str, figures: &ErrorFigures) -> [String; 5] {
    let lsb = |x: f64| format!("{x:.3}");
    let psnr = figures.psnr_db.map_or("no error".to_owned(), |db| format!("{db:.2}"));
    [name.to_owned(), lsb(figures.max_lsb), lsb(figures.rms_lsb), lsb(figures.mean_lsb), psnr]
}

fn built(run: &Run) -> String {
    let options: Vec<[String; 2]> = run
        .bench
        .spec
        .options()
        .into_iter()
        .map(|(name, value)| [name.to_owned(), value])
        .collect();
    let points: Vec<[String; 4]> = run
        .bench
        .spec
        .narrowing_points()
        .iter()
        .map(|point| {
            let name = format!("`{}`", point.name);
            [
                name,
                point.format.to_string(),
                point.format.width().to_string(),
                format!("`{}`", point.value),
            ]
        })
        .collect();
    format!(
        "## What was built\n\n{}\n\
         Values are rounded, to nearest and ties up, in these places and no others. `S1.10` has a sign, 1 integer bit and\n\
         10 fraction bits; `U` has no sign. Where values are known to be smaller, the hardware is narrower.\n\n{}",
        table(["spec", ""], &options),
        table(["narrowing point", "format", "bits", "what is rounded"], &points)
    )
}

fn ports_of(run: &Run) -> String {
    let design = &run.bench.design;
    let rows = ports::rows(run.bench.spec, design);
    let (held, entering) = match design.interval {
        1 => ("as many clocks as it has pixels".to_owned(), "on consecutive clocks"),
        clocks => (format!("{clocks} clocks a pixel"), "one after the other"),
    };
    format!(
        "## Ports\n\n{}\n\
         A span's data inputs are held for {held}, `valid` high in each of them and `start` in the first\n\
         only; its pixels enter {entering}. The next span may follow at once. A pixel that enters in clock c leaves in\n\
         clock c + {}, with `valid_out` high.\n",
        table(["port", "direction", "bits", "format", "meaning"], &rows),
        design.latency()
    )
}

fn units(run: &Run) -> String {
    format!(
        "## Units\n\nCounted in the design, before any FPGA tool has seen it; figures are of one unit, without the units inside it. Multiplier\n\
         bits are the sum of the products of both operands' widths: 18 x 18 is 324.\n\n{}",
        table(
            [
                "unit",
                "number",
                "latency",
                "multipliers",
                "multiplier bits",
                "adders",
                "multiplexers",
                "register bits"
            ],
            &units::rows(&run.bench.design)
        )
    )
}

/// What the scene's needs save, if that is known.
fn needs(run: &Run) -> String {
    let Some(savings) = &run.savings else { return String::new() };
    format!(
        "## What the scene does not need\n\n\
         Measured by elaborating the core without that one need known; savings overlap, and a negative number is what products\n\
         with constants cost in adders in place of multipliers. All together are measured against two general cores, which the table\n\
         names: one that knows nothing of the scene, and one as a renderer would have it, for as many lights, spans as wide as the\n\
         picture and exponents up to 128; neither knows of angles, colours or what inputs are given.\n\n{}",
        table(cmd_needs::TITLES, &cmd_needs::rows(savings))
    )
}

fn left_out(run: &Run) -> String {
    let left_out = &run.bench.design.left_out;
    if left_out.is_empty() {
        return "## Left out\n\nNothing: this scene makes use of everything that its method has.\n"
            .to_owned();
    }
    let rows: Vec<[String; 3]> = left_out
        .iter()
        .map(|left| [format!("`{}`", left.unit), left.what.clone(), left.why.clone()])
        .collect();
    format!(
        "## Left out\n\nHardware that a general core has and this one does not.\n\n{}",
        table(["unit", "what", "why nothing is lost"], &rows)
    )
}

fn facts(run: &Run) -> String {
    let rows: Vec<[String; 4]> =
        facts::facts(&run.bench.design, run.outcome).iter().map(Fact::row).collect();
    if rows.is_empty() {
        return "## Facts that were checked\n\nNone had to be assumed: intervals prove every width.\n".to_owned();
    }
    format!(
        "## Facts that were checked\n\nWhat intervals cannot see is stated by the units that rely on it, and was checked in every clock with a pixel. Seen are the\n\
         smallest and the largest value of all these signals in this run.\n\n{}",
        table(["fact", "signal", "must lie in", "seen"], &rows)
    )
}

fn waves(run: &Run, written: &Written) -> String {
    let text = match &written.window {
        None => "None was asked for: `--trace worst` shows the clocks around the pixel with the largest error.\n".to_owned(),
        Some(window) => format!(
            "`{dump}` holds every signal in clocks {} to {}. The save file opens the interesting ones as fixed-point numbers:\n\n\
             ```sh\ngtkwave {dump} {save}\n```\n",
            window.start,
            window.end - 1,
            dump = run.trace_format.file_name(),
            save = waveform::SAVE_FILE
        ),
    };
    format!("## Waveform\n\n{text}{}", way(run, written))
}

/// The picture of a pixel's way, if there is one.
fn way(run: &Run, written: &Written) -> String {
    if !written.files.iter().any(|file| file == worst::PICTURE) {
        return String::new();
    }
    let pixel = match &run.disagreement {
        None => "the pixel with the largest error",
        Some(disagreement) if disagreement.is_of_bound_alone() => {
            "the pixel whose error is furthest above its bound"
        }
        Some(_) => "the first disagreement",
    };
    format!(
        "\nThe way of {pixel} through the core, its value of each signal marked:\n\n[![way]({file})]({file})\n",
        file = worst::PICTURE
    )
}

fn verilog(run: &Run) -> String {
    let module = &run.module;
    format!(
        "## Verilog\n\n`{module}.v` is the whole core in Verilog-2001. What Specula emits belongs to whoever ran it. To look at it with\nother tools:\n\n\
         ```sh\n\
         verilator --lint-only -Wall {module}.v\n\
         iverilog -g2001 -Wall -t null {module}.v\n\
         yosys -p 'read_verilog {module}.v; synth -top {module}; stat'\n\
         ```\n"
    )
}
