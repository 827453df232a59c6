//! The hardware to build: methods, number formats, lights. What `golden` and `hdl` share, and all
//! they share.
//!
//! About arithmetic they share the *narrowing points*: each place where a value is rounded has a
//! name and a [`Format`] here. Rounding is to nearest, ties up (add half a unit in the last place,
//! then floor); between narrowing points arithmetic is exact.
//!
//! A method is a folder: `mod.rs` has its options and formats, `inputs` the ports of its cores,
//! `choose` the formats for a scene and what may be asked for, `set_up` the host's work for a span.
//! A line in `method` makes it known.
mod change;
mod choose;
pub mod consistent;
mod describe;
pub mod direct;
pub mod duff;
mod error;
mod finer;
pub mod gouraud;
pub mod hybrid;
mod inputs;
mod light_pipelines;
mod linear;
pub mod lyon;
mod method;
mod narrowing;
mod options;
pub mod phong;
pub mod power;
mod quadratic;
pub mod reflection;
mod scene_core;
mod serve;
mod set_up;
pub mod slerp;
mod spec_file;
mod specialise;
mod subject;

use serde::{Deserialize, Serialize};
pub use specula_datapath::{Format, InputPort, SpanPacket, format};
use specula_scene::needs::LocalKind;

pub use consistent::{ConsistentInputs, ConsistentSpec};
use describe::Describe;
pub use describe::Viewpoint;
pub use direct::{DirectInputs, DirectSpec};
pub use duff::{DuffInputs, DuffSpec};
pub use error::SpecError;
pub use gouraud::{GouraudInputs, GouraudSpec};
pub use hybrid::{HybridInputs, HybridSpec};
pub use inputs::EachInput;
pub use light_pipelines::LightPipelines;
pub use linear::Linear;
pub use lyon::{LyonInputs, LyonSpec};
pub use method::{Choice, Method, MethodSpec};
pub use narrowing::NarrowingPoint;
pub use options::{CoreOptions, Specialise};
pub use phong::{PhongInputs, PhongSpec};
pub use power::PowerUnit;
pub use quadratic::Quadratic;
pub use reflection::{ReflectionInputs, ReflectionSpec};
pub use scene_core::{CoreError, SceneCore};
pub use serve::Served;
pub use set_up::SetUp;
pub use slerp::{SlerpInputs, SlerpSpec};
pub use spec_file::SpecFile;
pub use specialise::{Given, Specialisation};
pub use subject::Subject;

/// Fraction bits of colour coefficients, which count LSBs of the 8-bit output: 2^-7 LSB is lost at
/// most in each.
pub const COEFFICIENT_FRACTION_BITS: u32 = 6;
/// Full scale of the output, in LSBs.
pub const FULL_SCALE: f64 = 255.0;

/// A core: a span goes in, and with every [`CoreSpec::interval`] clocks a pixel comes out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoreSpec {
    /// Number of lights, 1 to [`MOST_LIGHTS`](specula_scene::limits::MOST_LIGHTS).
    pub lights: usize,
    /// What the last of them are that are at a place; those before are at infinity.
    pub local_lights: Vec<LocalKind>,
    /// Whether the eye that sees highlights is at a place.
    pub local_eye: bool,
    /// Whether lights share a pipeline.
    pub light_pipelines: LightPipelines,
    /// Longest span the core can take, in pixels.
    pub longest_span: u32,
    /// Largest exponent n the core can take.
    pub largest_shininess: u32,
    /// Colour coefficients, in LSBs of the output: `U<i>.6`.
    pub coefficient: Format,
    /// Length of the shortest interpolated normal, relative to the longer end of its span. Error
    /// bounds rest on it; widths do not.
    pub shortest_normal: f64,
    /// Length of the shortest vector to a light or an eye at a place, relative to the longer one at
    /// the ends of its span. Error bounds rest on it; widths do not.
    pub shortest_way: f64,
    /// The same of vectors that have length 1 at both ends of their span. Error bounds rest on it;
    /// widths do not.
    pub shortest_unit_way: f64,
    /// Smallest cosine between a vertex normal and a face around the vertex. Error bounds rest on
    /// it; widths do not.
    pub least_cone_cosine: f64,
    /// Smallest cosine between an interpolated normal and the direction to the eye. Error bounds
    /// rest on it; widths do not.
    pub least_view_cosine: f64,
    /// How pixels are shaded.
    pub method: MethodSpec,
    /// What its inputs are given over the frames that it is for.
    #[serde(default, skip_serializing_if = "Specialisation::is_general")]
    pub specialisation: Specialisation,
}

impl CoreSpec {
    /// Which method this is.
    pub fn method(&self) -> Method {
        self.method.method()
    }

    /// Largest exponent of a spot; 1 without any.
    pub fn largest_spot_exponent(&self) -> u32 {
        let exponent = |kind: &LocalKind| match kind {
            LocalKind::Point => 1,
            LocalKind::Spot { exponent } => *exponent,
        };
        self.local_lights.iter().map(exponent).max().unwrap_or(1)
    }

    /// The initiation interval: clocks from one pixel to the next.
    pub fn interval(&self) -> u32 {
        match self.light_pipelines {
            LightPipelines::Each => 1,
            LightPipelines::Shared => self.lights as u32,
        }
    }

    /// Where lights and the eye at places are seen from.
    pub fn places_seen_from(&self) -> Viewpoint {
        self.method.describe().places_seen_from()
    }

    /// The data inputs of the core in the order in which packets hold them; `valid` and `start`
    /// come beside them.
    pub fn inputs(&self) -> Vec<InputPort> {
        self.method.describe().ports(self)
    }

    /// Ports of the coefficients of the three channels.
    fn colour_ports(&self, name: &str) -> [InputPort; 3] {
        ["r", "g", "b"]
            .map(|channel| InputPort::whole(format!("{name}_{channel}"), self.coefficient))
    }
}
