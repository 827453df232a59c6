//! Scenes to be shaded, and the specification of the hardware that shades them.
//!
//! A scene file or mesh becomes a [`Frame`]: visible [`Span`]s of triangles. A [`CoreSpec`] says
//! which core shades them, and [`CoreSpec::packet`] sets up each span for it.
mod angle;
mod builtin;
mod choose_core;
pub mod contributions;
pub mod defaults;
mod error;
mod file;

pub mod frame;
mod illumination;
mod load;
pub mod mesh;
pub mod needs;
mod parallel;
pub mod picture;
pub mod primitive;
pub mod regular;
pub mod spec;
mod spec_file;
mod surface;

pub use builtin::builtin_names;
pub use error::SceneError;
pub use file::CoreTable;
pub use frame::{
    Colour, DirectionalLight, Facet, Frame, LocalLight, Material, Span, Spot, Triangle, VertexCone,
};
pub use illumination::Illumination;
pub use load::{LoadedScene, load, parse};
pub use needs::Needs;
pub use parallel::ParallelSpan;
pub use spec::{CoreSpec, Method, MethodSpec, SpanPacket};
pub use spec_file::SpecFile;
pub use specula_datapath::Format;
pub use specula_datapath::format;
pub use surface::Surface;
