//! Options and formats of `consistent`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{
    ConsistentFormats, ConsistentSpec, Curve, Diffuse, Directions, Highlight, LARGEST_GAIN_BITS,
};
use crate::defaults::{exponent_bits, span_bits};
use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{
    INTERPOLATION_WEIGHT, MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT,
};
use crate::power::Power;
use crate::shading_method::{DirectionOutput, OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

/// The most fraction bits of ρ², twice those of ρ.
const MOST_SQUARED_FRACTION_BITS: u32 = 48;

/// 60 degrees, in quarter turns.
const SIXTY_DEGREES: f64 = 2.0 / 3.0;

impl ConsistentSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain { key: "curve", values: &["\"rational\"", "\"trigonometric\""] },
        OptionDomain { key: "diffuse", values: &["\"lambert\"", "\"consistent\""] },
        OptionDomain { key: "highlight", values: &["\"reflection\"", "\"blinn\""] },
        Power::OPTION_DOMAIN,
        Places::OPTION_DOMAIN,
    ];

    /// Options that change no pixel, and their values.
    pub const OUTPUT_DOMAINS: &'static [OptionDomain] = &[Directions::OPTION_DOMAIN];

    /// numerics N5 and N3e: 14 bits, 2 more for wide angles, and as many more
    /// as the power n multiplies what rounding adds to the length of r. ρ² has twice the bits of ρ
    /// where α comes near a quarter turn, where its root is steep, and else as many more as ρ ≥ q
    /// asks for.
    pub fn for_needs(needs: &Needs) -> ConsistentSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs));
        let curve = Curve::Rational;
        let widest = curve.quarter_turns(needs.least_cone_cosine);
        let steep = f64::max(1.0 - widest, 0.0).powi(2) / 2.0;
        let for_wide_angles = if widest > SIXTY_DEGREES { 2 } else { 0 };
        let fine = (11 + j.max(3) + for_wide_angles).min(MOST_FRACTION_BITS);
        let finer = |bits: u32| (fine + bits).min(MOST_FRACTION_BITS);
        let squared = (fine + 2 + (-steep.max(1e-9).log2()).ceil() as u32).min(2 * fine);
        let unit = |fraction_bits| Format::unsigned(1, fraction_bits);
        ConsistentSpec {
            curve,
            diffuse: Diffuse::Lambert,
            highlight: Highlight::Reflection,
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            directions: Directions::None,
            formats: ConsistentFormats {
                // A step is off by half an ulp, and so is S times that at the end of the span: log2
                // S + 1 more bits keep the weight within half an ulp of its own format.
                weight_accumulator: unit(fine + s + 1),
                weight: unit(fine),
                vector: Format::signed(1, fine),
                // What is added to z weighs more the shorter the normal, N' as much.
                length_squared: unit(finer(4)),
                gain: Format::unsigned(LARGEST_GAIN_BITS, finer(1)),
                // q falls by as much as 3.14 t grows by, and ρ by more.
                angle_accumulator: Format::signed(1, finer(2) + s + 1),
                angle: unit(finer(2)),
                tangent: unit(finer(2)),
                contraction: unit(finer(2)),
                cosine: Format::signed(1, fine),
                sine_ratio_squared: unit(squared),
                sine_ratio: unit(fine),
                way_accumulator: ways::vector_accumulator_for_spans(s, Format::signed(1, fine)),
                diffuse: unit(12),
                base: unit(11 + j.max(4)),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for ConsistentSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &ConsistentFormats {
            weight_accumulator,
            weight,
            vector,
            length_squared,
            gain,
            angle_accumulator,
            angle,
            tangent,
            contraction,
            cosine,
            sine_ratio_squared,
            sine_ratio,
            way_accumulator,
            diffuse,
            base,
            shape: _,
        } = &self.formats;
        let (point, accumulated, linear) =
            (NarrowingPoint::rounded, NarrowingPoint::accumulated, (1, span_bits));
        let angles = "start and step of t, rounded up by the host";
        let [step, interpolation] =
            NarrowingPoint::weight([weight_accumulator, weight], span_bits, INTERPOLATION_WEIGHT);
        let points = vec![
            step,
            interpolation,
            point(
                "vector",
                vector,
                SIGNED_UNIT,
                "components of N' = N0 + a (N1 - N0), of n = N'/|N'| and of r",
            ),
            point("length_squared", length_squared, UNIT, "z = N'.N'"),
            point("gain", gain, Format::unsigned(LARGEST_GAIN_BITS, 0), "1/sqrt(z), at most 16"),
            accumulated("angle_accumulator", angle_accumulator, SIGNED_UNIT, linear, angles),
            point("angle", angle, UNIT, "t = 2 alpha/pi, rounded up, at most 1")
                .no_finer_than(angle_accumulator),
            point(
                "tangent",
                tangent,
                UNIT,
                "tan(pi (1 - t)/4) and the steps of its polynomial (curve = trigonometric)",
            ),
            point("contraction", contraction, UNIT, "q, rounded down"),
            point("cosine", cosine, SIGNED_UNIT, "b = n.I, g = 1 + q (b - 1), and g + rho b"),
            point("sine_ratio_squared", sine_ratio_squared, UNIT, "rho^2 = q (1 + g)/(1 + b)")
                .up_to(MOST_SQUARED_FRACTION_BITS),
            point("sine_ratio", sine_ratio, UNIT, "rho"),
            point("diffuse", diffuse, UNIT, "n.L or |L + r|/2, clamped to 0..1"),
            point(
                "base",
                base,
                UNIT,
                "r.L or N_c.H, clamped to 0..1, and each square of it where power = squaring",
            ),
        ];
        let of_ways =
            ways::vector_accumulator_point(self.places, way_accumulator, vector, span_bits);
        points.into_iter().chain(of_ways).chain(self.power_unit().narrowing_point()).collect()
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let curve = match self.curve {
            Curve::Rational => "q = (1 - t)^2/(1 + (pi - 2) t)",
            Curve::Trigonometric => "q = (1 - sin alpha)/(1 + sin alpha)",
        };
        let diffuse = match self.diffuse {
            Diffuse::Lambert => "n.L",
            Diffuse::Consistent => "N_c.L, N_c half-way between L and its consistent reflection",
        };
        let base = match self.highlight {
            Highlight::Reflection => "r.L",
            Highlight::Blinn => "N_c.H with H = (L + V)/|L + V|, to the power 4n",
        };
        let options = [("curve", curve), ("diffuse", diffuse), ("base of the highlight", base)];
        options
            .map(|(name, value)| (name, value.to_owned()))
            .into_iter()
            .chain([self.power.option()])
            .chain(self.places.option())
            .chain(self.directions.option())
            .collect()
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "consistent")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn direction_outputs(&self) -> &'static [DirectionOutput] {
        self.directions.outputs()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::ConsistentSetUp::new(self, frame))
    }
}
