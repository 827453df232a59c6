//! Vectors along a span.
use specula_spec::Format;

use crate::error::interpolate::{self, overshoot, reach, slack};
use specula_datapath::bound::VectorError;
use specula_datapath::builder::{Builder, Sig, Vector};

/// What the normal along a span is interpolated from.
pub struct SpanNormals<'a> {
    /// 1 at the first pixel.
    pub first: &'a Sig,
    /// N0.
    pub start: &'a Vector,
    /// N1 - N0.
    pub delta: &'a Vector,
    /// 1/S.
    pub weight_step: &'a Sig,
}

/// Where an interpolation rounds.
#[derive(Clone, Copy, Debug)]
pub struct Interpolation {
    /// The weight's accumulator.
    pub accumulator: Format,
    /// The weight.
    pub weight: Format,
    /// Components of the vector.
    pub vector: Format,
    /// How long the vectors at the ends are but for rounding, and so all between them: 1 for
    /// normals.
    pub longest: f64,
    /// How far they are apart at most.
    pub apart: f64,
    /// Steps of the longest span.
    pub steps: u32,
}

impl Interpolation {
    fn overshoot(self) -> f64 {
        overshoot(self.accumulator, self.weight, self.steps)
    }
}

/// Interpolates linearly: N' = N0 + a (N1 - N0), where a grows by 1/S with each of at most
/// `steps` + 1 pixels. [Lyon, TR 43; methods B12]
pub fn interpolate(b: &Builder, span: SpanNormals, to: Interpolation) -> Vector {
    let inputs = (
        ("start", span.first),
        ("normal_start", span.start),
        ("normal_delta", span.delta),
        ("weight_step", span.weight_step),
    );
    b.unit(
        "interpolate",
        "N' = N0 + a (N1 - N0) [Lyon, TR 43]",
        inputs,
        |b, (first, start, delta, step)| {
            let a = weight_along(b, &first, &step, to);
            between(&start, &delta, &a, to, "|N'| <= 1").named("normal")
        },
    )
}

/// The weight a = i/S by itself, for several vectors. [Lyon, TR 43; methods B12]
pub fn weight(b: &Builder, first: &Sig, step: &Sig, to: Interpolation) -> Sig {
    b.unit(
        "span_weight",
        "a(i) = i/S [Lyon, TR 43]",
        (("start", first), ("weight_step", step)),
        |b, (first, step)| weight_along(b, &first, &step, to),
    )
}

/// A vector along the span, X' = X0 + a (X1 - X0), whose ends lie in the unit ball. [methods B12,
/// C15]
pub fn vector_between(
    b: &Builder,
    start: &Vector,
    delta: &Vector,
    a: &Sig,
    to: Interpolation,
) -> Vector {
    let inputs = (("vector_start", start), ("vector_delta", delta), ("weight", a));
    b.unit("along", "X' = X0 + a (X1 - X0) [methods B12, C15]", inputs, |_, (start, delta, a)| {
        between(&start, &delta, &a, to, "|X'| <= 1").named("vector")
    })
}

/// a, accumulated and rounded to U1.f each.
fn weight_along(b: &Builder, first: &Sig, step: &Sig, to: Interpolation) -> Sig {
    let most = 1.0 + slack(to.accumulator, to.steps);
    let a = Sig::accumulated(first, &b.integer(0), step, (0.0, most), to.steps, "0 <= a <= 1");
    a.rounded(to.weight.fraction_bits)
        .assumed(0.0, 1.0 + to.overshoot(), "0 <= a <= 1")
        .named("weight")
}

/// X0 + a (X1 - X0), rounded to S1.f. X0 and X1 lie in the unit ball but for rounding, √3/2 units of
/// the last place, and X' is longer than the longer of them by the factor [`reach`] at most; longer
/// ends alike.
///
/// # Error
/// [`interpolate::between`].
fn between(start: &Vector, delta: &Vector, a: &Sig, to: Interpolation, fact: &str) -> Vector {
    let reach = reach(to.overshoot());
    let error = interpolate::between([start.bound(), delta.bound()], a.bound(), to.apart, reach);
    let sent = |c: &Sig| {
        let error = interpolate::sent_difference(c.bound());
        c.clone().override_error("error::interpolate::sent_difference", error)
    };
    (start + &delta.map(sent).scaled(a))
        .no_longer_than((to.longest + to.vector.ulp()) * reach)
        .components_assumed_within(to.longest * reach, fact)
        .tighten_error("error::interpolate::between", VectorError::ball(error))
        .rounded(to.vector.fraction_bits) // S1.f
}
