//! The report for people: what was built, how exact and fast it is, and what to do next.
use specula_experiments::BoundShare;
use specula_testbench::ErrorFigures;

use super::facts::Fact;
use super::pictures::{ERROR, EXACT, EXPECTED, SIMULATED};
use super::{Report, rows, units};
use crate::ports::Port;
use crate::sequence::{ANIMATION, PLOT, TABLE};
use crate::table::markdown as table;
use crate::verilog::between_frames;
use crate::{cmd_needs, waveform, worst_pixel};

/// The text of `report.md`. It contains no times, so that the same run gives the same bytes.
pub fn markdown(report: &Report) -> String {
    [head(report), pictures(), rest(report)].join("\n")
}

/// The part before the pictures.
pub fn head(report: &Report) -> String {
    let sections = [Some(title(report)), Some(result(report)), sequence(report)];
    sections.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

/// The section about all frames, if the scene moves.
fn sequence(report: &Report) -> Option<String> {
    let sequence = report.sequence?;
    Some(format!(
        "## Sequence\n\nOne core shades {}. `{TABLE}` has a line for each, and the pictures from here on are of frame {}.\n\n\
         ![animation]({ANIMATION})\n\n![errors over time]({PLOT})\n",
        sequence.in_words(),
        sequence.shown
    ))
}

/// The part after the pictures.
pub fn rest(report: &Report) -> String {
    let sections = [
        errors(report),
        built(report),
        ports_of(report),
        units(report),
        needs(report),
        left_out(report),
        facts(report),
        waves(report),
        verilog(report),
    ];
    sections.join("\n")
}

fn title(report: &Report) -> String {
    let method = report.spec.method();
    format!(
        "# {}, shaded by `{}`\n\n\
         A pipeline of {} clocks that takes a pixel in {}: {}.\n\n\
         Made by Specula {}; `{}` makes the same Verilog.\n",
        report.scene,
        report.method,
        report.latency,
        pace(report.run.bench.design.interval),
        method.summary(),
        report.version,
        report.command
    )
}

fn pace(interval: u32) -> String {
    match interval {
        1 => "every clock".to_owned(),
        clocks => format!("{clocks} clocks, one for each light"),
    }
}

fn result(report: &Report) -> String {
    let verdict = match &report.run.disagreement {
        None => "Every pixel agrees with the bit-true model, each in its clock, every stated fact held, and no quantisation error is above its bound.\n"
            .to_owned(),
        Some(disagreement) => {
            let lines: Vec<String> = disagreement.lines().iter().map(|line| format!("- {line}\n")).collect();
            let verdict = if disagreement.is_bound_only() { "The quantisation error is above its proven bound." } else { "The core does not agree with its models." };
            format!("**{verdict}**\n\n{}", lines.concat())
        }
    };
    let named = |(name, value): (&str, String)| [name.to_owned(), value];
    let (width, height, spans) = (report.width, report.height, report.spans);
    let subject = [
        ("picture", format!("{width} x {height}, {spans} spans")),
        ("pixels shaded", report.pixels.to_string()),
        ("pixels that differ", report.mismatches.to_string()),
    ];
    let engine = ["engine".to_owned(), report.engine.to_owned()];
    let subject = subject.map(named).into_iter().chain(rows::camera(report));
    let rows = rows::sequence(report).into_iter().chain(subject);
    let rows = rows.chain(rows::speed(report)).chain([engine]);
    let rows = rows.chain(rows::stream(report)).chain(rows::made_for(report));
    let rows = rows.chain(rows::device(report));
    let rows: Vec<[String; 2]> = rows.chain(rows::formats(report)).collect();
    format!("## Result\n\n{verdict}\n{}", table(["", ""], &rows))
}

/// The section with the heat map and its scale.
pub fn heat_map() -> String {
    format!("![error]({ERROR})\n")
}

fn pictures() -> String {
    format!(
        "## Pictures\n\n\
         | simulated core | bit-true model | exact shading |\n|---|---|---|\n\
         | ![simulated]({SIMULATED}) | ![expected]({EXPECTED}) | ![exact]({EXACT}) |\n\n{}",
        heat_map()
    )
}

fn errors(report: &Report) -> String {
    let errors = report.error;
    let row = |name: &str, figures: &ErrorFigures| {
        let [largest, rms, mean, psnr] = rows::figures(figures);
        [name.to_owned(), largest, rms, mean, psnr]
    };
    let rows = [
        row("total: the core against exact shading", &errors.total),
        row("method: its method in exact arithmetic against exact shading", &errors.method),
        row("quantisation: the core against its method in exact arithmetic", &errors.quantisation),
    ];
    let worst = report.worst().map(|(worst, cycle)| {
        format!(
            "The largest total error, {:.2} LSB, is at ({}, {}); that pixel leaves in cycle {cycle}. ",
            worst.error_lsb, worst.x, worst.y
        )
    });
    format!(
        "## Errors\n\nIn LSBs of the 8-bit output, over the three channels of all shaded pixels. {}\
         The quantisation error is proven to stay within {}. Half an LSB of it is the rounding to 8 bits.\n\n{}\n{}",
        worst.unwrap_or_default(),
        report.bound_in_words(),
        table(["error", "largest", "rms", "mean", "PSNR in dB"], &rows),
        bound_shares(report)
    )
}

/// How the proven bound compares with the measured error, and where it comes from; empty if there
/// is no bound.
fn bound_shares(report: &Report) -> String {
    let Some(ratio) = report.bound_ratio else { return String::new() };
    let row = |share: &BoundShare| {
        [format!("`{}`", share.name), format!("{:.3}", share.lsb), format!("`{}`", share.value)]
    };
    let rows: Vec<[String; 3]> =
        report.bound_shares.iter().filter(|share| share.lsb >= 0.0005).map(row).collect();
    let text = format!(
        "The bound is {ratio:.1} times the largest quantisation error of this picture. It is for every scene with the same ranges; where formats were\n\
         narrowed for this picture (`--max-error`, `--max-quantisation`, `explore`), only what was measured is within that goal.\n"
    );
    if rows.is_empty() {
        return text;
    }
    let table = table(["narrowing point", "share in LSB", "what is rounded"], &rows);
    format!(
        "{text}\nBy how much the bound would be smaller if one place rounded far finer; shares overlap.\n\n{table}"
    )
}

fn built(report: &Report) -> String {
    let options: Vec<[String; 2]> =
        report.spec.options().into_iter().map(|(name, value)| [name.to_owned(), value]).collect();
    let points: Vec<[String; 4]> = report
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

fn ports_of(report: &Report) -> String {
    let design = &report.run.bench.design;
    let rows: Vec<[String; 9]> = report.ports.iter().map(Port::row).collect();
    let (entering, leaving) = match design.interval {
        1 => ("`valid` is high in each clock in which a pixel enters".to_owned(), "that enters in"),
        clocks => (
            format!("A pixel takes {clocks} clocks, in which `valid` is high"),
            "the last of whose clocks is",
        ),
    };
    format!(
        "## Ports\n\n{}\n\
         {entering}, and `start` in the first clock of a span only. A span's data inputs are held from\n\
         its first clock to its last; between them and between spans there may be clocks in which `valid` is low. A pixel\n\
         {leaving} clock c leaves in clock c + {}, with `valid_out` high.\n{}",
        table(Port::TITLES, &rows),
        design.depth(),
        between_frames(design).map(|rule| format!("{rule}\n")).unwrap_or_default()
    )
}

fn units(report: &Report) -> String {
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
            &units::rows(&report.run.bench.design)
        )
    )
}

/// What the scene's needs save; empty if that is not known.
fn needs(report: &Report) -> String {
    let Some(savings) = report.savings else { return String::new() };
    format!(
        "## What the scene does not need\n\n\
         Measured by elaborating the core without that one need known; savings overlap, and a negative number is what products\n\
         with constants cost in adders in place of multipliers. All together are measured against two general cores, which the table\n\
         names: one that knows nothing of the scene, and one as a renderer would have it, for as many lights, spans as wide as the\n\
         picture and exponents up to 128; neither knows of angles, colours or what inputs are given.\n\n{}",
        table(cmd_needs::TITLES, &cmd_needs::rows(savings))
    )
}

fn left_out(report: &Report) -> String {
    let left_out = &report.run.bench.design.left_out;
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

fn facts(report: &Report) -> String {
    let rows: Vec<[String; 4]> = report.facts.iter().map(Fact::row).collect();
    if rows.is_empty() {
        return "## Facts that were checked\n\nNone had to be assumed: intervals prove every width.\n".to_owned();
    }
    format!(
        "## Facts that were checked\n\nWhat intervals cannot see is stated by the units that rely on it, and was checked in every clock with a pixel. Seen are the\n\
         smallest and the largest value of all these signals in this run.\n\n{}",
        table(["fact", "signal", "must lie in", "seen"], &rows)
    )
}

fn waves(report: &Report) -> String {
    let text = match report.trace {
        None => "None was asked for: `--trace worst` shows the clocks around the pixel with the largest error.\n".to_owned(),
        Some([first, end]) => format!(
            "`{dump}` holds every signal in clocks {first} to {}. The save file opens the interesting ones as fixed-point numbers:\n\n\
             ```sh\ngtkwave {dump} {save}\n```\n",
            end - 1,
            dump = report.run.trace_format.file_name(),
            save = waveform::SAVE_FILE
        ),
    };
    format!("## Waveform\n\n{text}{}", pixel_path(report))
}

/// The section with the picture of a pixel's path through the core, if there is one.
fn pixel_path(report: &Report) -> String {
    if !report.files.iter().any(|file| file == worst_pixel::PICTURE) {
        return String::new();
    }
    let pixel = match &report.run.disagreement {
        None => "the pixel with the largest error",
        Some(disagreement) if disagreement.is_bound_only() => {
            "the pixel whose error is furthest above its bound"
        }
        Some(_) => "the first disagreement",
    };
    format!(
        "\nThe way of {pixel} through the core, its value of each signal marked:\n\n[![way]({file})]({file})\n",
        file = worst_pixel::PICTURE
    )
}

fn verilog(report: &Report) -> String {
    let module = report.module;
    format!(
        "## Verilog\n\n`{module}.v` is the whole core in Verilog-2001. What Specula emits belongs to whoever ran it. To look at it with\nother tools:\n\n\
         ```sh\n\
         verilator --lint-only -Wall {module}.v\n\
         iverilog -g2001 -Wall -t null {module}.v\n\
         yosys -p 'read_verilog {module}.v; synth -top {module}; stat'\n\
         ```\n"
    )
}
