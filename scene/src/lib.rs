//! What is to be shaded.
//!
//! A scene file or mesh becomes a [`Frame`]: visible [`Span`]s of triangles, and [`Needs`] says what
//! they ask of the hardware that shades them.
mod angle;
mod arc;
mod attenuation;
mod builtin;
pub mod contributions;
pub mod defaults;
mod error;
mod file;

pub mod frame;
mod grouped;
mod illumination;
pub mod limits;
mod load;
pub mod mesh;
pub mod needs;
mod parallel;
mod partial_material;
pub mod perspective;
pub mod picture;
pub mod primitive;
pub mod regular;
mod scan_line;
pub mod sequence;
mod shortest_halfway;
mod surface;
mod wrap;
mod wrapped_places;

pub use arc::Arc;
pub use attenuation::Attenuation;
pub use builtin::{builtin_names, builtin_text};
pub use error::SceneError;
pub use file::{CoreTable, SourceFile};
pub use frame::{
    Colour, DirectionalLight, Facet, Frame, LocalLight, Material, Span, Spot, Triangle, VertexCone,
};
pub use illumination::Illumination;
pub use load::{LONGEST_NAME, LoadedScene, load, module_name, parse};
pub use needs::Needs;
pub use parallel::ParallelSpan;
pub use partial_material::PartialMaterial;
pub use perspective::Perspective;
pub use scan_line::{ScanLine, normal_on_edge};
pub use sequence::Sequence;
pub use surface::Surface;
pub use wrap::Wrap;
