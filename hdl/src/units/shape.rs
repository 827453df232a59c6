//! The shape of the highlight.
use specula_scene::spec::lyon::LyonSpec;

use super::LengthOff;
use super::shape_error::{shape_error, steepest_slope};
use crate::builder::{Builder, Sig, Vector};

/// f_k(x) = (1 - x/2^k)^(2^k), 0 for x ≥ 2^k and where the normal has no direction, with x = (n/2)
/// D·D. [Lyon, TR 43; methods B]
///
/// Where D goes with 4n, read 4n for n.
///
/// # Error
/// That of [`shape_error`] for the largest exponent.
pub fn shape(
    b: &Builder,
    (d, length_off): (&Vector, LengthOff),
    shininess: &Sig,
    has_direction: &Sig,
    lyon: &LyonSpec,
) -> Sig {
    let log2_factor = lyon.difference.log2_exponent_factor();
    let x = if log2_factor == 0 { "(n/2)" } else { "2n" };
    let formula =
        format!("f = max(1 - x/{0}, 0)^{0}, x = {x} D.D [Lyon, TR 43]", 1 << lyon.squarings);
    b.unit(
        "shape",
        &formula,
        (("d", d), ("n", shininess), ("has_direction", has_direction)),
        |b, (d, n, has_direction)| {
            let fraction_bits = lyon.formats.shape.fraction_bits;
            // Where rounding may decide whether a normal has a direction, nothing is known of f.
            let sure = has_direction.error() == 0.0;
            let error =
                if sure { shape_error(&d, length_off, n.range().magnitude(), lyon) } else { 1.0 };

            let squared_length =
                d.length_squared_within(d.longest(), "|D| <= 2").named("d_squared");
            let x = (&n * squared_length)
                .times_power_of_two(log2_factor as i32 - (lyon.squarings as i32 + 1))
                .rounded(fraction_bits)
                .named("x");
            let shape = (b.integer(1) - x).at_least_zero();
            let mut f = has_direction.choose(&shape, &b.integer(0)).named("base");
            for _ in 0..lyon.squarings {
                f = square(b, &f, fraction_bits);
            }
            // The choice above counts as one between values that meet, so what is propagated
            // through it holds only where it is sure.
            let f = if sure { f.proven_error_value(error) } else { f.stated_error_value(error) };
            f.named("f")
        },
    )
}

/// The same f_k from m, the root of n: x/2^k = u·u with u_c = m|D_c| 2^-h, and 0 where an integer
/// part of u is not 0. [Lyon, TR 43, fig. 8; methods B]
///
/// # Error
/// As a function of |u| and with K = 2^k, f = (1 - u²)^K, whose slope is that of the figure 7 form
/// for n = 2K and at most s. u_c is off by half a unit of its last place beside m 2^-h times what D
/// is off, so u by √3/2 units and that, and f by s times as much. A step δ of m itself changes f by
/// 2K u² (1 - u²)^(K-1) δ/m, at most 2 ((K-1)/K)^(K-1) δ/m, at the smallest m. Rounding x and each
/// square adds K - 1/2 units of the last place.
pub fn root_shape(b: &Builder, d: &Vector, m: &Sig, has_direction: &Sig, lyon: &LyonSpec) -> Sig {
    let formula = format!(
        "f = max(1 - u.u, 0)^{}, u = m |D| / {} [Lyon, TR 43, fig. 8]",
        1 << lyon.squarings,
        1 << lyon.root_shift()
    );
    b.unit(
        "root_shape",
        &formula,
        (("d", d), ("m", m), ("has_direction", has_direction)),
        |b, (d, m, has_direction)| {
            let fraction_bits = lyon.formats.shape.fraction_bits;
            let error = if has_direction.error() == 0.0 { root_error(&d, &m, lyon) } else { 1.0 };
            let scaled = |c: &Sig| {
                let product = c.absolute() * &m;
                product
                    .times_power_of_two(-(lyon.root_shift() as i32))
                    .rounded(lyon.formats.scaled_difference.fraction_bits)
            };
            let u = d.map(scaled).named("scaled");
            let one = b.integer(1);
            let outside =
                u.x.at_least(&one).or(&u.y.at_least(&one)).or(&u.z.at_least(&one)).named("outside");
            let x = u
                .map(|c| c.low_bits(c.fraction_bits()))
                .length_squared()
                .rounded(fraction_bits)
                .named("x");
            let lit = has_direction.and(&outside.not()).named("lit");
            let mut f =
                lit.choose(&(b.integer(1) - x).at_least_zero(), &b.integer(0)).named("base");
            for _ in 0..lyon.squarings {
                f = square(b, &f, fraction_bits);
            }
            f.stated_error_value(error.min(1.0)).named("f")
        },
    )
}

fn root_error(d: &Vector, m: &Sig, lyon: &LyonSpec) -> f64 {
    let terms = f64::from(1u32 << lyon.squarings);
    // An integer m counts as exact where a port does, but here it is a rounded root.
    let half_step = 0.5 * m.ulp();
    let (smallest, largest) =
        (m.range().low as f64 * m.ulp() - half_step, m.range().high as f64 * m.ulp() + half_step);
    let shift = f64::from(1u32 << lyon.root_shift());
    let e_u =
        largest / shift * d.off().length + 0.75f64.sqrt() * lyon.formats.scaled_difference.ulp();
    let of_m = 2.0 * ((terms - 1.0) / terms).powf(terms - 1.0) * half_step / smallest;
    steepest_slope(lyon.squarings, 2.0 * terms) * e_u
        + of_m
        + (terms - 0.5) * lyon.formats.shape.ulp()
}

/// The least exponent from which on f is 0 wherever D is no shorter than `shortest`: n d² ≥
/// 2^(k+1).
pub fn least_dark_exponent(shortest: f64, lyon: &LyonSpec) -> f64 {
    if shortest > 0.0 {
        f64::from(2u32 << lyon.squarings) / (shortest * shortest)
    } else {
        f64::INFINITY
    }
}

/// The square of a number from 0 to 1, rounded.
pub(super) fn square(b: &Builder, base: &Sig, fraction_bits: u32) -> Sig {
    b.unit("square", "b^2", (("base", base),), |_, (base,)| {
        base.squared().rounded(fraction_bits).named("squared")
    })
}
