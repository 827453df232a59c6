//! Random spans with the light where the highlight is.
use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use specula_scene::frame::EYE;
use specula_scene::{Frame, Material};

use super::frame;

/// Numbers from 0 to 1 that decide a span.
pub type Draw = [f64; 12];

/// What spans to draw.
#[derive(Clone, Copy)]
pub struct Range {
    /// Widest angle between the end normals, in degrees.
    pub widest: f64,
    /// Farthest that the middle normal tilts from V, in degrees.
    pub tilt: f64,
    /// log2 of the length of the longest span.
    pub log2_length: f64,
    /// Number of lights.
    pub lights: usize,
}

/// A span drawn.
pub struct Drawn {
    /// It is the only span.
    pub frame: Frame,
    /// Pixel near whose highlight the first light stands.
    pub highlight: u32,
}

/// A span whose highlights lie on it: each light stands within the lobe, 4/√n, of the eye's
/// reflection at some pixel.
pub fn draw_frame(range: Range, draw: &Draw, material: Material) -> Drawn {
    let middle = turned(EYE, range.tilt.to_radians() * draw[0].sqrt(), draw[1]);
    let half = range.widest.to_radians() * draw[2].sqrt() / 2.0;
    let ends = [turned(middle, half, draw[3]), turned(middle, -half, draw[3])];
    let length = (range.log2_length * draw[4]).exp2().round() as u32;
    let lobe = 4.0 / f64::from(material.shininess).sqrt();
    let light = |index: usize| {
        let [along, off, azimuth] = [5, 6, 7].map(|k| (draw[k] + 0.37 * index as f64).fract());
        let normal = ends[0].lerp(ends[1], along).normalize();
        turned(2.0 * normal.dot(EYE) * normal - EYE, lobe * off, azimuth)
    };
    let lights: Vec<DVec3> = (0..range.lights).map(light).collect();
    let highlight = (draw[5] * f64::from(length - 1)).round() as u32;
    Drawn { frame: frame(ends, length, &lights, material), highlight }
}

/// The unit vector at `angle` radians from `axis`, at `azimuth` turns about it.
fn turned(axis: DVec3, angle: f64, azimuth: f64) -> DVec3 {
    let across = DQuat::from_axis_angle(axis, TAU * azimuth) * axis.any_orthonormal_vector();
    (axis * angle.cos() + across * angle.sin()).normalize()
}

/// A stream of draws, the same every time [Steele, Lea and Flood, SplitMix64].
pub struct Draws(pub u64);

impl Iterator for Draws {
    type Item = Draw;

    fn next(&mut self) -> Option<Draw> {
        Some(std::array::from_fn(|_| self.unit()))
    }
}

impl Draws {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
