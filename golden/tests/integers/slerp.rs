//! `slerp` on raw values.
use specula_scene::spec::SlerpSpec;

use crate::power;
use crate::raw::{Raw, round};

pub fn code(spec: &SlerpSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (w, x, p) = (f.weight.fraction_bits, f.cosine.fraction_bits, f.component.fraction_bits);
    let (d, e) = (f.diffuse.fraction_bits, f.base.fraction_bits);
    let weights = turned(spec, raw, i).map(|x| round(x, f.state.fraction_bits, w));
    let mixed = |name: &str| {
        let sum = weights[0] * raw.get(&format!("{name}_start")) + weights[1] * raw.get(&format!("{name}_across"));
        round(sum, w + p, x)
    };
    let g = round((2 << (2 * w)) - weights[0].pow(2) - weights[1].pow(2), 2 * w, x);
    let k = round(mixed("view") * g, 2 * x, x);
    let bits = d.max(e).max(f.shape.fraction_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let j = mixed(&format!("light{light}"));
        let diffuse = round(j, x, d).clamp(0, 1 << d);
        // On the finer of the two points.
        let fine = (2 * x).max(p);
        let base = ((2 * j * k) << (fine - 2 * x)) - (raw.get(&format!("light{light}_dot_view")) << (fine - p));
        let b = round(base, fine, e).clamp(0, 1 << e);
        let (power, power_bits) = power::raised(raw, b, e, f.shape.fraction_bits);
        terms.push((format!("light{light}_diffuse"), diffuse << (bits - d)));
        terms.push((format!("light{light}_specular"), power << (bits - power_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// c and s of pixel `i`.
fn turned(spec: &SlerpSpec, raw: &Raw, i: u32) -> [i128; 2] {
    let (f, t) = (spec.formats.state.fraction_bits, spec.formats.turn.fraction_bits);
    let (cosine, sine) = (raw.get("turn_cosine"), raw.get("turn_sine"));
    (0..i).fold([1 << f, 0], |[c, s], _| [c * cosine - s * sine, s * cosine + c * sine].map(|x| round(x, f + t, f)))
}
