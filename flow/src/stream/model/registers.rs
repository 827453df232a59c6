//! Inputs that hold for a frame, as registers keep them.
use specula_spec::raw_value;

use super::super::{FrameInput, StreamCore};

/// What has been written, and what the core sees of it.
pub struct Registers {
    inputs: Vec<FrameInput>,
    /// Bits of what waits for the next frame, for each input.
    waiting: Vec<u64>,
    /// Bits of what holds for this one.
    held: Vec<u64>,
    /// Frames that have begun.
    pub frames: u32,
}

impl Registers {
    /// Those of a core after reset.
    pub fn new(core: &StreamCore) -> Registers {
        let inputs = core.frame_inputs();
        let reset: Vec<u64> = inputs.iter().map(|input| input.reset as u64).collect();
        Registers { inputs, held: vec![0; reset.len()], waiting: reset, frames: 0 }
    }

    /// Writes a word.
    pub fn write(&mut self, (address, word): (u32, u32)) {
        for (input, waiting) in self.inputs.iter().zip(&mut self.waiting) {
            let low = *waiting & u64::from(u32::MAX);
            if address == input.address {
                *waiting = *waiting >> 32 << 32 | u64::from(word);
            } else if input.high_bits() > 0 && address == input.address + 4 {
                *waiting = u64::from(word) << 32 | low;
            }
        }
    }

    /// Ends a clock in which a frame begins: what waits is taken over.
    pub fn begin_frame(&mut self) {
        self.held.clone_from(&self.waiting);
        self.frames += 1;
    }

    /// Raw values of the inputs that hold for this frame, with the inputs' numbers.
    pub fn held(&self) -> impl Iterator<Item = (usize, i64)> {
        let raw =
            |(input, &bits): (&FrameInput, &u64)| (input.number, raw_value(input.format, bits));
        self.inputs.iter().zip(&self.held).map(raw)
    }
}
