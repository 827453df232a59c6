//! Set-up of a span for `lyon`.
use super::{Difference, LyonInputs, LyonLight, LyonSpec};
use crate::frame::{DirectionalLight, EYE, Frame, Span};
use crate::spec::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct LyonSetUp<'a> {
    lyon: &'a LyonSpec,
    frame: &'a Frame,
    lights: Vec<LightInputs>,
}

/// Inputs that depend on the light alone.
struct LightInputs {
    direction: [i64; 3],
    halfway: Option<[i64; 3]>,
}

impl<'a> LyonSetUp<'a> {
    pub fn new(lyon: &'a LyonSpec, frame: &'a Frame) -> LyonSetUp<'a> {
        LyonSetUp { lyon, frame, lights: frame.lights.iter().map(|light| LightInputs::new(lyon, light)).collect() }
    }
}

impl LightInputs {
    fn new(lyon: &LyonSpec, light: &DirectionalLight) -> LightInputs {
        let (f, l) = (&lyon.formats, light.direction);
        let halfway = match lyon.difference {
            Difference::HalfwayCrossNormal => Some(f.vector_sum().quantise_vector(l + EYE)),
            Difference::ReflectionMinusLight => None,
        };
        LightInputs { direction: f.vector.quantise_vector(l), halfway }
    }

    fn with(&self, &Coefficients { diffuse, specular }: &Coefficients) -> LyonLight<i64> {
        LyonLight { direction: self.direction, halfway: self.halfway, diffuse, specular }
    }
}

impl SetUpSpan for LyonSetUp<'_> {
    fn inputs(&self, span: &Span, material: &MaterialInputs) -> Vec<i64> {
        let f = &self.lyon.formats;
        let [start, end] = self.frame.end_normals(span).map(|n| f.vector.quantise_vector(n));
        let step = if span.steps() == 0 { 0.0 } else { f64::from(span.steps()).recip() };
        let inputs = LyonInputs {
            normal_start: start,
            normal_delta: std::array::from_fn(|i| end[i] - start[i]),
            weight_step: f.weight_accumulator.quantise(step),
            shininess: i64::from(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: self.lights.iter().zip(&material.lights).map(|(light, coefficients)| light.with(coefficients)).collect(),
        };
        inputs.to_vec()
    }
}
