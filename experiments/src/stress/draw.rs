//! Seeded random numbers, directions and spans.
use std::f64::consts::TAU;

use glam::DVec3;
use specula_scene::frame::EYE;

/// A stream of random numbers [Steele, Lea and Flood, SplitMix64].
#[derive(Clone, Debug)]
pub struct Draw(u64);

impl Draw {
    /// The stream of a seed; `stream` distinguishes the streams of one seed.
    pub fn new(seed: u64, stream: u64) -> Draw {
        let mut draw = Draw(seed ^ stream.wrapping_mul(0xD129_42F0_1E47_6C35));
        draw.bits();
        draw
    }

    /// A new independent stream.
    pub fn fork(&mut self) -> Draw {
        Draw(self.bits())
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    /// A number from 0 to 1, 1 excluded.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Barycentric weights, evenly over a triangle.
    pub fn weights(&mut self) -> [f64; 3] {
        let (root, share) = (self.unit().sqrt(), self.unit());
        [1.0 - root, root * (1.0 - share), root * share]
    }

    /// A number from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// An integer from `low` to `high`. The ends are more likely than others, since faults are
    /// there.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        match self.bits() % 8 {
            0 => low,
            1 => high,
            _ => {
                (i128::from(low)
                    + i128::from(self.bits()) % (i128::from(high) - i128::from(low) + 1))
                    as i64
            }
        }
    }

    /// One of `choices`, of which there is at least one.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.bits() % choices.len() as u64) as usize]
    }

    /// A length from 1 to `longest` pixels, with a uniformly distributed logarithm.
    pub fn length(&mut self, longest: u32) -> u32 {
        let log2 = self.within(0.0, f64::from(longest).log2());
        (libm::exp2(log2).round() as u32).clamp(1, longest)
    }

    /// A power of two from 1 to 4096.
    pub fn even_shininess(&mut self) -> u32 {
        1 << self.between(0, 12)
    }

    /// A unit vector, sometimes on an axis.
    pub fn direction(&mut self) -> DVec3 {
        if self.bits().is_multiple_of(8) {
            return self.one_of(&AXES);
        }
        // Archimedes: heights on a sphere are uniform.
        let (height, azimuth) = (self.within(-1.0, 1.0), self.unit());
        turned(DVec3::Z, libm::acos(height), azimuth)
    }

    /// Unit vectors at the ends of a span that are `degrees` apart, their middle at most `tilt`
    /// degrees from the eye.
    pub fn ends(&mut self, degrees: f64, tilt: f64) -> [DVec3; 2] {
        let middle = turned(EYE, (tilt * self.unit().sqrt()).to_radians(), self.unit());
        let (half, azimuth) = (degrees.to_radians() / 2.0, self.unit());
        [turned(middle, half, azimuth), turned(middle, -half, azimuth)]
    }

    /// A light whose highlight for exponent `n` lies on a span between these normals: within 2/√n
    /// of the eye's reflection at some point.
    pub fn aimed(&mut self, ends: [DVec3; 2], n: u32) -> DVec3 {
        let normal = ends[0].lerp(ends[1], self.unit()).try_normalize().unwrap_or(ends[0]);
        let reflected = (2.0 * normal.dot(EYE) * normal - EYE).normalize();
        turned(reflected, 2.0 / f64::from(n).sqrt() * self.unit(), self.unit())
    }
}

/// Both directions along each axis.
pub const AXES: [DVec3; 6] =
    [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];

/// The unit vector at `degrees` from the eye towards x.
pub fn tilted(degrees: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    DVec3::new(sin, 0.0, cos)
}

/// The unit vector at `angle` radians from `axis`, at `azimuth` turns about it.
pub fn turned(axis: DVec3, angle: f64, azimuth: f64) -> DVec3 {
    let (u, v) = axis.any_orthonormal_pair();
    let (sin, cos) = libm::sincos(TAU * azimuth);
    let (across, along) = libm::sincos(angle);
    (axis * along + (u * cos + v * sin) * across).normalize()
}
