//! Options and formats of `reflection`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{Bisector, Highlight, ReflectionFormats, ReflectionSpec};
use crate::defaults::{exponent_bits, small_q_bits, span_bits};
use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{
    MOST_ACCUMULATOR_FRACTION_BITS, MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT,
};
use crate::power::Power;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

impl ReflectionSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain { key: "bisector", values: &["\"span\"", "\"triangle\""] },
        OptionDomain { key: "specular", values: &["\"blinn\"", "\"hybrid\"", "\"eq34\""] },
        Power::OPTION_DOMAIN,
        Places::OPTION_DOMAIN,
    ];

    /// numerics N3b, for half an LSB with the dearest highlight: as `duff`, and a bit more in
    /// accumulators and operands, since q of H is 1/2 or more up to 90 degrees; as many more as q
    /// of N can be small, for the hybrid's highlight.
    pub fn for_needs(needs: &Needs) -> ReflectionSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs).max(4));
        let small_q = small_q_bits(needs);
        let at_most = |fraction_bits: u32| fraction_bits.min(MOST_FRACTION_BITS);
        let operand = Format::signed(1, at_most(14 + j + small_q));
        ReflectionSpec {
            bisector: Bisector::Span,
            specular: Highlight::Eq34,
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            formats: ReflectionFormats {
                // In short spans the operand asks for more than the sums do.
                accumulator: Format::signed(
                    3,
                    (2 * s + 10 + j + small_q)
                        .clamp(operand.fraction_bits, MOST_ACCUMULATOR_FRACTION_BITS),
                ),
                operand,
                reciprocal: Format::unsigned(3, at_most(12 + j)),
                way_root: ways::root_for_needs(needs, operand, at_most(12 + j)),
                cosine: Format::signed(1, at_most(11 + j)),
                diffuse: Format::unsigned(1, 12),
                base: Format::unsigned(1, at_most(11 + j)),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for ReflectionSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &ReflectionFormats {
            accumulator,
            operand,
            reciprocal,
            way_root,
            cosine,
            diffuse,
            base,
            shape: _,
        } = &self.formats;
        let point = NarrowingPoint::rounded;
        let finest_square = ways::finest_square(self.places, way_root);
        let differences = "start and differences of squares and numerators, rounded by the host";
        let points = vec![
            NarrowingPoint::accumulated(
                "accumulator",
                accumulator,
                Format::signed(3, 0),
                (2, span_bits),
                differences,
            )
            .with_at_least(finest_square),
            point("operand", operand, SIGNED_UNIT, "q = H.H and the numerators")
                .no_finer_than(accumulator)
                .with_at_least(finest_square),
            point("reciprocal", reciprocal, Format::unsigned(3, 0), "1/q"),
            point("cosine", cosine, SIGNED_UNIT, "N'.L, N'.V and N'.H, clamped to -1..1, and L.V"),
            point("diffuse", diffuse, UNIT, "N'.L, clamped at 0").no_finer_than(cosine),
            point(
                "base",
                base,
                UNIT,
                "base of the highlight, and each square of it where power = squaring",
            )
            .no_finer_than(cosine),
        ];
        let points = points.into_iter().chain(ways::narrowing_point(self.places, way_root));
        points.chain(self.power_unit().narrowing_point()).collect()
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let n = match self.bisector {
            Bisector::Span => "half-way between the normals at the span's ends",
            Bisector::Triangle => "the sum of the triangle's vertex normals",
        };
        let base = match self.specular {
            Highlight::Blinn => "N'.H with H = (L + V)/|L + V|, to the power 4n",
            Highlight::Hybrid => "R.L = (2(N.V)(N.L) - (L.V)(N.N))/(N.N)",
            Highlight::Eq34 => "R.L = 2(N'.V)(N'.L) - L.V",
        };
        let options = [
            ("fixed normal", n.to_owned()),
            ("base of the highlight", base.to_owned()),
            self.power.option(),
        ];
        options.into_iter().chain(self.places.option()).collect()
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "reflection")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::ReflectionSetUp { reflection: self, frame })
    }
}
