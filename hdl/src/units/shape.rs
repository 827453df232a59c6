//! The shape of the highlight.
use specula_spec::lyon::LyonSpec;

use super::LengthError;
use super::power::square;
use super::vector::gated;
use crate::error;
use crate::error::shape::RootShape;
use specula_datapath::builder::{Builder, Sig, Vector};

/// f(x) = (1 - x/K)^K, 0 for x ≥ K and where the normal has no direction, with x = (n/2) D·D; f_k
/// for K = 2^k. [Lyon, TR 43; methods B, B10]
///
/// Where D goes with 4n, read 4n for n. `shininess` is n over the odd power of K.
///
/// # Error
/// [`error::shape::bound`] for the largest exponent.
pub fn shape(
    b: &Builder,
    (d, length_error): (&Vector, LengthError),
    shininess: &Sig,
    has_direction: &Sig,
    lyon: &LyonSpec,
) -> Sig {
    let log2_factor = lyon.difference.log2_exponent_factor();
    let x = if log2_factor == 0 { "(n/2)" } else { "2n" };
    let formula = format!("f = max(1 - x/{0}, 0)^{0}, x = {x} D.D [Lyon, TR 43]", lyon.terms());
    b.unit(
        "shape",
        &formula,
        (("d", d), ("n", shininess), ("has_direction", has_direction)),
        |b, (d, n, has_direction)| {
            let fraction_bits = lyon.formats.shape.fraction_bits;
            let error = error::shape::bound(d.bound(), length_error, n.bound(), lyon);
            let squared_length = d
                .truncated_length_squared_within(
                    lyon.formats.product.fraction_bits,
                    d.longest(),
                    "|D| <= 2",
                )
                .named("d_squared");
            let x = (&n * squared_length)
                .times_power_of_two(log2_factor as i32 - (lyon.squarings as i32 + 1))
                .rounded(fraction_bits)
                .named("x"); // U1.f, and each square
            let shape = (b.integer(1) - x).at_least_zero();
            let base = has_direction.choose(&shape, &b.integer(0)).named("base");
            let f = raised(b, &base, lyon);
            gated(f.tighten_error("error::shape::bound", error), &has_direction).named("f")
        },
    )
}

/// The base to the K, rounded after each product: first to the odd power of K, whose binary digits
/// behind the first square, and multiply by the base where they are 1, and then by squarings.
fn raised(b: &Builder, base: &Sig, lyon: &LyonSpec) -> Sig {
    let fraction_bits = lyon.formats.shape.fraction_bits;
    let mut f = base.clone();
    for digit in (0..lyon.odd_power.ilog2()).rev() {
        f = square(b, &f, fraction_bits);
        if (lyon.odd_power >> digit) & 1 == 1 {
            f = (&f * base).rounded(fraction_bits).named("odd_power");
        }
    }
    (0..lyon.squarings).fold(f, |f, _| square(b, &f, fraction_bits))
}

/// The same f from m, the root of n: x/K = u·u with u_c = m|D_c| 2^-h, and 0 where an integer part
/// of u is not 0. [Lyon, TR 43, fig. 8; methods B]
///
/// # Error
/// [`RootShape::error`].
pub fn root_shape(b: &Builder, d: &Vector, m: &Sig, has_direction: &Sig, lyon: &LyonSpec) -> Sig {
    let formula = format!(
        "f = max(1 - u.u, 0)^{}, u = m |D| / {} [Lyon, TR 43, fig. 8]",
        lyon.terms(),
        1 << lyon.root_shift()
    );
    b.unit(
        "root_shape",
        &formula,
        (("d", d), ("m", m), ("has_direction", has_direction)),
        |b, (d, m, has_direction)| {
            let fraction_bits = lyon.formats.shape.fraction_bits;
            let error = RootShape::of(lyon).error(d.bound(), m.bound());
            let scaled = |c: &Sig| {
                let product = c.absolute() * &m;
                product
                    .times_power_of_two(-(lyon.root_shift() as i32))
                    .rounded(lyon.formats.scaled_difference.fraction_bits)
            };
            let u = d.map(scaled).named("scaled"); // U8.f
            let one = b.integer(1);
            let outside =
                u.x.at_least(&one).or(&u.y.at_least(&one)).or(&u.z.at_least(&one)).named("outside");
            let x = u
                .map(|c| c.low_bits(c.fraction_bits()))
                .length_squared()
                .rounded(fraction_bits)
                .named("x"); // U1.f, and each square
            let lit = has_direction.and(&outside.not()).named("lit");
            let base = lit.choose(&(b.integer(1) - x).at_least_zero(), &b.integer(0)).named("base");
            let f = raised(b, &base, lyon);
            let f = f.override_error("error::shape::RootShape::error", error);
            gated(f, &has_direction).named("f")
        },
    )
}
