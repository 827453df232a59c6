//! Each paper's loop in f32, for its run time.
//!
//! What belongs to the frame (intensities of vertices, steps along edges, products of materials and
//! lights) is worked out once for it, set-up once for a span, and the loop runs from pixel to pixel;
//! they are apart so that their times can be measured apart. Nothing is allocated for a span.
mod along_span;
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

/// A frame that is shaded by one loop, one block of spans after another. Calls are virtual, one for
/// a block or a span; pixels are not.
pub trait Software {
    /// Sets spans of the frame up, in place of those before, whose memory they take over.
    fn set_up(&mut self, spans: &[Span]);

    /// Shades pixels 0, 1, … of span `number` of those that are set up, up to `out`'s length:
    /// 0..=255 LSB a channel, not rounded. A span is shaded once.
    fn shade(&mut self, number: usize, out: &mut [[f32; 3]]);
}

/// Works out what belongs to a frame.
pub type OfMesh = for<'a> fn(&'a Mesh<'a>) -> Box<dyn Software + 'a>;
