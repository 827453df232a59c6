//! Random pauses, as the bench draws them.

/// Pauses of one stream: in which clocks it rests. How often it does changes every 64 clocks, from
/// never to nearly always.
pub struct Pauses {
    random: u32,
    /// It rests in this many of 256 clocks.
    share: u8,
    /// The clock, modulo 64.
    phase: u8,
}

impl Pauses {
    /// Those of words that go in. No seed, or 0, is none.
    pub fn of_packets(seed: u32) -> Option<Pauses> {
        Pauses::beginning(seed, (seed << 16 | 0x9e37) ^ seed >> 16)
    }

    /// Those of pixels that come out.
    pub fn of_pixels(seed: u32) -> Option<Pauses> {
        Pauses::beginning(seed, (0x85eb_0000 | seed & 0xffff) ^ seed >> 16 << 16)
    }

    fn beginning(seed: u32, random: u32) -> Option<Pauses> {
        (seed != 0).then_some(Pauses { random, share: 0, phase: 0 })
    }

    /// Whether it rests in this clock.
    pub fn rests(&self) -> bool {
        ((self.random >> 24) as u8) < self.share
    }

    /// Ends a clock. [Marsaglia, Xorshift RNGs, Journal of Statistical Software 8, 2003: 13, 17, 5]
    pub fn clock(&mut self) {
        if self.phase == 0 {
            self.share = if self.random & 0x200 == 0 { self.random as u8 } else { 0 };
        }
        self.phase = (self.phase + 1) % 64;
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
    }
}
