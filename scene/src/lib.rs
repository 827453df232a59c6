//! What is to be shaded, and the hardware it is to be shaded by.
//!
//! A scene file or mesh becomes a [`Frame`]: visible [`Span`]s of triangles. A [`CoreSpec`] says which core shades them, and
//! [`CoreSpec::packet`] sets up each span for it.
pub mod format;
pub mod frame;

pub use format::Format;
pub use frame::{Colour, DirectionalLight, Frame, Material, Span, Triangle};
