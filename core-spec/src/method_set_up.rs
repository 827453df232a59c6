//! A method's part of the set-up of one span.
use specula_scene::frame::Span;

use crate::inputs::{CoreInputs, InputGroup, LightInputs, Many};
use crate::quadratic::Quadratic;

/// Inputs that depend on the material alone, as raw values.
pub struct MaterialInputs {
    /// Ambient light sent back.
    pub ambient: [i64; 3],
    /// Coefficients under each light.
    pub lights: Vec<Coefficients>,
}

/// A light's colour times a material's reflectances, as raw values.
pub struct Coefficients {
    /// Diffuse, red, green and blue.
    pub diffuse: [i64; 3],
    /// Specular, red, green and blue.
    pub specular: [i64; 3],
}

/// What distance leaves of each light along a span, as raw values; none of those that do not become
/// weaker.
pub type Attenuations = Many<Option<Quadratic<i64>>>;

/// Sets up spans of one frame for a core with some method.
pub trait SetUpSpan: Send + Sync {
    /// Appends raw values of the core's inputs, in port order. They may lie outside the ports'
    /// ranges by what f64 rounds.
    fn append(
        &self,
        span: &Span,
        material: &MaterialInputs,
        attenuations: Attenuations,
        out: &mut Vec<i64>,
    );
}

/// What one method computes for the spans of one frame.
pub trait MethodSetUp: Send + Sync {
    /// Raw values of the inputs that the lights of a span have in common.
    type SpanGroup: InputGroup<Value = i64>;
    /// Raw values of the inputs of each light, coefficients apart.
    type LightGroup: InputGroup<Value = i64>;
    /// What the inputs of a span and of its lights are made of.
    type Geometry;

    /// What the inputs of a span and of its lights are made of.
    fn geometry(&self, span: &Span) -> Self::Geometry;

    /// The inputs that the lights of a span have in common.
    fn span_inputs(&self, span: &Span, geometry: &Self::Geometry) -> Self::SpanGroup;

    /// The inputs of light number `index`, those at places counted last.
    fn light_inputs(
        &self,
        span: &Span,
        geometry: &Self::Geometry,
        index: usize,
    ) -> Self::LightGroup;

    /// Whether light number `index` has a highlight at all; without one its specular coefficients
    /// are 0.
    fn has_highlight(&self, _index: usize) -> bool {
        true
    }
}

impl<M: MethodSetUp> SetUpSpan for M {
    fn append(
        &self,
        span: &Span,
        material: &MaterialInputs,
        attenuations: Attenuations,
        out: &mut Vec<i64>,
    ) {
        let geometry = self.geometry(span);
        let lights = material.lights.iter().zip(attenuations).enumerate();
        let light =
            |(index, (coefficients, attenuation)): (usize, (&Coefficients, _))| LightInputs {
                light: self.light_inputs(span, &geometry, index),
                attenuation,
                diffuse: coefficients.diffuse,
                specular: if self.has_highlight(index) { coefficients.specular } else { [0; 3] },
            };
        let inputs = CoreInputs {
            span: self.span_inputs(span, &geometry),
            ambient: material.ambient,
            lights: lights.map(light).collect(),
        };
        inputs.append_to(out);
    }
}
