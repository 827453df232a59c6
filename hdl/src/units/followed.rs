//! Normals of unit length without a root, each made of the one before.
use specula_spec::lyon::LyonFormats;

use super::divider;
use crate::error::followed::Followed;
use specula_datapath::bound::VectorError;
use specula_datapath::builder::{Builder, LoopInvariant, Sig, Vector};

/// What normals that follow one another begin with.
pub struct Follow<'a> {
    /// 1 at the first pixel of a span.
    pub first: &'a Sig,
    /// Whether they do in this span; else each is wrapped around `axis`.
    pub follows: &'a Sig,
    /// w, around which the first is wrapped.
    pub axis: &'a Vector,
    /// N between unit ends.
    pub normal: &'a Vector,
}

/// n = N + u H with H = N + b and u = (1 - N·N)/(H·H): the unit vector b, which is n of the pixel
/// before, wrapped around H. [Hast, Barrera and Bengtsson, eq. 27; methods C7]
///
/// It is 2H (H·b)/(H·H) - b for |b| = 1, where 2H·b = H·H + 1 - N·N. What does not wait for b is
/// outside the loop, which holds H·H, a division and a product, all of it within one clock. Written
/// so, it forgets errors: those of b go on multiplied by u, which is less than 1, where the
/// reflection itself passes them on whole.
///
/// # Error
/// [`Followed::error`].
pub fn followed(b: &Builder, of: Follow, formats: &LyonFormats) -> Vector {
    let inputs =
        (("start", of.first), ("follows", of.follows), ("normal", of.normal), ("w", of.axis));
    b.unit(
        "followed",
        "n' = N + u (N + n), u = (1 - N.N) / |N + n|^2 [Hast et al., eq. 27]",
        inputs,
        |b, (first, follows, n, w)| {
            let z = n
                .length_squared_within(n.longest(), "|N| <= 1")
                .rounded(formats.length_squared.fraction_bits)
                .named("z"); // U1.f
            let y = (b.integer(1) - &z).named("y");
            let error = Followed::new(n.bound(), w.bound(), y.bound()).error(formats);
            let (longest, bits) = (1.0 + error, formats.vector.fraction_bits);
            let widest = n.longest() + longest;
            let invariant = LoopInvariant { limits: (-longest, longest), fact: "|n| = 1", error };
            let restart = first.or(&follows.not());
            let operands = [&n.x, &n.y, &n.z, &y];
            let next = b.carried(
                &restart,
                ([&w.x, &w.y, &w.z], operands),
                bits,
                &invariant,
                |[x, y, z], [n_x, n_y, n_z, residue]| {
                    let n = Vector::new([n_x, n_y, n_z].map(Sig::clone));
                    let h = &n + &Vector::new([x, y, z].map(Sig::clone));
                    let q = h
                        .length_squared_within(widest, "|H| <= 2")
                        .rounded(formats.wrap_operand.fraction_bits)
                        .named("q"); // U3.f
                    // U1.f, then S1.f.
                    let u = divider(b, residue, &q, formats.wrap_ratio.fraction_bits).named("u");
                    let Vector { x, y, z, .. } = (&n + &h.scaled(&u)).rounded(bits).named("n");
                    [x, y, z]
                },
            );
            Vector::new(next)
                .override_error("error::followed::Followed::error", VectorError::ball(error))
                .no_longer_than(longest)
                .no_shorter_than(1.0, "|n| = 1")
                .named("normal")
        },
    )
}
