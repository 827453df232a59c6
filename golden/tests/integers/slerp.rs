//! `slerp` on raw values.
use specula_spec::SlerpSpec;
use specula_spec::slerp::Form;

use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &SlerpSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (w, x, p) = (f.weight.fraction_bits, f.cosine.fraction_bits, f.component.fraction_bits);
    let (d, e, c) = (f.diffuse.fraction_bits, f.base.fraction_bits, f.vector.fraction_bits);
    let weights = turned(spec, raw, i);
    let normal = (spec.form == Form::Vector).then(|| normal(spec, raw, weights));
    let mixed = |name: &str| match normal {
        Some(n) => round(
            (0..3).map(|k| n[k] * raw.vector(&format!("{name}_direction"))[k]).sum(),
            2 * c,
            x,
        ),
        None => round(
            weights[0] * raw.get(&format!("{name}_start"))
                + weights[1] * raw.get(&format!("{name}_across")),
            w + p,
            x,
        ),
    };
    let k = match normal {
        Some(n) => round(n[2], c, x),
        None => {
            let g = round((2 << (2 * w)) - weights[0].pow(2) - weights[1].pow(2), 2 * w, x);
            round(mixed("view") * g, 2 * x, x)
        }
    };
    let bits = d.max(e).max(f.shape.fraction_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let j = mixed(&format!("light{light}"));
        let diffuse = round(j, x, d).clamp(0, 1 << d);
        // On the finer of the two points.
        let fine = (2 * x).max(p);
        let base = ((2 * j * k) << (fine - 2 * x))
            - (raw.get(&format!("light{light}_dot_view")) << (fine - p));
        let b = round(base, fine, e).clamp(0, 1 << e);
        let (power, power_bits) = power::raised(raw, b, e, f.shape.fraction_bits);
        terms.push((format!("light{light}_diffuse"), diffuse << (bits - d)));
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// The weights of pixel `i`.
fn turned(spec: &SlerpSpec, raw: &Raw, i: u32) -> [i128; 2] {
    let state = if raw.has("turn_back") { &spec.formats.scaled_state } else { &spec.formats.state };
    let (f, t) = (state.fraction_bits, spec.formats.turn.fraction_bits);
    let (cosine, sine) = (raw.get("turn_cosine"), raw.get("turn_sine"));
    let turn = |start: [i128; 2], down: i128, up: i128| {
        (0..i).fold(start, |[c, s], _| {
            [c * cosine - s * down, s * cosine + c * up].map(|x| round(x, f + t, f))
        })
    };
    let weights = if raw.has("turn_back") {
        let back = raw.get("turn_back");
        let [falling, _] = turn([1 << f, raw.get("falling_cosine")], sine, back);
        let [_, rising] = turn([raw.get("rising_cosine"), 0], back, sine);
        [falling, rising]
    } else {
        turn([1 << f, 0], sine, sine)
    };
    weights.map(|x| round(x, f, spec.formats.weight.fraction_bits))
}

/// N (3 - N·N)/2.
fn normal(spec: &SlerpSpec, raw: &Raw, weights: [i128; 2]) -> [i128; 3] {
    let f = &spec.formats;
    let (w, v, x) = (f.weight.fraction_bits, f.vector.fraction_bits, f.cosine.fraction_bits);
    let other = if raw.has("turn_back") { "normal_end" } else { "normal_across" };
    let (a, b) = (raw.vector("normal_start"), raw.vector(other));
    let n = [0, 1, 2].map(|c| round(weights[0] * a[c] + weights[1] * b[c], w + v, v));
    let square: i128 = n.iter().map(|c| c * c).sum();
    let g = round((3 << (2 * v)) - square, 2 * v + 1, x);
    n.map(|c| round(g * c, x + v, v))
}
