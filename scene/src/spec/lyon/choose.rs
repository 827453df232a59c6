//! Options and formats of `lyon`: defaults for a scene, and what may be asked for.
use super::{Difference, LyonFormats, LyonSpec, Normalisation};
use crate::format::Format;
use crate::frame::Frame;
use crate::needs::Needs;
use crate::spec::choose::{span_bits, within};
use crate::spec::describe::Describe;
use crate::spec::narrowing::{SIGNED_UNIT, UNIT};
use crate::spec::set_up::SetUpSpan;
use crate::spec::{Choice, CoreSpec, InputPort, NarrowingPoint, SpecError};

impl LyonSpec {
    /// Options and their values.
    pub const CHOICES: &'static [Choice] = &[
        Choice { key: "normalisation", values: &["\"g1\"", "\"g2\""] },
        Choice { key: "newton_steps", values: &["0", "1", "2", "3"] },
        Choice { key: "difference", values: &["\"reflection-minus-light\"", "\"halfway-cross-normal\""] },
        Choice { key: "squarings", values: &["0", "1", "2", "3"] },
    ];

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
}

impl Describe for LyonSpec {
    fn ports(&self, core: &CoreSpec) -> Vec<InputPort> {
        self.inputs(core).to_vec()
    }

    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &LyonFormats { weight_accumulator, weight, vector, length_squared, gain, diffuse, difference, shape } = &self.formats;
        let point = NarrowingPoint::rounded;
        let accumulated = "step of the interpolation weight, rounded by the host";
        vec![
            NarrowingPoint::accumulated("weight_accumulator", weight_accumulator, UNIT, (1, span_bits), accumulated),
            point("weight", weight, UNIT, "interpolation weight a").no_finer_than(weight_accumulator),
            point("vector", vector, SIGNED_UNIT, "components of N' = N0 + a (N1 - N0) and of n = g N'"),
            point("length_squared", length_squared, UNIT, "z = N'.N'"),
            point("gain", gain, Format::unsigned(2, 0), "g, about 1/sqrt(z)"),
            point("diffuse", diffuse, UNIT, "n.L, clamped at 0"),
            // D·D has twice the fraction bits, n another 13, and all of it must fit 63 bits.
            point("difference", difference, Format::signed(2, 0), "components of D").with_at_most(20),
            point("shape", shape, UNIT, "x = n D.D / 2^(k+1), and each square of 1 - x"),
        ]
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let first = match self.normalisation {
            Normalisation::G1 => "g1 = 1 + y/2",
            Normalisation::G2 => "g2 = 1 + (y + y^2)/2",
        };
        let difference = match self.difference {
            Difference::ReflectionMinusLight => "D = R - L",
            Difference::HalfwayCrossNormal => "D = H x N",
        };
        vec![
            ("normalisation", format!("{first}, y = 1 - z")),
            ("Newton steps", self.newton_steps.to_string()),
            ("difference", difference.to_owned()),
            ("shape", format!("f = (1 - x)^(2^k), 0 from x = 1 on; k = {}", self.squarings)),
        ]
    }

    fn check_options(&self) -> Result<(), SpecError> {
        within("newton_steps", self.newton_steps.into(), 0, 3)?;
        within("squarings", self.squarings.into(), 0, 3)
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::LyonSetUp::new(self, frame))
    }
}
