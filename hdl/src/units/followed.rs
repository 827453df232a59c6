//! Normals of unit length without a root, each made of the one before.
use specula_scene::spec::lyon::LyonFormats;

use super::divider;
use crate::builder::{Builder, Known, Off, Sig, Vector};

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
/// [`follower_error`].
pub fn followed(b: &Builder, of: Follow, formats: &LyonFormats, shortest: f64) -> Vector {
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
                .named("z");
            let y = (b.integer(1) - &z).named("y");
            let error = follower_error(&n, &w, &y, formats, shortest);
            let (longest, bits) = (1.0 + error, formats.vector.fraction_bits);
            let widest = n.longest() + longest;
            let known = Known { limits: (-longest, longest), fact: "|n| = 1", error };
            let restart = first.or(&follows.not());
            let operands = [&n.x, &n.y, &n.z, &y];
            let next = b.carried(
                &restart,
                ([&w.x, &w.y, &w.z], operands),
                bits,
                &known,
                |[x, y, z], [n_x, n_y, n_z, residue]| {
                    let n = Vector::new([n_x, n_y, n_z].map(Sig::clone));
                    let h = &n + &Vector::new([x, y, z].map(Sig::clone));
                    let q = h
                        .length_squared_within(widest, "|H| <= 2")
                        .rounded(formats.wrap_operand.fraction_bits)
                        .named("q");
                    let u =
                        divider(b, residue, &q, formats.wrap_ratio.fraction_bits, 1.0).named("u");
                    let Vector { x, y, z, .. } = (&n + &h.scaled(&u)).rounded(bits).named("n");
                    [x, y, z]
                },
            );
            Vector::new(next).known_off(Off::within(error)).no_longer_than(longest).named("normal")
        },
    )
}

/// How far wrapped normals that follow one another are off.
///
/// As a function of b, N and y = 1 - N·N, n has the derivatives u (1 - 2ĤĤᵀ), an isometry times u,
/// 1 + that, and H/|H|². So with N off by e_N, b by e and y by e_y it is off by u e + (1 + u) e_N +
/// e_y/|H| and by what rounding adds: u_o u/(2|H|) for H·H, u_r |H|/2 ≤ 1.1 u_r for u, and √3/2 u_v
/// for n.
///
/// Let s be |N| where it is shortest. Around a fixed w within 90 degrees of N, |H|² ≥ 1 + s². Spans
/// that follow turn by 120 degrees at most, so s ≥ 1/2, and N stays within 30 degrees of b: in
/// narrow ones all do; in others N turns by 12.5 degrees a step at most, of which a wrap leaves a
/// third, 19 degrees in all. So |H|² ≥ 1 + s² + √3 s and u ≤ .36, and errors end at what is added
/// over 1 - u. As long as e + e_N ≤ 1/16, H as it is is shorter by no more.
fn follower_error(n: &Vector, w: &Vector, y: &Sig, formats: &LyonFormats, shortest: f64) -> f64 {
    let (e_n, e_w, e_y) = (n.off().length, w.off().length, y.error_value());
    let added = |s: f64, h_squared: f64| {
        let h = h_squared.sqrt() - 0.0625;
        let u = (1.0 - s * s + e_y) / (h * h);
        let rounding = formats.wrap_operand.ulp() * u / (2.0 * h)
            + 1.1 * formats.wrap_ratio.ulp()
            + 0.75f64.sqrt() * formats.vector.ulp();
        (u, (1.0 + u) * e_n + e_y / h + rounding)
    };
    let (fixed, of_fixed) = added(shortest, 1.0 + shortest * shortest);
    let s = shortest.max(0.5);
    let (follows, of_following) = added(s, 1.0 + s * s + 3f64.sqrt() * s);
    // The first pixel of a span that follows has the error of w, no more than what following ends
    // at.
    let error = (fixed * e_w + of_fixed).max(e_w.max(of_following / (1.0 - follows)));
    // Beyond, two unit vectors are no further apart than 2.
    if error + e_n <= 0.0625 { error } else { 2.0 }
}
