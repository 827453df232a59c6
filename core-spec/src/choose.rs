//! The spec for a scene: documented defaults, then what the user says in the scene file's `[core]`
//! table.
use serde::Serialize;
use serde::de::DeserializeOwned;
use specula_datapath::Format;
use specula_scene::limits::{LARGEST_SHININESS, LONGEST_SPAN, MOST_LIGHTS};
use specula_scene::needs::{LocalKind, Needs};

use super::narrowing::LARGEST_ROOT_REACH;
use super::{
    COEFFICIENT_FRACTION_BITS, CoreOptions, CoreSpec, FULL_SCALE, LightPipelines, Method,
    NarrowingPoint, SpecError, Specialisation,
};

/// The most integer bits of a coefficient: 256 times full scale.
const MOST_COEFFICIENT_BITS: f64 = 16.0;
/// The most bits by which formats are finer for bright highlights.
const MOST_BITS_FOR_HIGHLIGHTS: f64 = 2.0;

impl CoreSpec {
    /// The spec for a scene with these needs: the method asked for on the command line, else the
    /// scene file's, else `lyon`, with and `phong` where a light or the eye is at a place, with the
    /// defaults of numerics N5, changed where the scene file's `[core]` table
    /// says so.
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
        let named = table.method.as_deref().map(Method::from_name).transpose()?;
        let method = method.or(named).unwrap_or(Method::default_for(needs));
        let spec = CoreSpec {
            lights: needs.lights,
            local_lights: needs.local_lights.clone(),
            local_eye: needs.local_eye,
            light_pipelines: table.light_pipelines.unwrap_or_default(),
            longest_span: needs.longest_span.next_power_of_two(),
            largest_shininess: needs.largest_shininess,
            coefficient: coefficient_format(needs.brightest_coefficient),
            shortest_normal: needs.shortest_normal,
            shortest_way: needs.shortest_way,
            shortest_unit_way: needs.shortest_unit_way,
            least_cone_cosine: needs.least_cone_cosine,
            least_view_cosine: needs.least_view_cosine,
            method: method.spec(needs, &table.of(method))?,
            specialisation: Specialisation::default(),
        };
        let spec = spec.for_highlights(needs, &table.of(method));
        spec.check()?;
        spec.method.describe().check_serves(needs)?;
        Ok(spec)
    }

    /// The same core with finer formats where a colour is brighter than full scale, but for those
    /// that `changes` names.
    ///
    /// docs/numerics.md recommends formats by errors of intensities times full scale. Twice as
    /// bright, and those errors are twice as large: a bit more in every format. Two are the most,
    /// since what is four times full scale is white but for the highlight's edge.
    fn for_highlights(self, needs: &Needs, changes: &toml::Table) -> CoreSpec {
        let bits =
            needs.brightest_coefficient.max(1.0).log2().ceil().min(MOST_BITS_FOR_HIGHLIGHTS) as i32;
        let formats = changes.get("formats").and_then(toml::Value::as_table);
        let kept: Vec<&str> =
            formats.into_iter().flat_map(toml::Table::keys).map(String::as_str).collect();
        (1..=bits).rev().find_map(|added| self.finer(added, &kept)).unwrap_or(self)
    }

    /// Whether formats and numbers are such that a core can be built.
    ///
    /// # Errors
    /// [`SpecError`] names the first that is not.
    pub fn check(&self) -> Result<(), SpecError> {
        within("lights", self.lights as f64, 1.0, MOST_LIGHTS as f64)?;
        self.check_places()?;
        within("longest_span", self.longest_span.into(), 1.0, LONGEST_SPAN.into())?;
        self.check_coefficient()?;
        within("largest_shininess", self.largest_shininess.into(), 1.0, LARGEST_SHININESS.into())?;
        within("shortest_normal", self.shortest_normal, 0.0, 1.0)?;
        within("shortest_way", self.shortest_way, 0.0, 1.0)?;
        within("shortest_unit_way", self.shortest_unit_way, 0.0, 1.0)?;
        within("least_cone_cosine", self.least_cone_cosine, -1.0, 1.0)?;
        within("least_view_cosine", self.least_view_cosine, -1.0, 1.0)?;
        self.method.describe().check_options()?;
        self.narrowing_points().iter().try_for_each(NarrowingPoint::check)?;
        self.check_specialisation()
    }

    /// Lights at places.
    fn check_places(&self) -> Result<(), SpecError> {
        within("lights at a place", self.local_lights.len() as f64, 0.0, self.lights as f64)?;
        for light in &self.local_lights {
            if let LocalKind::Spot { exponent } = *light {
                within("exponent", exponent.into(), 1.0, LARGEST_SHININESS.into())?;
            }
        }
        Ok(())
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

    /// Every place where the method rounds values, in the order of the data.
    pub fn narrowing_points(&self) -> Vec<NarrowingPoint> {
        self.method.describe().narrowing_points(span_bits(self.longest_span))
    }

    /// The same core for any scene, with other formats at these narrowing points.
    ///
    /// # Errors
    /// [`SpecError`] if there is no such point, or it may not have the format.
    pub fn with_formats(&self, formats: &[(&str, Format)]) -> Result<CoreSpec, SpecError> {
        let formats = formats
            .iter()
            .map(|&(name, format)| (name.to_owned(), format.to_string().into()))
            .collect();
        let changes = [("formats".to_owned(), toml::Value::Table(formats))].into_iter().collect();
        let spec = CoreSpec { method: self.method.with(&changes)?, ..self.general() };
        spec.check()?;
        Ok(spec)
    }

    /// The options of the method: names and values, for people to read.
    pub fn method_options(&self) -> Vec<(&'static str, String)> {
        self.method.describe().options()
    }

    /// What else the spec says: names and values, for people to read.
    pub fn options(&self) -> Vec<(&'static str, String)> {
        let mut options = vec![
            ("lights", self.lights.to_string()),
            ("longest span", format!("{} pixels", self.longest_span)),
            ("largest exponent n", self.largest_shininess.to_string()),
            ("colour coefficients", format!("{}, in LSBs of the 8-bit output", self.coefficient)),
            (
                "shortest interpolated normal",
                format!("{:.3} of the longer one at the ends of its span", self.shortest_normal),
            ),
        ];
        if self.light_pipelines == LightPipelines::Shared {
            options.push((
                "light pipelines",
                format!("one, in which the lights take turns: {} clocks a pixel", self.interval()),
            ));
        }
        options.extend(self.method_options());
        options.push(("made for", self.specialisation.in_words()));
        options
    }
}

/// `U<i>.6`, with room for the brightest product of light and reflectance.
fn coefficient_format(brightest: f64) -> Format {
    let integer_bits = (FULL_SCALE * brightest + 1.0).log2().ceil().max(1.0) as u32;
    Format::unsigned(integer_bits, COEFFICIENT_FRACTION_BITS)
}

/// Bits that number the pixels of the longest span.
pub(super) fn span_bits(longest_span: u32) -> u32 {
    longest_span.next_power_of_two().ilog2()
}

/// Bits by which q = N·N falls short of 1 where normals are shortest; 8 at most, which spans of 165
/// degrees take.
pub(super) fn small_q_bits(needs: &Needs) -> u32 {
    (-2.0 * needs.shortest_normal.max(0.0625).log2()).ceil() as u32
}

/// Integer bits m of 1/√q that reach twice as far as the shortest normal asks, so that rounding
/// cannot lead past them; q of `operand` fraction bits tells 4^-m from 0.
pub(super) fn root_reach(needs: &Needs, operand: u32) -> u32 {
    let shortest = needs.shortest_normal.max(0.5f64.powi(LARGEST_ROOT_REACH as i32));
    ((-shortest.log2()).ceil() as u32 + 1).min(operand / 2).min(LARGEST_ROOT_REACH)
}

/// log₂ n of the largest exponent, rounded up: how many bits of its base are lost in the power.
pub(super) fn exponent_bits(needs: &Needs) -> u32 {
    needs.largest_shininess.max(1).next_power_of_two().ilog2()
}

/// The default with the user's keys in place of its own.
pub(super) fn merged<T: Serialize + DeserializeOwned>(
    default: &T,
    changes: &toml::Table,
) -> Result<T, SpecError> {
    let fail = |message: String| SpecError::Core { message };
    let mut table = toml::Table::try_from(default).map_err(|e| fail(e.to_string()))?;
    overlay(&mut table, changes);
    table.try_into().map_err(|e: toml::de::Error| fail(e.message().to_owned()))
}

fn overlay(table: &mut toml::Table, changes: &toml::Table) {
    for (key, change) in changes {
        match (table.get_mut(key), change) {
            (Some(toml::Value::Table(inner)), toml::Value::Table(change)) => overlay(inner, change),
            _ => {
                table.insert(key.clone(), change.clone());
            }
        }
    }
}

/// Whether a number is one that cores can be built for.
pub(super) fn within(name: &'static str, value: f64, low: f64, high: f64) -> Result<(), SpecError> {
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(SpecError::OutOfRange { name, value, low, high })
    }
}
