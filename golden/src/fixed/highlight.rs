//! Cosines and bases of highlights, and their powers.
use std::fmt;

use specula_spec::Format;

use super::number::{Wide, round_quotient, round_to};
use super::observer::{Observer, narrow};
use super::root::reciprocal_square_root;

/// s = 1/√max(q, 4^-m) with m the format's integer bits, and 0 where q ≤ 0.
pub(super) fn root(
    observer: &mut impl Observer,
    name: impl fmt::Display,
    q: Wide,
    format: Format,
) -> Wide {
    let root = if q > Wide::ZERO {
        reciprocal_square_root(q, format.integer_bits, format.fraction_bits)
    } else {
        Wide::ZERO
    };
    observer.see(format_args!("{name}"), root, format);
    root
}

/// u·N s, kept within -1 to 1; `product` is exact.
pub(super) fn cosine(
    observer: &mut impl Observer,
    name: impl fmt::Display,
    product: Wide,
    format: Format,
) -> Wide {
    let cosine = round_to(product, format.fraction_bits).clamp(-Wide::ONE, Wide::ONE);
    observer.see(format_args!("{name}"), cosine, format);
    cosine
}

/// A cosine as an amount of light, 0 or more.
pub(super) fn amount(
    observer: &mut impl Observer,
    name: &str,
    cosine: Wide,
    format: Format,
) -> Wide {
    // Rounding is monotonic and leaves 0 as it is, so that the clamp may come first.
    narrow(observer, format_args!("{name}"), cosine.max(Wide::ZERO), format)
}

/// p/q, kept within 0 to 1; 0 for q ≤ 0.
pub(super) fn limited_quotient(p: Wide, q: Wide, fraction_bits: u32) -> Wide {
    if p <= Wide::ZERO || q <= Wide::ZERO {
        Wide::ZERO
    } else if p >= q {
        Wide::ONE
    } else {
        round_quotient(p, q, fraction_bits)
    }
}

/// The base p/q, kept within 0 to 1.
pub(super) fn quotient(observer: &mut impl Observer, p: Wide, q: Wide, format: Format) -> Wide {
    let quotient = limited_quotient(p, q, format.fraction_bits);
    observer.see(format_args!("base"), quotient, format);
    quotient
}

/// R·L of a normal with a direction, kept within 0 to 1; `cosine` is 2(N·V)(N·L) - L·V, exact.
pub(super) fn reflection(
    observer: &mut impl Observer,
    has_direction: bool,
    cosine: Wide,
    format: Format,
) -> Wide {
    let rounded = round_to(cosine, format.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
    let base = if has_direction { rounded } else { Wide::ZERO };
    observer.see(format_args!("base"), base, format);
    base
}
