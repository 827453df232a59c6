//! Lights that become weaker with distance, whatever the method is [Hast, Barrera and Bengtsson,
//! §1].
//!
//! What distance leaves of a light, A = min(1, 1/(c + l d + q d²)), goes along a span as a quadratic
//! in the pixel number, through its values at both ends and half-way, by additions as Hast's p and q
//! do (eq. 17 to 26). A core with it divides by nothing and takes no root; how far the quadratic is
//! from A is part of the method's error (decision 0043).
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::Needs;
use specula_scene::limits::MOST_LIGHTS;

use crate::core_input::CoreInput;
use crate::defaults::span_bits;
use crate::error::{SpecError, within};
use crate::formats::formats;
use crate::merge::merged;
use crate::narrowing::{MOST_ACCUMULATOR_FRACTION_BITS, NarrowingPoint, UNIT};
use crate::parameters::CoreParameters;
use crate::quadratic::Quadratic;

/// How far a quadratic through three values from 0 to 1 goes beyond them: it is from -1/8 to 9/8.
pub const OVERSHOOT: f64 = 0.125;

/// The lights that become weaker with distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AttenuationSpec {
    /// Which of those at places they are, counted from 0, in rising order.
    pub lights: Vec<usize>,
    /// The narrowing points.
    pub formats: AttenuationFormats,
}

formats! {
    /// The narrowing points of lights that become weaker, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct AttenuationFormats {
        /// Accumulators of A and its differences: `S3.f`. The host rounds start and differences into
        /// it.
        pub attenuation_accumulator: Format,
        /// A, rounded from the accumulator and kept within 0 to 1: `U1.f`.
        pub attenuation: Format,
        /// Diffuse and specular intensity times A: `U1.f`.
        pub attenuated: Format,
    }
}

impl AttenuationFormats {
    /// The formats of these narrowing points in a method's table, which then has them no more: a user
    /// names them beside those of the method.
    pub(crate) fn taken_from(options: &mut toml::Table) -> toml::Table {
        let names = ["attenuation_accumulator", "attenuation", "attenuated"];
        let Some(formats) = options.get_mut("formats").and_then(toml::Value::as_table_mut) else {
            return toml::Table::new();
        };
        names
            .into_iter()
            .filter_map(|name| Some((name.to_owned(), formats.remove(name)?)))
            .collect()
    }
}

impl AttenuationSpec {
    /// That of a scene with these needs, with `changes` in place of default formats; `None` where no
    /// light becomes weaker.
    ///
    /// Accumulators are for a sixteenth of an LSB, 2 log2 S + 10 (numerics N3b).
    pub(crate) fn for_needs(
        needs: &Needs,
        changes: &toml::Table,
    ) -> Result<Option<AttenuationSpec>, SpecError> {
        if needs.attenuated_lights.is_empty() {
            return Ok(None);
        }
        let attenuation = Format::unsigned(1, 12);
        // In short spans the share asks for more than the sums do.
        let sums = (2 * span_bits(needs.longest_span) + 10)
            .clamp(attenuation.fraction_bits, MOST_ACCUMULATOR_FRACTION_BITS);
        let default = AttenuationFormats {
            attenuation_accumulator: Format::signed(3, sums),
            attenuation,
            attenuated: Format::unsigned(1, 12),
        };
        let formats = merged(&default, changes)?;
        Ok(Some(AttenuationSpec { lights: needs.attenuated_lights.clone(), formats }))
    }

    /// Every place where values are rounded, in the order of the data.
    pub(crate) fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &AttenuationFormats { attenuation_accumulator, attenuation, attenuated } =
            &self.formats;
        let differences = "start and differences of what distance leaves of light, rounded by the \
                           host";
        vec![
            NarrowingPoint::accumulated(
                "attenuation_accumulator",
                attenuation_accumulator,
                Format::signed(3, 0),
                (2, span_bits),
                differences,
            ),
            NarrowingPoint::rounded(
                "attenuation",
                attenuation,
                UNIT,
                "what distance leaves of light, clamped to 0..1",
            )
            .no_finer_than(attenuation_accumulator),
            NarrowingPoint::rounded(
                "attenuated",
                attenuated,
                UNIT,
                "diffuse and specular intensities times what distance leaves",
            ),
        ]
    }

    /// Whether its lights are among so many at places.
    ///
    /// # Errors
    /// [`SpecError`] says which is not.
    pub(crate) fn check(&self, local_lights: usize) -> Result<(), SpecError> {
        within("lights that become weaker", self.lights.len() as f64, 1.0, MOST_LIGHTS as f64)?;
        let mut least = 0;
        for &light in &self.lights {
            let (low, high) = (f64::from(least), local_lights as f64 - 1.0);
            within("a light that becomes weaker", light as f64, low, high)?;
            least = light as u32 + 1;
        }
        Ok(())
    }
}

impl CoreParameters {
    /// How light number `index` becomes weaker, those at places counted last; `None` if it does not.
    pub fn attenuation_of(&self, index: usize) -> Option<&AttenuationSpec> {
        let local = index.checked_sub(self.lights_at_infinity())?;
        self.attenuation.as_ref().filter(|attenuation| attenuation.lights.contains(&local))
    }

    /// The inputs of that, if it does.
    pub(crate) fn attenuation_inputs(&self, index: usize) -> Option<Quadratic<CoreInput>> {
        let format = self.attenuation_of(index)?.formats.attenuation_accumulator;
        let name = format!("light{index}_attenuation");
        Some(Quadratic::share_inputs("A, what distance leaves of the light,", &name, format))
    }
}
