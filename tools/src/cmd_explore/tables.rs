//! The front of a search as tables.
use specula_experiments::explore::{Exploration, Explored};

use crate::clock::Clock;
use crate::table;

/// Titles of [`for_any_device`].
const TITLES: [&str; 9] = [
    "",
    "error in LSB",
    "cells",
    "multiplier bits",
    "blocks",
    "adder bits",
    "register bits",
    "frames/s",
    "core",
];

/// The front of cores for any device, at one clock.
pub fn for_any_device(exploration: &Exploration, clock: Clock) -> String {
    let row = |core: &Explored| {
        let Explored { core: name, error, cost, cycles, .. } = core;
        [
            format!("{error:.3}"),
            cost.cells().to_string(),
            cost.multiplier_bits.to_string(),
            cost.blocks.map_or("-".to_owned(), |blocks| blocks.to_string()),
            cost.adder_bits.to_string(),
            cost.register_bits.to_string(),
            format!("{:.0}", clock.frames_per_second(cycles)),
            name.clone(),
        ]
    };
    with_best(exploration, TITLES, row)
}

/// Titles of [`on_target`].
const TARGET_TITLES: [&str; 9] = [
    "",
    "error in LSB",
    "cells",
    "look-up tables",
    "flip-flops",
    "blocks",
    "MHz",
    "frames/s",
    "core",
];

/// The front of cores that are made for a target, each at its own clock.
pub fn on_target(exploration: &Exploration) -> String {
    let row = |core: &Explored| {
        let Explored { core: name, error, cycles, on_target, .. } = core;
        let on = on_target.unwrap_or_default();
        let clock = Clock::predicted(on.predicted_mhz);
        [
            format!("{error:.3}"),
            on.cells.to_string(),
            on.resources.luts.to_string(),
            on.resources.flip_flops.to_string(),
            on.resources.blocks.to_string(),
            format!("{:.0}", clock.mhz),
            format!("{:.0}", clock.frames_per_second(cycles)),
            name.clone(),
        ]
    };
    with_best(exploration, TARGET_TITLES, row)
}

/// The front with its titles, and a mark at the best core.
fn with_best(
    exploration: &Exploration,
    titles: [&str; 9],
    row: impl Fn(&Explored) -> [String; 8],
) -> String {
    let mark = |index| if exploration.best == Some(index) { "best" } else { "" };
    let marked = exploration.front.iter().enumerate().map(|(index, core)| {
        let [error, cells, a, b, c, d, frames, name] = row(core);
        [mark(index).to_owned(), error, cells, a, b, c, d, frames, name]
    });
    let rows: Vec<[String; 9]> = [titles.map(str::to_owned)].into_iter().chain(marked).collect();
    table::shown(&rows)
}
