//! The spec for a scene: documented defaults, then what the user says in the scene file's `[core]` table.
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::hybrid::{HybridFormats, HybridSpec};
use super::lyon::{Difference, LyonFormats, LyonSpec, Normalisation};
use super::{
    COEFFICIENT_FRACTION_BITS, CoreSpec, FULL_SCALE, LARGEST_SHININESS, LONGEST_SPAN, MOST_LIGHTS, Method, MethodSpec, SpecError,
};
use crate::format::Format;
use crate::needs::Needs;

/// The most fraction bits a user may ask for at any narrowing point, accumulators apart.
const MOST_FRACTION_BITS: u32 = 24;
/// The fewest fraction bits at any narrowing point.
const FEWEST_FRACTION_BITS: u32 = 4;
/// The most integer bits of a coefficient: 256 times full scale.
const MOST_COEFFICIENT_BITS: u64 = 16;
/// The most fraction bits of an accumulator: with sign and three integer bits, 60 bits wide.
const MOST_ACCUMULATOR_FRACTION_BITS: u32 = 56;

/// The `[core]` table of a scene file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoreOptions {
    /// Name of the method.
    pub method: Option<String>,
    /// Options of `lyon` that differ from the default.
    #[serde(default)]
    pub lyon: toml::Table,
    /// Options of `hybrid` that differ from the default.
    #[serde(default)]
    pub hybrid: toml::Table,
}

impl CoreSpec {
    /// The spec for a scene with these needs: the method asked for on the command line, else the scene file's, else `lyon`, with
    /// the defaults of NUMERICS.md "Recommended formats", changed where the scene file's `[core]` table says so.
    ///
    /// # Errors
    /// [`SpecError`] if there is no such method, or the method or its formats cannot serve the scene.
    pub fn for_scene(needs: &Needs, table: Option<&CoreOptions>, method: Option<Method>) -> Result<CoreSpec, SpecError> {
        let default = CoreOptions::default();
        let table = table.unwrap_or(&default);
        let named = table.method.as_deref().map(Method::from_name).transpose()?;
        let method = match method.or(named).unwrap_or(Method::Lyon) {
            Method::Lyon => MethodSpec::Lyon(merged(&LyonSpec::for_needs(needs), &table.lyon)?),
            Method::Hybrid => MethodSpec::Hybrid(merged(&HybridSpec::for_needs(needs), &table.hybrid)?),
        };
        let spec = CoreSpec {
            lights: needs.lights,
            longest_span: needs.longest_span.next_power_of_two(),
            largest_shininess: needs.largest_shininess,
            coefficient: coefficient_format(needs.brightest_coefficient),
            shortest_normal: needs.shortest_normal,
            method,
        };
        spec.check()?;
        spec.check_serves(needs)?;
        Ok(spec)
    }

    /// Whether formats and numbers are such that a core can be built.
    ///
    /// # Errors
    /// [`SpecError`] names the first that is not.
    pub fn check(&self) -> Result<(), SpecError> {
        within("lights", self.lights as u64, 1, MOST_LIGHTS as u64)?;
        within("longest_span", self.longest_span.into(), 1, LONGEST_SPAN.into())?;
        within("coefficient integer bits", self.coefficient.integer_bits.into(), 1, MOST_COEFFICIENT_BITS)?;
        within("largest_shininess", self.largest_shininess.into(), 1, LARGEST_SHININESS.into())?;
        match &self.method {
            MethodSpec::Lyon(lyon) => lyon.check(span_bits(self.longest_span)),
            MethodSpec::Hybrid(hybrid) => hybrid.check(span_bits(self.longest_span)),
        }
    }

    fn check_serves(&self, needs: &Needs) -> Result<(), SpecError> {
        match (self.method(), needs.uneven_shininess) {
            (Method::Hybrid, Some(shininess)) => {
                let above = shininess.next_power_of_two();
                Err(SpecError::UnevenShininess { shininess, below: above / 2, above })
            }
            _ => Ok(()),
        }
    }
}

/// `U<i>.6`, with room for the brightest product of light and reflectance.
fn coefficient_format(brightest: f64) -> Format {
    let integer_bits = (FULL_SCALE * brightest + 1.0).log2().ceil().max(1.0) as u32;
    Format::unsigned(integer_bits, COEFFICIENT_FRACTION_BITS)
}

/// Bits that number the pixels of the longest span.
fn span_bits(longest_span: u32) -> u32 {
    longest_span.next_power_of_two().ilog2()
}

impl LyonSpec {
    /// NUMERICS.md "Recommended formats": the typical column up to 30 degrees and n = 256, else the extreme column.
    pub fn for_needs(needs: &Needs) -> LyonSpec {
        let typical = needs.widest_angle <= 30.0 && needs.largest_shininess <= 256;
        let (vector, fine, shape) = if typical { (14, 14, 12) } else { (17, 19, 14) };
        LyonSpec {
            normalisation: Normalisation::G2,
            newton_steps: u32::from(!typical),
            difference: Difference::HalfwayCrossNormal,
            squarings: 2,
            formats: LyonFormats {
                // A step is off by half an ulp, and so is S times that at the end of the span: log2 S + 1 more bits keep the
                // weight within half an ulp of its own format.
                weight_accumulator: Format::unsigned(1, vector + span_bits(needs.longest_span) + 1),
                weight: Format::unsigned(1, vector),
                vector: Format::signed(1, vector),
                length_squared: Format::unsigned(1, fine),
                gain: Format::unsigned(2, fine),
                diffuse: Format::unsigned(1, shape),
                difference: Format::signed(2, vector),
                shape: Format::unsigned(1, shape),
            },
        }
    }

    /// `span_bits` number the pixels of the longest span.
    fn check(&self, span_bits: u32) -> Result<(), SpecError> {
        within("newton_steps", self.newton_steps.into(), 0, 3)?;
        within("squarings", self.squarings.into(), 0, 3)?;
        let f = &self.formats;
        accumulator("weight_accumulator", f.weight_accumulator, Format::unsigned(1, 0))?;
        // S steps, each off by half a unit of the last place, must leave the weight near 1 at the end of the span.
        fine_enough("weight_accumulator", f.weight_accumulator, span_bits + 3)?;
        coarser("weight", f.weight, f.weight_accumulator)?;
        narrowing("weight", f.weight, Format::unsigned(1, 0))?;
        narrowing("vector", f.vector, Format::signed(1, 0))?;
        narrowing("length_squared", f.length_squared, Format::unsigned(1, 0))?;
        narrowing("gain", f.gain, Format::unsigned(2, 0))?;
        narrowing("diffuse", f.diffuse, Format::unsigned(1, 0))?;
        // D·D has twice the fraction bits, n another 13, and all of it must fit 63 bits.
        narrowing_to("difference", f.difference, Format::signed(2, 0), 20)?;
        narrowing("shape", f.shape, Format::unsigned(1, 0))
    }
}

impl HybridSpec {
    /// NUMERICS.md 3b: accumulators for half an LSB, 2 log2 S + 8 + log2 n; the base's bits alone and one more for its
    /// squares, 9 + log2 n; p and q as in direct
    /// evaluation, 12 + log2 n, and as many more as q can be small.
    pub fn for_needs(needs: &Needs) -> HybridSpec {
        let (s, j) = (span_bits(needs.longest_span), needs.largest_shininess.max(1).ilog2());
        let small_q = (-2.0 * needs.shortest_normal.max(0.0625).log2()).ceil() as u32;
        let operand = (12 + j.max(4) + small_q).min(MOST_FRACTION_BITS);
        HybridSpec {
            formats: HybridFormats {
                diffuse_accumulator: Format::signed(1, 12 + s + 1),
                diffuse: Format::unsigned(1, 12),
                // In short spans the operand asks for more than the sums do.
                accumulator: Format::signed(3, (2 * s + 8 + j.max(4) + small_q).max(operand)),
                operand: Format::signed(1, operand),
                base: Format::unsigned(1, 9 + j.max(4)),
            },
        }
    }

    /// `span_bits` number the pixels of the longest span.
    fn check(&self, span_bits: u32) -> Result<(), SpecError> {
        let f = &self.formats;
        fine_enough("diffuse_accumulator", f.diffuse_accumulator, span_bits + 3)?;
        // Second differences add up to S²/4 units of the last place (NUMERICS 3b), which must stay well below 1.
        fine_enough("accumulator", f.accumulator, 2 * span_bits + 3)?;
        accumulator("diffuse_accumulator", f.diffuse_accumulator, Format::signed(1, 0))?;
        narrowing("diffuse", f.diffuse, Format::unsigned(1, 0))?;
        coarser("diffuse", f.diffuse, f.diffuse_accumulator)?;
        accumulator("accumulator", f.accumulator, Format::signed(3, 0))?;
        narrowing("operand", f.operand, Format::signed(1, 0))?;
        coarser("operand", f.operand, f.accumulator)?;
        narrowing("base", f.base, Format::unsigned(1, 0))
    }
}

/// The default with the user's keys in place of its own.
fn merged<T: Serialize + DeserializeOwned>(default: &T, changes: &toml::Table) -> Result<T, SpecError> {
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

fn within(name: &'static str, value: u64, low: u64, high: u64) -> Result<(), SpecError> {
    if (low..=high).contains(&value) { Ok(()) } else { Err(SpecError::OutOfRange { name, value, low, high }) }
}

fn narrowing(name: &'static str, given: Format, shape: Format) -> Result<(), SpecError> {
    narrowing_to(name, given, shape, MOST_FRACTION_BITS)
}

fn accumulator(name: &'static str, given: Format, shape: Format) -> Result<(), SpecError> {
    narrowing_to(name, given, shape, MOST_ACCUMULATOR_FRACTION_BITS)
}

fn narrowing_to(name: &'static str, given: Format, shape: Format, most_fraction_bits: u32) -> Result<(), SpecError> {
    let fits = given.signed == shape.signed
        && given.integer_bits == shape.integer_bits
        && (FEWEST_FRACTION_BITS..=most_fraction_bits).contains(&given.fraction_bits);
    let wanted = Format { fraction_bits: 14, ..shape }.to_string();
    if fits {
        Ok(())
    } else {
        Err(SpecError::WrongFormat { name, given, wanted, fewest_fraction_bits: FEWEST_FRACTION_BITS, most_fraction_bits })
    }
}

/// Errors of an accumulator grow with the span, so the longest span asks for fraction bits.
fn fine_enough(name: &'static str, given: Format, fewest: u32) -> Result<(), SpecError> {
    if given.fraction_bits >= fewest {
        return Ok(());
    }
    let wanted = format!("{}, since the longest span adds up its error", Format { fraction_bits: fewest, ..given });
    Err(SpecError::WrongFormat {
        name,
        given,
        wanted,
        fewest_fraction_bits: fewest,
        most_fraction_bits: MOST_ACCUMULATOR_FRACTION_BITS,
    })
}

/// A value rounded from an accumulator cannot have more fraction bits than it.
fn coarser(name: &'static str, given: Format, accumulator: Format) -> Result<(), SpecError> {
    let most_fraction_bits = accumulator.fraction_bits;
    if given.fraction_bits <= most_fraction_bits {
        return Ok(());
    }
    Err(SpecError::WrongFormat {
        name,
        given,
        wanted: format!("a format no finer than {accumulator}"),
        fewest_fraction_bits: FEWEST_FRACTION_BITS,
        most_fraction_bits,
    })
}
