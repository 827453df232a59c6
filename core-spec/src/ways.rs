//! Ways to lights and to the eye at places, for methods that work with scalars along a span [Hast,
//! Barrera and Bengtsson, eq. 35; methods C15].
//!
//! The way F - P from the surface to a place F is linear along a span, X(i) = x + y i, as the normal
//! N(i) = m + k i is. So N·X, X·X and the like are quadratic in the pixel number and go along by
//! additions, as Hast's p and q do (eq. 17 to 26), and the unit vector L = X/|X| is never made: N·L
//! is (N·X)/√(X·X). A light or an eye at infinity has a constant X, whose quadratics stand still.
use glam::DVec3;
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::frame::{EYE, Frame, Span, Spot};
use specula_scene::needs::{LocalKind, Needs};

use crate::core_input::CoreInput;
use crate::defaults::reach;
use crate::input_meaning::InputMeaning;
use crate::inputs::inputs;
use crate::linear::Linear;
use crate::narrowing::{
    LARGEST_ROOT_REACH, MOST_ACCUMULATOR_FRACTION_BITS, MOST_FRACTION_BITS, NarrowingPoint,
};
use crate::parameters::CoreParameters;
use crate::quadratic::Quadratic;
use crate::shading_method::{OptionDomain, Viewpoint};

/// From where lights and the eye at places are seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Places {
    /// From the middle of each span: the host takes one direction for all of its pixels.
    Span,
    /// From every pixel: the core divides by the length of the way to each place.
    Pixel,
}

impl Places {
    /// The option that methods with the choice have.
    pub(crate) const OPTION_DOMAIN: OptionDomain =
        OptionDomain { key: "places", values: &["\"span\"", "\"pixel\""] };

    /// From every pixel where there are places.
    pub(crate) fn for_needs(needs: &Needs) -> Places {
        if needs.has_places() { Places::Pixel } else { Places::Span }
    }

    /// What it is, for people to read, where it makes a difference.
    pub(crate) fn option(self) -> Option<(&'static str, String)> {
        let of_pixels = || ("places", "seen from every pixel, by 1/sqrt(X.X)".to_owned());
        (self == Places::Pixel).then(of_pixels)
    }

    /// The same for all methods.
    pub(crate) fn viewpoint(self) -> Viewpoint {
        match self {
            Places::Span => Viewpoint::Span,
            Places::Pixel => Viewpoint::Pixel,
        }
    }

    /// Whether a core follows ways to places.
    pub fn follows_ways(self, core: &CoreParameters) -> bool {
        self == Places::Pixel && core.has_places()
    }

    /// Whether packets for a frame hold ways to places.
    pub(crate) fn sends_ways(self, frame: &Frame) -> bool {
        self == Places::Pixel && !frame.directions_are_constant()
    }
}

/// Where what comes of ways is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayFormats {
    /// Accumulators of quadratics and their differences, and of what is linear: `S3.f`.
    pub accumulator: Format,
    /// What is rounded from them, N·L and N·V: `S1.f`.
    pub operand: Format,
    /// 1/√(X·X): `U<m>.f`; it reaches 2^m.
    pub root: Format,
    /// L·V: `S1.f`.
    pub cosine: Format,
    /// The cosine between a spot's axis and the way from it: `U1.f`.
    pub base: Format,
    /// The share of a spot: `U1.f`.
    pub shape: Format,
}

impl WayFormats {
    /// 1/|L + V|, which saturates at 16.
    pub fn halfway_gain(&self) -> Format {
        Format::unsigned(4, self.root.fraction_bits)
    }
}

/// The format of 1/√(X·X) for a scene, of operands with so many fraction bits.
pub(crate) fn root_for_needs(needs: &Needs, operand: Format, fraction_bits: u32) -> Format {
    let reach = reach(needs.shortest_way, operand.fraction_bits);
    Format::unsigned(reach, fraction_bits.min(MOST_FRACTION_BITS))
}

/// The narrowing point of 1/√(X·X), where there is one.
pub(crate) fn narrowing_point(places: Places, root: Format) -> Option<NarrowingPoint> {
    let reach = Format::unsigned(root.integer_bits.clamp(1, LARGEST_ROOT_REACH), 0);
    let point = || NarrowingPoint::rounded("way_root", root, reach, "1/sqrt(X.X), X to a place");
    (places == Places::Pixel).then(point)
}

/// The format of accumulators for spans of so many bits, of which operands are rounded: errors of
/// second differences add up to S²/4 units.
pub(crate) fn accumulator_for_spans(span_bits: u32, operand: Format) -> Format {
    let fraction_bits = (2 * span_bits + operand.fraction_bits.saturating_sub(4))
        .clamp(operand.fraction_bits, MOST_ACCUMULATOR_FRACTION_BITS);
    Format::signed(3, fraction_bits)
}

/// The narrowing point of these accumulators, where there are any.
pub(crate) fn accumulator_point(
    places: Places,
    accumulator: Format,
    operand: Format,
    span_bits: u32,
) -> Option<NarrowingPoint> {
    let differences = "start and differences of what comes of ways to places, rounded by the host";
    accumulated(places, [accumulator, operand], (2, span_bits), differences)
}

/// The narrowing point of an accumulator, of which `finest` is rounded, with errors of an `order`.
fn accumulated(
    places: Places,
    [accumulator, finest]: [Format; 2],
    order: (u32, u32),
    value: &'static str,
) -> Option<NarrowingPoint> {
    let point = || {
        let shape = Format::signed(3, 0);
        NarrowingPoint::accumulated("way_accumulator", accumulator, shape, order, value)
            .with_at_least(finest.fraction_bits)
    };
    (places == Places::Pixel).then(point)
}

/// The format of accumulators of what is linear, of which vectors are rounded.
pub(crate) fn vector_accumulator_for_spans(span_bits: u32, vector: Format) -> Format {
    Format::signed(3, vector.fraction_bits + span_bits + 1)
}

/// The narrowing point of these accumulators, where there are any.
pub(crate) fn vector_accumulator_point(
    places: Places,
    accumulator: Format,
    vector: Format,
    span_bits: u32,
) -> Option<NarrowingPoint> {
    let components = "start and step of the components of ways to places, rounded by the host";
    accumulated(places, [accumulator, vector], (1, span_bits), components)
}

/// Fraction bits that tell 4^-m from 0, with places seen from pixels.
pub(crate) fn finest_square(places: Places, root: Format) -> u32 {
    if places == Places::Pixel { 2 * root.integer_bits } else { 0 }
}

inputs! {
    /// The way X to a light, but for what the normal makes of it.
    LightWay {
        /// X·X.
        squared: group(Quadratic),
        /// X·V, or X·E with the way E to an eye at a place.
        dot_view: group(Quadratic),
        /// There for a spot only.
        spot: group_if_any(SpotWay),
    }
}

inputs! {
    /// What a spot is besides.
    SpotWay {
        /// S·X with S against the axis.
        axis: group(Linear),
        /// The spot's exponent.
        exponent: one,
    }
}

inputs! {
    /// The way X to a light, and what the normal makes of it.
    LightCosine {
        /// N·X.
        normal: group(Quadratic),
        /// The rest.
        way: group(LightWay),
    }
}

inputs! {
    /// A way by its components.
    VectorWay {
        /// To the right.
        x: group(Linear),
        /// Up.
        y: group(Linear),
        /// Towards an eye at infinity.
        z: group(Linear),
    }
}

inputs! {
    /// The way to a light by its components.
    VectorLight {
        /// X.
        way: group(VectorWay),
        /// There for a spot only.
        spot: group_if_any(VectorSpot),
    }
}

inputs! {
    /// What a spot is besides.
    VectorSpot {
        /// The unit vector along which it shines.
        axis: vector,
        /// The spot's exponent.
        exponent: one,
    }
}

inputs! {
    /// The way E to an eye at a place, and what the normal makes of it.
    EyeCosine {
        /// N·E.
        normal: group(Quadratic),
        /// E·E.
        squared: group(Quadratic),
    }
}

impl LightWay<CoreInput> {
    /// The inputs of light number `index`.
    pub(crate) fn inputs(
        core: &CoreParameters,
        index: usize,
        format: Format,
    ) -> LightWay<CoreInput> {
        let name = |part: &str| format!("light{index}_{part}");
        let dot_view = if core.local_eye { "X.E" } else { "X.V" };
        LightWay {
            squared: Quadratic::squared_length_inputs("X.X", &name("way_squared"), format),
            dot_view: Quadratic::reflected_inputs(dot_view, &name("way_dot_view"), format),
            spot: core.spot_exponent(index).map(|_| SpotWay {
                axis: Linear::inputs("X.S", &name("spot_axis"), format),
                exponent: spot_exponent(core, &name("exponent")),
            }),
        }
    }
}

impl<T: Clone> VectorWay<T> {
    /// The components at the first pixel, and what they grow by.
    pub fn start_and_step(&self) -> [[T; 3]; 2] {
        let components = [&self.x, &self.y, &self.z];
        [components.map(|c| c.start.clone()), components.map(|c| c.step.clone())]
    }
}

impl VectorWay<CoreInput> {
    /// The inputs of a way called `way` in formulas.
    pub(crate) fn inputs(way: &str, name: &str, format: Format) -> VectorWay<CoreInput> {
        let component =
            |c: &str| Linear::inputs(&format!("{way}, {c},"), &format!("{name}_{c}"), format);
        VectorWay { x: component("x"), y: component("y"), z: component("z") }
    }
}

impl VectorLight<CoreInput> {
    /// The inputs of light number `index`, with vectors in the format `vector`.
    pub(crate) fn inputs(
        core: &CoreParameters,
        index: usize,
        accumulator: Format,
        vector: Format,
    ) -> VectorLight<CoreInput> {
        let name = |part: &str| format!("light{index}_{part}");
        VectorLight {
            way: VectorWay::inputs("X", &name("way"), accumulator),
            spot: core.spot_exponent(index).map(|_| VectorSpot {
                axis: spot_axis(&name("axis"), vector),
                exponent: spot_exponent(core, &name("exponent")),
            }),
        }
    }
}

/// The axis of a spot.
pub(crate) fn spot_axis(name: &str, vector: Format) -> [CoreInput; 3] {
    let meaning =
        InputMeaning::light("the spot's axis", "the unit vector along which the light shines");
    CoreInput::vector(&meaning, name, vector, 1.0)
}

/// The exponent of a spot, from 1 on.
pub(crate) fn spot_exponent(core: &CoreParameters, name: &str) -> CoreInput {
    let meaning = InputMeaning::light("the spot's exponent", "as the light has it");
    CoreInput::whole_number(meaning, name, core.largest_spot_exponent())
}

impl LightCosine<CoreInput> {
    /// The inputs of light number `index`.
    pub(crate) fn inputs(
        core: &CoreParameters,
        index: usize,
        format: Format,
    ) -> LightCosine<CoreInput> {
        let name = format!("light{index}_way_normal");
        LightCosine {
            normal: Quadratic::reflected_inputs("N.X", &name, format),
            way: LightWay::inputs(core, index, format),
        }
    }
}

impl EyeCosine<CoreInput> {
    /// The inputs of an eye at a place.
    pub(crate) fn inputs(format: Format) -> EyeCosine<CoreInput> {
        EyeCosine {
            normal: Quadratic::reflected_inputs("N.E", "eye_normal", format),
            squared: Quadratic::squared_length_inputs("E.E", "eye_squared", format),
        }
    }
}

/// The ways from a span to a frame's lights and eye.
#[derive(Clone, Copy)]
pub(crate) struct Ways<'a> {
    pub frame: &'a Frame,
    pub span: &'a Span,
    pub accumulator: Format,
}

impl Ways<'_> {
    /// x and y of the way to light number `index`; L and 0 for one at infinity.
    pub fn way_to_light(&self, index: usize) -> [DVec3; 2] {
        match index.checked_sub(self.frame.lights.len()) {
            None => [self.frame.lights[index].direction, DVec3::ZERO],
            Some(local) => self.way_to_place(self.frame.local_lights[local].position),
        }
    }

    /// What light number `index` is besides, if it is a spot.
    fn spot(&self, index: usize) -> Option<&Spot> {
        let local = index.checked_sub(self.frame.lights.len())?;
        self.frame.local_lights[local].spot.as_ref()
    }

    /// x and y of the way to the eye; V and 0 for one at infinity.
    pub fn way_to_eye(&self) -> [DVec3; 2] {
        self.frame.eye.map_or([EYE, DVec3::ZERO], |eye| self.way_to_place(eye))
    }

    fn way_to_place(&self, place: DVec3) -> [DVec3; 2] {
        self.span.start_and_step(self.frame.end_vectors_to(self.span, place))
    }

    /// (m + k i)·(x + y i).
    pub fn product(&self, [m, k]: [DVec3; 2], [x, y]: [DVec3; 2]) -> Quadratic<i64> {
        Quadratic::new(self.span, m.dot(x), m.dot(y) + k.dot(x), k.dot(y))
            .quantised(self.accumulator)
    }

    /// (m + k i)·u.
    pub fn linear(&self, [m, k]: [DVec3; 2], u: DVec3) -> Linear<i64> {
        Linear::new(self.span, m.dot(u), k.dot(u)).quantised(self.accumulator)
    }

    /// The components of a way.
    pub fn vector(&self, way: [DVec3; 2]) -> VectorWay<i64> {
        let [x, y, z] = DVec3::AXES.map(|axis| self.linear(way, axis));
        VectorWay { x, y, z }
    }

    /// The way to light number `index` by its components, with vectors in the format `vector`.
    pub fn vector_light(&self, index: usize, vector: Format) -> VectorLight<i64> {
        VectorLight {
            way: self.vector(self.way_to_light(index)),
            spot: self.spot(index).map(|spot| VectorSpot {
                axis: vector.quantise_vector(spot.axis),
                exponent: spot.exponent.into(),
            }),
        }
    }

    /// The way to an eye at a place by its components, if it is at one.
    pub fn vector_eye(&self) -> Option<VectorWay<i64>> {
        self.frame.eye.is_some().then(|| self.vector(self.way_to_eye()))
    }

    fn squared(&self, way: [DVec3; 2]) -> Quadratic<i64> {
        self.product(way, way)
    }

    /// What a `way` to light number `index` has but for the normal.
    pub fn light(&self, index: usize, way: [DVec3; 2]) -> LightWay<i64> {
        LightWay {
            squared: self.squared(way),
            dot_view: self.product(way, self.way_to_eye()),
            spot: self.spot(index).map(|spot| SpotWay {
                axis: self.linear(way, -spot.axis),
                exponent: spot.exponent.into(),
            }),
        }
    }

    /// The same, and what a normal makes of it.
    pub fn light_cosine(
        &self,
        normal: [DVec3; 2],
        index: usize,
        way: [DVec3; 2],
    ) -> LightCosine<i64> {
        LightCosine { normal: self.product(normal, way), way: self.light(index, way) }
    }

    /// The way to an eye at a place, if it is at one.
    pub fn eye_cosine(&self, normal: [DVec3; 2]) -> Option<EyeCosine<i64>> {
        let way = self.way_to_eye();
        let cosine = || EyeCosine { normal: self.product(normal, way), squared: self.squared(way) };
        self.frame.eye.is_some().then(cosine)
    }
}

impl CoreParameters {
    /// The exponent of light number `index`, if it is a spot.
    pub fn spot_exponent(&self, index: usize) -> Option<u32> {
        match self.local_lights.get(index.checked_sub(self.lights_at_infinity())?)? {
            LocalKind::Spot { exponent } => Some(*exponent),
            LocalKind::Point => None,
        }
    }
}
