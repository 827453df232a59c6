//! What a core must compute, bit for bit, written from `docs/arithmetic.md` and the spec.
//!
//! Numbers are exact between narrowing points (`number`), which round to nearest with ties up.
mod attenuation;
mod colour;
mod consistent;
mod direct;
mod duff;
mod error;
mod exp2;
mod forward;
mod gaussian;
mod gouraud;
mod highlight;
mod hybrid;
mod lyon;
mod method;
mod model;
mod number;
mod observer;
mod packet;
mod phong;
mod power;
mod raised;
mod reflection;
mod root;
mod shader;
mod slerp;
mod span_extent;
mod span_vectors;
mod spot;
mod vector;
mod vector_ways;
mod ways;
mod wrapped;

pub use error::PacketError;
pub use model::Model;
pub use observer::Observation;
