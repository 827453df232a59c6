//! Set-up of one span: what the host works out in f64 and quantises into the core's formats.
use glam::DVec3;

use super::hybrid::{HybridInputs, HybridLight, HybridSpec, Quadratic};
use super::lyon::{Difference, LyonInputs, LyonLight, LyonSpec};
use super::{CoreSpec, FULL_SCALE, MethodSpec};
use crate::format::Format;
use crate::frame::{Colour, DirectionalLight, EYE, Frame, Material, Span};

/// What a core is given of one span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpanPacket {
    /// Clocks for which the span goes in, one per pixel.
    pub length: u32,
    /// Raw values of [`CoreSpec::inputs`], in that order.
    pub inputs: Vec<i64>,
}

/// Sets up spans of one frame for a core; what does not change from span to span is worked out once.
pub struct SetUp<'a> {
    core: &'a CoreSpec,
    frame: &'a Frame,
    /// Smallest and largest raw value of each input.
    ranges: Vec<(i64, i64)>,
    /// What belongs to each material of the frame.
    materials: Vec<MaterialInputs>,
    /// L and H of each light, for `lyon`.
    lights: Vec<LightInputs>,
}

/// Inputs that depend on the material alone.
struct MaterialInputs {
    ambient: [i64; 3],
    /// Diffuse and specular coefficients under each light.
    lights: Vec<[[i64; 3]; 2]>,
}

/// Inputs that depend on the light alone.
struct LightInputs {
    direction: [i64; 3],
    halfway: Option<[i64; 3]>,
}

impl<'a> SetUp<'a> {
    /// The set-up of spans of `frame` for `core`.
    pub fn new(core: &'a CoreSpec, frame: &'a Frame) -> SetUp<'a> {
        SetUp {
            core,
            frame,
            ranges: core.inputs().iter().map(|port| port.range).collect(),
            materials: frame.materials.iter().map(|material| MaterialInputs::new(core, frame, material)).collect(),
            lights: frame.lights.iter().map(|light| LightInputs::new(core, light)).collect(),
        }
    }

    /// Sets up a span. Every value is within its port's range.
    pub fn packet(&self, span: &Span) -> SpanPacket {
        let mut inputs = match &self.core.method {
            MethodSpec::Lyon(lyon) => self.lyon_inputs(lyon, span).to_vec(),
            MethodSpec::Hybrid(hybrid) => self.hybrid_inputs(hybrid, span).to_vec(),
        };
        // In exact arithmetic nothing is out of range; f64 may be by some units of its own last place, as N·N of a unit vector is.
        for (value, &(low, high)) in inputs.iter_mut().zip(&self.ranges) {
            *value = (*value).clamp(low, high);
        }
        SpanPacket { length: span.length, inputs }
    }

    fn material(&self, span: &Span) -> &MaterialInputs {
        &self.materials[self.frame.triangles[span.triangle].material]
    }

    fn lyon_inputs(&self, lyon: &LyonSpec, span: &Span) -> LyonInputs<i64> {
        let f = &lyon.formats;
        let material = self.material(span);
        let [start, end] = self.frame.end_normals(span).map(|n| quantised(n, f.vector));
        let step = if span.steps() == 0 { 0.0 } else { f64::from(span.steps()).recip() };
        let light = |(light, &[diffuse, specular]): (&LightInputs, &[[i64; 3]; 2])| LyonLight {
            direction: light.direction,
            halfway: light.halfway,
            diffuse,
            specular,
        };
        LyonInputs {
            normal_start: start,
            normal_delta: std::array::from_fn(|i| end[i] - start[i]),
            weight_step: f.weight_accumulator.quantise(step),
            shininess: i64::from(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: self.lights.iter().zip(&material.lights).map(light).collect(),
        }
    }

    fn hybrid_inputs(&self, hybrid: &HybridSpec, span: &Span) -> HybridInputs<i64> {
        let f = &hybrid.formats;
        let material = self.material(span);
        let [start, end] = self.frame.end_normals(span);
        // N(i) = m + k i. In a span of one pixel k is not used.
        let (m, k) = (start, (end - start) / f64::from(span.steps().max(1)));
        let q = quadratic(span, m.dot(m), 2.0 * k.dot(m), k.dot(k));
        let light = |(light, &[diffuse, specular]): (&DirectionalLight, &[[i64; 3]; 2])| {
            let (intensity_start, intensity_step) = gouraud(self.frame, span, light.direction);
            HybridLight {
                numerator: numerator(span, m, k, light.direction).quantised(f.accumulator),
                intensity_start: f.diffuse_accumulator.quantise(intensity_start),
                intensity_step: f.diffuse_accumulator.quantise(intensity_step),
                diffuse,
                specular,
            }
        };
        HybridInputs {
            denominator: q.quantised(f.accumulator),
            log2_shininess: i64::from(self.frame.material(span).shininess.ilog2()),
            ambient: material.ambient,
            lights: self.frame.lights.iter().zip(&material.lights).map(light).collect(),
        }
    }
}

impl MaterialInputs {
    fn new(core: &CoreSpec, frame: &Frame, material: &Material) -> MaterialInputs {
        // Light times reflectance, in LSBs.
        let coefficients = |reflectance: Colour, light: Colour| {
            std::array::from_fn(|c| core.coefficient.quantise(FULL_SCALE * reflectance[c] * light[c]))
        };
        let under = |light: &DirectionalLight| {
            [coefficients(material.diffuse, light.colour), coefficients(material.specular, light.colour)]
        };
        MaterialInputs { ambient: coefficients(material.ambient, frame.ambient), lights: frame.lights.iter().map(under).collect() }
    }
}

impl LightInputs {
    fn new(core: &CoreSpec, light: &DirectionalLight) -> LightInputs {
        match &core.method {
            MethodSpec::Lyon(lyon) => {
                let (f, l) = (&lyon.formats, light.direction);
                let halfway = match lyon.difference {
                    Difference::HalfwayCrossNormal => Some(quantised(l + EYE, f.vector_sum())),
                    Difference::ReflectionMinusLight => None,
                };
                LightInputs { direction: quantised(l, f.vector), halfway }
            }
            // The direction enters its quadratics only.
            MethodSpec::Hybrid(_) => LightInputs { direction: [0; 3], halfway: None },
        }
    }
}

impl CoreSpec {
    /// Sets up a span for this core; [`SetUp`] sets up many.
    pub fn packet(&self, frame: &Frame, span: &Span) -> SpanPacket {
        SetUp::new(self, frame).packet(span)
    }
}

fn quantised(vector: DVec3, format: Format) -> [i64; 3] {
    vector.to_array().map(|component| format.quantise(component))
}

/// p(i) = 2(N·V)(N·L) - (L·V)(N·N) with N = m + k i.
fn numerator(span: &Span, m: DVec3, k: DVec3, l: DVec3) -> Quadratic<f64> {
    let l_dot_v = l.dot(EYE);
    quadratic(
        span,
        2.0 * m.dot(EYE) * m.dot(l) - l_dot_v * m.dot(m),
        2.0 * (m.dot(EYE) * k.dot(l) + k.dot(EYE) * m.dot(l)) - 2.0 * l_dot_v * k.dot(m),
        2.0 * k.dot(EYE) * k.dot(l) - l_dot_v * k.dot(k),
    )
}

/// Start and differences of c + b i + a i² (Hast eq. 20 to 26: p0 = C, dp0 = A + B, d2p = 2A), as far as the span is long enough to use them.
fn quadratic(span: &Span, c: f64, b: f64, a: f64) -> Quadratic<f64> {
    let used_from = |steps: u32, x: f64| if span.steps() >= steps { x } else { 0.0 };
    Quadratic { start: c, first_difference: used_from(1, a + b), second_difference: used_from(2, 2.0 * a) }
}

impl Quadratic<f64> {
    fn quantised(&self, format: Format) -> Quadratic<i64> {
        let q = |x: f64| format.quantise(x);
        Quadratic { start: q(self.start), first_difference: q(self.first_difference), second_difference: q(self.second_difference) }
    }
}

/// Gouraud's intensity at the first pixel and its step: max(N·L, 0) at the triangle's vertices, interpolated linearly
/// [lecture, eq. 3.2 to 3.6].
fn gouraud(frame: &Frame, span: &Span, light: DVec3) -> (f64, f64) {
    let at_vertices = frame.triangles[span.triangle].normals.map(|n| n.dot(light).max(0.0));
    let at = |weights: [f64; 3]| (0..3).map(|v| weights[v] * at_vertices[v]).sum::<f64>();
    let (start, end) = (at(span.start), at(span.end));
    (start, (end - start) / f64::from(span.steps().max(1)))
}
