//! Mirrors: a mesh that reflects its surroundings, by an environment map or by rays traced into
//! itself (figure 1).
pub mod claims;
mod environment;
mod hierarchy;
mod mirror;
pub mod picture;
mod ray;
pub(super) mod tears;
mod traced_mesh;

pub use mirror::Normals;
pub use picture::{Mirrored, Rays, Surroundings, mirrored};
