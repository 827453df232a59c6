//! `hybrid` on raw values.
use specula_spec::HybridSpec;

use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &HybridSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let (diffuse_bits, base_bits) =
        (spec.formats.diffuse.fraction_bits, spec.formats.base.fraction_bits);
    let bits = diffuse_bits.max(base_bits).max(spec.formats.shape.fraction_bits);
    let operand = |name: &str| {
        quadratic(
            raw,
            name,
            i,
            spec.formats.accumulator.fraction_bits,
            spec.formats.operand.fraction_bits,
        )
    };
    let q = operand("denominator");
    let mut terms = Vec::new();
    for light in 0..lights {
        let p = operand(&format!("light{light}_numerator"));
        let b = base(p, q, base_bits);
        let (power, power_bits) =
            power::raised(raw, b, base_bits, spec.formats.shape.fraction_bits);
        terms.push((
            format!("light{light}_diffuse"),
            diffuse(spec, raw, light, i) << (bits - diffuse_bits),
        ));
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// By repeated addition, as Hast's loop has it.
pub fn quadratic(raw: &Raw, name: &str, i: u32, from: u32, to: u32) -> i128 {
    let mut value = raw.get(&format!("{name}_start"));
    let mut difference = raw.get(&format!("{name}_first_difference"));
    let second_difference = raw.get(&format!("{name}_second_difference"));
    for _ in 0..i {
        value += difference;
        difference += second_difference;
    }
    round(value, from, to)
}

/// The one b with b - 1/2 ≤ p/q · 2^bits < b + 1/2.
pub fn base(p: i128, q: i128, bits: u32) -> i128 {
    if p <= 0 || q <= 0 {
        return 0;
    }
    if p >= q {
        return 1 << bits;
    }
    let below = (p << bits) / q;
    let rest = (p << bits) - below * q;
    if 2 * rest >= q { below + 1 } else { below }
}

fn diffuse(spec: &HybridSpec, raw: &Raw, light: usize, i: u32) -> i128 {
    let start = raw.get(&format!("light{light}_intensity_start"));
    let accumulated = start + i128::from(i) * raw.get(&format!("light{light}_intensity_step"));
    let bits = spec.formats.diffuse.fraction_bits;
    round(accumulated, spec.formats.diffuse_accumulator.fraction_bits, bits).clamp(0, 1 << bits)
}
