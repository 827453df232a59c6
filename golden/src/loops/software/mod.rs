//! Each paper's loop in f32, for measuring its run time.
//!
//! What belongs to the frame (intensities of vertices, steps along edges, products of materials and
//! lights) is computed once for it, set-up once for a span, and the loop runs from pixel to pixel.
//! The three are separate functions, so that their times can be measured separately. Nothing is
//! allocated for a span.
mod along_span;
mod arc_edges;
mod linear;
mod looped;
mod mesh;
mod methods;
mod placed;
mod set_up;
mod surface;

use specula_scene::Span;

pub use mesh::Mesh;
pub use methods::{METHODS, Method, Places, by_name};

/// A frame that one loop shades, one block of spans after another. There is a virtual call for a
/// block or a span, none for a pixel.
pub trait Software {
    /// Sets up spans of the frame, which replace those before and reuse their memory.
    fn set_up(&mut self, spans: &[Span]);

    /// Shades pixels 0, 1, … of span `number` of those that are set up, up to `out`'s length:
    /// 0..=255 LSB a channel, not rounded. A span can be shaded only once.
    fn shade(&mut self, number: usize, out: &mut [[f32; 3]]);
}

/// Computes what belongs to a frame.
pub type OfMesh = for<'a> fn(&'a Mesh<'a>) -> Box<dyn Software + 'a>;
