//! Pictures of frames, pixel by pixel.
use rayon::prelude::*;
use specula_scene::{Frame, Span};
use specula_testbench::Image;

/// A frame's picture; `colour` gives a pixel of a span.
pub fn painted(frame: &Frame, colour: impl Fn(&Span, u32) -> [u8; 3] + Sync) -> Image {
    let of_span = |span: &Span| (0..span.length).map(|i| colour(span, i)).collect();
    let spans: Vec<Vec<[u8; 3]>> = frame.spans.par_iter().map(of_span).collect();
    let mut image = Image::filled(frame.width, frame.height, frame.background);
    for (span, pixels) in frame.spans.iter().zip(spans) {
        image.run_mut(span).copy_from_slice(&pixels);
    }
    image
}

/// A colour in LSBs, rounded to 8 bits.
pub fn rounded(colour: [f64; 3]) -> [u8; 3] {
    colour.map(|channel| channel.round() as u8)
}
