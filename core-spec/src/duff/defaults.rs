//! Options and formats of `duff`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{DuffFormats, DuffSpec, Highlight};
use crate::defaults::{exponent_bits, root_reach, small_q_bits, span_bits};
use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{LARGEST_ROOT_REACH, MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::power::Power;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

impl DuffSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain {
            key: "specular",
            values: &["\"blinn\"", "\"quotient\"", "\"eq33\"", "\"eq34\""],
        },
        Power::OPTION_DOMAIN,
        Places::OPTION_DOMAIN,
    ];

    /// numerics N3b, for half an LSB with the dearest highlight, Blinn's with 4n: an error e of q
    /// moves the base N·H s by e/2q, and the power 2n times as far, twice as far as in `hybrid`. So
    /// accumulators have 2 log2 S + 9 + log2 n, linear ones log2 S + 13 + log2 n, p and q 13 + log2
    /// n bits, and as many more as q can be small; the base, squared twice more than in `hybrid`,
    /// 11 + log2 n.
    pub fn for_needs(needs: &Needs) -> DuffSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs).max(4));
        let small_q = small_q_bits(needs);
        let at_most = |fraction_bits: u32| fraction_bits.min(MOST_FRACTION_BITS);
        let operand = Format::signed(1, at_most(13 + j + small_q));
        DuffSpec {
            specular: Highlight::Eq34,
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            formats: DuffFormats {
                // In short spans the operand asks for more than the sums do.
                linear_accumulator: Format::signed(
                    1,
                    (s + 13 + j + small_q / 2).max(operand.fraction_bits),
                ),
                accumulator: Format::signed(
                    3,
                    (2 * s + 9 + j + small_q).max(operand.fraction_bits),
                ),
                operand,
                root: Format::unsigned(root_reach(needs, operand.fraction_bits), at_most(12 + j)),
                way_root: ways::root_for_needs(needs, operand, at_most(12 + j)),
                quotient: Format::signed(2, at_most(12 + j)),
                cosine: Format::signed(1, at_most(11 + j)),
                diffuse: Format::unsigned(1, 12),
                base: Format::unsigned(1, at_most(11 + j)),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for DuffSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &DuffFormats {
            linear_accumulator,
            accumulator,
            operand,
            root,
            way_root,
            quotient,
            cosine,
            diffuse,
            base,
            shape: _,
        } = &self.formats;
        let (point, accumulated) = (NarrowingPoint::rounded, NarrowingPoint::accumulated);
        let (linear, quadratic) = ((1, span_bits), (2, span_bits));
        let steps = "start and step of N.L, N.V and N.H, rounded by the host";
        let differences =
            "start and differences of q = N.N and of the numerator, rounded by the host";
        // q is told from what s reaches to.
        let finest_q = (2 * root.integer_bits).max(ways::finest_square(self.places, way_root));
        let reach = Format::unsigned(root.integer_bits.clamp(1, LARGEST_ROOT_REACH), 0);
        let points = vec![
            accumulated("linear_accumulator", linear_accumulator, SIGNED_UNIT, linear, steps)
                .with_at_least(finest_q),
            accumulated("accumulator", accumulator, Format::signed(3, 0), quadratic, differences)
                .with_at_least(finest_q),
            point("operand", operand, SIGNED_UNIT, "N.L, N.V, N.H, q and the numerator")
                .no_finer_than(linear_accumulator)
                .no_finer_than(accumulator)
                .with_at_least(finest_q),
            point("root", root, reach, "s = 1/sqrt q"),
            point("quotient", quotient, Format::signed(2, 0), "N.L/q, with eq. 33"),
            point(
                "cosine",
                cosine,
                SIGNED_UNIT,
                "N.L s, N.V s and N.H s, clamped to -1..1, and L.V",
            ),
            point("diffuse", diffuse, UNIT, "N.L s, clamped at 0").no_finer_than(cosine),
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
        let base = match self.specular {
            Highlight::Blinn => "N.H/sqrt q with H = (L + V)/|L + V|, to the power 4n",
            Highlight::Quotient => "R.L = (2(N.V)(N.L) - (L.V)(N.N))/q",
            Highlight::Eq33 => "R.L = 2(N.V)(p/q) - L.V",
            Highlight::Eq34 => "R.L = 2(N.V s)(p s) - L.V, s = 1/sqrt q",
        };
        let options = [("base of the highlight", base.to_owned()), self.power.option()];
        options.into_iter().chain(self.places.option()).collect()
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "duff")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::DuffSetUp { duff: self, frame })
    }
}
