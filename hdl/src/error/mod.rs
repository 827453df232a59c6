//! Proofs of error bounds, a file for each unit: numbers alone, without signals.
pub mod angular;
pub mod colour;
pub mod consistent_reflection;
pub mod direct;
pub mod divider;
#[cfg(test)]
mod draw;
pub mod followed;
pub mod gaussian;
pub mod host;
pub mod interpolate;
pub mod linear;
pub mod power;
pub mod quadratic;
pub mod rotation;
pub mod shape;
pub mod wrapped;
