//! Reflections that never point into the surface.
use specula_spec::Format;
use specula_spec::consistent::ConsistentFormats;

use super::divider::divider;
use super::square_root::square_root;
use crate::error::consistent_reflection::{Horizon, Reflection};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{Builder, Sig, Vector};

/// r = (g + ρb)N - ρI with b = N·I, g = 1 + q(b - 1) and ρ = √(q(1 + g)/(1 + b)) ≤ 1; and whether I
/// is above the horizon that α leaves, g + b > 0. [Reshetov, Soupikov and Mark; methods D]
///
/// Where the reflection counts, 1 + b is no smaller than `least_divisor`.
///
/// # Error
/// [`Reflection::error`].
pub fn consistent_reflection(
    b: &Builder,
    n: &Vector,
    incoming: &Vector,
    q: &Sig,
    formats: &ConsistentFormats,
    least_divisor: f64,
) -> (Vector, Sig) {
    let inputs = (("n", n), ("incoming", incoming), ("q", q));
    b.unit(
        "consistent_reflection",
        "r = (g + rho b) N - rho I [Reshetov et al.]",
        inputs,
        |b, (n, incoming, q)| {
            let fraction_bits = formats.cosine.fraction_bits;
            let one = b.integer(1);
            // A vector that the host rounded is longer than 1 by √3/2 units of the last place at most;
            // a direction to a place may be longer.
            let lengths = (n.longest(), incoming.longest().max(1.0 + formats.vector.ulp()));
            let cosine = n.dot_within(&incoming, lengths, "|N.I| <= |N||I|").rounded(fraction_bits);
            let cos_beta = cosine.clamped_below(-1).clamped_above(1).named("cos_beta"); // S1.f
            let cos_gamma =
                (&one + &q * (&cos_beta - &one)).rounded(fraction_bits).named("cos_gamma"); // S1.f
            let above_horizon =
                b.integer(0).less_than(&(&cos_gamma + &cos_beta)).named("above_horizon");

            let dividend = &q * (&one + &cos_gamma);
            let divisor = (&one + &cos_beta)
                .real_within(Interval::at_least(least_divisor), "N.I where the reflection counts")
                .named("one_plus_cos_beta");
            let ratio_bits = formats.sine_ratio_squared.fraction_bits;
            // Both U1.f.
            let squared = divider(b, &dividend, &divisor, ratio_bits);
            let rho = square_root(b, &squared, formats.sine_ratio.fraction_bits).named("rho");

            // Both S2.f.
            let share =
                (&cos_gamma + &rho * &cos_beta).rounded(fraction_bits).named("normal_share");
            let r = &n.scaled(&share) - &incoming.scaled(&rho);
            let known = Reflection {
                vectors: [n.bound(), incoming.bound()],
                q: q.bound(),
                cosines: [cos_beta.bound(), cos_gamma.bound()],
                operands: [dividend.bound(), divisor.bound()],
                least_divisor,
            };
            let (whole, component) = known.error(formats, r.longest());
            let r = r.override_error(PROOF, whole).tighten_components(PROOF, component);
            (r.rounded(formats.vector.fraction_bits).named("r"), above_horizon)
        },
    )
}

/// Where the error of r is proven.
const PROOF: &str = "error::consistent_reflection::Reflection::error";

/// N_c·I of some I.
pub struct ConsistentCosine {
    /// |I + r|/2, 0 to 1. Its error is that of an I above the horizon.
    pub cosine: Sig,
    /// Whether I is above the horizon and the normal has a direction. If not, N_c·I is 0.
    pub lit: Sig,
    /// How large N_c·I is at most where rounding decides that.
    pub most_at_edge: f64,
}

impl ConsistentCosine {
    /// N_c·I.
    ///
    /// # Error
    /// That of [`ConsistentCosine::cosine`], or `most_at_edge`.
    pub fn gated(&self, b: &Builder) -> Sig {
        let known = self.cosine.bound().error_bound().or_gated(self.most_at_edge);
        let lit = self.lit.choose(&self.cosine, &b.integer(0)).clamped_above(1);
        lit.override_error(AT_EDGE, known).named("lit_cosine")
    }

    /// (N_c·I)^n from the power of the cosine, n no less than `least_exponent`.
    ///
    /// # Error
    /// That of the power, or `most_at_edge` to the power of the least exponent.
    pub fn gated_power(&self, b: &Builder, power: &Sig, least_exponent: i32) -> Sig {
        let at_edge = self.most_at_edge.powi(least_exponent);
        let known = power.bound().error_bound().or_gated(at_edge);
        let lit = self.lit.choose(power, &b.integer(0));
        lit.override_error(AT_EDGE, known).named("lit_power")
    }
}

/// Where it is proven how large N_c·I is at the horizon.
const AT_EDGE: &str = "error::consistent_reflection::Horizon::most_at_edge";

/// N_c·I = |I + r|/2 with r the reflection of I, and 0 for an I below the horizon or a normal
/// without direction. [Reshetov, Soupikov and Mark; methods D]
///
/// # Error
/// [`Horizon::cosine`] and [`Horizon::most_at_edge`].
pub fn consistent_cosine(
    b: &Builder,
    mirror: (&Vector, &Sig, &Sig),
    incoming: &Vector,
    (formats, to): (&ConsistentFormats, Format),
) -> ConsistentCosine {
    let (n, q, has_direction) = mirror;
    let inputs = (("n", n), ("q", q), ("has_direction", has_direction), ("incoming", incoming));
    let mut most_at_edge = 1.0;
    let (cosine, lit) = b.unit(
        "consistent_cosine",
        "c = |I + r|/2 [Reshetov et al.]",
        inputs,
        |b, (n, q, has_direction, incoming)| {
            let horizon = Horizon::new([n.bound(), incoming.bound()], q.bound(), formats.cosine);
            let least = horizon.least_divisor(q.bound());
            let (r, above_horizon) = consistent_reflection(b, &n, &incoming, &q, formats, least);
            let known = Horizon::cosine([incoming.bound(), r.bound()], to);
            most_at_edge = horizon.most_at_edge(known, has_direction.bound());
            let quarter = (&incoming + &r)
                .length_squared()
                .times_power_of_two(-2)
                .clamped_above(1)
                .named("quarter");
            let root = square_root(b, &quarter, to.fraction_bits).clamped_above(1);
            let cosine = root
                .override_error("error::consistent_reflection::Horizon::cosine", known)
                .named("cosine");
            (cosine, above_horizon.and(&has_direction).named("lit"))
        },
    );
    ConsistentCosine { cosine, lit, most_at_edge }
}
