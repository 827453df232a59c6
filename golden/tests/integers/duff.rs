//! `duff` on raw values.
use specula_spec::DuffSpec;
use specula_spec::duff::Highlight;

use crate::hybrid::{base, quadratic};
use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &DuffSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (diffuse_bits, base_bits, cosine_bits) =
        (f.diffuse.fraction_bits, f.base.fraction_bits, f.cosine.fraction_bits);
    let bits = diffuse_bits.max(base_bits).max(f.shape.fraction_bits);
    let operand = f.operand.fraction_bits;
    let of_q = |name: &str| quadratic(raw, name, i, f.accumulator.fraction_bits, operand);
    let linear = |name: &str| linear(raw, name, i, f.linear_accumulator.fraction_bits, operand);
    let q = of_q("denominator");
    let s = if q > 0 {
        reciprocal_root(
            q.max(1 << (operand - 2 * f.root.integer_bits)),
            operand,
            f.root.fraction_bits,
        )
    } else {
        0
    };
    let cosine = |p: i128| cosine(p * s, operand + f.root.fraction_bits, cosine_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let p = linear(&format!("light{light}_cosine"));
        let c = cosine(p);
        let base = match spec.specular {
            Highlight::Blinn => {
                round(cosine(linear(&format!("light{light}_halfway"))), cosine_bits, base_bits)
                    .max(0)
            }
            Highlight::Quotient => base(of_q(&format!("light{light}_numerator")), q, base_bits),
            Highlight::Eq33 if q > 0 => {
                let t_bits = f.quotient.fraction_bits;
                let limit = f.root.integer_bits + t_bits;
                let product = 2
                    * linear("view")
                    * nearest_quotient(p, q, t_bits).clamp(-1 << limit, 1 << limit);
                less_light(raw, light, product, operand + t_bits, cosine_bits, base_bits)
            }
            Highlight::Eq34 if q > 0 => {
                let product = 2 * cosine(linear("view")) * c;
                less_light(raw, light, product, 2 * cosine_bits, cosine_bits, base_bits)
            }
            Highlight::Eq33 | Highlight::Eq34 => 0,
        };
        let (power, power_bits) = power::raised(raw, base, base_bits, f.shape.fraction_bits);
        let diffuse = round(c, cosine_bits, diffuse_bits).max(0);
        terms.push((format!("light{light}_diffuse"), diffuse << (bits - diffuse_bits)));
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// By repeated addition.
pub fn linear(raw: &Raw, name: &str, i: u32, from: u32, to: u32) -> i128 {
    let (start, step) = (raw.get(&format!("{name}_start")), raw.get(&format!("{name}_step")));
    round((0..i).fold(start, |value, _| value + step), from, to)
}

/// A product with `from` bits as a cosine.
pub fn cosine(product: i128, from: u32, to: u32) -> i128 {
    round(product, from, to).clamp(-1 << to, 1 << to)
}

/// A product with `from` bits less L·V, from 0 to 1.
pub fn less_light(
    raw: &Raw,
    light: usize,
    product: i128,
    from: u32,
    cosine_bits: u32,
    to: u32,
) -> i128 {
    let light_dot_view = raw.get(&format!("light{light}_dot_view"));
    let bits = from.max(cosine_bits);
    let difference = (product << (bits - from)) - (light_dot_view << (bits - cosine_bits));
    round(difference, bits, to).clamp(0, 1 << to)
}

/// The s with (s - 1/2)² q ≤ 2^(2 root) < (s + 1/2)² q, found by halving.
fn reciprocal_root(q: i128, operand: u32, root: u32) -> i128 {
    let one = 1_i128 << (2 * root + 2 + operand);
    let (mut low, mut high) = (0_i128, 1_i128 << (root + 14));
    while high - low > 1 {
        let middle = (low + high) / 2;
        if (2 * middle - 1).pow(2) * q <= one { low = middle } else { high = middle }
    }
    low
}

/// floor(p/q · 2^bits + 1/2).
fn nearest_quotient(p: i128, q: i128, bits: u32) -> i128 {
    let below = (p << bits).div_euclid(q);
    let rest = (p << bits) - below * q;
    if 2 * rest >= q { below + 1 } else { below }
}
