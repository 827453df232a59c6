//! Random numbers that are the same on every machine.

/// Knuth's MMIX generator.
pub struct Random(u64);

impl Random {
    /// The numbers of a seed.
    pub fn new(seed: u64) -> Random {
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        // The first numbers of seeds near each other are near each other.
        (0..4).for_each(|_| {
            random.next();
        });
        random
    }

    fn next(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 32
    }

    /// From 0 up to, but without, 1.
    pub fn unit(&mut self) -> f64 {
        self.next() as f64 / 4_294_967_296.0
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        self.next() as usize % end
    }
}
