//! `direct` on raw values.
use specula_scene::spec::DirectSpec;

use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &DirectSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (w, u, p, z) = (f.weight.fraction_bits, f.product.fraction_bits, f.component.fraction_bits, f.length_squared.fraction_bits);
    let (r, x, d, e) = (f.reciprocal.fraction_bits, f.cosine.fraction_bits, f.diffuse.fraction_bits, f.base.fraction_bits);
    let t = round(i128::from(i) * raw.get("weight_step"), f.weight_accumulator.fraction_bits, w);
    let product = round(t * ((1 << w) - t), 2 * w, u);
    let k = f.spread.fraction_bits + u;
    let q = round((1 << k) - raw.get("spread") * product, k, z);
    let s = reciprocal_root(q.max(1 << (z - 2 * f.reciprocal.integer_bits)), z, r);
    let cosine = |name: &str| {
        let linear = (raw.get(&format!("{name}_start")) << w) + t * raw.get(&format!("{name}_delta"));
        round(round(linear, p + w, x) * s, x + r, x).clamp(-1 << x, 1 << x)
    };
    let bits = d.max(e).max(f.shape.fraction_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let j = cosine(&format!("light{light}"));
        terms.push((format!("light{light}_diffuse"), round(j, x, d).max(0) << (bits - d)));
        let fine = (2 * x).max(p);
        let dot_view = raw.get(&format!("light{light}_dot_view")) << (fine - p);
        let base = round(((2 * j * cosine("view")) << (fine - 2 * x)) - dot_view, fine, e).clamp(0, 1 << e);
        let b = if q > 0 { base } else { 0 };
        let (power, power_bits) = power::raised(raw, b, e, f.shape.fraction_bits);
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// The greatest s of `to` fraction bits with (s - 1/2)² q ≤ 1, by halving; q has `from`.
fn reciprocal_root(q: i128, from: u32, to: u32) -> i128 {
    let one = 1_i128 << (2 * to + 2 + from);
    let (mut low, mut high) = (0, 1_i128 << (to + 5));
    while high - low > 1 {
        let middle = (low + high) / 2;
        if (2 * middle - 1).pow(2) * q <= one { low = middle } else { high = middle }
    }
    low
}
