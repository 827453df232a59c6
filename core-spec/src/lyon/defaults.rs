//! Options and formats of `lyon`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{
    Difference, Halfway, LyonFormats, LyonSpec, Normalisation, Normals, ShapeDatapath, WrapAxis,
};
use crate::defaults::span_bits;
use crate::error::{SpecError, within};
use crate::increments::Increments;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{
    FEWEST_FRACTION_BITS, INTERPOLATION_WEIGHT, MOST_FRACTION_BITS, NarrowingPoint, SIGNED_UNIT,
    UNIT,
};
use crate::parameters::FULL_SCALE;
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};
use crate::ways::{self, Places};

/// The fewest fraction bits on the way from one wrapped normal to the next.
const FEWEST_TO_FOLLOW: u32 = 8;

impl LyonSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain { key: "normals", values: &["\"linear\"", "\"flat\"", "\"wrapped\""] },
        OptionDomain { key: "axis", values: &["\"bisector\"", "\"face\"", "\"previous\""] },
        Increments::OPTION_DOMAIN,
        OptionDomain {
            key: "normalisation",
            values: &["\"none\"", "\"g1\"", "\"g2\"", "\"exact\""],
        },
        OptionDomain { key: "newton_steps", values: &["0", "1", "2", "3"] },
        OptionDomain {
            key: "difference",
            values: &[
                "\"reflection-minus-light\"",
                "\"light-reflection\"",
                "\"halfway-projection\"",
                "\"halfway-cross-normal\"",
                "\"unit-halfway-minus-normal\"",
                "\"unit-halfway-projection\"",
            ],
        },
        OptionDomain { key: "halfway", values: &["\"unit\"", "\"half\"", "\"half-g2\""] },
        OptionDomain { key: "shape", values: &["\"f-k\"", "\"root\""] },
        OptionDomain { key: "squarings", values: &["0", "1", "2", "3", "4"] },
        OptionDomain { key: "odd_power", values: &["1", "3", "5", "7", "9", "11", "13", "15"] },
        Places::OPTION_DOMAIN,
    ];

    /// numerics N5: the typical column up to 30 degrees and n = 256, else the
    /// extreme column.
    pub fn for_needs(needs: &Needs) -> LyonSpec {
        let typical = needs.widest_angle <= 30.0 && needs.largest_shininess <= 256;
        let (vector, fine, shape) = if typical { (14, 14, 12) } else { (17, 19, 14) };
        let span_bits = span_bits(needs.longest_span);
        let accumulator = ways::vector_accumulator_for_spans(span_bits, Format::signed(1, vector));
        LyonSpec {
            normals: Normals::Linear,
            axis: WrapAxis::Bisector,
            increments: Increments::Multiplied,
            normalisation: cheapest_normalisation(needs),
            newton_steps: u32::from(!typical).max(newton_steps_for_ways(needs)),
            difference: Difference::HalfwayCrossNormal,
            halfway: Halfway::Unit,
            shape: ShapeDatapath::FK,
            squarings: 2,
            odd_power: 1,
            places: Places::for_needs(needs),
            formats: LyonFormats {
                // A step is off by half an ulp, and so is S times that at the end of the span: log2
                // S + 1 more bits keep the weight within half an ulp of its own format.
                weight_accumulator: Format::unsigned(1, vector + span_bits + 1),
                weight: Format::unsigned(1, vector),
                normal_accumulator: accumulator,
                vector: Format::signed(1, vector),
                // N' is off by up to 4 of their units of the last place, and by half of its own.
                wrap_operand: Format::unsigned(3, fine + 2),
                wrap_ratio: Format::unsigned(1, fine + 2),
                length_squared: Format::unsigned(1, fine),
                gain: Format::unsigned(2, fine),
                way_accumulator: accumulator,
                product: WHOLE_PRODUCT,
                diffuse: Format::unsigned(1, shape),
                difference: Format::signed(2, vector),
                // m is off by 2^-9 at most, and f by 2/m of that and less: 0.3 LSB where m is √2.
                root_shininess: Format::unsigned(7, if typical { 8 } else { 10 }),
                // A bit more of D, as bright highlights ask for, must have room too.
                shininess_share: Format::unsigned(13, shape.min(room_for_share(vector + 1))),
                scaled_difference: Format::unsigned(8, shape),
                shape: Format::unsigned(1, shape),
            },
        }
    }
}

/// The most fraction bits of a share of n where D has so many: of the 62 bits of n D·D, D·D has twice
/// D's and 3 more, and the share of n 13 whole ones.
fn room_for_share(difference_bits: u32) -> u32 {
    46_u32.saturating_sub(2 * difference_bits).max(FEWEST_FRACTION_BITS)
}

/// The product of two numbers with the most fraction bits, which is not truncated.
const WHOLE_PRODUCT: Format = Format::signed(3, 2 * MOST_FRACTION_BITS);
/// With sign and three integer bits, 60 bits wide.
const MOST_PRODUCT_FRACTION_BITS: u32 = 56;
/// Fraction bits that products have more than their factors where a search begins (decision 0038).
const GUARD_BITS: u32 = 4;

/// From so short a way on three of Newton's steps do not suffice.
const SHORTEST_FOR_NEWTON: f64 = 0.5;

/// Newton steps behind g2 for the ways of a scene: a way of length r is r (1 + (y + y²)/2) long
/// after g2, with y = 1 - r², and a step makes an error e of that 3e²/2.
///
/// ```text
/// r    after g2   1 step     2 steps    3 steps
/// 0.8  0.2 %      1e-5
/// 0.7  3 %        1.3e-3     3e-6
/// 0.5  17 %       4 %        2.5e-3     1e-5
/// ```
fn newton_steps_for_ways(needs: &Needs) -> u32 {
    match needs.shortest_way {
        _ if !needs.has_places() => 0,
        r if r >= 0.8 => 1,
        r if r >= 0.7 => 2,
        _ => 3,
    }
}

/// The cheapest normalisation that makes the shortest normal long enough, or g2, of which
/// docs/numerics.md says when it takes a Newton step.
///
/// A normal of length r is r g1 = (3r - r³)/2 long after g1. Where it is too short by 2^-11, N·L at
/// full scale is 1/8 LSB too small. D = R - L, which takes it worst, is off by twice as much along
/// itself, and f_2 moves with it by 0.67 √n: that is to be half an LSB at most.
fn cheapest_normalisation(needs: &Needs) -> Normalisation {
    let ways = if needs.has_places() { needs.shortest_way } else { 1.0 };
    if ways < SHORTEST_FOR_NEWTON {
        return Normalisation::Exact;
    }
    let r = needs.shortest_normal.min(ways);
    let steepest = 0.67 * f64::from(needs.largest_shininess).sqrt();
    let most = (1.0 / 2048.0_f64).min(0.5 / (2.0 * steepest * FULL_SCALE));
    match (1.0 - r, 1.0 - (3.0 * r - r * r * r) / 2.0) {
        (as_it_is, _) if as_it_is <= most => Normalisation::None,
        (_, after_g1) if after_g1 <= most => Normalisation::G1,
        _ => Normalisation::G2,
    }
}

impl ShadingMethod for LyonSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        let f = &self.formats;
        let point = NarrowingPoint::rounded;
        let mut points = self.normal_points(span_bits);
        points.extend(ways::vector_accumulator_point(
            self.places,
            f.way_accumulator,
            f.vector,
            span_bits,
        ));
        let product = "products of N'.N', n.L, H x N and D.D, truncated before they are added";
        points.push(
            point("product", f.product, Format::signed(3, 0), product)
                .up_to(MOST_PRODUCT_FRACTION_BITS)
                .searched_from(f.vector.fraction_bits + GUARD_BITS),
        );
        points.push(point("diffuse", f.diffuse, UNIT, "n.L, clamped at 0"));
        // D·D has twice the fraction bits, n another 13, and all of it must fit 63 bits.
        points.push(
            point("difference", f.difference, Format::signed(2, 0), "components of D")
                .with_at_most(20),
        );
        points.extend(self.shape_points());
        points
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let mut options = Vec::new();
        if self.normals != Normals::Linear {
            options.push(("normals", self.normals_in_words()));
        }
        if self.normals == Normals::Linear {
            options.push(("normalisation", self.normalisation_in_words()));
        }
        let approximate = matches!(self.normalisation, Normalisation::G1 | Normalisation::G2);
        if self.normals == Normals::Linear && approximate {
            options.push(("Newton steps", self.newton_steps.to_string()));
        }
        if self.normals != Normals::Flat {
            options.extend(self.increments.option("N' = N' + dN"));
        }
        options.push(("difference", self.difference_in_words()));
        options.push(("shape", self.shape_in_words()));
        options.extend(self.places.option());
        options
    }

    fn check_options(&self) -> Result<(), SpecError> {
        within("newton_steps", self.newton_steps.into(), 0.0, 3.0)?;
        within("squarings", self.squarings.into(), 0.0, 4.0)?;
        if self.odd_power.is_multiple_of(2) {
            return Err(SpecError::Core {
                message: format!(
                    "`odd_power` is {}, which is even: powers of two are `squarings`",
                    self.odd_power
                ),
            });
        }
        within("odd_power", self.odd_power.into(), 1.0, 15.0)
    }

    fn places_seen_from(&self) -> Viewpoint {
        self.places.viewpoint()
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::LyonSetUp::new(self, frame))
    }
}

impl LyonSpec {
    /// Narrowing points on the way to the normal.
    fn normal_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        let f = &self.formats;
        let point = NarrowingPoint::rounded;
        if self.normals == Normals::Flat {
            let mut points =
                vec![point("vector", f.vector, SIGNED_UNIT, "components of the normal n")];
            points.extend(self.normalisation_points());
            return points;
        }
        // What is carried from pixel to pixel stays near unit length only where rounding is fine.
        let fewest = if self.follows() { FEWEST_TO_FOLLOW } else { FEWEST_FRACTION_BITS };
        let mut points = match self.increments {
            Increments::Multiplied => {
                let formats = [f.weight_accumulator, f.weight];
                NarrowingPoint::weight(formats, span_bits, INTERPOLATION_WEIGHT)
                    .map(|point| point.with_at_least(fewest))
                    .to_vec()
            }
            Increments::Added => {
                vec![self.span_vectors().accumulator_point("normal_accumulator", span_bits)]
            }
        };
        let components = match self.increments {
            Increments::Multiplied => "components of N' = N0 + a (N1 - N0) and of n = g N'",
            Increments::Added => "components of N' = N0 + i dN and of n = g N'",
        };
        points.push(point("vector", f.vector, SIGNED_UNIT, components).with_at_least(fewest));
        if self.follows() {
            points.push(
                point("length_squared", f.length_squared, UNIT, "z = N'.N'").with_at_least(fewest),
            );
            let q = "H.H, H = N' + n of the pixel before, or + w";
            points.push(
                point("wrap_operand", f.wrap_operand, Format::unsigned(3, 0), q)
                    .with_at_least(fewest),
            );
            points.push(
                point("wrap_ratio", f.wrap_ratio, UNIT, "u = (1 - z) / H.H").with_at_least(fewest),
            );
        } else if self.normals == Normals::Wrapped {
            points.push(point(
                "wrap_operand",
                f.wrap_operand,
                Format::unsigned(3, 0),
                "H.w and H.H, H = N' + w",
            ));
            points.push(point("wrap_ratio", f.wrap_ratio, UNIT, "v = H.w / H.H"));
        }
        points.extend(self.normalisation_points());
        points
    }

    /// Narrowing points of the normalisation, of normals and of ways to places.
    fn normalisation_points(&self) -> Vec<NarrowingPoint> {
        let (f, point) = (&self.formats, NarrowingPoint::rounded);
        let serves = self.normals == Normals::Linear || self.places == Places::Pixel;
        if self.normalisation == Normalisation::None || !serves {
            return Vec::new();
        }
        let square = point("length_squared", f.length_squared, UNIT, "z = N'.N'");
        let gain = point("gain", f.gain, Format::unsigned(2, 0), "g, about 1/sqrt(z)");
        // What is carried from pixel to pixel has its own z.
        if self.follows() { vec![gain] } else { vec![square, gain] }
    }

    /// Narrowing points on the way from D to f.
    fn shape_points(&self) -> Vec<NarrowingPoint> {
        let f = &self.formats;
        let point = NarrowingPoint::rounded;
        match self.shape {
            ShapeDatapath::FK => {
                let x = match (self.difference.takes_unit_halfway(), self.odd_power) {
                    (true, 1) => "x = 4n D.D / 2^(k+1), and each square of 1 - x",
                    (false, 1) => "x = n D.D / 2^(k+1), and each square of 1 - x",
                    (true, _) => "x = 4n D.D / 2K, and each power of 1 - x",
                    (false, _) => "x = n D.D / 2K, and each power of 1 - x",
                };
                let mut points = Vec::new();
                if self.odd_power > 1 {
                    let share = "n over the odd power, rounded by the host";
                    let whole = Format::unsigned(13, 0);
                    points.push(
                        point("shininess_share", f.shininess_share, whole, share)
                            .with_at_most(room_for_share(f.difference.fraction_bits)),
                    );
                }
                points.push(point("shape", f.shape, UNIT, x));
                points
            }
            ShapeDatapath::Root => vec![
                point(
                    "root_shininess",
                    f.root_shininess,
                    Format::unsigned(7, 0),
                    "m, rounded by the host",
                )
                .down_to(0),
                point(
                    "scaled_difference",
                    f.scaled_difference,
                    Format::unsigned(8, 0),
                    "u_c = m |D_c| / 2^h",
                ),
                point(
                    "shape",
                    f.shape,
                    UNIT,
                    if self.odd_power == 1 {
                        "x = u.u, and each square of 1 - x"
                    } else {
                        "x = u.u, and each power of 1 - x"
                    },
                ),
            ],
        }
    }

    fn normals_in_words(&self) -> String {
        match (self.normals, self.axis) {
            (Normals::Linear, _) => "interpolated linearly",
            (Normals::Flat, _) => "the polygon's own normal",
            (Normals::Wrapped, WrapAxis::Bisector) => "wrapped around the bisector of the end normals",
            (Normals::Wrapped, WrapAxis::Previous) => {
                "wrapped around the one of the pixel before; around the bisector in wide spans of few steps"
            }
            (Normals::Wrapped, WrapAxis::Face) => "wrapped around the polygon's own normal, or the bisector 90 degrees from it",
        }
        .to_owned()
    }

    fn normalisation_in_words(&self) -> String {
        match self.normalisation {
            Normalisation::None => "none, n = N'",
            Normalisation::G1 => "g1 = 1 + y/2, y = 1 - z",
            Normalisation::G2 => "g2 = 1 + (y + y^2)/2, y = 1 - z",
            Normalisation::Exact => "g = 1/sqrt(z), correctly rounded",
        }
        .to_owned()
    }

    fn difference_in_words(&self) -> String {
        let h = match self.halfway {
            Halfway::Unit => "h = H/|H|",
            Halfway::Half => "h = H/2",
            Halfway::HalfG2 => "h = g2(H.H/4) H/2",
        };
        match self.difference {
            Difference::ReflectionMinusLight => "D = R - L".to_owned(),
            Difference::LightReflection => "D = 2(N.L)N - H".to_owned(),
            Difference::HalfwayProjection => "D = (H.N)N - H".to_owned(),
            Difference::HalfwayCrossNormal => "D = H x N".to_owned(),
            Difference::UnitHalfwayMinusNormal => format!("D = h - N with 4n, {h}"),
            Difference::UnitHalfwayProjection => format!("D = (h.N)N - h with 4n, {h}"),
        }
    }

    fn shape_in_words(&self) -> String {
        let from = match self.shape {
            ShapeDatapath::FK => "",
            ShapeDatapath::Root => "; from squares of m D, m = sqrt(n)",
        };
        match self.odd_power {
            1 => format!("f = (1 - x)^(2^k), 0 from x = 1 on; k = {}{from}", self.squarings),
            _ => format!("f = (1 - x)^K, 0 from x = 1 on; K = {}{from}", self.terms()),
        }
    }
}
