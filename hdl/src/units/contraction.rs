//! How far a consistent reflection departs from the plain one.
use specula_spec::consistent::{ConsistentFormats, Curve};

use super::divider::{QuotientFormat, quotient};
use crate::error;
use specula_datapath::bound::Interval;
use specula_datapath::builder::{Builder, Sig};

/// t = 2α/π along a span.
pub struct SpanAngles<'a> {
    /// 1 at the first pixel.
    pub first: &'a Sig,
    /// t at the first pixel.
    pub start: &'a Sig,
    /// What t grows by with each pixel.
    pub step: &'a Sig,
}

/// q of t, which is rounded up and clamped to 1; q is rounded down, so that both are on the safe
/// side. Errors: [`error::contraction`]. [Reshetov, Soupikov and Mark; methods D]
pub fn contraction(
    b: &Builder,
    angles: SpanAngles,
    curve: Curve,
    formats: &ConsistentFormats,
    steps: u32,
) -> Sig {
    let inputs =
        (("start", angles.first), ("angle_start", angles.start), ("angle_step", angles.step));
    b.unit(
        "contraction",
        "q(t), t = 2 alpha/pi [Reshetov et al.]",
        inputs,
        |b, (first, start, step)| {
            let proven = error::contraction::angle(formats.angle_accumulator, formats.angle, steps);
            let limits = (0.0, proven.largest);
            let sum = Sig::accumulated(&first, &start, &step, limits, steps, "0 <= t <= 1.0625");
            let t = rounded_up(b, &sum, formats.angle.fraction_bits).clamped_above(1);
            let t = t.override_error("error::contraction::angle", proven.error).named("t");
            match curve {
                Curve::Rational => rational(b, &t, formats),
                Curve::Trigonometric => trigonometric(b, &t, formats),
            }
        },
    )
}

/// Smallest value not below it with `fraction_bits` bits right of the point.
fn rounded_up(b: &Builder, x: &Sig, fraction_bits: u32) -> Sig {
    match x.fraction_bits().saturating_sub(fraction_bits) {
        0 => x.clone(),
        dropped => {
            let almost_one =
                b.integer((1 << dropped) - 1).times_power_of_two(-(x.fraction_bits() as i32));
            (x + almost_one).truncated(fraction_bits)
        }
    }
}

/// q = (1 - t)²/(1 + κt), κ = 1169/1024, rounded down.
///
/// ⌊x⌋ = ⌊(x - 1/2) + 1/2⌋: the correctly rounded quotient after half a unit of its last place is
/// taken off.
fn rational(b: &Builder, t: &Sig, formats: &ConsistentFormats) -> Sig {
    b.unit("rational_curve", "q = (1 - t)^2/(1 + (pi - 2) t)", (("t", t),), |b, (t,)| {
        let fraction_bits = formats.contraction.fraction_bits;
        let error = error::contraction::rational(t.bound(), formats.contraction);
        let above = (b.integer(1) - &t).squared().named("above");
        let below = (b.integer(1) + &t * b.integer(1169).times_power_of_two(-10))
            .real_within(Interval::at_least(1.0), "t >= 0")
            .named("below");
        let lowered = &above - below.times_power_of_two(-(fraction_bits as i32 + 1));
        let to = QuotientFormat { integer_bits: 0, fraction_bits };
        b.instance("curve_divider", || quotient(b, &lowered, &below, to))
            .override_error("error::contraction::rational", error)
            .named("q")
    })
}

/// q = T² with T = tan(π/4 - α/2) = u(1 - (1 - v) S(v)), u = 1 - t and v = u², T and q rounded
/// down.
///
/// # Error
/// [`error::contraction::trigonometric`].
fn trigonometric(b: &Builder, t: &Sig, formats: &ConsistentFormats) -> Sig {
    b.unit(
        "trigonometric_curve",
        "q = (1 - sin alpha)/(1 + sin alpha) = tan(pi/4 - alpha/2)^2",
        (("t", t),),
        |b, (t,)| {
            const COEFFICIENTS: [i64; 4] = [225_028, 55_803, 13_064, 5_363];
            let fraction_bits = formats.tangent.fraction_bits;
            let error =
                error::contraction::trigonometric(t.bound(), formats.tangent, formats.contraction);
            let up = |x: Sig| rounded_up(b, &x, fraction_bits);
            let [s0, s1, s2, s3] = COEFFICIENTS.map(|s| b.integer(s).times_power_of_two(-20));
            let u = (b.integer(1) - &t).named("u");
            let v = u.squared().truncated(fraction_bits).named("v");
            let sum = [s2, s1, s0].into_iter().fold(up(s3), |h, s| up(s + &v * h).named("h"));
            let w = up((b.integer(1) - &v) * sum).named("w");
            let tangent = (&u * (b.integer(1) - w)).truncated(fraction_bits).named("tangent");
            let q = tangent.squared().truncated(formats.contraction.fraction_bits).clamped_above(1);
            q.override_error("error::contraction::trigonometric", error).named("q")
        },
    )
}
