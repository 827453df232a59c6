//! A core: parameters, a method, and what its inputs are given.
use specula_datapath::{Format, Hold, InputPort};
use specula_scene::needs::Needs;

use crate::attenuation::{AttenuationFormats, AttenuationSpec};
use crate::components::Components;
use crate::core_input::{CoreInput, InputRole};
use crate::defaults::span_bits;
use crate::error::SpecError;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, InputGroup, MethodInputs};
use crate::light_pipelines::LightPipelines;
use crate::method::{Method, MethodSpec};
use crate::narrowing::NarrowingPoint;
use crate::options::CoreOptions;
use crate::parameters::CoreParameters;
use crate::shading_method::{DirectionOutput, Viewpoint};
use crate::specialisation::Specialisation;
use crate::target_clock::TargetClock;

/// The most bits by which formats are finer for bright highlights.
const MOST_BITS_FOR_HIGHLIGHTS: f64 = 2.0;

/// A core: a span goes in, and with every [`CoreParameters::interval`] clocks a pixel comes out.
#[derive(Clone, Debug, PartialEq)]
pub struct CoreSpec {
    /// What it has whatever its method is.
    pub parameters: CoreParameters,
    /// How pixels are shaded.
    pub method: MethodSpec,
    /// What its inputs are given over the frames that it is for.
    pub specialisation: Specialisation,
    /// The clock that it is made for; without, operators have a register each, for any device.
    pub target: Option<TargetClock>,
}

/// The inputs of a core by a method: their ports.
pub type Ports<M> = CoreInputs<
    <<M as MethodInputs>::SpanGroup as InputGroup>::Mapped<InputPort>,
    <<M as MethodInputs>::LightGroup as InputGroup>::Mapped<InputPort>,
    InputPort,
>;

impl CoreSpec {
    /// The spec for a scene with these needs: the method asked for on the command line, else the
    /// scene file's, else `lyon`, or `phong` where a light or the eye is at a place, with the
    /// defaults of numerics N5, changed where the scene file's `[core]` table says so. Directions to
    /// places that are asked to be wrapped are true ones where wraps may move colours by more than
    /// 3 LSB.
    ///
    /// # Errors
    /// [`SpecError`] if there is no such method, or the method or its formats cannot serve the
    /// scene.
    pub fn for_scene(
        needs: &Needs,
        table: Option<&CoreOptions>,
        method: Option<Method>,
    ) -> Result<CoreSpec, SpecError> {
        let default = CoreOptions::default();
        let table = table.unwrap_or(&default);
        let kept = table.kept()?;
        let needs = &kept.relaxed(needs);
        let named = table.named_method()?;
        let method = method.or(named).unwrap_or(Method::default_for(needs));
        let pipelines = table.light_pipelines.unwrap_or_default();
        let components = table.components.unwrap_or_default();
        let mut options = table.method_table(method);
        let of_lights = AttenuationFormats::taken_from(&mut options);
        let mut spec = CoreSpec {
            parameters: CoreParameters::for_needs(needs, pipelines, components),
            method: with_places_that_serve(method.spec(needs, &options)?, needs),
            specialisation: Specialisation::keeping(kept),
            target: None,
        };
        spec.check_kept()?;
        spec.parameters.least_view_cosine = spec.least_view_cosine(needs);
        if spec.places_seen_from() != Viewpoint::Vertex {
            spec.parameters.attenuation = AttenuationSpec::for_needs(needs, &of_lights)?;
        }
        let spec = spec.for_highlights(needs, &table.named_formats(method));
        spec.check()?;
        spec.method.shading().check_compatible(needs)?;
        Ok(spec)
    }

    /// The same core with finer formats where a colour is brighter than full scale, but for those
    /// that are `named`.
    ///
    /// docs/numerics.md recommends formats by errors of intensities times full scale. Twice as
    /// bright, and those errors are twice as large: a bit more in every format. Two are the most,
    /// since what is four times full scale is white but for the highlight's edge.
    fn for_highlights(self, needs: &Needs, named: &[String]) -> CoreSpec {
        let bits =
            needs.brightest_coefficient.max(1.0).log2().ceil().min(MOST_BITS_FOR_HIGHLIGHTS) as i32;
        let kept: Vec<&str> = named.iter().map(String::as_str).collect();
        (1..=bits).rev().find_map(|added| self.finer(added, &kept)).unwrap_or(self)
    }

    /// Whether formats and numbers are such that a core can be built.
    ///
    /// # Errors
    /// [`SpecError`] names the first that is not.
    pub fn check(&self) -> Result<(), SpecError> {
        self.parameters.check()?;
        self.target.as_ref().map_or(Ok(()), TargetClock::check)?;
        self.method.shading().check_options()?;
        self.narrowing_points().iter().try_for_each(NarrowingPoint::check)?;
        if self.specialisation.is_general() {
            return Ok(());
        }
        self.specialisation.check(&self.general().inputs())
    }

    /// Whether every input that is to be kept is one.
    fn check_kept(&self) -> Result<(), SpecError> {
        let inputs = self.method.core_inputs(&self.parameters);
        let Some(stranger) = self.specialisation.kept().stranger(&inputs) else { return Ok(()) };
        let names: Vec<&str> = inputs.iter().map(|input| input.port.name.as_str()).collect();
        let message = format!(
            "there is no `{stranger}` to keep; `keep` has \"lights\", \"materials\", \"camera\", \"objects\" or an input: {}",
            names.join(", ")
        );
        Err(SpecError::Core { message })
    }

    /// Which method this is.
    pub fn method(&self) -> Method {
        self.method.method()
    }

    /// The same core for any frame.
    pub fn general(&self) -> CoreSpec {
        CoreSpec { specialisation: self.specialisation.general(), ..self.clone() }
    }

    /// The directions that leave the core beside a pixel's colour, in the order of their ports.
    pub fn direction_outputs(&self) -> &'static [DirectionOutput] {
        self.method.shading().direction_outputs()
    }

    /// Where lights and the eye at places are seen from.
    pub fn places_seen_from(&self) -> Viewpoint {
        self.method.shading().places_seen_from()
    }

    /// Whether the core follows the ways from pixels to lights and eye at places.
    pub fn follows_ways(&self) -> bool {
        self.parameters.has_places() && self.places_seen_from() == Viewpoint::Pixel
    }

    /// The smallest cosine between normals and the direction to the eye, as the core sees it.
    pub(crate) fn least_view_cosine(&self, needs: &Needs) -> f64 {
        if self.follows_ways() {
            needs.least_view_cosine_of_pixels
        } else {
            needs.least_view_cosine
        }
    }

    /// The ports of the core's data inputs in the order in which packets hold them; `valid` and
    /// `start` come beside them.
    pub fn inputs(&self) -> Vec<InputPort> {
        let inputs = self.method.core_inputs(&self.parameters);
        inputs.iter().map(|input| self.port(input)).collect()
    }

    /// What each of [`CoreSpec::inputs`] tells of a scene.
    pub fn input_roles(&self) -> Vec<InputRole> {
        self.method.core_inputs(&self.parameters).iter().map(|input| input.meaning.role).collect()
    }

    /// What each of [`CoreSpec::inputs`] is, and how a host computes it.
    pub fn input_meanings(&self) -> Vec<InputMeaning> {
        self.method.core_inputs(&self.parameters).into_iter().map(|input| input.meaning).collect()
    }

    /// The ports of [`CoreSpec::inputs`] by the names that `method`, which is this core's, has for
    /// them.
    pub fn ports<M: MethodInputs>(&self, method: &M) -> Ports<M> {
        let inputs = method.core_inputs(&self.parameters);
        inputs.map(|input| self.port(input))
    }

    /// The port of an input of the method, as it is here.
    fn port(&self, input: &CoreInput) -> InputPort {
        let hold = match input.port.hold {
            Hold::Frame => self.parameters.hold(input.meaning.role, self.places_seen_from()),
            Hold::Span => Hold::Span,
        };
        InputPort { hold, ..self.specialisation.narrowed(&input.port) }
    }

    /// Every place where values are rounded, those of the method first, in the order of the data.
    pub fn narrowing_points(&self) -> Vec<NarrowingPoint> {
        let span_bits = span_bits(self.parameters.longest_span);
        let attenuation = self.parameters.attenuation.iter();
        let of_lights = attenuation.flat_map(|attenuation| attenuation.narrowing_points(span_bits));
        self.method.shading().narrowing_points(span_bits).into_iter().chain(of_lights).collect()
    }

    /// The format of the narrowing point called `name`.
    pub(crate) fn format_mut(&mut self, name: &str) -> Option<&mut Format> {
        let attenuation = self.parameters.attenuation.as_mut();
        let of_lights = attenuation.and_then(|attenuation| attenuation.formats.named_mut(name));
        of_lights.or_else(|| self.method.format_mut(name))
    }

    /// The same core for any scene, with other formats at these narrowing points.
    ///
    /// # Errors
    /// [`SpecError`] if there is no such point, or it may not have the format.
    pub fn with_formats(&self, formats: &[(&str, Format)]) -> Result<CoreSpec, SpecError> {
        let mut spec = self.general();
        for &(name, format) in formats {
            let wrong = || SpecError::Core { message: format!("no narrowing point `{name}`") };
            *spec.format_mut(name).ok_or_else(wrong)? = format;
        }
        spec.check()?;
        Ok(spec)
    }

    /// The options of the method: names and values, for people to read.
    pub fn method_options(&self) -> Vec<(&'static str, String)> {
        self.method.shading().options()
    }

    /// What else the spec says: names and values, for people to read.
    pub fn options(&self) -> Vec<(&'static str, String)> {
        let parameters = &self.parameters;
        let mut options = vec![
            ("lights", parameters.lights.to_string()),
            ("longest span", format!("{} pixels", parameters.longest_span)),
            ("largest exponent n", parameters.largest_shininess.to_string()),
            (
                "colour coefficients",
                format!("{}, in LSBs of the 8-bit output", parameters.coefficient),
            ),
            (
                "shortest interpolated normal",
                format!(
                    "{:.3} of the longer one at the ends of its span",
                    parameters.shortest_normal
                ),
            ),
        ];
        if parameters.light_pipelines == LightPipelines::Shared {
            options.push((
                "light pipelines",
                format!(
                    "one, in which the lights take turns: {} clocks a pixel",
                    parameters.interval()
                ),
            ));
        }
        if parameters.components == Components::Serial {
            let words = format!(
                "one after another through one multiplier: {} clocks a pixel",
                parameters.interval()
            );
            options.push(("components", words));
        }
        options.extend(self.method_options());
        options.push(("made for", self.specialisation.in_words()));
        options.push(("can shade", self.can_shade()));
        options
    }
}

/// Directions to places that are asked to be wrapped are true ones where wraps do not serve a scene.
fn with_places_that_serve(method: MethodSpec, needs: &Needs) -> MethodSpec {
    match method {
        MethodSpec::Phong(phong) => MethodSpec::Phong(phong.with_places_for(needs)),
        other => other,
    }
}
