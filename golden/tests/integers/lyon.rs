//! `lyon` on raw values.
use specula_scene::spec::LyonSpec;
use specula_scene::spec::lyon::{Difference, Normalisation};

use crate::raw::{Raw, round};

pub fn code(spec: &LyonSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let (diffuse_bits, shape_bits) = (spec.formats.diffuse.fraction_bits, spec.formats.shape.fraction_bits);
    let (n, z) = normal(spec, raw, i);
    let bits = diffuse_bits.max(shape_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let l = raw.vector(&format!("light{light}_direction"));
        let cosine = round(dot(n, l), 2 * spec.formats.vector.fraction_bits, diffuse_bits).max(0);
        terms.push((format!("light{light}_diffuse"), cosine << (bits - diffuse_bits)));
        // A normal that rounds to nothing has no direction.
        let highlight = if z == 0 { 0 } else { shape(spec, raw, n, light) };
        terms.push((format!("light{light}_specular"), highlight << (bits - shape_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// n and z.
fn normal(spec: &LyonSpec, raw: &Raw, i: u32) -> ([i128; 3], i128) {
    let f = &spec.formats;
    let (v, w, zf, gf) = (f.vector.fraction_bits, f.weight.fraction_bits, f.length_squared.fraction_bits, f.gain.fraction_bits);
    let a = round(i128::from(i) * raw.get("weight_step"), f.weight_accumulator.fraction_bits, w);
    let (start, delta) = (raw.vector("normal_start"), raw.vector("normal_delta"));
    let lerp = [0, 1, 2].map(|c| round((start[c] << w) + a * delta[c], v + w, v));
    let z = round(dot(lerp, lerp), 2 * v, zf);
    let y = (1 << zf) - z;
    let mut g = match spec.normalisation {
        Normalisation::G1 => round((2 << zf) + y, zf + 1, gf),
        Normalisation::G2 => round((2 << (2 * zf)) + (y << zf) + y * y, 2 * zf + 1, gf),
    };
    for _ in 0..spec.newton_steps {
        let square = round(g * g, 2 * gf, gf);
        let factor = round((3 << (zf + gf)) - z * square, zf + gf, gf);
        g = round(g * factor, 2 * gf + 1, gf);
    }
    (lerp.map(|c| round(g * c, gf + v, v)), z)
}

fn shape(spec: &LyonSpec, raw: &Raw, n: [i128; 3], light: usize) -> i128 {
    let (d, s) = (spec.formats.difference.fraction_bits, spec.formats.shape.fraction_bits);
    let difference = match spec.difference {
        Difference::HalfwayCrossNormal => cross_halfway(spec, raw, n, light),
        Difference::ReflectionMinusLight => reflection_minus_light(spec, raw, n, light),
    };
    let x = round(raw.get("shininess") * dot(difference, difference), 2 * d + spec.squarings + 1, s);
    let mut f = ((1 << s) - x).max(0);
    for _ in 0..spec.squarings {
        f = round(f * f, 2 * s, s);
    }
    f
}

fn cross_halfway(spec: &LyonSpec, raw: &Raw, n: [i128; 3], light: usize) -> [i128; 3] {
    let h = raw.vector(&format!("light{light}_halfway"));
    [(1, 2), (2, 0), (0, 1)].map(|(p, q)| {
        let component = h[p] * n[q] - h[q] * n[p];
        round(component, 2 * spec.formats.vector.fraction_bits, spec.formats.difference.fraction_bits)
    })
}

fn reflection_minus_light(spec: &LyonSpec, raw: &Raw, n: [i128; 3], light: usize) -> [i128; 3] {
    let (v, d) = (spec.formats.vector.fraction_bits, spec.formats.difference.fraction_bits);
    let l = raw.vector(&format!("light{light}_direction"));
    let w = round(2 * n[2], v, d);
    let one = 1_i128 << v;
    [0, 1, 2].map(|c| round(w * n[c] - (([0, 0, one][c] + l[c]) << d), v + d, d))
}

fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    (0..3).map(|c| a[c] * b[c]).sum()
}
