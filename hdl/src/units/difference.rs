//! The vector D, whose squared length the highlight depends on.
use specula_scene::spec::lyon::LyonFormats;

use super::length_off::{LengthOff, Reflected};
use crate::builder::{Builder, Off, Vector};

/// D = H × N with H = L + V, as long as the part of H that is perpendicular to N. [methods B13]
///
/// |D| ≤ |H||N| and |H| ≤ 2, and with H and N off by e_H and e_N, D is off by |H| e_N + |N| e_H + e_H e_N.
pub fn halfway_cross_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit(
        "halfway_cross_normal",
        "D = H x N, H = L + V [methods B13]",
        (("h", h), ("n", n)),
        |_, (h, n)| {
            let (longest_h, longest_n) = (2.0 + 2.0 * formats.vector.ulp(), n.longest());
            let (e_h, e_n) = (h.off().length, n.off().length);
            let error = longest_h * e_n + longest_n * e_h + e_h * e_n;
            let d = h.cross(&n).assumed_within(longest_h * longest_n, "|H x N| <= |H||N|");
            d.proven_off_by(error).rounded(formats.difference.fraction_bits).named("d")
        },
    )
}

/// D = R - L with R = 2(N·V)N - V, the view vector reflected about the normal, which is no shorter
/// than `shortest`, and how far |D| is off. [Lyon, TR 43, fig. 7; methods B1, B2]
pub fn reflection_minus_light(
    b: &Builder,
    (n, shortest): (&Vector, f64),
    v: &Vector,
    l: &Vector,
    formats: &LyonFormats,
) -> (Vector, LengthOff) {
    let formula = "D = 2(N.V)N - V - L [Lyon, TR 43, fig. 7]";
    let d = b.unit(
        "reflection_minus_light",
        formula,
        (("n", n), ("v", v), ("l", l)),
        |_, (n, v, l)| reflected_minus(&n, ("twice_n_dot_v", &v), &l, formats),
    );
    (d, reflected_length_off((n, shortest), v, l, formats))
}

/// D2 = 2(N·L)N - L - V, the light reflected about the normal, which is no shorter than `shortest`,
/// less V, and how far |D2| is off. [Lyon, TR 43, fig. 5; methods B4]
pub fn light_reflection(
    b: &Builder,
    (n, shortest): (&Vector, f64),
    l: &Vector,
    v: &Vector,
    formats: &LyonFormats,
) -> (Vector, LengthOff) {
    let formula = "D = 2(N.L)N - L - V [Lyon, TR 43, fig. 5]";
    let d = b.unit("light_reflection", formula, (("n", n), ("l", l), ("v", v)), |_, (n, l, v)| {
        reflected_minus(&n, ("twice_n_dot_l", &l), &v, formats)
    });
    (d, reflected_length_off((n, shortest), l, v, formats))
}

/// Of D as [`reflected_minus`] makes it.
fn reflected_length_off(
    (n, shortest): (&Vector, f64),
    of: &Vector,
    from: &Vector,
    formats: &LyonFormats,
) -> LengthOff {
    let (off, ulp) = (n.off(), formats.difference.ulp());
    LengthOff::of_reflection(&Reflected {
        n: off,
        lengths: ((shortest - off.length).max(0.0), n.longest() + off.length),
        of: of.off().length,
        from: from.off().length,
        rounding_along: 0.5 * ulp,
        rounding: 0.75f64.sqrt() * ulp,
    })
}

/// The unit vector `of` reflected about n, less the unit vector `from`: 2(n·of)n - of - from.
///
/// It is no longer than the reflection and 1, and the reflection exceeds 1 no more than |n|² does.
///
/// # Error
/// 2(n·of)n = |n|² (R + of) for the reflection R about n's direction. With n' off by a across and l
/// along n, R turns by twice the angle that n does, which moves it by 2a/|n'|, and |n'|² - |n|² ≤
/// 2|n| l + l² + a². So the reflection is off by 2|n'| a and twice the latter; an `of` off by e
/// adds e max(1, 2|n|² - 1), since reflecting about n stretches by no more; rounding 2(n·of) adds
/// |n| times half a unit.
fn reflected_minus(
    n: &Vector,
    (name, of): (&str, &Vector),
    from: &Vector,
    formats: &LyonFormats,
) -> Vector {
    let fraction_bits = formats.difference.fraction_bits;
    let cosine = n.dot_within(of, (n.longest(), of.longest()), "|N.V|, |N.L| <= |N|");
    let twice = cosine.doubled().rounded(fraction_bits).named(name);
    let reflection = n.scaled(&twice) - of;
    // R = 2(N·V)N - V is off by up to |N|² in length as N is, and rounding each component adds to
    // that.
    let longest_n = n.longest();
    let longest =
        2.0 * longest_n * longest_n + 8.0 * formats.vector.ulp() + 8.0 * formats.difference.ulp();
    let Off { across, along, .. } = n.off();
    let square = 2.0 * longest_n * along + along * along + across * across;
    let of_n = 2.0 * (longest_n + along + across) * across + 2.0 * square;
    let of_vectors =
        of.off().length * (2.0 * (longest_n + along).powi(2) - 1.0).max(1.0) + from.off().length;
    let off = of_n + of_vectors + 0.5 * longest_n * formats.difference.ulp();
    let d = (reflection - from).assumed_within(longest, "|R - L| <= |R| + |L|");
    d.proven_off_by(off).rounded(fraction_bits).named("d")
}

/// D = (H·N)N - H, the way from H to its projection on N; `h` is H = L + V or about a unit vector.
/// [Lyon, TR 43, fig. 5; methods B5, B6]
///
/// With r = |N|, the part along N is (r² - 1) times that of H and the part across is that of H: |D|
/// ≤ |H| max(1, r² - 1). Rounding H·N lengthens it by |N|/2 units of the last place.
///
/// # Error
/// With H and N off by e_H and e_N it is off by 2|H||N| e_N + (|N|² + 1) e_H, products of errors,
/// and |N|/2 units.
pub fn halfway_projection(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = (H.N)N - H [Lyon, TR 43, fig. 5]";
    b.unit("halfway_projection", formula, (("h", h), ("n", n)), |_, (h, n)| {
        let fraction_bits = formats.difference.fraction_bits;
        let lengths = (h.longest(), n.longest());
        let h_dot_n =
            h.dot_within(&n, lengths, "|H.N| <= |H||N|").rounded(fraction_bits).named("h_dot_n");
        let longest = lengths.0 * (lengths.1 * lengths.1 - 1.0).max(1.0)
            + lengths.1 * formats.difference.ulp();
        let d = n.scaled(&h_dot_n) - &h;
        let (e_h, e_n) = (h.off().length, n.off().length);
        let (h_reach, n_reach) = (lengths.0 + e_h, lengths.1 + e_n);
        let off = h_reach * (2.0 * n_reach * e_n)
            + (n_reach * n_reach + 1.0) * e_h
            + 0.5 * n_reach * formats.difference.ulp();
        d.assumed_within(longest, "|(H.N)N - H| <= |H|")
            .proven_off_by(off)
            .rounded(fraction_bits)
            .named("d")
    })
}

/// D = h - N for a half-way vector h of about unit length: no multiplier at all. [Lyon, TR 43;
/// methods B6]
pub fn halfway_minus_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("halfway_minus_normal", "D = h - N [Lyon, TR 43]", (("h", h), ("n", n)), |_, (h, n)| {
        let longest = h.longest() + n.longest();
        let off = h.off().length + n.off().length;
        (&h - &n)
            .assumed_within(longest, "|h - N| <= |h| + |N|")
            .proven_off_by(off)
            .rounded(formats.difference.fraction_bits)
            .named("d")
    })
}
