//! Set-up of one span: what the host computes in f64 and quantises into the core's formats.
use specula_datapath::SpanPacket;
use specula_scene::ParallelSpan;
use specula_scene::frame::{Colour, Frame, Material, Span};

use crate::core_spec::CoreSpec;
use crate::method_set_up::{Attenuations, Coefficients, MaterialInputs, SetUpSpan};
use crate::parameters::{CoreParameters, FULL_SCALE};
use crate::quadratic::Quadratic;
use crate::shading_method::Viewpoint;

/// Sets up spans of one frame for a core; what does not change from span to span is computed
/// once.
pub struct SetUp<'a> {
    core: &'a CoreSpec,
    frame: &'a Frame,
    /// Smallest and largest raw value of each input.
    ranges: Vec<(i64, i64)>,
    /// What belongs to each material of the frame.
    materials: Vec<MaterialInputs>,
    method: Box<dyn SetUpSpan + 'a>,
}

impl<'a> SetUp<'a> {
    /// The set-up of spans of `frame` for `core`.
    pub fn new(core: &'a CoreSpec, frame: &'a Frame) -> SetUp<'a> {
        SetUp {
            core,
            frame,
            ranges: core.inputs().iter().map(|port| port.range).collect(),
            materials: frame
                .materials
                .iter()
                .map(|material| material_inputs(&core.parameters, frame, material))
                .collect(),
            method: core.method.shading().set_up(frame),
        }
    }

    /// Sets up a span: appends the raw values of the ports, in their order, each within its port's
    /// range. Nothing is allocated besides, unless the span's middle has to be asked where lights
    /// and eye are.
    pub fn append(&self, span: &Span, out: &mut Vec<i64>) {
        let start = out.len();
        if self.core.places_seen_from() == Viewpoint::Span && !self.frame.directions_are_constant()
        {
            self.append_from_the_middle(span, out);
        } else {
            let material = &self.materials[self.frame.triangles[span.triangle].material];
            self.method.append(span, material, self.attenuations(span), out);
        }
        // In exact arithmetic nothing is out of range; f64 may be by some units of its own last
        // place, as N·N of a unit vector is.
        for (value, &(low, high)) in out[start..].iter_mut().zip(&self.ranges) {
            *value = (*value).clamp(low, high);
        }
    }

    /// A span by itself, set up.
    pub fn packet(&self, span: &Span) -> SpanPacket {
        let mut inputs = Vec::with_capacity(self.ranges.len());
        self.append(span, &mut inputs);
        SpanPacket { length: span.length, inputs }
    }

    /// As the span's middle sees lights and eye.
    fn append_from_the_middle(&self, span: &Span, out: &mut Vec<i64>) {
        let parallel = ParallelSpan::new(self.frame, span);
        let material =
            material_inputs(&self.core.parameters, &parallel.frame, &parallel.frame.materials[0]);
        let method = self.core.method.shading().set_up(&parallel.frame);
        method.append(parallel.span(), &material, self.attenuations(span), out);
    }

    /// What distance leaves of each light along a span.
    fn attenuations(&self, span: &Span) -> Attenuations {
        let parameters = &self.core.parameters;
        let of_light = |index: usize| {
            let format = parameters.attenuation_of(index)?.formats.attenuation_accumulator;
            // A light that does not become weaker is whole everywhere.
            let along = self.frame.attenuation_along(span, index).unwrap_or([1.0; 3]);
            Some(Quadratic::through(span, along).quantised(format))
        };
        (0..parameters.lights).map(of_light).collect()
    }
}

/// Light times reflectance, in LSBs.
fn material_inputs(core: &CoreParameters, frame: &Frame, material: &Material) -> MaterialInputs {
    let product = |reflectance: Colour, light: Colour| {
        std::array::from_fn(|c| core.coefficient.quantise(FULL_SCALE * reflectance[c] * light[c]))
    };
    let under = |colour: Colour| Coefficients {
        diffuse: product(material.diffuse, colour),
        specular: product(material.specular, colour),
    };
    MaterialInputs {
        ambient: product(material.ambient, frame.ambient),
        lights: frame.light_colours().map(under).collect(),
    }
}

impl CoreSpec {
    /// Sets up a span for this core; [`SetUp`] sets up many.
    pub fn packet(&self, frame: &Frame, span: &Span) -> SpanPacket {
        SetUp::new(self, frame).packet(span)
    }
}
