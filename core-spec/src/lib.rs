//! The hardware to build: methods, number formats, lights. What `golden` and `hdl` share, and all
//! they share.
//!
//! About arithmetic they share the *narrowing points*: each place where a value is rounded has a
//! name and a [`Format`] here. Rounding is to nearest, ties up (add half a unit in the last place,
//! then floor); between narrowing points arithmetic is exact.
//!
//! A [`CoreSpec`] has [`CoreParameters`], a method and a [`Specialisation`]. A method is a folder:
//! `mod.rs` has its options and formats, `inputs` what its cores are given for a span and for each
//! light, `defaults` the formats for a scene and what may be asked for, `set_up` the host's work
//! for a span. It sees parameters and never a whole core, so nothing beneath it depends on which
//! methods there are; a line in `method` makes it known.
pub mod attenuation;
mod can_shade;
mod compatibility;
mod components;
pub mod consistent;
mod core_input;
mod core_spec;
mod defaults;
pub mod direct;
pub mod duff;
mod error;
mod finer;
mod formats;
mod frames;
mod given_values;
pub mod gouraud;
pub mod hybrid;
mod increments;
mod input_meaning;
mod inputs;
mod kept;
mod keys;
mod light_pipelines;
mod linear;
pub mod lyon;
mod merge;
mod method;
mod method_set_up;
mod narrowing;
mod options;
mod packet_layout;
mod parameters;
pub mod phong;
pub mod power;
mod quadratic;
mod rebase;
pub mod reflection;
mod scene_core;
mod set_up;
mod shading_method;
pub mod slerp;
mod spec_file;
mod specialisation;
mod specialise;
mod survey;
mod target_clock;
pub mod ways;

pub use specula_datapath::{Format, Hold, InputPort, SpanPacket, format};

pub use attenuation::AttenuationSpec;
pub use compatibility::FittedCore;
pub use components::Components;
pub use consistent::{ConsistentInputs, ConsistentSpec};
pub use core_input::{CoreInput, InputRole};
pub use core_spec::{CoreSpec, Ports};
pub use direct::{DirectInputs, DirectSpec};
pub use duff::{DuffInputs, DuffSpec};
pub use error::SpecError;
pub use frames::Frames;
pub use gouraud::{GouraudInputs, GouraudSpec};
pub use hybrid::{HybridInputs, HybridSpec};
pub use increments::Increments;
pub use input_meaning::InputMeaning;
pub use inputs::{CoreInputs, InputGroup, LightInputs, MethodInputs, NoInputs};
pub use kept::{Kept, KeptWithin};
pub use light_pipelines::LightPipelines;
pub use linear::Linear;
pub use lyon::{LyonInputs, LyonSpec};
pub use method::{Method, MethodSpec};
pub use narrowing::NarrowingPoint;
pub use options::{ANY_METHOD, CoreOptions, Specialise, UnnamedFormats};
pub use packet_layout::{
    FieldContent, PacketField, PacketLayout, Positions, SpanHeader, WordWidth, built_format,
    raw_value,
};
pub use parameters::{COEFFICIENT_FRACTION_BITS, CoreParameters, FULL_SCALE};
pub use phong::{PhongInputs, PhongSpec};
pub use power::PowerUnit;
pub use quadratic::Quadratic;
pub use reflection::{ReflectionInputs, ReflectionSpec};
pub use scene_core::{CoreError, SceneCore};
pub use set_up::SetUp;
pub use shading_method::{DirectionOutput, OptionDomain, Viewpoint};
pub use slerp::{SlerpInputs, SlerpSpec};
pub use spec_file::SpecFile;
pub use specialisation::{Given, Specialisation};
pub use survey::Survey;
pub use target_clock::TargetClock;
