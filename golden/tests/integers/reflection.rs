//! `reflection` on raw values.
use specula_spec::ReflectionSpec;
use specula_spec::reflection::Highlight;

use crate::duff::{cosine, less_light};
use crate::hybrid::{base, quadratic};
use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &ReflectionSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (diffuse_bits, base_bits, cosine_bits) =
        (f.diffuse.fraction_bits, f.base.fraction_bits, f.cosine.fraction_bits);
    let bits = diffuse_bits.max(base_bits).max(f.shape.fraction_bits);
    let operand =
        |name: &str| quadratic(raw, name, i, f.accumulator.fraction_bits, f.operand.fraction_bits);
    let q = operand("denominator");
    let w = reciprocal(q, f.operand.fraction_bits, f.reciprocal.fraction_bits);
    let cosine =
        |p: i128| cosine(p * w, f.operand.fraction_bits + f.reciprocal.fraction_bits, cosine_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let c = cosine(operand(&format!("light{light}_cosine")));
        let base = match spec.specular {
            Highlight::Blinn => {
                round(cosine(operand(&format!("light{light}_halfway"))), cosine_bits, base_bits)
                    .max(0)
            }
            Highlight::Hybrid => base(
                operand(&format!("light{light}_numerator")),
                operand("normal_squared"),
                base_bits,
            ),
            Highlight::Eq34 if q > 0 => less_light(
                raw,
                light,
                2 * cosine(operand("view")) * c,
                2 * cosine_bits,
                cosine_bits,
                base_bits,
            ),
            Highlight::Eq34 => 0,
        };
        let (power, power_bits) = power::raised(raw, base, base_bits, f.shape.fraction_bits);
        terms.push((
            format!("light{light}_diffuse"),
            round(c, cosine_bits, diffuse_bits).max(0) << (bits - diffuse_bits),
        ));
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// 1/q by halving: the w with (2w - 1) q ≤ 2 < (2w + 1) q, from 0 to 4.
fn reciprocal(q: i128, operand: u32, bits: u32) -> i128 {
    if q <= 0 {
        return 0;
    }
    let two = 2_i128 << (bits + operand);
    let (mut low, mut high) = (0, (4 << bits) + 1);
    while high - low > 1 {
        let middle = (low + high) / 2;
        if (2 * middle - 1) * q <= two { low = middle } else { high = middle }
    }
    low
}
