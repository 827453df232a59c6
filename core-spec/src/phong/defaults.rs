//! Options and formats of `phong`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{Highlight, PhongFormats, PhongSpec, Places};
use crate::defaults::span_bits;
use crate::error::SpecError;
use crate::increments::Increments;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{INTERPOLATION_WEIGHT, NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::vector_accumulator_for_spans;

impl PhongSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain {
            key: "highlight",
            values: &[
                "\"reflection\"",
                "\"blinn\"",
                "\"torrance-sparrow\"",
                "\"trowbridge-reitz\"",
            ],
        },
        OptionDomain { key: "places", values: &["\"exact\"", "\"wrapped\""] },
        Increments::OPTION_DOMAIN,
    ];

    /// An error e of the base moves (R·L)^n by n e at most, so half an LSB asks for log2 n + 9 bits
    /// of it (numerics N3b, "power base bits alone", has 16 for n = 256 and 21 for 8000), and two
    /// more of the cosines and vectors it is made of, whose errors add up; short vectors lose bits
    /// as they are made long. Wrapped vectors are off by up to 4 units of the last place of H·w and
    /// H·H.
    pub fn for_needs(needs: &Needs) -> PhongSpec {
        let exponent_bits = needs.largest_shininess.max(1).next_power_of_two().ilog2();
        let short =
            (-needs.shortest_normal.min(needs.shortest_way).max(0.0625).log2()).ceil() as u32;
        let base = (exponent_bits.max(4) + 9).min(22);
        let vector = (base + 2 + short).min(22);
        let span_bits = span_bits(needs.longest_span);
        PhongSpec {
            highlight: Highlight::Reflection,
            places: Places::Exact,
            increments: Increments::Multiplied,
            formats: PhongFormats {
                weight_accumulator: Format::unsigned(1, vector + span_bits + 1),
                weight: Format::unsigned(1, vector),
                vector_accumulator: vector_accumulator_for_spans(
                    span_bits,
                    Format::signed(1, vector),
                ),
                vector: Format::signed(1, vector),
                length_squared: Format::unsigned(2, (vector + 2 + short).min(24)),
                gain: Format::unsigned(4, (vector + 1).min(24)),
                wrap_operand: Format::unsigned(3, (vector + 2).min(24)),
                wrap_ratio: Format::unsigned(1, (vector + 2).min(24)),
                cosine: Format::signed(1, (base + 2).min(24)),
                base: Format::unsigned(1, base),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for PhongSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &PhongFormats {
            weight_accumulator,
            weight,
            vector_accumulator: _,
            vector,
            length_squared,
            gain,
            wrap_operand,
            wrap_ratio,
            cosine,
            base,
            shape,
        } = &self.formats;
        let point = NarrowingPoint::rounded;
        let mut points = match self.increments {
            Increments::Multiplied => {
                let formats = [weight_accumulator, weight];
                NarrowingPoint::weight(formats, span_bits, INTERPOLATION_WEIGHT).to_vec()
            }
            Increments::Added => {
                vec![self.span_vectors().accumulator_point("vector_accumulator", span_bits)]
            }
        };
        points.extend([
            point(
                "vector",
                vector,
                SIGNED_UNIT,
                "components of interpolated vectors, and of n, l and v",
            )
            .with_at_most(22),
            point("length_squared", length_squared, Format::unsigned(2, 0), "squared lengths"),
            point("gain", gain, Format::unsigned(4, 0), "1 over a length, saturated"),
        ]);
        if self.places == Places::Wrapped {
            points.push(point(
                "wrap_operand",
                wrap_operand,
                Format::unsigned(3, 0),
                "H.w and H.H, H = w + (F - P)",
            ));
            points.push(point("wrap_ratio", wrap_ratio, UNIT, "v = H.w / H.H"));
        }
        points.extend([
            point("cosine", cosine, SIGNED_UNIT, "n.l, n.v and v.l"),
            point("base", base, UNIT, "R.L or H*.N, clamped to 0..1, or 1 - H*.N").with_at_most(22),
            point("shape", shape, UNIT, "powers, and the share of a spot").with_at_most(16),
        ]);
        points
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let highlight = match self.highlight {
            Highlight::Reflection => "(R.L)^n, R.L = 2(N.V)(N.L) - V.L",
            Highlight::Blinn => "(H*.N)^4n, H* = (L + V)/|L + V|",
            Highlight::TorranceSparrow => "exp(-2n a^2), a the angle between H* and N",
            Highlight::TrowbridgeReitz => "(1/(1 + (1 - (H*.N)^2) n))^2",
        };
        let mut options = vec![("highlight", highlight.to_owned())];
        if self.places == Places::Wrapped {
            options.push((
                "directions to places",
                "2v H - w, H = w + (F - P), v = H.w / H.H".to_owned(),
            ));
        }
        options.extend(self.increments.option("N' = N' + dN"));
        options
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.check_wraps(needs)
    }

    fn places_seen_from(&self) -> Viewpoint {
        Viewpoint::Pixel
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::PhongSetUp { phong: self, frame })
    }
}
