//! `consistent` on raw values.
use specula_spec::ConsistentSpec;
use specula_spec::consistent::{Curve, Diffuse, Highlight};

use crate::power;
use crate::raw::{Raw, round};

/// A reflection: b, g, r.
type Reflection = (i128, i128, [i128; 3]);

pub fn code(spec: &ConsistentSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (diffuse_bits, base_bits, v) =
        (f.diffuse.fraction_bits, f.base.fraction_bits, f.vector.fraction_bits);
    let bits = diffuse_bits.max(base_bits).max(f.shape.fraction_bits);
    let (n, z) = normal(spec, raw, i);
    let q = contraction(spec, raw, i);
    let (_, _, r) = reflection(spec, n, q, [0, 0, 1 << v]);
    let mut terms = Vec::new();
    for light in 0..lights {
        let l = raw.vector(&format!("light{light}_direction"));
        let diffuse = match spec.diffuse {
            Diffuse::Lambert => round(dot(n, l), 2 * v, diffuse_bits).clamp(0, 1 << diffuse_bits),
            Diffuse::Consistent if z == 0 => 0,
            Diffuse::Consistent => lit(spec, reflection(spec, n, q, l), l, diffuse_bits),
        };
        terms.push((format!("light{light}_diffuse"), diffuse << (bits - diffuse_bits)));
        let base = match spec.highlight {
            _ if z == 0 => 0,
            Highlight::Reflection => round(dot(r, l), 2 * v, base_bits).clamp(0, 1 << base_bits),
            Highlight::Blinn => {
                let h = raw.vector(&format!("light{light}_halfway"));
                lit(spec, reflection(spec, n, q, h), h, base_bits)
            }
        };
        let (power, power_bits) = power::raised(raw, base, base_bits, f.shape.fraction_bits);
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// n and z.
fn normal(spec: &ConsistentSpec, raw: &Raw, i: u32) -> ([i128; 3], i128) {
    let f = &spec.formats;
    let (v, w, zf, gf) = (
        f.vector.fraction_bits,
        f.weight.fraction_bits,
        f.length_squared.fraction_bits,
        f.gain.fraction_bits,
    );
    let a = round(i128::from(i) * raw.get("weight_step"), f.weight_accumulator.fraction_bits, w);
    let (start, delta) = (raw.vector("normal_start"), raw.vector("normal_delta"));
    let lerp = [0, 1, 2].map(|c| round((start[c] << w) + a * delta[c], v + w, v));
    let z = round(dot(lerp, lerp), 2 * v, zf);
    // In units of 2^-(zf + 8), where 4^-4 is whole: the greatest g with (2g - 1)² z ≤ 4 · 2^2gf, by
    // bisection.
    let limited = (z << 8).max(1 << zf);
    let not_above = |g: i128| (2 * g - 1).pow(2) * limited <= 1 << (2 * gf + 2 + zf + 8);
    let gain = greatest(1 << (gf + 4), not_above);
    (lerp.map(|c| round(gain * c, gf + v, v)), z)
}

/// The greatest number from 0 to `most` for which `holds`, which holds for 0 and stops once.
fn greatest(most: i128, holds: impl Fn(i128) -> bool) -> i128 {
    let (mut low, mut high) = (0, most + 1);
    while high - low > 1 {
        let middle = (low + high) / 2;
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}

fn contraction(spec: &ConsistentSpec, raw: &Raw, i: u32) -> i128 {
    let f = &spec.formats;
    let (af, cf) = (f.angle.fraction_bits, f.contraction.fraction_bits);
    let accumulated = raw.get("angle_start") + i128::from(i) * raw.get("angle_step");
    let t = up(accumulated, f.angle_accumulator.fraction_bits, af).min(1 << af);
    let u = (1 << af) - t;
    match spec.curve {
        // u²/(1 + 1169 t/1024), u² in units of 2^-2af, the divisor in units of 2^-(af + 10).
        Curve::Rational => ((u * u) << (cf + 10)) / (((1 << (af + 10)) + 1169 * t) << af),
        Curve::Trigonometric => {
            let tangent = tangent(u, af, f.tangent.fraction_bits);
            down(tangent * tangent, 2 * f.tangent.fraction_bits, cf)
        }
    }
}

fn tangent(u: i128, af: u32, tf: u32) -> i128 {
    let one = 1 << tf;
    let v = down(u * u, 2 * af, tf);
    // Twenty places of s and twice tf of v · h, all in units of 2^-(20 + 2 tf).
    let mut h = up(5363, 20, tf);
    for s in [13_064, 55_803, 225_028] {
        h = up((s << (2 * tf)) + ((v * h) << 20), 20 + 2 * tf, tf);
    }
    let w = up((one - v) * h, 2 * tf, tf);
    down(u * (one - w), af + tf, tf)
}

fn reflection(spec: &ConsistentSpec, n: [i128; 3], q: i128, incoming: [i128; 3]) -> Reflection {
    let f = &spec.formats;
    let (v, qf, c) = (f.vector.fraction_bits, f.contraction.fraction_bits, f.cosine.fraction_bits);
    let (sf, rf) = (f.sine_ratio_squared.fraction_bits, f.sine_ratio.fraction_bits);
    let one = 1 << c;
    let b = round(dot(n, incoming), 2 * v, c).clamp(-one, one);
    let g = round((1 << (qf + c)) + q * (b - one), qf + c, c);
    let s = ratio(q * (one + g), (one + b) << qf, sf);
    // (2ρ - 1)² ≤ 4s, in units of 2^-2rf or 2^-sf, whichever are finer.
    let finer = sf.max(2 * rf);
    let not_above =
        |rho: i128| rho == 0 || (2 * rho - 1).pow(2) << (finer - 2 * rf) <= (4 * s) << (finer - sf);
    let rho = greatest(1 << rf, not_above);
    let m = round((g << rf) + rho * b, rf + c, c);
    let r = [0, 1, 2].map(|k| {
        let (with_normal, with_incoming) = (m * n[k], rho * incoming[k]);
        // Units of 2^-(c + v) and 2^-(rf + v).
        round((with_normal << rf) - (with_incoming << c), c + v + rf, v)
    });
    (b, g, r)
}

/// p/q to so many bits, 0 where either is 0 and 1 at most.
fn ratio(p: i128, q: i128, bits: u32) -> i128 {
    if p <= 0 || q <= 0 {
        return 0;
    }
    let below = (p << bits) / q;
    let rest = (p << bits) - below * q;
    (if 2 * rest >= q { below + 1 } else { below }).min(1 << bits)
}

/// |L + r|/2, 0 to 1, with `d` bits.
fn lit(spec: &ConsistentSpec, (b, g, r): Reflection, l: [i128; 3], d: u32) -> i128 {
    let v = spec.formats.vector.fraction_bits;
    if g + b <= 0 {
        return 0;
    }
    let sum = [0, 1, 2].map(|c| l[c] + r[c]);
    // (2d - 1)² ≤ 4 |L + r|²/4.
    let squared = dot(sum, sum);
    let finer = v.max(d);
    let not_above =
        |x: i128| x == 0 || (2 * x - 1).pow(2) << (2 * (finer - d)) <= squared << (2 * (finer - v));
    greatest(1 << d, not_above)
}

fn down(raw: i128, from: u32, to: u32) -> i128 {
    if to >= from { raw << (to - from) } else { raw >> (from - to) }
}

fn up(raw: i128, from: u32, to: u32) -> i128 {
    -down(-raw, from, to)
}

fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    (0..3).map(|c| a[c] * b[c]).sum()
}
