//! Formats of `direct`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{DirectFormats, DirectSpec, Root};
use crate::defaults::{exponent_bits, span_bits};
use crate::error::{SpecError, within};
use crate::increments::Increments;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::power::Power;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

/// The most integer bits m of 1/√q: normals shorter than 2^-m come out short.
const LARGEST_REACH: u32 = 4;

impl DirectSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        Power::OPTION_DOMAIN,
        Places::OPTION_DOMAIN,
        Increments::OPTION_DOMAIN,
        OptionDomain { key: "root", values: &["\"exact\"", "\"newton\""] },
        OptionDomain { key: "newton_steps", values: &["1", "2"] },
    ];

    /// numerics N3b, direct evaluation: 12 + log2 n for what enters the base, whatever the length
    /// of the span, and as many more as q can be small; t turns the normal alone, which shows by
    /// √n. Two of Newton's steps serve spans of any length up to 90 degrees (numerics N3c).
    pub fn for_needs(needs: &Needs) -> DirectSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs).max(4));
        let reach = (-needs.shortest_normal.max(0.0625).log2()).ceil() as u32;
        let most = |bits: u32| bits.min(MOST_FRACTION_BITS);
        let weight = 12 + j.div_ceil(2) + reach;
        let cosine = Format::signed(1, most(12 + j + reach));
        DirectSpec {
            root: Root::Exact,
            newton_steps: 2,
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            increments: Increments::Multiplied,
            formats: DirectFormats {
                weight_accumulator: Format::unsigned(1, weight + s + 1),
                weight: Format::unsigned(1, weight),
                product: Format::unsigned(1, most(14 + j + 2 * reach)),
                spread: Format::unsigned(3, most(12 + j + 2 * reach)),
                component: Format::signed(1, most(12 + j + reach)),
                scalar_accumulator: Format::signed(1, cosine.fraction_bits + s + 1),
                length_squared: Format::unsigned(1, most(12 + j + 2 * reach)),
                length: Format::unsigned(1, most(12 + j + reach)),
                reciprocal: Format::unsigned(reach, most(12 + j)),
                cosine,
                way_accumulator: ways::accumulator_for_spans(s, cosine),
                way_root: ways::root_for_needs(needs, cosine, most(12 + j)),
                diffuse: Format::unsigned(1, 12),
                base: Format::unsigned(1, 9 + j),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for DirectSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &DirectFormats {
            weight_accumulator,
            weight,
            product,
            spread,
            component,
            scalar_accumulator,
            length_squared,
            length,
            reciprocal,
            cosine,
            way_accumulator,
            way_root,
            diffuse,
            base,
            shape: _,
        } = &self.formats;
        let point = NarrowingPoint::rounded;
        // `check_options` limits the integer bits.
        let reach = Format::unsigned(reciprocal.integer_bits, 0);
        let values = ["step of t, rounded by the host", "t"];
        let components = match self.increments {
            Increments::Multiplied => {
                "A.L, A.V, their differences to B's, and L.V, rounded by the host"
            }
            Increments::Added => "L.V, rounded by the host",
        };
        let mut points =
            NarrowingPoint::weight([weight_accumulator, weight], span_bits, values).to_vec();
        points.extend([
            point("product", product, UNIT, "t (1 - t)"),
            point("spread", spread, Format::unsigned(3, 0), "|B - A|^2, rounded by the host"),
            point("component", component, SIGNED_UNIT, components),
        ]);
        if self.increments == Increments::Added {
            let steps = "start and step of N.L and N.V, rounded by the host";
            let order = (1, span_bits);
            points.push(
                NarrowingPoint::accumulated(
                    "scalar_accumulator",
                    scalar_accumulator,
                    SIGNED_UNIT,
                    order,
                    steps,
                )
                .with_at_least(cosine.fraction_bits),
            );
        }
        points.extend([
            // A reciprocal root tells 4^-m from 0.
            point("length_squared", length_squared, UNIT, "q = N.N")
                .with_at_least(2 * LARGEST_REACH),
        ]);
        if self.root == Root::Newton {
            // 4^-m has the root 2^-m.
            points.push(
                point("length", length, UNIT, "q/d, and d = sqrt(q) by Newton's method")
                    .with_at_least(LARGEST_REACH),
            );
        }
        points.extend([
            point("reciprocal", reciprocal, reach, "1/sqrt(q)"),
            point("cosine", cosine, SIGNED_UNIT, "N.L and N.V, and both times 1/sqrt(q)")
                .with_at_least(ways::finest_square(self.places, way_root)),
            point("diffuse", diffuse, UNIT, "N.L/sqrt(q), clamped to 0..1").no_finer_than(cosine),
            point(
                "base",
                base,
                UNIT,
                "2 J K - L.V, clamped to 0..1, and each square of it where power = squaring",
            ),
        ]);
        points.extend(ways::accumulator_point(self.places, way_accumulator, cosine, span_bits));
        points.extend(ways::narrowing_point(self.places, way_root));
        points.extend(self.power_unit().narrowing_point());
        points
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let steps = match self.newton_steps {
            1 => "1 step".to_owned(),
            steps => format!("{steps} steps"),
        };
        let root = match self.root {
            Root::Exact => "1/sqrt(q), correctly rounded".to_owned(),
            Root::Newton => format!("{steps} of Newton's method from the pixel before"),
        };
        let options = [("root", root), self.power.option()];
        let along = self.increments.option("J = J + dJ and K = K + dK");
        options.into_iter().chain(self.places.option()).chain(along).collect()
    }

    fn check_options(&self) -> Result<(), SpecError> {
        within("newton_steps", self.newton_steps.into(), 1.0, 2.0)?;
        within(
            "reciprocal integer bits",
            self.formats.reciprocal.integer_bits.into(),
            0.0,
            LARGEST_REACH.into(),
        )
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "direct")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::DirectSetUp { direct: self, frame })
    }
}
