//! Unit vectors without a root [Hast, Barrera and Bengtsson, eq. 27 and 36 to 38; methods C4,
//! C16 to C18].
use specula_spec::Format;

use super::highlight::limited_quotient;
use super::number::Wide;
use super::observer::{Observer, narrow, narrow_vector};
use super::vector::{Vector, dot};

/// Where a wrap rounds.
#[derive(Clone, Copy)]
pub(super) struct WrapFormats {
    /// p and q.
    pub operand: Format,
    /// v.
    pub ratio: Format,
    /// The vector.
    pub vector: Format,
}

/// A wrapped vector, and what it is made of.
pub(super) struct Wrapped {
    /// 2v H - w.
    pub vector: Vector,
    /// p = H·w.
    pub operand: Wide,
    /// v = p/q with q = H·H, kept within 0 to 1.
    pub ratio: Wide,
}

/// w, wrapped around H; the observer is shown `prefix`_p and so on, and the vector as `name`.
pub(super) fn wrapped(
    observer: &mut impl Observer,
    [prefix, name]: [&str; 2],
    h: &Vector,
    axis: &Vector,
    formats: WrapFormats,
) -> Wrapped {
    let operand = narrow(observer, format_args!("{prefix}_p"), dot(h, axis), formats.operand);
    let square = narrow(observer, format_args!("{prefix}_q"), dot(h, h), formats.operand);
    let ratio = limited_quotient(operand, square, formats.ratio.fraction_bits);
    observer.see(format_args!("{prefix}_ratio"), ratio, formats.ratio);
    let vector = std::array::from_fn(|c| (ratio << 1) * h[c] - axis[c]);
    Wrapped { vector: narrow_vector(observer, name, vector, formats.vector), operand, ratio }
}
