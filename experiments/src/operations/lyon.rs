//! The multipliers of figures 7 and 8, compared with those of the core [Lyon, TR 43].
use specula_datapath::Design;
use specula_scene::{Frame, Needs};
use specula_spec::Method;

use super::general_core;
use specula_testbench::BenchError;

/// A datapath of the report: options and formats of `lyon`, and its k.
#[derive(Clone, Copy, Debug)]
pub struct Datapath {
    /// Lines of `lyon`'s table.
    pub table: &'static str,
    /// The number k of squarings.
    pub squarings: u32,
}

/// Figure 7 with g2 and 10 fraction bits everywhere.
pub const FIGURE_7: Datapath = Datapath {
    table: "difference = \"reflection-minus-light\"\nnormalisation = \"g2\"\nnewton_steps = 0\nsquarings = 2\n\
            formats.weight = \"U1.10\"\nformats.vector = \"S1.10\"\nformats.length_squared = \"U1.10\"\nformats.gain = \"U2.10\"\n\
            formats.difference = \"S2.10\"\nformats.shape = \"U1.10\"\n",
    squarings: 2,
};

/// Figure 8 after exact normalisation: vectors and D with 10 fraction bits, m D with 9.
pub const FIGURE_8: Datapath = Datapath {
    table: "difference = \"reflection-minus-light\"\nnormalisation = \"exact\"\nshape = \"root\"\nsquarings = 1\n\
            formats.weight = \"U1.10\"\nformats.vector = \"S1.10\"\nformats.length_squared = \"U1.14\"\nformats.gain = \"U2.14\"\n\
            formats.difference = \"S2.10\"\nformats.scaled_difference = \"U8.9\"\nformats.shape = \"U1.16\"\n",
    squarings: 1,
};

/// A part of a figure, and the part of the core that corresponds to it.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Its figure, by number and letter.
    pub figure: &'static str,
    /// The factors.
    pub product: &'static str,
    /// The report's words about it.
    pub printed: &'static str,
    /// The unit of the core that contains it.
    pub unit: &'static str,
    /// Widths of the operands, including signs, for each multiplier of the core.
    pub core: &'static [[u32; 2]],
    /// Why the core differs from what is printed.
    pub why: &'static str,
}

/// The parts that have multipliers; those of one unit are in its order.
pub const PARTS: [Part; 9] = [
    part(
        "7a",
        "(1 − a) N0 + a N1",
        "6, \"might merge\"",
        "interpolate",
        &[[13, 11]; 3],
        "N0 + a (N1 − N0)",
    ),
    part("7a", "N'·N', y², g N'", "3, 1, 3", "normalise", &[[12, 12]; 7], ""),
    part(
        "7b",
        "N·V, 2(N·V) N",
        "3, 3",
        "reflection_minus_light",
        &[[12, 12]; 3],
        "V = (0, 0, 1), so N·V is Nz",
    ),
    part("7c", "D·D", "three 12 × 12", "shape", &[[13, 13]; 3], "D = ±2.0 where L = −R: S2.10"),
    part(
        "7c",
        "n D·D",
        "one 14 × 22",
        "shape",
        &[[23, 13]],
        "4.0 = D·D has a bit more; n up to 8000 takes 13, without sign",
    ),
    part("7d", "squarings", "two", "shape", &[[11, 11]; 2], ""),
    part(
        "8",
        "m \\|D\\|",
        "three 7 × 11",
        "root_shape",
        &[[12, 7]; 3],
        "\\|D\\| = 2.0 has a bit more",
    ),
    part("8", "m D·m D", "three 9 × 9", "root_shape", &[[9, 9]; 3], ""),
    part("8", "squaring", "one", "root_shape", &[[17, 17]], ""),
];

const fn part(
    figure: &'static str,
    product: &'static str,
    printed: &'static str,
    unit: &'static str,
    core: &'static [[u32; 2]],
    why: &'static str,
) -> Part {
    Part { figure, product, printed, unit, core, why }
}

impl Part {
    /// The general core that has the part, for n from 1 to 8000 and with the whole m of figure 8.
    ///
    /// # Errors
    /// [`BenchError`] if it cannot be built for the frame.
    pub fn design(&self, frame: &Frame) -> Result<Design, BenchError> {
        let needs = Needs { smallest_shininess: 1, largest_shininess: 8000, ..Needs::of(frame) };
        let (datapath, further) = match self.figure {
            "8" => (FIGURE_8, "formats.root_shininess = \"U7.0\"\n"),
            _ => (FIGURE_7, ""),
        };
        general_core(&needs, Method::Lyon, &format!("[lyon]\n{}{further}", datapath.table))
    }
}
