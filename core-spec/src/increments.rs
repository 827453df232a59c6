//! Vectors and scalars along a span, by what they change by over all of it or with each pixel
//! [lecture, eq. 4.1 to 4.3; Lyon, TR 43, fig. 6 and 7; methods A6, B12].
use glam::DVec3;
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::frame::Span;

use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::narrowing::NarrowingPoint;
use crate::shading_method::OptionDomain;

/// What becomes of increments: how a vector or scalar N gets from one end of a span to the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Increments {
    /// N0 + a (N1 - N0): a weight a = i/S that grows with each pixel multiplies them.
    #[default]
    Multiplied,
    /// N ← N + ΔN with ΔN = (N1 - N0)/S, as the papers print it: no multiplier.
    Added,
}

impl Increments {
    /// The option that methods with the choice have.
    pub(crate) const OPTION_DOMAIN: OptionDomain =
        OptionDomain { key: "increments", values: &["\"multiplied\"", "\"added\""] };

    /// What it is, for people to read, where it is not the default; `sum` is what is added up.
    pub(crate) fn option(self, sum: &str) -> Option<(&'static str, String)> {
        let added = || ("increments", format!("added, {sum} with each pixel"));
        (self == Increments::Added).then(added)
    }
}

/// Vectors along the spans of a core.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanVectors {
    pub increments: Increments,
    /// Components of the vectors, and of their ends where increments are multiplied: `S1.f`.
    pub vector: Format,
    /// Accumulators of the components, where increments are added: `S3.f`.
    pub accumulator: Format,
}

impl SpanVectors {
    /// The inputs of a vector at the first pixel, no longer than `longest`, which is 1 or 2.
    pub fn start(&self, meaning: &InputMeaning, name: &str, longest: f64) -> [CoreInput; 3] {
        let format = match self.increments {
            Increments::Multiplied if longest <= 1.0 => self.vector,
            _ => self.change_format(),
        };
        CoreInput::vector(meaning, name, format, longest)
    }

    /// The inputs of what the vector called `value` changes by: over the whole span, which
    /// `whole` tells of, or with each pixel. Its ends are up to 2 apart.
    pub fn change(&self, value: &str, whole: &InputMeaning, name: &str) -> [CoreInput; 3] {
        let (meaning, change) = match self.increments {
            Increments::Multiplied => (whole.clone(), "delta"),
            Increments::Added => (InputMeaning::step(value), "step"),
        };
        CoreInput::vector(&meaning, &format!("{name}_{change}"), self.change_format(), 2.0)
    }

    /// What the host sends of a vector with these values at both ends of a span: the first, and what
    /// it changes by.
    pub fn quantised(&self, span: &Span, ends: [DVec3; 2]) -> [[i64; 3]; 2] {
        let format = self.change_format();
        match self.increments {
            Increments::Multiplied => {
                // The difference of what is sent, so that the end is met as it was rounded.
                let [start, end] = ends.map(|end| format.quantise_vector(end));
                [start, std::array::from_fn(|c| end[c] - start[c])]
            }
            Increments::Added => {
                span.start_and_step(ends).map(|vector| format.quantise_vector(vector))
            }
        }
    }

    /// Where increments are added, the narrowing point of the accumulators, called `name`.
    pub fn accumulator_point(&self, name: &'static str, span_bits: u32) -> NarrowingPoint {
        let components =
            "start and step of the components of vectors along the span, rounded by the host";
        let (shape, order) = (Format::signed(3, 0), (1, span_bits));
        NarrowingPoint::accumulated(name, self.accumulator, shape, order, components)
            .with_at_least(self.vector.fraction_bits)
    }

    /// Has one integer bit more than the vectors where it is not an accumulator's.
    fn change_format(&self) -> Format {
        match self.increments {
            Increments::Multiplied => {
                Format::signed(self.vector.integer_bits + 1, self.vector.fraction_bits)
            }
            Increments::Added => self.accumulator,
        }
    }
}
