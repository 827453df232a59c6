//! The page with the counts and the verdicts.
use std::fmt::Write as _;

use specula_experiments::reproduce::gates::{
    CLAIMS, CONTENDERS, Contender, EqualCore, Measure, SizeClaim,
};

use super::counted::Case;
use crate::cmd_reproduce::section::written;
use crate::table;

/// How the page begins.
pub const HEAD: &str = "\
# Is Lyon's reformulation simpler hardware?

Written by `specula reproduce gates`. Lyon concludes that shading by the distance of R and L, in place of their dot product, \"leads to a
simpler hardware implementation with less numerical difficulty\". Here are cores of both, counted.
";

const METHOD: &str = "\
Every core is in the coarsest formats that were found to keep its quantisation error, against its own formulas in exact arithmetic, within
the same limit at every pixel (as `--max-quantisation` finds them). What the formulas themselves change is in the column *by design*: the
largest difference to exact Phong shading before anything is rounded; no format lowers it. Cores for any scene have their constants as inputs.

*Two-input gates* are NAND gates and inverters (Yosys, `abc -g NAND`), with multipliers and tables as gates and without flip-flops: a chip of
Lyon's day. *LUTs alone* are look-up tables of four inputs without carry chains. *LUTs beside blocks* and *blocks* are an ECP5's (`synth_ecp5`), with
multipliers of 18 × 18 bits: today. *Multiplier bits* are the products of the operands' widths, summed. Every operator has a register behind
it, so flip-flops are those of a pipeline of one pixel a clock; delay lines are counted as flip-flops.
";

/// The page for a scene, on which quantisation errors are `most` LSBs at most.
pub fn of(scene: &str, most: f64, cases: &[Case], synthesiser: &str) -> String {
    let mut text = format!(
        "{HEAD}\n{METHOD}\nScene: {scene}; quantisation errors of {} LSB at most. Counted by {synthesiser}; made by Specula {}.\n\n{}\n## Verdicts\n\n\
         A claim holds where its ratio is below 1.\n\n{}\n",
        written(most),
        env!("CARGO_PKG_VERSION"),
        contenders(),
        claims(cases)
    );
    for case in cases {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "## For {}\n\n{}\n{}", case.title, sizes(case), formats(case));
    }
    text.trim_end().to_owned() + "\n"
}

fn contenders() -> String {
    let rows = CONTENDERS.map(|Contender { name, what, .. }| [name, what].map(str::to_owned));
    table::markdown(["core", "what it computes"], &rows)
}

/// The claims: a ratio for each case, and the verdict over all of them.
fn claims(cases: &[Case]) -> String {
    let heads = cases.iter().map(|case| case.title.clone());
    let titles: Vec<String> = ["claim", "ratio"]
        .map(str::to_owned)
        .into_iter()
        .chain(heads)
        .chain(["verdict".to_owned()])
        .collect();
    let row = |claim: &SizeClaim| -> Vec<String> {
        let ratios: Vec<Option<f64>> = cases.iter().map(|case| claim.ratio(&case.counts)).collect();
        let shown = ratios
            .iter()
            .map(|ratio| ratio.map_or("–".to_owned(), |ratio| format!("{ratio:.2}")));
        let what = if claim.what.is_empty() { "″" } else { claim.what };
        [what, claim.quantity]
            .map(str::to_owned)
            .into_iter()
            .chain(shown)
            .chain([verdict(&ratios)])
            .collect()
    };
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = format!("|{}\n", "---|".repeat(titles.len()));
    let rows: String = CLAIMS.iter().map(|claim| line(&row(claim))).collect();
    line(&titles) + &rule + &rows
}

fn verdict(ratios: &[Option<f64>]) -> String {
    let known: Vec<f64> = ratios.iter().flatten().copied().collect();
    match (known.iter().filter(|ratio| **ratio < 1.0).count(), known.len()) {
        (_, 0) => "nothing to compare".to_owned(),
        (held, all) if held == all => "holds".to_owned(),
        (0, _) => "does not hold".to_owned(),
        (held, all) => format!("holds in {held} of {all}"),
    }
}

fn sizes(case: &Case) -> String {
    let titles = Measure::ALL.map(|measure| measure.title);
    let [a, b, c, d, e, f, g, h] = titles;
    let rows: Vec<[String; 11]> = CONTENDERS
        .iter()
        .zip(&case.cores)
        .zip(&case.counts)
        .map(|((contender, core), counts)| {
            let [a, b, c, d, e, f, g, h] =
                Measure::ALL.map(|measure| (measure.of)(counts).to_string());
            let EqualCore { method_lsb, quantisation_lsb, .. } = core;
            let [by_design, quantisation] = [method_lsb, quantisation_lsb].map(|lsb| written(*lsb));
            [contender.name.to_owned(), by_design, quantisation, a, b, c, d, e, f, g, h]
        })
        .collect();
    table::markdown(["core", "by design, LSB", "quantisation, LSB", a, b, c, d, e, f, g, h], &rows)
}

/// The formats of each core, so that bits can be compared.
fn formats(case: &Case) -> String {
    let list = |core: &EqualCore| {
        let points = core.spec.narrowing_points();
        let formats: Vec<String> =
            points.iter().map(|point| format!("{} {}", point.name, point.format)).collect();
        formats.join(", ")
    };
    let line = |(contender, core): (&Contender, &EqualCore)| {
        format!("- {}: {}.\n", contender.name, list(core))
    };
    format!("Formats:\n\n{}", CONTENDERS.iter().zip(&case.cores).map(line).collect::<String>())
}
