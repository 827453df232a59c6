//! The shape of the highlight.
use specula_scene::spec::lyon::LyonSpec;

use crate::builder::{Builder, Sig, Vector};

/// f_k(x) = (1 - x/2^k)^(2^k), 0 for x ≥ 2^k and where the normal has no direction, with x = (n/2) D·D. [Lyon, TR 43; METHODS B]
///
/// Where D goes with 4n, read 4n for n.
///
/// # Error
/// As a function of d = |D| and with K = 2^k, f = (1 - n d²/2K)^K has the slope -n d (1 - n d²/2K)^(K-1). Put t = n d²/2K: it is
/// √n √(2Kt) (1 - t)^(K-1), largest at t = 1/(2K - 1), so a vector D that is off by e moves f by
/// e √n √(2K/(2K-1)) ((2K-2)/(2K-1))^(K-1) at most. Rounding x/2^k and each square adds K/2 + (K - 1)/2 units of the last place.
pub fn shape(b: &Builder, d: &Vector, shininess: &Sig, has_direction: &Sig, lyon: &LyonSpec) -> Sig {
    let log2_factor = lyon.difference.log2_exponent_factor();
    let x = if log2_factor == 0 { "(n/2)" } else { "2n" };
    let formula = format!("f = max(1 - x/{0}, 0)^{0}, x = {x} D.D [Lyon, TR 43]", 1 << lyon.squarings);
    b.unit("shape", &formula, (("d", d), ("n", shininess), ("has_direction", has_direction)), |b, (d, n, has_direction)| {
        let fraction_bits = lyon.formats.shape.fraction_bits;
        let slope = steepest_slope(lyon.squarings, n.range().magnitude() * f64::from(1 << log2_factor));
        let k = 1 << lyon.squarings;
        let rounding = (f64::from(k) - 0.5) * lyon.formats.shape.ulp();
        // Where rounding may decide whether a normal has a direction, nothing is known of f.
        let sure = has_direction.error() == 0.0;
        let error = if sure { (d.off().length * slope + rounding).min(1.0) } else { 1.0 };

        let squared_length = d.length_squared_within(d.longest(), "|D| <= 2").named("d_squared");
        let x = (&n * squared_length)
            .times_power_of_two(log2_factor as i32 - (lyon.squarings as i32 + 1))
            .rounded(fraction_bits)
            .named("x");
        let shape = (b.integer(1) - x).at_least_zero();
        let mut f = has_direction.choose(&shape, &b.integer(0)).named("base");
        for _ in 0..lyon.squarings {
            f = square(b, &f, fraction_bits);
        }
        // The choice above counts as one between values that meet, so what is propagated through it holds only where it is sure.
        let f = if sure { f.proven_error_value(error) } else { f.stated_error_value(error) };
        f.named("f")
    })
}

/// The same f_k from m, the root of n: x/2^k = u·u with u_c = m|D_c| 2^-h, and 0 where an integer part of u is not 0.
/// [Lyon, TR 43, fig. 8; METHODS B]
///
/// # Error
/// As a function of |u| and with K = 2^k, f = (1 - u²)^K, whose slope is that of the figure 7 form for n = 2K and at most s. u_c is off by
/// half a unit of its last place beside m 2^-h times what D is off, so u by √3/2 units and that, and f by s times as much. A step δ of m itself changes f by 2K u² (1 - u²)^(K-1) δ/m, at most
/// 2 ((K-1)/K)^(K-1) δ/m, at the smallest m. Rounding x and each square adds K - 1/2 units of the last place.
pub fn root_shape(b: &Builder, d: &Vector, m: &Sig, has_direction: &Sig, lyon: &LyonSpec) -> Sig {
    let formula =
        format!("f = max(1 - u.u, 0)^{}, u = m |D| / {} [Lyon, TR 43, fig. 8]", 1 << lyon.squarings, 1 << lyon.root_shift());
    b.unit("root_shape", &formula, (("d", d), ("m", m), ("has_direction", has_direction)), |b, (d, m, has_direction)| {
        let fraction_bits = lyon.formats.shape.fraction_bits;
        let error = if has_direction.error() == 0.0 { root_error(&d, &m, lyon) } else { 1.0 };
        let scaled = |c: &Sig| {
            let product = c.absolute() * &m;
            product.times_power_of_two(-(lyon.root_shift() as i32)).rounded(lyon.formats.scaled_difference.fraction_bits)
        };
        let u = d.map(scaled).named("scaled");
        let one = b.integer(1);
        let outside = u.x.at_least(&one).or(&u.y.at_least(&one)).or(&u.z.at_least(&one)).named("outside");
        let x = u.map(|c| c.low_bits(c.fraction_bits())).length_squared().rounded(fraction_bits).named("x");
        let lit = has_direction.and(&outside.not()).named("lit");
        let mut f = lit.choose(&(b.integer(1) - x).at_least_zero(), &b.integer(0)).named("base");
        for _ in 0..lyon.squarings {
            f = square(b, &f, fraction_bits);
        }
        f.stated_error_value(error.min(1.0)).named("f")
    })
}

fn root_error(d: &Vector, m: &Sig, lyon: &LyonSpec) -> f64 {
    let terms = f64::from(1u32 << lyon.squarings);
    // An integer m counts as exact where a port does, but here it is a rounded root.
    let half_step = 0.5 * m.ulp();
    let (smallest, largest) = (m.range().low as f64 * m.ulp() - half_step, m.range().high as f64 * m.ulp() + half_step);
    let shift = f64::from(1u32 << lyon.root_shift());
    let e_u = largest / shift * d.off().length + 0.75f64.sqrt() * lyon.formats.scaled_difference.ulp();
    let of_m = 2.0 * ((terms - 1.0) / terms).powf(terms - 1.0) * half_step / smallest;
    steepest_slope(lyon.squarings, 2.0 * terms) * e_u + of_m + (terms - 0.5) * lyon.formats.shape.ulp()
}

/// How far [`shape`] is off where the real D is no shorter than `shortest`, whatever n is.
///
/// With y = n d² its slope in d is y (1 - y/2K)^(K-1)/d, largest at y = 2; and between both D no d is shorter than `shortest` less what D is off.
pub fn shape_error_beyond(d: &Vector, shortest: f64, lyon: &LyonSpec) -> f64 {
    let k = f64::from(1u32 << lyon.squarings);
    let off = d.off().length;
    let least = shortest - off;
    if least <= 0.0 {
        return 1.0;
    }
    off * steepest_of_any(k) / least + (k - 0.5) * lyon.formats.shape.ulp()
}

/// Largest |df_k/d|D|| times |D|, for any exponent.
fn steepest_of_any(k: f64) -> f64 {
    2.0 * (1.0 - 1.0 / k).powf(k - 1.0)
}

/// Largest |df_k/d|D|| for exponents up to `n`.
fn steepest_slope(squarings: u32, n: f64) -> f64 {
    let k = f64::from(1u32 << squarings);
    let t = 1.0 / (2.0 * k - 1.0);
    (n * 2.0 * k * t).sqrt() * (1.0 - t).powf(k - 1.0)
}

/// The square of a number from 0 to 1, rounded.
pub(super) fn square(b: &Builder, base: &Sig, fraction_bits: u32) -> Sig {
    b.unit("square", "b^2", (("base", base),), |_, (base,)| base.squared().rounded(fraction_bits).named("squared"))
}

#[cfg(test)]
mod tests {
    use super::{steepest_of_any, steepest_slope};

    #[test]
    fn the_slope_bound_is_met_and_not_exceeded() {
        for squarings in 0..=3 {
            let k = f64::from(1u32 << squarings);
            for n in [1.0, 16.0, 300.0, 8191.0] {
                let f = |d: f64| (1.0 - n * d * d / (2.0 * k)).max(0.0).powf(k);
                let step = 1e-5 / f64::sqrt(n);
                let slope = |i: i32| {
                    let d = f64::from(i) * 1e-3 / n.sqrt();
                    ((f(d + step) - f(d)) / step).abs()
                };
                let steepest = (0..4000).map(slope).fold(0.0, f64::max);
                let bound = steepest_slope(squarings, n);
                assert!(steepest <= bound * 1.0001 && steepest > bound * 0.99, "k {squarings} n {n}: {steepest} against {bound}");
            }
        }
    }

    #[test]
    fn away_from_the_middle_no_exponent_is_steeper_than_stated() {
        for squarings in 0..=3 {
            let k = f64::from(1u32 << squarings);
            for d in [0.05, 0.4, 0.8, 1.9_f64] {
                let slope = |n: f64| if n * d * d < 2.0 * k { n * d * (1.0 - n * d * d / (2.0 * k)).powf(k - 1.0) } else { 0.0 };
                let steepest = (1..40_000).map(|i| slope(f64::from(i) / 20.0)).fold(0.0, f64::max);
                let bound = steepest_of_any(k) / d;
                assert!(steepest <= bound && steepest > 0.9 * bound, "k {squarings} d {d}: {steepest} against {bound}");
            }
        }
    }
}
