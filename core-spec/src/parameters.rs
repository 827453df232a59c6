//! What a core has whatever its method is.
use specula_datapath::{Format, Hold};
use specula_scene::limits::{LARGEST_SHININESS, LONGEST_SPAN, MOST_LIGHTS};
use specula_scene::needs::{LocalKind, Needs};

use crate::attenuation::AttenuationSpec;
use crate::components::Components;
use crate::core_input::InputRole;
use crate::error::{SpecError, within};
use crate::light_pipelines::LightPipelines;
use crate::shading_method::Viewpoint;

/// Fraction bits of colour coefficients, which count LSBs of the 8-bit output: 2^-7 LSB is lost at
/// most in each.
pub const COEFFICIENT_FRACTION_BITS: u32 = 6;
/// Full scale of the output, in LSBs.
pub const FULL_SCALE: f64 = 255.0;
/// The most integer bits of a coefficient: 256 times full scale.
const MOST_COEFFICIENT_BITS: f64 = 16.0;

/// What a core has whatever its method is.
#[derive(Clone, Debug, PartialEq)]
pub struct CoreParameters {
    /// Number of lights, 1 to [`MOST_LIGHTS`](specula_scene::limits::MOST_LIGHTS).
    pub lights: usize,
    /// What the last of them are that are at a place; those before are at infinity.
    pub local_lights: Vec<LocalKind>,
    /// Whether the eye that sees highlights is at a place.
    pub local_eye: bool,
    /// Whether spans of a frame may have different materials. If not, exponents and colours hold for
    /// a frame.
    pub several_materials: bool,
    /// Whether lights share a pipeline.
    pub light_pipelines: LightPipelines,
    /// Whether the components of vectors share multipliers.
    pub components: Components,
    /// Longest span the core can take, in pixels.
    pub longest_span: u32,
    /// Largest exponent n the core can take.
    pub largest_shininess: u32,
    /// Colour coefficients, in LSBs of the output: `U<i>.6`.
    pub coefficient: Format,
    /// Length of the shortest interpolated normal, relative to the longer end of its span. Error
    /// bounds rest on it; widths do not.
    pub shortest_normal: f64,
    /// Length of the shortest vector to a light or an eye at a place, relative to the longer one at
    /// the ends of its span. Error bounds rest on it; widths do not.
    pub shortest_way: f64,
    /// The same of vectors that have length 1 at both ends of their span. Error bounds rest on it;
    /// widths do not.
    pub shortest_unit_way: f64,
    /// Length of the shortest L + V at a pixel that sees places for itself, 0 to 2. Error bounds rest
    /// on it; widths do not.
    pub shortest_halfway: f64,
    /// Smallest cosine between a vertex normal and a face around the vertex. Error bounds rest on
    /// it; widths do not.
    pub least_cone_cosine: f64,
    /// Smallest cosine between an interpolated normal and the direction to the eye. Error bounds
    /// rest on it; widths do not.
    pub least_view_cosine: f64,
    /// Which lights become weaker with distance, if any do and pixels have to know.
    pub attenuation: Option<AttenuationSpec>,
}

impl CoreParameters {
    /// Those of a core for a scene with these needs, in which light does not become weaker.
    pub(crate) fn for_needs(
        needs: &Needs,
        light_pipelines: LightPipelines,
        components: Components,
    ) -> CoreParameters {
        CoreParameters {
            lights: needs.lights,
            local_lights: needs.local_lights.clone(),
            local_eye: needs.local_eye,
            several_materials: needs.materials > 1,
            light_pipelines,
            components,
            longest_span: needs.longest_span.next_power_of_two(),
            largest_shininess: needs.largest_shininess,
            coefficient: coefficient_format(needs.brightest_coefficient),
            shortest_normal: needs.shortest_normal,
            shortest_way: needs.shortest_way,
            shortest_unit_way: needs.shortest_unit_way,
            shortest_halfway: needs.shortest_halfway,
            least_cone_cosine: needs.least_cone_cosine,
            least_view_cosine: needs.least_view_cosine,
            attenuation: None,
        }
    }

    /// Number of lights at infinity, which are the first ones.
    pub(crate) fn lights_at_infinity(&self) -> usize {
        self.lights - self.local_lights.len()
    }

    /// Largest exponent of a spot; 1 without any.
    pub fn largest_spot_exponent(&self) -> u32 {
        let exponent = |kind: &LocalKind| match kind {
            LocalKind::Point => 1,
            LocalKind::Spot { exponent } => *exponent,
        };
        self.local_lights.iter().map(exponent).max().unwrap_or(1)
    }

    /// Whether lights or the eye are at places.
    pub fn has_places(&self) -> bool {
        self.local_eye || !self.local_lights.is_empty()
    }

    /// For how long inputs of a role stand still, unless they are held for a span anyway; lights and
    /// the eye at places are seen from `viewpoint`.
    pub(crate) fn hold(&self, role: InputRole, viewpoint: Viewpoint) -> Hold {
        let of_material = !self.several_materials;
        let of_lights = !self.has_places() || viewpoint != Viewpoint::Span;
        let holds = match role {
            InputRole::Light => of_lights,
            InputRole::Exponent | InputRole::Ambient => of_material,
            // What reaches a span of a light at a place is part of them.
            InputRole::Diffuse | InputRole::Specular => of_material && of_lights,
            InputRole::Surface => false,
        };
        if holds { Hold::Frame } else { Hold::Span }
    }

    /// The initiation interval: clocks from one pixel to the next.
    pub fn interval(&self) -> u32 {
        match (self.light_pipelines, self.components) {
            (_, Components::Serial) => 3,
            (LightPipelines::Each, _) => 1,
            (LightPipelines::Shared, _) => self.lights as u32,
        }
    }

    /// Whether the numbers are such that a core can be built.
    ///
    /// # Errors
    /// [`SpecError`] names the first that is not.
    pub(crate) fn check(&self) -> Result<(), SpecError> {
        within("lights", self.lights as f64, 1.0, MOST_LIGHTS as f64)?;
        self.check_turns()?;
        self.check_places()?;
        within("longest_span", self.longest_span.into(), 1.0, LONGEST_SPAN.into())?;
        self.check_coefficient()?;
        within("largest_shininess", self.largest_shininess.into(), 1.0, LARGEST_SHININESS.into())?;
        within("shortest_normal", self.shortest_normal, 0.0, 1.0)?;
        within("shortest_way", self.shortest_way, 0.0, 1.0)?;
        within("shortest_unit_way", self.shortest_unit_way, 0.0, 1.0)?;
        within("shortest_halfway", self.shortest_halfway, 0.0, 2.0)?;
        within("least_cone_cosine", self.least_cone_cosine, -1.0, 1.0)?;
        within("least_view_cosine", self.least_view_cosine, -1.0, 1.0)
    }

    /// What shares hardware: lights or components, not both.
    fn check_turns(&self) -> Result<(), SpecError> {
        if self.components == Components::Serial && self.light_pipelines == LightPipelines::Shared {
            let message = "lights that share a pipeline leave no clocks for `components = \"serial\"`: leave out one of `light_pipelines` and `components`";
            return Err(SpecError::Core { message: message.into() });
        }
        Ok(())
    }

    /// Lights at places.
    fn check_places(&self) -> Result<(), SpecError> {
        within("lights at a place", self.local_lights.len() as f64, 0.0, self.lights as f64)?;
        for light in &self.local_lights {
            if let LocalKind::Spot { exponent } = *light {
                within("exponent", exponent.into(), 1.0, LARGEST_SHININESS.into())?;
            }
        }
        let local = self.local_lights.len();
        self.attenuation.as_ref().map_or(Ok(()), |attenuation| attenuation.check(local))
    }

    fn check_coefficient(&self) -> Result<(), SpecError> {
        let Format { signed, integer_bits, fraction_bits } = self.coefficient;
        within("coefficient integer bits", integer_bits.into(), 1.0, MOST_COEFFICIENT_BITS)?;
        if signed || fraction_bits != COEFFICIENT_FRACTION_BITS {
            let (name, given) = ("coefficient", self.coefficient);
            let wanted = Format::unsigned(integer_bits, COEFFICIENT_FRACTION_BITS).to_string();
            let bits = COEFFICIENT_FRACTION_BITS;
            return Err(SpecError::WrongFormat {
                name,
                given,
                wanted,
                fewest_fraction_bits: bits,
                most_fraction_bits: bits,
            });
        }
        Ok(())
    }
}

/// `U<i>.6`, with room for the brightest product of light and reflectance.
fn coefficient_format(brightest: f64) -> Format {
    let integer_bits = (FULL_SCALE * brightest + 1.0).log2().ceil().max(1.0) as u32;
    Format::unsigned(integer_bits, COEFFICIENT_FRACTION_BITS)
}
