//! The self-checking bench of a block.
use super::StreamCore;
use super::template::Values;
use super::vectors::Vectors;

/// Adds what the bench's template asks for besides.
pub fn values(core: &StreamCore, vectors: &Vectors, frames: usize, values: &mut Values) {
    let [words, pixels, writes] = vectors.counts();
    values.set("WORD_COUNT", words);
    values.set("PIXEL_COUNT", pixels);
    values.set("WRITE_COUNT", writes);
    values.set("FRAME_COUNT", frames);
    values.set("WORD_LINE_TOP", core.word.bits() + 1);
    values.set("PIXEL_LINE_TOP", core.pixel_bits() + 1);
    values.flag("writes", writes > 0);
}
