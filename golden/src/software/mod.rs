//! Each paper's loop in f32, for its run time: a [`Scheme`] per light, set up once for a span.
//!
//! `new` and `shade` are apart so that their times can be measured apart.
mod looped;
mod methods;
mod placed;

use specula_scene::{Frame, Span};

pub use looped::Loop;
pub use methods::{METHODS, Method, by_name};
pub use placed::PlacedLoop;

/// A span that was set up. The call is virtual, once a span; its pixels are not.
pub trait Software {
    /// Shades pixels 0, 1, … in turn, up to `out`'s length: 0..=255 LSB a channel, not rounded.
    fn shade(&self, out: &mut [[f32; 3]]);
}

/// Sets up a span of a frame.
pub type SetUp = fn(&Frame, &Span) -> Box<dyn Software>;
