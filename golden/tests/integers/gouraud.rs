//! `gouraud` on raw values.
use specula_spec::GouraudSpec;
use specula_spec::gouraud::Interpolation;

use crate::raw::{Raw, round};

pub fn code(spec: &GouraudSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let names = (0..lights)
        .flat_map(|light| ["diffuse", "specular"].map(|kind| format!("light{light}_{kind}")));
    let terms: Vec<_> = names.map(|name| (name.clone(), intensity(spec, raw, &name, i))).collect();
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, spec.formats.intensity.fraction_bits))
}

fn intensity(spec: &GouraudSpec, raw: &Raw, name: &str, i: u32) -> i128 {
    let bits = spec.formats.intensity.fraction_bits;
    match spec.interpolation {
        Interpolation::Uniform => raw.get(&format!("{name}_intensity")),
        Interpolation::Linear => {
            let (start, step) = (
                raw.get(&format!("{name}_intensity_start")),
                raw.get(&format!("{name}_intensity_step")),
            );
            let sum = (0..i).fold(start, |sum, _| sum + step);
            round(sum, spec.formats.accumulator.fraction_bits, bits).clamp(0, 1 << bits)
        }
    }
}
