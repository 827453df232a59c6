//! `lyon` on raw values.
use specula_spec::LyonSpec;
use specula_spec::lyon::{Difference, Normalisation, Normals, ShapeDatapath};

use crate::along;
use crate::raw::{Raw, round};

pub fn code(spec: &LyonSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let (diffuse_bits, shape_bits) =
        (spec.formats.diffuse.fraction_bits, spec.formats.shape.fraction_bits);
    let (n, has_direction) = normal(spec, raw, i);
    let bits = diffuse_bits.max(shape_bits);
    let mut terms = Vec::new();
    for light in 0..lights {
        let l = raw.vector(&format!("light{light}_direction"));
        let bits_of_product = 2 * spec.formats.vector.fraction_bits;
        let cosine =
            round(truncated_dot(spec, n, l, bits_of_product), bits_of_product, diffuse_bits);
        let cosine = cosine.max(0);
        terms.push((format!("light{light}_diffuse"), cosine << (bits - diffuse_bits)));
        // A normal that rounds to nothing has no direction.
        let highlight = if has_direction { shape(spec, raw, n, light) } else { 0 };
        terms.push((format!("light{light}_specular"), highlight << (bits - shape_bits)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

/// n, and whether it has a direction.
fn normal(spec: &LyonSpec, raw: &Raw, i: u32) -> ([i128; 3], bool) {
    let f = &spec.formats;
    if spec.normals == Normals::Flat {
        let n = raw.vector("normal");
        return (n, n != [0; 3]);
    }
    let (v, zf, gf) =
        (f.vector.fraction_bits, f.length_squared.fraction_bits, f.gain.fraction_bits);
    let start = if raw.has("wrap_start_x") { "wrap_start" } else { "normal_start" };
    let formats = [f.weight_accumulator, f.weight, f.normal_accumulator, f.vector];
    let interpolated = |i: u32| along::vector(raw, [start, "normal"], i, formats);
    let lerp = interpolated(i);
    if raw.has("wrap_follows") {
        let axis = raw.vector("wrap_axis");
        let from = if raw.get("wrap_follows") == 1 { 0 } else { i };
        let n = (from..=i).fold(axis, |before, i| follower(spec, interpolated(i), before));
        return (n, n != [0; 3]);
    }
    if spec.normals == Normals::Wrapped {
        let n = wrapped(spec, lerp, raw.vector("wrap_axis"));
        return (n, n != [0; 3]);
    }
    let square = match spec.normalisation {
        Normalisation::Exact => dot(lerp, lerp),
        _ => truncated_dot(spec, lerp, lerp, 2 * v),
    };
    let z = round(square, 2 * v, zf);
    let y = (1 << zf) - z;
    let mut g = match spec.normalisation {
        Normalisation::None => return (lerp, lerp != [0; 3]),
        Normalisation::Exact => {
            let g = reciprocal_root(z, zf, gf);
            return (lerp.map(|c| round(g * c, gf + v, v)), z != 0);
        }
        Normalisation::G1 => round((2 << zf) + y, zf + 1, gf),
        Normalisation::G2 => round((2 << (2 * zf)) + (y << zf) + y * y, 2 * zf + 1, gf),
    };
    for _ in 0..spec.newton_steps {
        let square = round(g * g, 2 * gf, gf);
        let factor = round((3 << (zf + gf)) - z * square, zf + gf, gf);
        g = round(g * factor, 2 * gf + 1, gf);
    }
    (lerp.map(|c| round(g * c, gf + v, v)), z != 0)
}

/// The greatest r with (2r - 1)² z ≤ 4 · 4^to, by bisection; z counts as 4^-4 at least.
fn reciprocal_root(z: i128, from: u32, to: u32) -> i128 {
    let z = (z << 8).max(1 << from);
    let (mut yes, mut no) = (0_i128, (16 << to) + 1);
    while no - yes > 1 {
        let r = (yes + no) / 2;
        if (2 * r - 1).pow(2) * z <= 1 << (2 + 2 * to + from + 8) { yes = r } else { no = r }
    }
    yes
}

/// 2v H - w, v the one fraction with v - 1/2 ≤ p/q < v + 1/2 in units of its last place.
fn wrapped(spec: &LyonSpec, h: [i128; 3], w: [i128; 3]) -> [i128; 3] {
    let (v, o, r) = (
        spec.formats.vector.fraction_bits,
        spec.formats.wrap_operand.fraction_bits,
        spec.formats.wrap_ratio.fraction_bits,
    );
    let (p, q) = (round(dot(h, w), 2 * v, o), round(dot(h, h), 2 * v, o));
    let ratio =
        if p <= 0 || q <= 0 { 0 } else { (((p << (r + 1)) + q).div_euclid(2 * q)).min(1 << r) };
    [0, 1, 2].map(|c| round(2 * ratio * h[c] - (w[c] << r), v + r, v))
}

/// N + u (N + b), u = (1 - N·N)/|N + b|².
fn follower(spec: &LyonSpec, n: [i128; 3], before: [i128; 3]) -> [i128; 3] {
    let f = &spec.formats;
    let (v, z, o, r) = (
        f.vector.fraction_bits,
        f.length_squared.fraction_bits,
        f.wrap_operand.fraction_bits,
        f.wrap_ratio.fraction_bits,
    );
    let h = [0, 1, 2].map(|c| n[c] + before[c]);
    // p/q in the same units.
    let p = ((1 << z) - round(dot(n, n), 2 * v, z)) << o;
    let q = round(dot(h, h), 2 * v, o) << z;
    let ratio =
        if p <= 0 || q <= 0 { 0 } else { (((p << (r + 1)) + q).div_euclid(2 * q)).min(1 << r) };
    [0, 1, 2].map(|c| round((n[c] << r) + ratio * h[c], v + r, v))
}

fn shape(spec: &LyonSpec, raw: &Raw, n: [i128; 3], light: usize) -> i128 {
    let s = spec.formats.shape.fraction_bits;
    let difference = difference(spec, raw, n, light);
    let x = match spec.shape {
        ShapeDatapath::FK if spec.odd_power > 1 => {
            product(spec, raw.get("shininess_share"), difference)
        }
        ShapeDatapath::FK => product(spec, raw.get("shininess"), difference),
        ShapeDatapath::Root => squares(spec, raw.get("root_shininess"), difference),
    };
    let base = ((1 << s) - x).max(0);
    let mut f = base;
    // The odd power by its binary digits, written out.
    let digits: &[bool] = match spec.odd_power {
        1 => &[],
        3 => &[true],
        5 => &[false, true],
        7 => &[true, true],
        9 => &[false, false, true],
        11 => &[false, true, true],
        13 => &[true, false, true],
        _ => &[true, true, true],
    };
    for &multiplies in digits {
        f = round(f * f, 2 * s, s);
        if multiplies {
            f = round(f * base, 2 * s, s);
        }
    }
    for _ in 0..spec.squarings {
        f = round(f * f, 2 * s, s);
    }
    f
}

/// n D·D / 2^(k+1), or 4n for n.
fn product(spec: &LyonSpec, n: i128, difference: [i128; 3]) -> i128 {
    let (d, s) = (spec.formats.difference.fraction_bits, spec.formats.shape.fraction_bits);
    let factor = match spec.difference {
        Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection => 4,
        _ => 1,
    };
    let of_n = if spec.odd_power > 1 { spec.formats.shininess_share.fraction_bits } else { 0 };
    let square = truncated_dot(spec, difference, difference, 2 * d);
    round(factor * n * square, 2 * d + of_n + spec.squarings + 1, s)
}

/// u·u whole, however long u is: from 1 on it makes no difference, so the augmented comparator is
/// not needed here.
fn squares(spec: &LyonSpec, m: i128, difference: [i128; 3]) -> i128 {
    let f = &spec.formats;
    let shift = match spec.difference {
        Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection => [0, 0, 1, 1, 2],
        _ => [1, 1, 2, 2, 3],
    };
    let from = f.root_shininess.fraction_bits
        + f.difference.fraction_bits
        + shift[spec.squarings as usize];
    let u = difference.map(|c| round(m * c.abs(), from, f.scaled_difference.fraction_bits));
    round(dot(u, u), 2 * f.scaled_difference.fraction_bits, f.shape.fraction_bits)
}

fn difference(spec: &LyonSpec, raw: &Raw, n: [i128; 3], light: usize) -> [i128; 3] {
    let (v, d) = (spec.formats.vector.fraction_bits, spec.formats.difference.fraction_bits);
    let l = raw.vector(&format!("light{light}_direction"));
    let eye = [0, 0, 1 << v];
    let halfway = || raw.vector(&format!("light{light}_halfway"));
    match spec.difference {
        Difference::ReflectionMinusLight => reflected_minus(spec, n, eye, l),
        Difference::LightReflection => reflected_minus(spec, n, l, eye),
        Difference::HalfwayCrossNormal => cross_halfway(spec, halfway(), n),
        Difference::HalfwayProjection | Difference::UnitHalfwayProjection => {
            projection(spec, halfway(), n)
        }
        Difference::UnitHalfwayMinusNormal => {
            let h = halfway();
            [0, 1, 2].map(|c| round(h[c] - n[c], v, d))
        }
    }
}

fn projection(spec: &LyonSpec, h: [i128; 3], n: [i128; 3]) -> [i128; 3] {
    let (v, d) = (spec.formats.vector.fraction_bits, spec.formats.difference.fraction_bits);
    let p = round(dot(h, n), 2 * v, d);
    [0, 1, 2].map(|c| round(p * n[c] - (h[c] << d), v + d, d))
}

fn cross_halfway(spec: &LyonSpec, h: [i128; 3], n: [i128; 3]) -> [i128; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(p, q)| {
        let bits = 2 * spec.formats.vector.fraction_bits;
        let component = truncated(spec, h[p] * n[q], bits) - truncated(spec, h[q] * n[p], bits);
        round(component, bits, spec.formats.difference.fraction_bits)
    })
}

fn reflected_minus(spec: &LyonSpec, n: [i128; 3], of: [i128; 3], from: [i128; 3]) -> [i128; 3] {
    let (v, d) = (spec.formats.vector.fraction_bits, spec.formats.difference.fraction_bits);
    let w = round(2 * dot(n, of), 2 * v, d);
    [0, 1, 2].map(|c| round(w * n[c] - ((of[c] + from[c]) << d), v + d, d))
}

fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    (0..3).map(|c| a[c] * b[c]).sum()
}

/// a·b of truncated products, which have so many fraction bits.
fn truncated_dot(spec: &LyonSpec, a: [i128; 3], b: [i128; 3], bits: u32) -> i128 {
    (0..3).map(|c| truncated(spec, a[c] * b[c], bits)).sum()
}

/// A product of so many fraction bits without those that truncation takes: they are 0 then.
fn truncated(spec: &LyonSpec, product: i128, bits: u32) -> i128 {
    let lost = bits.saturating_sub(spec.formats.product.fraction_bits);
    product.div_euclid(1 << lost) << lost
}
