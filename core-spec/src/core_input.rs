//! An input of a core, and what it tells of a scene.
use specula_datapath::{Format, Hold, InputPort};

use crate::input_meaning::InputMeaning;

/// What an input tells of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputRole {
    /// Where lights are, and what is made of that alone.
    Light,
    /// Exponents of highlights.
    Exponent,
    /// Ambient light sent back.
    Ambient,
    /// Diffuse coefficients.
    Diffuse,
    /// Specular coefficients.
    Specular,
    /// The surface, from span to span.
    Surface,
}

impl InputRole {
    /// Every role.
    pub const ALL: [InputRole; 6] = [
        InputRole::Light,
        InputRole::Exponent,
        InputRole::Ambient,
        InputRole::Diffuse,
        InputRole::Specular,
        InputRole::Surface,
    ];

    /// Its name for people.
    pub const fn in_words(self) -> &'static str {
        match self {
            InputRole::Light => "directions of lights",
            InputRole::Exponent => "exponents of materials",
            InputRole::Ambient => "ambient light",
            InputRole::Diffuse => "diffuse colours",
            InputRole::Specular => "specular colours",
            InputRole::Surface => "what changes along spans",
        }
    }
}

/// An input of a core.
#[derive(Clone, Debug, PartialEq)]
pub struct CoreInput {
    /// The port of the hardware.
    pub port: InputPort,
    /// What it is.
    pub meaning: InputMeaning,
}

impl CoreInput {
    /// Whether it belongs to one of the lights, whose inputs are called after it.
    pub(crate) fn is_of_a_light(&self) -> bool {
        self.port.name.starts_with("light")
    }

    /// All that a role tells but of the surface stands still for a frame, as far as the core's
    /// parameters allow.
    fn of_port(meaning: InputMeaning, port: InputPort) -> CoreInput {
        let hold = if meaning.role == InputRole::Surface { Hold::Span } else { Hold::Frame };
        CoreInput { port: InputPort { hold, ..port }, meaning }
    }

    /// The same input where set-up gives it other values from span to span, whatever its role.
    pub(crate) fn held_for_a_span(self) -> CoreInput {
        CoreInput { port: InputPort { hold: Hold::Span, ..self.port }, ..self }
    }

    /// An input that takes every value of its format.
    pub(crate) fn whole(
        meaning: InputMeaning,
        name: impl Into<String>,
        format: Format,
    ) -> CoreInput {
        CoreInput::of_port(meaning, InputPort::whole(name, format))
    }

    /// An input that takes values from `low` to `high`.
    pub(crate) fn between(
        meaning: InputMeaning,
        name: impl Into<String>,
        format: Format,
        low: f64,
        high: f64,
    ) -> CoreInput {
        CoreInput::of_port(meaning, InputPort::between(name, format, low, high))
    }

    /// An input for a whole number from 1 to `largest`.
    pub(crate) fn whole_number(meaning: InputMeaning, name: &str, largest: u32) -> CoreInput {
        let format = Format::unsigned(u32::BITS - largest.leading_zeros(), 0);
        CoreInput::between(meaning, name, format, 1.0, largest.into())
    }

    /// Inputs for a vector's components, each from -`limit` to `limit`.
    pub(crate) fn vector(
        meaning: &InputMeaning,
        name: &str,
        format: Format,
        limit: f64,
    ) -> [CoreInput; 3] {
        let mut axes = ["x", "y", "z"].into_iter();
        InputPort::vector(name, format, limit).map(|port| {
            CoreInput::of_port(meaning.component(axes.next().unwrap_or_default()), port)
        })
    }

    /// Inputs for the coefficients of the three channels.
    pub(crate) fn colour(meaning: &InputMeaning, name: &str, format: Format) -> [CoreInput; 3] {
        [("r", "red"), ("g", "green"), ("b", "blue")].map(|(channel, in_words)| {
            CoreInput::whole(meaning.component(in_words), format!("{name}_{channel}"), format)
        })
    }
}
