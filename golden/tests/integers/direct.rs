//! `direct` on raw values.
use specula_spec::direct::Root;
use specula_spec::{DirectSpec, Increments};

use crate::duff;
use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &DirectSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (w, p, z) =
        (f.weight.fraction_bits, f.component.fraction_bits, f.length_squared.fraction_bits);
    let (r, x, d, e) = (
        f.reciprocal.fraction_bits,
        f.cosine.fraction_bits,
        f.diffuse.fraction_bits,
        f.base.fraction_bits,
    );
    let (t, q) = t_and_q(spec, raw, i);
    let s = match spec.root {
        Root::Exact => reciprocal_root(at_least(spec, q), z, r),
        Root::Newton => quotient(
            (1, 0),
            (length(spec, raw, i), f.length.fraction_bits),
            f.reciprocal.integer_bits,
            r,
        ),
    };
    let linear = |name: &str| match spec.increments {
        Increments::Multiplied => round(
            (raw.get(&format!("{name}_start")) << w) + t * raw.get(&format!("{name}_delta")),
            p + w,
            x,
        ),
        Increments::Added => duff::linear(raw, name, i, f.scalar_accumulator.fraction_bits, x),
    };
    let cosine = |name: &str| round(linear(name) * s, x + r, x).clamp(-1 << x, 1 << x);
    let view = match spec.root {
        Root::Exact => cosine("view"),
        Root::Newton => {
            let m = f.reciprocal.integer_bits;
            round(linear("view") * quotient((1, 0), (at_least(spec, q), z), 2 * m, r), x + r, x)
                .clamp(-1 << (x + m), 1 << (x + m))
        }
    };
    let bits = d.max(e).max(f.shape.fraction_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let name = format!("light{light}");
        let j = cosine(&name);
        terms.push((format!("light{light}_diffuse"), round(j, x, d).max(0) << (bits - d)));
        let fine = (2 * x).max(p);
        let dot_view = raw.get(&format!("light{light}_dot_view")) << (fine - p);
        let along_light = if spec.root == Root::Newton { linear(&name) } else { j };
        let base = round(((2 * along_light * view) << (fine - 2 * x)) - dot_view, fine, e)
            .clamp(0, 1 << e);
        let b = if q > 0 { base } else { 0 };
        let (power, power_bits) = power::raised(raw, b, e, f.shape.fraction_bits);
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// t and q of pixel `i`.
fn t_and_q(spec: &DirectSpec, raw: &Raw, i: u32) -> (i128, i128) {
    let f = &spec.formats;
    let (w, u) = (f.weight.fraction_bits, f.product.fraction_bits);
    let t = round(i128::from(i) * raw.get("weight_step"), f.weight_accumulator.fraction_bits, w);
    let product = round(t * ((1 << w) - t), 2 * w, u);
    let k = f.spread.fraction_bits + u;
    (t, round((1 << k) - raw.get("spread") * product, k, f.length_squared.fraction_bits))
}

/// q, and 4^-m where it is less.
fn at_least(spec: &DirectSpec, q: i128) -> i128 {
    let f = &spec.formats;
    q.max(1 << (f.length_squared.fraction_bits - 2 * f.reciprocal.integer_bits))
}

/// d of pixel `i`, from 1 on.
fn length(spec: &DirectSpec, raw: &Raw, i: u32) -> i128 {
    let f = &spec.formats;
    let (bits, z) = (f.length.fraction_bits, f.length_squared.fraction_bits);
    (0..=i).fold(1 << bits, |d, pixel| {
        let q = at_least(spec, t_and_q(spec, raw, pixel).1);
        (0..spec.newton_steps).fold(d, |d, _| {
            round(d + quotient((q, z), (d, bits), f.reciprocal.integer_bits, bits), 1, 0)
        })
    })
}

/// p/q to `to` fraction bits, 2^`most` at most; each operand with its own fraction bits.
fn quotient((p, p_bits): (i128, u32), (q, q_bits): (i128, u32), most: u32, to: u32) -> i128 {
    let (p, q) = (p << q_bits, q << p_bits);
    (((p << (to + 1)) + q) / (2 * q)).min(1 << (most + to))
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
