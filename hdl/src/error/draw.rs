//! Numbers for the tests of bounds, the same ones on every run.
use glam::DVec3;

/// Draws numbers from a seeded stream.
pub struct Draw(fastrand::Rng);

impl Draw {
    /// A stream of numbers.
    pub fn new(seed: u64) -> Draw {
        Draw(fastrand::Rng::with_seed(seed))
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    /// An error of `most` at most: three times out of four at one of the ends, since bounds are
    /// reached there.
    pub fn error(&mut self, most: f64) -> f64 {
        match self.0.u8(..8) {
            0..3 => most,
            3..6 => -most,
            _ => self.between(-most, most),
        }
    }

    /// One of `choices`.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.0.usize(..choices.len())]
    }

    /// A unit vector.
    pub fn direction(&mut self) -> DVec3 {
        let mut component = || self.between(-1.0, 1.0);
        DVec3::new(component(), component(), component()).try_normalize().unwrap_or(DVec3::Z)
    }

    /// A unit vector across another.
    pub fn across(&mut self, unit: DVec3) -> DVec3 {
        unit.cross(self.direction()).try_normalize().unwrap_or(unit.any_orthonormal_vector())
    }
}
