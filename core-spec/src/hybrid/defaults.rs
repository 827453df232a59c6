//! Formats of `hybrid`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{HybridFormats, HybridSpec};
use crate::defaults::{exponent_bits, small_q_bits, span_bits};
use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::power::Power;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

impl HybridSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] =
        &[Power::OPTION_DOMAIN, Places::OPTION_DOMAIN];

    /// numerics N3b: accumulators for half an LSB, 2 log2 S + 8 + log2 n; the base's bits alone
    /// and one more for its squares, 9 + log2 n; p and q as in direct evaluation, 12 + log2 n, and
    /// as many more as q can be small.
    pub fn for_needs(needs: &Needs) -> HybridSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs));
        let small_q = small_q_bits(needs);
        let operand = Format::signed(1, (12 + j.max(4) + small_q).min(MOST_FRACTION_BITS));
        HybridSpec {
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            formats: HybridFormats {
                diffuse_accumulator: Format::signed(1, 12 + s + 1),
                diffuse: Format::unsigned(1, 12),
                // In short spans the operand asks for more than the sums do.
                accumulator: Format::signed(
                    3,
                    (2 * s + 8 + j.max(4) + small_q).max(operand.fraction_bits),
                ),
                operand,
                way_root: ways::root_for_needs(needs, operand, 12 + j.max(4)),
                base: Format::unsigned(1, 9 + j.max(4)),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for HybridSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &HybridFormats {
            diffuse_accumulator,
            diffuse,
            accumulator,
            operand,
            way_root,
            base,
            shape: _,
        } = &self.formats;
        let (point, accumulated) = (NarrowingPoint::rounded, NarrowingPoint::accumulated);
        let (linear, quadratic) = ((1, span_bits), (2, span_bits));
        let finest_square = ways::finest_square(self.places, way_root);
        let intensity = "start and step of the diffuse intensity, rounded by the host";
        let differences = "start and differences of p and q, rounded by the host";
        let points = vec![
            accumulated("diffuse_accumulator", diffuse_accumulator, SIGNED_UNIT, linear, intensity),
            point("diffuse", diffuse, UNIT, "diffuse intensity, clamped to 0..1")
                .no_finer_than(diffuse_accumulator),
            accumulated("accumulator", accumulator, Format::signed(3, 0), quadratic, differences)
                .with_at_least(finest_square),
            point("operand", operand, SIGNED_UNIT, "p and q as they enter the divider")
                .no_finer_than(accumulator)
                .with_at_least(finest_square),
            point("base", base, UNIT, "p/q, and each square of it where power = squaring"),
        ];
        let points = points.into_iter().chain(ways::narrowing_point(self.places, way_root));
        points.chain(self.power_unit().narrowing_point()).collect()
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        [self.power.option()].into_iter().chain(self.places.option()).collect()
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "hybrid")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::HybridSetUp { hybrid: self, frame })
    }
}
