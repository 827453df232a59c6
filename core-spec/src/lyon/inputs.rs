//! The inputs of a `lyon` core.
use specula_datapath::Format;

use super::{Halfway, LyonSpec, Normals, ShapeDatapath, WrapAxis};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::Exponent;
use crate::increments::Increments;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::ways::{VectorLight, VectorWay};

inputs! {
    /// Inputs that the lights of a span have in common.
    LyonSpan {
        /// N0, the normal at the first pixel; of flat normals the only one, and of those wrapped
        /// around a fixed w N0 + w.
        normal_start: vector,
        /// N1 - N0, over the whole span, or with each pixel where increments are added; not there
        /// with flat normals.
        normal_delta: vector_if_any,
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel. Not there with
        /// flat normals, nor where increments are added.
        weight_step: one_if_any,
        /// w, with wrapped normals.
        wrap_axis: vector_if_any,
        /// Whether w is the wrapped normal before from the second pixel on, where normals are
        /// wrapped around that.
        wrap_follows: one_if_any,
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(VectorWay),
        /// n, or m of the root shape.
        shininess: one,
    }
}

inputs! {
    /// Inputs of one light.
    LyonLight {
        /// L; there without ways to places.
        direction: vector_if_any,
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(VectorLight),
        /// The half-way vector, where D is made of one, without ways to places.
        halfway: vector_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type LyonInputs<T> = CoreInputs<LyonSpan<T>, LyonLight<T>, T>;

impl MethodInputs for LyonSpec {
    type SpanGroup = LyonSpan<CoreInput>;
    type LightGroup = LyonLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> LyonSpan<CoreInput> {
        let f = &self.formats;
        let changes = self.normals != Normals::Flat;
        let vector =
            |meaning: &InputMeaning, name: &str| CoreInput::vector(meaning, name, f.vector, 1.0);
        let vectors = self.span_vectors();
        let number = |meaning: InputMeaning, name: &str, format: Format| {
            CoreInput::between(meaning, name, format, 0.0, 1.0)
        };
        let [start, delta] = self.normal_meanings();
        let multiplies = changes && self.increments == Increments::Multiplied;
        LyonSpan {
            normal_start: match self.normals {
                Normals::Flat => vector(&start, "normal"),
                Normals::Wrapped if !self.follows() => vectors.start(&start, "wrap_start", 2.0),
                Normals::Linear | Normals::Wrapped => vectors.start(&start, "normal_start", 1.0),
            },
            normal_delta: changes.then(|| vectors.change("the normal N", &delta, "normal")),
            weight_step: multiplies
                .then(|| number(InputMeaning::weight_step(), "weight_step", f.weight_accumulator)),
            wrap_axis: (self.normals == Normals::Wrapped)
                .then(|| vector(&self.axis_meaning(), "wrap_axis")),
            wrap_follows: self
                .follows()
                .then(|| number(follows_meaning(), "wrap_follows", Format::unsigned(1, 0))),
            eye: (self.places.follows_ways(core) && core.local_eye)
                .then(|| VectorWay::inputs("E", "eye", f.way_accumulator)),
            shininess: self.shininess_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> LyonLight<CoreInput> {
        let f = &self.formats;
        let name = format!("light{index}_halfway");
        let halfway = || {
            if self.difference.takes_unit_halfway() {
                // g2 makes h longer than 1 by 0.2 % at most (methods B9), and that only where it is
                // no nearer than 20 degrees to an axis.
                CoreInput::vector(&self.halfway_meaning(), &name, f.vector, 1.0)
            } else {
                let meaning = InputMeaning::light("L + V", "with V = (0, 0, 1)");
                CoreInput::vector(&meaning, &name, f.vector_sum(), 2.0)
            }
        };
        let direction = format!("light{index}_direction");
        let follows_ways = self.places.follows_ways(core);
        let takes_halfway = self.difference.takes_halfway() || self.difference.takes_unit_halfway();
        LyonLight {
            direction: (!follows_ways)
                .then(|| CoreInput::vector(&InputMeaning::direction(), &direction, f.vector, 1.0)),
            way: follows_ways
                .then(|| VectorLight::inputs(core, index, f.way_accumulator, f.vector)),
            halfway: (takes_halfway && !follows_ways).then(halfway),
        }
    }
}

impl LyonSpec {
    /// What the normal at the first pixel is, and what it changes by.
    fn normal_meanings(&self) -> [InputMeaning; 2] {
        let wrapped = "vertex normals interpolated at the pixel's centre, of unit length, plus w";
        match self.normals {
            Normals::Flat => {
                let computed = "the unit normal on the side that is seen";
                let normal = InputMeaning::surface("N, the polygon's normal", computed);
                [normal.clone(), normal]
            }
            Normals::Wrapped if !self.follows() => InputMeaning::along_span("N + w", wrapped),
            Normals::Wrapped => InputMeaning::along_span(
                "the normal N",
                "vertex normals interpolated at the pixel's centre, of unit length",
            ),
            Normals::Linear => InputMeaning::normal_along_span(),
        }
    }

    /// What normals are wrapped around.
    fn axis_meaning(&self) -> InputMeaning {
        let computed = match self.axis {
            WrapAxis::Face => {
                "the polygon's unit normal; the unit bisector of the ends' normals where it is 90 \
                 degrees or more from one of them"
            }
            WrapAxis::Bisector => "the unit bisector of the ends' normals",
            WrapAxis::Previous => {
                "the first pixel's unit normal where wrap_follows is 1, else the unit bisector of \
                 the ends' normals"
            }
        };
        InputMeaning::surface("w, what normals are wrapped around", computed)
    }

    /// The half-way vector of about unit length.
    fn halfway_meaning(&self) -> InputMeaning {
        match self.halfway {
            Halfway::Unit => InputMeaning::unit_halfway(),
            Halfway::Half => InputMeaning::light("h", "(L + V)/2 with V = (0, 0, 1)"),
            Halfway::HalfG2 => InputMeaning::light(
                "h, times about 1/|h|",
                "h (1 + (y + y^2)/2) with h = (L + V)/2, V = (0, 0, 1) and y = 1 - h.h",
            ),
        }
    }

    fn shininess_input(&self, core: &CoreParameters) -> CoreInput {
        let largest = core.largest_shininess;
        match (self.shape, self.odd_power) {
            (ShapeDatapath::FK, 2..) => {
                let share = |shininess: u32| self.shininess_factor() * f64::from(shininess);
                let format = self.formats.shininess_share;
                let computed = format!("the material's n over {}", self.odd_power);
                let meaning =
                    InputMeaning::of(Exponent, "a share of the highlight's exponent", computed);
                CoreInput::between(meaning, "shininess_share", format, share(1), share(largest))
            }
            (ShapeDatapath::FK, _) => {
                let format = Format::unsigned(u32::BITS - largest.leading_zeros(), 0);
                let meaning =
                    InputMeaning::of(Exponent, "the highlight's exponent", "the material's n");
                CoreInput::between(meaning, "shininess", format, 1.0, f64::from(largest))
            }
            (ShapeDatapath::Root, _) => {
                let root = |shininess| (self.root_factor() * f64::from(shininess)).sqrt();
                let of = if self.squarings.is_multiple_of(2) { "twice " } else { "" };
                let over = match self.odd_power {
                    1 => String::new(),
                    odd => format!(" over {odd}"),
                };
                let squared = format!("the root of {of}the material's n{over}");
                CoreInput::between(
                    InputMeaning::of(Exponent, "the root of the highlight's exponent", squared),
                    "root_shininess",
                    self.formats.root_shininess,
                    root(1),
                    root(largest),
                )
            }
        }
    }
}

/// Whether normals follow.
fn follows_meaning() -> InputMeaning {
    InputMeaning::surface(
        "whether each pixel's normal is wrapped around the one before",
        "1 where the ends' normals are up to 30 degrees apart, or up to 120 in a span of 17 pixels \
         or more",
    )
}
