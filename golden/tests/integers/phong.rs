//! `phong` on raw values, lights and eye at infinity or not.
use specula_spec::PhongSpec;
use specula_spec::phong::Highlight;

use crate::raw::{Raw, round};
use crate::{along as span, gaussian, power};

/// A unit vector, if it has a direction.
type Direction = Option<[i128; 3]>;

pub fn code(spec: &PhongSpec, raw: &Raw, lights: usize, i: u32) -> [u8; 3] {
    let f = &spec.formats;
    let (c, s) = (f.cosine.fraction_bits, f.shape.fraction_bits);
    let bits = c.max(s);
    let normal = along(spec, raw, "normal", i).map(|(vector, _)| vector);
    let view = if has_way(raw, "eye") {
        along(spec, raw, "eye", i).map(|(vector, _)| vector)
    } else {
        Some([0, 0, 1 << f.vector.fraction_bits])
    };
    let mut terms = Vec::new();
    for light in 0..lights {
        let name = |part: &str| format!("light{light}_{part}");
        let direction = if raw.has(&name("direction_x")) {
            Some((raw.vector(&name("direction")), None))
        } else {
            along(spec, raw, &name("way"), i)
        };
        // 2 v p is above 2 v where p is above 1; the spot is dark elsewhere.
        let one = 1 << f.wrap_operand.fraction_bits;
        let direction = direction
            .filter(|(_, wrap)| !raw.has(&name("exponent")) || wrap.is_none_or(|[p, _]| p > one));
        // Diffuse with the cosine's bits, or the shape's behind a spot.
        let (diffuse, specular) = match (normal, direction) {
            (Some(n), Some((l, wrap))) => lit(spec, raw, [n, l], wrap, view, light),
            _ => (0, 0),
        };
        let diffuse_bits = if raw.has(&name("exponent")) { s } else { c };
        terms.push((name("diffuse"), diffuse << (bits - diffuse_bits)));
        terms.push((name("specular"), specular << (bits - s)));
    }
    ["r", "g", "b"].map(|channel| raw.code(channel, &terms, bits))
}

fn has_way(raw: &Raw, name: &str) -> bool {
    raw.has(&format!("{name}_start_x")) || raw.has(&format!("{name}_wrap_start_x"))
}

/// The direction, and p and v of one that is wrapped.
fn along(
    spec: &PhongSpec,
    raw: &Raw,
    name: &str,
    i: u32,
) -> Option<([i128; 3], Option<[i128; 2]>)> {
    if raw.has(&format!("{name}_wrap_axis_x")) {
        return wrapped(spec, raw, name, i);
    }
    let f = &spec.formats;
    let (v, g) = (f.vector.fraction_bits, f.gain.fraction_bits);
    let lerp = on_span(spec, raw, name, i);
    let z = round(dot(lerp, lerp), 2 * v, f.length_squared.fraction_bits);
    let r = reciprocal_root(z, f.length_squared.fraction_bits, g);
    (z > 0).then(|| (lerp.map(|c| round(r * c, g + v, v)), None))
}

/// The vector before it is made a direction.
fn on_span(spec: &PhongSpec, raw: &Raw, name: &str, i: u32) -> [i128; 3] {
    let f = &spec.formats;
    let formats = [f.weight_accumulator, f.weight, f.vector_accumulator, f.vector];
    span::vector(raw, [&format!("{name}_start"), name], i, formats)
}

fn wrapped(
    spec: &PhongSpec,
    raw: &Raw,
    name: &str,
    i: u32,
) -> Option<([i128; 3], Option<[i128; 2]>)> {
    let f = &spec.formats;
    let (v, o, r) =
        (f.vector.fraction_bits, f.wrap_operand.fraction_bits, f.wrap_ratio.fraction_bits);
    let axis = raw.vector(&format!("{name}_wrap_axis"));
    let h = on_span(spec, raw, &format!("{name}_wrap"), i);
    let (p, q) = (round(dot(h, axis), 2 * v, o), round(dot(h, h), 2 * v, o));
    let ratio =
        if p <= 0 || q <= 0 { 0 } else { (((p << (r + 1)) + q).div_euclid(2 * q)).min(1 << r) };
    let l = [0, 1, 2].map(|c| round(2 * ratio * h[c] - (axis[c] << r), v + r, v));
    (l != [0; 3]).then_some((l, Some([p, ratio])))
}

/// The r of `to` bits with r - 1/2 ≤ 1/√z < r + 1/2 units of the last place, that is (2r - 1)² z ≤
/// 4 · 2^2to < (2r + 1)² z, by bisection; 16 for z ≤ 1/256.
fn reciprocal_root(z: i128, from: u32, to: u32) -> i128 {
    if z << 8 <= 1 << from {
        return 16 << to;
    }
    let (mut low, mut high) = (0, 17 << to);
    while high - low > 1 {
        let middle = (low + high) / 2;
        let fits = (2 * middle - 1) * (2 * middle - 1) * z <= 1 << (2 * to + 2 + from);
        (low, high) = if fits { (middle, high) } else { (low, middle) };
    }
    low
}

fn lit(
    spec: &PhongSpec,
    raw: &Raw,
    [n, l]: [[i128; 3]; 2],
    wrap: Option<[i128; 2]>,
    view: Direction,
    light: usize,
) -> (i128, i128) {
    let f = &spec.formats;
    let (v, c, b, s) = (
        f.vector.fraction_bits,
        f.cosine.fraction_bits,
        f.base.fraction_bits,
        f.shape.fraction_bits,
    );
    let nl = round(dot(n, l), 2 * v, c);
    let amounts = (nl.max(0), view.map_or(0, |view| specular(spec, raw, [n, l, view], nl, light)));
    let name = |part: &str| format!("light{light}_{part}");
    if !raw.has(&name("exponent")) {
        return amounts;
    }
    let (o, r) = (f.wrap_operand.fraction_bits, f.wrap_ratio.fraction_bits);
    let cosine = match wrap {
        Some([p, ratio]) => round(2 * ratio * p - (1 << (o + r)), o + r, b),
        None => round(-dot(l, raw.vector(&name("axis"))), 2 * v, b),
    };
    let cosine = cosine.clamp(0, 1 << b);
    let share = power::of(
        cosine,
        b,
        raw.get(&name("exponent")),
        i128::BITS - raw.largest(&name("exponent")).leading_zeros(),
        s,
    );
    (round(share * amounts.0, s + c, s), round(share * amounts.1, 2 * s, s))
}

fn specular(
    spec: &PhongSpec,
    raw: &Raw,
    [n, l, view]: [[i128; 3]; 3],
    nl: i128,
    light: usize,
) -> i128 {
    let f = &spec.formats;
    let (v, c, b, s, g) = (
        f.vector.fraction_bits,
        f.cosine.fraction_bits,
        f.base.fraction_bits,
        f.shape.fraction_bits,
        f.gain.fraction_bits,
    );
    let name = |part: &str| format!("light{light}_{part}");
    let nv = round(dot(n, view), 2 * v, c);
    let vl = || round(dot(view, l), 2 * v, c);
    let exponent = raw.get("shininess");
    let exponent_bits = u32::BITS - (raw.largest("shininess") as u32).leading_zeros();
    if spec.highlight == Highlight::Reflection {
        let vl =
            if raw.has(&name("light_dot_view")) { raw.get(&name("light_dot_view")) } else { vl() };
        let base = round(2 * nv * nl - (vl << c), 2 * c, b).clamp(0, 1 << b);
        return power::of(base, b, exponent, exponent_bits, s);
    }
    let gain = if raw.has(&name("halfway_gain")) {
        raw.get(&name("halfway_gain"))
    } else {
        let z = f.length_squared.fraction_bits;
        reciprocal_root(round((2 << c) + 2 * vl(), c, z), z, g)
    };
    let cosine = (nl + nv) * gain;
    let base = round(cosine, c + g, b).clamp(0, 1 << b);
    match spec.highlight {
        Highlight::TrowbridgeReitz => {
            let x = round(((1 << (2 * b)) - base * base) * exponent, 2 * b, b);
            // 2^(s + 1) 2^b / (2^b + x), and half of it, rounded up.
            let u = ((1_i128 << (s + 1 + b)) / ((1 << b) + x) + 1) / 2;
            round(u * u, 2 * s, s)
        }
        Highlight::TorranceSparrow => {
            let versine = round((1 << (c + g)) - cosine, c + g, b).clamp(0, 15 << (b - 3));
            gaussian::of(versine, b, exponent, s)
        }
        _ => power::of(base, b, exponent, exponent_bits, s),
    }
}

fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    (0..3).map(|c| a[c] * b[c]).sum()
}
