//! The hardware to build: methods, number formats, lights. What `golden` and `hdl` share, and all they share.
//!
//! About arithmetic they share the *narrowing points*: each place where a value is rounded has a name and a [`Format`] here.
//! Rounding is to nearest, ties up (add half a unit in the last place, then floor); between narrowing points arithmetic is exact.
mod choose;
mod error;
pub mod hybrid;
pub mod lyon;
mod packet;
mod port;

use serde::Serialize;

use crate::format::Format;

pub use choose::CoreOptions;
pub use error::SpecError;
pub use hybrid::{HybridInputs, HybridSpec};
pub use lyon::{LyonInputs, LyonSpec};
pub use packet::{SetUp, SpanPacket};
pub use port::InputPort;

/// Fraction bits of colour coefficients, which count LSBs of the 8-bit output: 2^-7 LSB is lost at most in each.
pub const COEFFICIENT_FRACTION_BITS: u32 = 6;
/// Full scale of the output, in LSBs.
pub const FULL_SCALE: f64 = 255.0;
/// The most lights a core takes; each has a pipeline of its own.
pub const MOST_LIGHTS: usize = 4;
/// The largest exponent n (EXTREMES row 24).
pub const LARGEST_SHININESS: u32 = 8191;
/// The longest span, in pixels (EXTREMES row 38).
pub const LONGEST_SPAN: u32 = 8192;

/// A core: a span goes in, one pixel comes out per clock.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CoreSpec {
    /// Number of lights, 1 to [`MOST_LIGHTS`].
    pub lights: usize,
    /// Longest span the core can take, in pixels.
    pub longest_span: u32,
    /// Largest exponent n the core can take.
    pub largest_shininess: u32,
    /// Colour coefficients, in LSBs of the output: `U<i>.6`.
    pub coefficient: Format,
    /// Length of the shortest interpolated normal, relative to the longer end of its span. Error bounds rest on it; widths do not.
    pub shortest_normal: f64,
    /// How pixels are shaded.
    pub method: MethodSpec,
}

/// How pixels are shaded.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MethodSpec {
    /// Lyon's reformulation of Phong shading for hardware.
    Lyon(LyonSpec),
    /// Gouraud diffuse with Hast's specular recurrence.
    Hybrid(HybridSpec),
}

/// The methods there are, by the names users give them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`MethodSpec::Lyon`].
    Lyon,
    /// [`MethodSpec::Hybrid`].
    Hybrid,
}

impl Method {
    /// Every method.
    pub const ALL: [Method; 2] = [Method::Lyon, Method::Hybrid];

    /// The name that the command line and scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Method::Lyon => "lyon",
            Method::Hybrid => "hybrid",
        }
    }

    /// One line on what it does, with its source.
    pub const fn summary(self) -> &'static str {
        match self {
            Method::Lyon => "per-pixel normal, approximate normalisation, shape function f_k [Lyon, TR 43]",
            Method::Hybrid => "Gouraud diffuse, specular base p/q by forward differences [Hast et al., eq. 17-26]",
        }
    }

    /// The method of that name.
    ///
    /// # Errors
    /// [`SpecError::UnknownMethod`] if there is none.
    pub fn from_name(name: &str) -> Result<Method, SpecError> {
        let found = Method::ALL.into_iter().find(|m| m.name() == name);
        found.ok_or_else(|| SpecError::UnknownMethod { name: name.to_owned() })
    }
}

impl CoreSpec {
    /// Which method this is.
    pub fn method(&self) -> Method {
        match self.method {
            MethodSpec::Lyon(_) => Method::Lyon,
            MethodSpec::Hybrid(_) => Method::Hybrid,
        }
    }

    /// The data inputs of the core in the order in which packets hold them; `valid` and `start` come beside them.
    pub fn inputs(&self) -> Vec<InputPort> {
        match &self.method {
            MethodSpec::Lyon(lyon) => lyon.inputs(self).to_vec(),
            MethodSpec::Hybrid(hybrid) => hybrid.inputs(self).to_vec(),
        }
    }

    /// A colour coefficient's port.
    fn coefficient_port(&self, name: String) -> InputPort {
        InputPort::whole(name, self.coefficient)
    }

    /// Ports of the coefficients of the three channels.
    fn colour_ports(&self, name: &str) -> [InputPort; 3] {
        ["r", "g", "b"].map(|channel| self.coefficient_port(format!("{name}_{channel}")))
    }
}
