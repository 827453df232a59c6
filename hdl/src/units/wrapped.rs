//! Vectors of unit length without a root.
use specula_spec::Format;

use super::{divider, has_direction};
use crate::error::wrapped::{Edge, WrapUnits, Wrapped, longest};
use specula_datapath::bound::{Interval, VectorError};
use specula_datapath::builder::{Builder, Sig, Vector};

/// Where a wrap rounds.
#[derive(Clone, Copy, Debug)]
pub struct WrapFormats {
    /// H·w and H·H.
    pub operand: Format,
    /// v.
    pub ratio: Format,
    /// Components of the vector.
    pub vector: Format,
}

impl WrapFormats {
    fn units(self) -> WrapUnits {
        WrapUnits { operand: self.operand.ulp(), ratio: self.ratio.ulp() }
    }
}

/// n = 2v H - w with v = H·w / H·H: the unit vector w, wrapped around H = N' + w. [Hast, Barrera
/// and Bengtsson, eq. 27, 36 and 38; methods C4, C16, C18]
///
/// It is -w reflected about H, so as long as w whatever H is. With N' within 90 degrees of w and
/// the unit ball, |H|² = 1 + |N'|² + 2N'·w is 1 at least and 0 ≤ v ≤ 1.
///
/// # Error
/// [`Wrapped::error`].
pub fn wrapped(b: &Builder, h: &Vector, w: &Vector, formats: WrapFormats) -> Vector {
    b.unit(
        "wrapped",
        "n = 2v H - w, v = H.w / H.H [Hast et al., eq. 27]",
        (("h", h), ("w", w)),
        |b, (h, w)| {
            let (p, q) = operands(&h, &w, formats);
            let v = divider(b, &p, &q, formats.ratio.fraction_bits).named("v");
            around(&h, &w, &v, formats)
        },
    )
}

/// The direction to a place, wrapped.
pub struct WrappedPlace {
    /// L'.
    pub direction: Vector,
    /// w·L', kept within 0 to 1.
    pub cosine: Sig,
    /// Whether there is light from there. If not, nothing else here means anything.
    pub exists: Sig,
    /// How strong a spot may be at most where rounding decides whether it is seen; 0 if it is none.
    pub most_at_edge: f64,
}

/// Where a wrapped direction is used.
#[derive(Clone, Copy, Debug)]
pub struct ToPlace {
    /// Where it rounds.
    pub formats: WrapFormats,
    /// Fraction bits of w·L'.
    pub cosine_bits: u32,
    /// X = H - w, which is no vector here, is no shorter.
    pub shortest_way: f64,
}

/// L' = 2v H - w as [`wrapped`], and w·L' = 2 v p - 1 with p = H·w and v = p / H·H. Where the bit
/// `spot` is 1, w is S, the way back along the axis of a spot, and X = H - S at any angle to it.
/// [Hast, Barrera and Bengtsson, eq. 36 to 38; methods C16 to C18]
///
/// Where p ≤ 1, X·S ≤ 0: a spot gives no light there, and v is 0 so that L' is as long as S.
/// Everywhere else |H| is 1 at least.
///
/// # Error
/// [`Wrapped::error`] where rounding has not moved p across 1, [`Edge::strength`] where it has.
pub fn wrapped_place(b: &Builder, h: &Vector, w: &Vector, spot: &Sig, to: ToPlace) -> WrappedPlace {
    let formula = "L' = 2v H - w, w.L' = 2v H.w - 1, v = H.w / H.H [Hast et al., eq. 36-38]";
    let is_spot = spot.range().high > 0;
    let mut most_at_edge = 0.0;
    let (direction, (cosine, exists)) = b.unit(
        "wrapped_place",
        formula,
        (("h", h), ("w", w), ("spot", spot)),
        |b, (h, w, spot)| {
            let (p, q) = operands(&h, &w, to.formats);
            if is_spot {
                most_at_edge = Edge::new(p.bound(), q.bound(), to.shortest_way)
                    .rounded_strength(to.formats.ratio.ulp());
            }
            let lit = b.integer(1).less_than(&p).named("lit");
            let (zero, dark) = (b.integer(0), spot.choose(&lit.not(), &b.integer(0)).named("dark"));
            let p = dark.choose(&zero, &p).named("p_if_lit");
            let v = divider(b, &p, &q, to.formats.ratio.fraction_bits).named("v");
            let cosine = ((&v * &p).doubled() - b.integer(1)).rounded(to.cosine_bits);
            let direction = around(&h, &w, &v, to.formats);
            let exists = spot.choose(&lit, &has_direction(b, &direction)).named("exists");
            (direction, (cosine.at_least_zero().clamped_above(1).named("cosine"), exists))
        },
    );
    WrappedPlace { direction, cosine, exists, most_at_edge }
}

/// |H|² is no smaller wherever the wrap serves.
const SHORTEST_SQUARED: Interval = Interval::at_least(1.0);

/// p = H·w and q = H·H, both rounded to U3.f.
fn operands(h: &Vector, w: &Vector, formats: WrapFormats) -> (Sig, Sig) {
    let bits = formats.operand.fraction_bits;
    let lengths = (h.longest(), w.longest());
    let p = h.dot_within(w, lengths, "|H.w| <= |H||w|").rounded(bits).named("p");
    let q = h.length_squared_within(lengths.0, "|H| <= 2").rounded(bits).named("q");
    (p, q.real_within(SHORTEST_SQUARED, "|H| >= 1 where the wrap serves"))
}

/// 2v H - w, rounded to S1.f.
fn around(h: &Vector, w: &Vector, v: &Sig, formats: WrapFormats) -> Vector {
    let longest = longest(w.longest(), formats.units(), formats.vector.ulp());
    let error = Wrapped::new(h.bound(), w.bound()).error(formats.units());
    (h.scaled(&v.doubled()) - w)
        .tighten_error("error::wrapped::Wrapped::error", VectorError::ball(error))
        .assumed_within(longest, "|2v H - w| = |w|")
        .rounded(formats.vector.fraction_bits)
        .no_shorter_than(w.bound().shortest, "|2v H - w| = |w|")
        .named("n")
}
