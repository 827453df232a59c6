//! The inputs of a `reflection` core.
use super::{Highlight, ReflectionSpec};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};
use crate::ways::LightWay;

inputs! {
    /// Inputs that the lights of a span have in common.
    ReflectionSpan {
        /// q = H·H.
        denominator: group(Quadratic),
        /// H·n; there with ways to places.
        h_dot_n: group_if_any(Linear),
        /// q N'·V; there with eq. 34, and with ways to places.
        view: group_if_any(Quadratic),
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(ReflectedEye),
        /// N·V; there with ways to places, the hybrid's highlight and an eye at infinity.
        normal_view: group_if_any(Linear),
        /// N·N; there with the hybrid's highlight only.
        normal_squared: group_if_any(Quadratic),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    ReflectionLight {
        /// q N'·L; there without ways to places.
        cosine: group_if_any(Quadratic),
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(ReflectedLight),
        /// q N'·H with H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: group_if_any(Quadratic),
        /// 2(N·V)(N·L) - (L·V)(N·N); there with the hybrid's highlight only.
        numerator: group_if_any(Quadratic),
        /// L·V; there with eq. 34 only.
        dot_view: one_if_any,
    }
}

inputs! {
    /// The way E to an eye at a place, and what normals make of it.
    ReflectedEye {
        /// H·E.
        bisecting: group(Quadratic),
        /// n·E.
        fixed: group(Linear),
        /// N·E; there with the hybrid's highlight only.
        normal: group_if_any(Quadratic),
        /// E·E.
        squared: group(Quadratic),
    }
}

inputs! {
    /// The way X to a light, and what normals make of it.
    ReflectedLight {
        /// H·X.
        bisecting: group(Quadratic),
        /// n·X.
        fixed: group(Linear),
        /// N·X; there with the hybrid's highlight only.
        normal: group_if_any(Quadratic),
        /// The rest.
        way: group(LightWay),
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type ReflectionInputs<T> = CoreInputs<ReflectionSpan<T>, ReflectionLight<T>, T>;

/// With |H| ≤ 1 and |N| ≤ 1 along the span, squares lie from 0 to 1 and numerators from -1 to 1.
impl MethodInputs for ReflectionSpec {
    type SpanGroup = ReflectionSpan<CoreInput>;
    type LightGroup = ReflectionLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> ReflectionSpan<CoreInput> {
        let accumulator = self.formats.accumulator;
        let follows_ways = self.places.follows_ways(core);
        let has_eye = follows_ways && core.local_eye;
        let is_hybrid = self.specular == Highlight::Hybrid;
        let looks_at_the_eye = self.specular == Highlight::Eq34 || (follows_ways && !is_hybrid);
        let reflected =
            |value: &str, name: &str| Quadratic::reflected_inputs(value, name, accumulator);
        ReflectionSpan {
            denominator: Quadratic::squared_length_inputs("H.H", "denominator", accumulator),
            h_dot_n: follows_ways.then(|| Linear::inputs("H.n", "h_dot_n", accumulator)),
            view: (looks_at_the_eye && !has_eye)
                .then(|| reflected("2(H.n)(H.V) - (n.V)(H.H)", "view")),
            eye: has_eye.then(|| ReflectedEye {
                bisecting: reflected("H.E", "eye_bisecting"),
                fixed: Linear::inputs("n.E", "eye_fixed", accumulator),
                normal: is_hybrid.then(|| reflected("N.E", "eye_normal")),
                squared: Quadratic::squared_length_inputs("E.E", "eye_squared", accumulator),
            }),
            normal_view: (follows_ways && is_hybrid && !has_eye)
                .then(|| Linear::inputs("N.V", "normal_view", accumulator)),
            normal_squared: self.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length_inputs("N.N", "normal_squared", accumulator)
            }),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> ReflectionLight<CoreInput> {
        let called = |input: &str| format!("light{index}_{input}");
        let reflected = |value: &str, input: &str| {
            Quadratic::reflected_inputs(value, &called(input), self.formats.accumulator)
        };
        if self.places.follows_ways(core) {
            let accumulator = self.formats.accumulator;
            let linear =
                |value: &str, input: &str| Linear::inputs(value, &called(input), accumulator);
            let way = ReflectedLight {
                bisecting: reflected("H.X", "way_bisecting"),
                fixed: linear("n.X", "way_fixed"),
                normal: self.only_with(Highlight::Hybrid, || reflected("N.X", "way_normal")),
                way: LightWay::inputs(core, index, accumulator),
            };
            return ReflectionLight::of_way(way);
        }
        ReflectionLight {
            cosine: Some(reflected("2(H.n)(H.L) - (n.L)(H.H)", "cosine")),
            way: None,
            halfway: self.only_with(Highlight::Blinn, || {
                reflected("2(H.n)(H.h) - (n.h)(H.H) with h = (L + V)/|L + V|", "halfway")
            }),
            numerator: self.only_with(Highlight::Hybrid, || reflected(REFLECTED, "numerator")),
            dot_view: self.only_with(Highlight::Eq34, || {
                let meaning = InputMeaning::light_dot_view();
                CoreInput::between(meaning, called("dot_view"), self.formats.cosine, -1.0, 1.0)
            }),
        }
    }
}

impl<T> ReflectionLight<T> {
    /// A light of which nothing but the way is sent.
    pub(super) fn of_way(way: ReflectedLight<T>) -> ReflectionLight<T> {
        let way = Some(way);
        ReflectionLight { cosine: None, way, halfway: None, numerator: None, dot_view: None }
    }
}

impl ReflectionSpec {
    /// What belongs to one highlight alone.
    pub(super) fn only_with<T>(&self, highlight: Highlight, make: impl FnOnce() -> T) -> Option<T> {
        (self.specular == highlight).then(make)
    }
}
