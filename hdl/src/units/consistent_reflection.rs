//! Reflections that never point into the surface.
use specula_scene::Format;
use specula_scene::spec::consistent::ConsistentFormats;

use super::divider::divider;
use super::square_root::square_root;
use crate::error::consistent_reflection::{Components, Consistency, Horizon, Operands, reflection};
use specula_datapath::builder::{Builder, Sig, Vector};

/// r = (g + ρb)N - ρI with b = N·I, g = 1 + q(b - 1) and ρ = √(q(1 + g)/(1 + b)) ≤ 1; and whether I
/// is above the horizon that α leaves, g + b > 0. [Reshetov, Soupikov and Mark; methods D]
///
/// # Error
/// [`Operands::off`] as a whole, [`Components::error`] of each component.
pub fn consistent_reflection(
    b: &Builder,
    n: &Vector,
    incoming: &Vector,
    q: &Sig,
    formats: &ConsistentFormats,
    known: Consistency,
) -> (Vector, Sig) {
    let inputs = (("n", n), ("incoming", incoming), ("q", q));
    b.unit(
        "consistent_reflection",
        "r = (g + rho b) N - rho I [Reshetov et al.]",
        inputs,
        |b, (n, incoming, q)| {
            let fraction_bits = formats.cosine.fraction_bits;
            let one = b.integer(1);
            let lengths = (n.longest(), 1.0 + formats.vector.ulp());
            let cosine = n.dot_within(&incoming, lengths, "|N.I| <= |N||I|").rounded(fraction_bits);
            let cos_beta = cosine.clamped_below(-1).clamped_above(1).named("cos_beta"); // S1.f
            let cos_gamma =
                (&one + &q * (&cos_beta - &one)).rounded(fraction_bits).named("cos_gamma"); // S1.f
            let above_horizon =
                b.integer(0).less_than(&(&cos_gamma + &cos_beta)).named("above_horizon");

            let (dividend, divisor) =
                (&q * (&one + &cos_gamma), (&one + &cos_beta).named("one_plus_cos_beta"));
            let ratio_bits = formats.sine_ratio_squared.fraction_bits;
            // Both U1.f.
            let squared = divider(b, &dividend, &divisor, ratio_bits, known.least_divisor);
            let rho = square_root(b, &squared, formats.sine_ratio.fraction_bits).named("rho");

            // Both S2.f.
            let share =
                (&cos_gamma + &rho * &cos_beta).rounded(fraction_bits).named("normal_share");
            let r = &n.scaled(&share) - &incoming.scaled(&rho);
            let r = Bounds { n: &n, incoming: &incoming, q: &q, cosines: [&cos_beta, &cos_gamma] }
                .state(&r, [&dividend, &divisor], formats, known);
            (r.rounded(formats.vector.fraction_bits).named("r"), above_horizon)
        },
    )
}

/// What the error of r is made of.
struct Bounds<'a> {
    n: &'a Vector,
    incoming: &'a Vector,
    q: &'a Sig,
    /// b and g.
    cosines: [&'a Sig; 2],
}

impl Bounds<'_> {
    /// r with its error, ρ² being the quotient of `operands`.
    fn state(
        self,
        r: &Vector,
        operands: [&Sig; 2],
        formats: &ConsistentFormats,
        known: Consistency,
    ) -> Vector {
        let Bounds { n, incoming, q, cosines } = self;
        let of_components = Components {
            vectors: [n, incoming].map(|vector| vector.bound().component_error),
            cosines: cosines.map(Sig::error_value),
            operands: operands.map(Sig::error_value),
            longest: n.longest(),
        };
        let of_whole = Operands {
            normal: n.bound().error,
            incoming: incoming.bound().error,
            q: q.error_value(),
        };
        let (off, of_component) = reflection(
            of_components.error(formats, known),
            of_whole.off(formats, known),
            r.longest(),
        );
        r.clone()
            .override_error("error::consistent_reflection", off)
            .tighten_components("error::consistent_reflection", of_component)
    }
}

/// N_c·I = |I + r|/2 with r the reflection of I, and 0 for an I below the horizon or a normal
/// without direction. [Reshetov, Soupikov and Mark; methods D]
///
/// # Error
/// [`Horizon::cosine`].
pub fn consistent_cosine(
    b: &Builder,
    mirror: (&Vector, &Sig, &Sig),
    incoming: &Vector,
    (formats, to): (&ConsistentFormats, Format),
    least_q: f64,
) -> Sig {
    let (n, q, has_direction) = mirror;
    let inputs = (("n", n), ("q", q), ("has_direction", has_direction), ("incoming", incoming));
    b.unit(
        "consistent_cosine",
        "c = |I + r|/2 [Reshetov et al.]",
        inputs,
        |b, (n, q, has_direction, incoming)| {
            let offs = [n.bound().error.length, incoming.bound().error.length];
            let horizon = Horizon::new(offs, q.error_value(), formats.cosine.ulp());
            let known = horizon.above(least_q);
            let (r, above_horizon) = consistent_reflection(b, &n, &incoming, &q, formats, known);
            let offs = [incoming.bound().error.length, r.bound().error.length];
            let error = horizon.cosine(offs, to.ulp(), has_direction.error() == 0.0);
            let quarter = (&incoming + &r)
                .length_squared()
                .times_power_of_two(-2)
                .clamped_above(1)
                .named("quarter");
            let root = square_root(b, &quarter, to.fraction_bits);
            let lit =
                above_horizon.and(&has_direction).choose(&root, &b.integer(0)).clamped_above(1);
            lit.override_error("consistent_reflection", error).named("cosine")
        },
    )
}
