//! What the data sheet says of a core.
use std::fmt::Write;

use specula_datapath::resources::Resources;
use specula_datapath::target::Target;
use specula_datapath::timing::Timing;

use super::StreamCore;
use super::packet_table::packet_table;
use super::register_table::{frame_rules, register_table};
use super::template::Values;

/// Adds what the data sheet's template asks for besides.
pub fn values(core: &StreamCore, values: &mut Values) {
    let (spec, design) = (core.spec, core.design);
    let method = spec.method();
    values.set("METHOD", method.name());
    values.set("SUMMARY", method.summary());
    values.set("LATENCY", design.latency());
    values.set("TOTAL_LATENCY", core.first_pixel());
    let bound = design.error_bound();
    values.set(
        "BOUND",
        if bound.is_finite() {
            format!("{bound:.3} LSB")
        } else {
            "no known number of LSBs".into()
        },
    );
    values.set("BITS", core.layout.bits);
    values.set("FULL_SPEED", (core.words() + 1).div_ceil(design.interval));
    values.set("PACKET_TABLE", packet_table(core));
    values.set("REGISTER_TABLE", register_table(core));
    values.set("FRAME_RULES", frame_rules(core));
    values.set("OPTIONS_TABLE", options_table(core));
    values.set("FORMAT_TABLE", format_table(core));
    size(core, values);
    clock(core, values);
}

/// The method's options.
fn options_table(core: &StreamCore) -> String {
    let rows = core.spec.options().into_iter().map(|(name, value)| [format!("`{name}`"), value]);
    table(["option", "value"], rows)
}

/// Every place where the core rounds.
fn format_table(core: &StreamCore) -> String {
    let points = core.spec.narrowing_points();
    let rows = points
        .iter()
        .map(|point| [format!("`{}`", point.name), point.format.to_string(), point.value.into()]);
    table(["rounded value", "format", "what it is"], rows)
}

/// A table; nothing if it has no rows.
fn table<const N: usize>(
    titles: [&str; N],
    rows: impl ExactSizeIterator<Item = [String; N]>,
) -> String {
    if rows.len() == 0 {
        return String::new();
    }
    let mut text = format!("| {} |\n|{}\n", titles.join(" | "), "---|".repeat(N));
    for row in rows {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    text
}

/// Cells that the core takes.
fn size(core: &StreamCore, values: &mut Values) {
    let of_core = core.spec.target.as_ref().and_then(|target| target.target().ok());
    let is_own = of_core.is_some();
    let Some(target) = of_core.or_else(|| Target::named(FOR_ANY_DEVICE)) else { return };
    let Resources { luts, flip_flops, blocks, memories, .. } = Resources::of(core.design, &target);
    let cells = format!(
        "{luts} look-up tables, {flip_flops} flip-flops, {blocks} multiplier blocks, {memories} \
         block RAMs of {}",
        target.part
    );
    let about = if is_own {
        format!("Specula estimates {cells} for the core alone, by the rules of Yosys's mapping.")
    } else {
        format!(
            "The core is made for any device: products are plain `*`, from which tools make \
             multiplier blocks.\nSpecula estimates {cells} for the core alone."
        )
    };
    values.set("SIZE", cells);
    values.set("SIZE_ABOUT", about);
}

/// The target on which a core for any device is estimated, as it is synthesised.
const FOR_ANY_DEVICE: &str = "ecp5";

/// The clock that the core was made for, and the predicted one.
fn clock(core: &StreamCore, values: &mut Values) {
    let made_for = core.spec.target.as_ref();
    let predicted = made_for.and_then(|clock| {
        let target = clock.target().ok()?;
        let mhz = Timing::of(core.design, &target)?.mhz();
        Some((clock.clock_mhz, mhz, target))
    });
    let (row, about) = match predicted {
        Some((asked, mhz, Target { name, part, .. })) => (
            format!("{mhz:.1} MHz predicted on {part}"),
            format!(
                "The core's pipeline was scheduled for {asked} MHz on `{name}` ({part}). The delays \
                 of that device\npredict {mhz:.1} MHz for the core; `specula synth` measures what \
                 place-and-route reaches."
            ),
        ),
        None => (
            "not scheduled for a device".to_owned(),
            "The core has a register behind every operator and was scheduled for no device; \
             `--target` makes a core\nfor a device's clock."
                .to_owned(),
        ),
    };
    values.set("CLOCK", row);
    values.set("CLOCK_ABOUT", about);
}
