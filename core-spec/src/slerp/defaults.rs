//! Formats of `slerp`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{Basis, Edges, Form, SlerpFormats, SlerpSpec};
use crate::defaults::{exponent_bits, span_bits};
use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::power::Power;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

/// The most fraction bits of the state and of what turns it: their product has two bits more on the
/// left and must fit 63.
const MOST_STATE_BITS: u32 = 28;
const MOST_TURN_BITS: u32 = 30;

impl SlerpSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        Power::OPTION_DOMAIN,
        Places::OPTION_DOMAIN,
        OptionDomain { key: "form", values: &["\"scalar\"", "\"vector\""] },
        OptionDomain { key: "frame", values: &["\"orthonormal\"", "\"ends\""] },
        OptionDomain { key: "edges", values: &["\"linear\"", "\"slerp\""] },
    ];

    /// An angle that is off by e moves cos^n by 1.2 √n e, and every step may add 0.9 units of the
    /// state's last place: with n = 2^j, log2 S + 9 + j/2 bits (numerics N3d has log2 S + 8 for the
    /// diffuse intensity alone), and two more for what turns it. A scalar that is off by e moves
    /// the base by 2e and cos^n by 2 n e: 11 + j bits.
    pub fn for_needs(needs: &Needs) -> SlerpSpec {
        let (s, j) = (span_bits(needs.longest_span), exponent_bits(needs));
        let state = (s + 9 + j.max(4).div_ceil(2)).min(MOST_STATE_BITS);
        let scalar = (11 + j.max(4)).min(MOST_FRACTION_BITS);
        let cosine = Format::signed(1, scalar);
        SlerpSpec {
            form: Form::Scalar,
            frame: Basis::Orthonormal,
            edges: Edges::Linear,
            power: Power::for_needs(needs),
            places: Places::for_needs(needs),
            formats: SlerpFormats {
                turn: Format::signed(1, state + 2),
                state: Format::signed(1, state),
                // 1/sin f makes errors of what turns it up to 5.76 times as large.
                scaled_state: Format::signed(3, (state + 3).min(MOST_STATE_BITS)),
                weight: Format::signed(1, (12 + j.max(4).div_ceil(2)).min(state)),
                vector: Format::signed(1, (scalar + 1).min(MOST_FRACTION_BITS)),
                component: Format::signed(1, scalar),
                cosine,
                way_accumulator: ways::accumulator_for_spans(s, cosine),
                way_root: ways::root_for_needs(needs, cosine, scalar),
                diffuse: Format::unsigned(1, 12),
                base: Format::unsigned(1, 9 + j.max(4)),
                shape: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for SlerpSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &SlerpFormats {
            turn,
            state,
            scaled_state,
            weight,
            vector,
            component,
            cosine,
            way_accumulator,
            way_root,
            diffuse,
            base,
            shape: _,
        } = &self.formats;
        let (point, accumulated) = (NarrowingPoint::rounded, NarrowingPoint::accumulated);
        let linear = (1, span_bits);
        let turned = "cosine and sine of the angle from pixel to pixel, rounded by the host";
        let mut points = vec![
            accumulated("turn", turn, SIGNED_UNIT, linear, turned).with_at_most(MOST_TURN_BITS),
        ];
        if self.between_ends() {
            let angles =
                "cosines and sines of the angles from both ends over sin f, rounded at every pixel";
            let (reach, words) =
                (Format::signed(3, 0), "weights of both ends, as they are multiplied with");
            points.push(
                accumulated("scaled_state", scaled_state, reach, linear, angles)
                    .with_at_most(MOST_STATE_BITS),
            );
            points.push(point("weight", weight, SIGNED_UNIT, words).no_finer_than(scaled_state));
        } else {
            let angle = "cosine and sine of the angle from the first pixel, rounded at every pixel";
            points.push(
                accumulated("state", state, SIGNED_UNIT, linear, angle)
                    .with_at_most(MOST_STATE_BITS),
            );
            points.push(
                point(
                    "weight",
                    weight,
                    SIGNED_UNIT,
                    "cosine and sine, as they are multiplied with",
                )
                .no_finer_than(state),
            );
        }
        let (scalars, cosines) = match self.form {
            Form::Scalar => (
                "A.L, T.L, A.V, T.V and L.V, rounded by the host",
                "J = N.L, K = N.V, 2 - N.N, and K (2 - N.N)",
            ),
            Form::Vector => ("L.V, rounded by the host", "(3 - N.N)/2, J = n.L and K = n.V"),
        };
        if self.form == Form::Vector {
            points.push(point(
                "vector",
                vector,
                SIGNED_UNIT,
                "components of N, and of n = N (3 - N.N)/2",
            ));
        }
        points.extend([
            point("component", component, SIGNED_UNIT, scalars),
            point("cosine", cosine, SIGNED_UNIT, cosines)
                .with_at_least(ways::finest_square(self.places, way_root)),
            point("diffuse", diffuse, UNIT, "J, clamped to 0..1").no_finer_than(cosine),
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
        let words = match (self.form, self.frame) {
            (Form::Scalar, _) => "N.L and N.V, in an orthonormal frame",
            (Form::Vector, Basis::Orthonormal) => "the normal itself, in an orthonormal frame",
            (Form::Vector, Basis::Ends) => {
                "the normal itself, between the ends; linear below 10 degrees"
            }
        };
        let mut options = vec![("what turns", words.to_owned())];
        if self.edges == Edges::Slerp {
            options.push(("edges", "normals at them by slerp from vertex to vertex".to_owned()));
        }
        options.push(self.power.option());
        options.extend(self.places.option());
        options
    }

    fn check_compatible(&self, needs: &Needs) -> Result<(), SpecError> {
        self.power.check_compatible(needs, "slerp")
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::SlerpSetUp { slerp: self, frame })
    }
}
