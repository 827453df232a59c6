//! Proofs of error bounds, a file for each unit: numbers alone, without signals.
pub mod angular;
pub mod contraction;
pub mod cosine;
pub mod difference;
pub mod diffuse;
#[cfg(test)]
mod draw;
pub mod host;
pub mod length_off;
pub mod newton_root;
pub mod normalise;
pub mod normalise_exactly;
pub mod reciprocal_square_root;
pub mod rotation;
pub mod square_root;
pub mod turned;
pub mod turned_normal;
pub mod unit_vectors;
pub mod vector;
