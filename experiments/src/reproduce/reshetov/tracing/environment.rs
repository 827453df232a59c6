//! A small procedural environment: what is far away in each direction.
use std::f64::consts::{PI, TAU};

use glam::DVec3;

/// The ground, in squares, fades into the horizon below this height of a direction.
const HAZE: f64 = 0.25;
const GROUND: [DVec3; 2] = [DVec3::new(0.20, 0.13, 0.08), DVec3::new(0.72, 0.62, 0.48)];
const HORIZON: DVec3 = DVec3::new(0.86, 0.90, 0.95);
const ZENITH: DVec3 = DVec3::new(0.12, 0.28, 0.62);
const SUN: DVec3 = DVec3::new(1.0, 0.97, 0.85);
/// Where the sun is, and the cosine of its radius.
const SUN_DIRECTION: DVec3 =
    DVec3::new(-0.371_390_676_354_103_7, 0.557_086_014_531_155_6, 0.742_781_352_708_207_5);
const SUN_RADIUS: f64 = 0.99;
/// Pillars all round, each as wide as its gap.
const PILLARS: f64 = 24.0;
const PILLAR_TOP: f64 = 0.22;
const PILLAR: DVec3 = DVec3::new(0.42, 0.16, 0.14);

/// The colour in a direction, a unit vector with y up; 1 is full scale.
pub fn colour(direction: DVec3) -> DVec3 {
    match direction.y {
        height if height < 0.0 => ground(direction),
        height if height < PILLAR_TOP && is_pillar(direction) => PILLAR,
        _ if direction.dot(SUN_DIRECTION) > SUN_RADIUS => SUN,
        height => HORIZON.lerp(ZENITH, height.sqrt()),
    }
}

/// Squares on a plane a unit below.
fn ground(direction: DVec3) -> DVec3 {
    let depth = -direction.y;
    let squares = (direction.x / depth).floor() + (direction.z / depth).floor();
    let colour = GROUND[squares.rem_euclid(2.0) as usize];
    HORIZON.lerp(colour, (depth / HAZE).min(1.0))
}

fn is_pillar(direction: DVec3) -> bool {
    let turn = (libm::atan2(direction.z, direction.x) + PI) / TAU;
    (turn * 2.0 * PILLARS).floor() as i64 % 2 == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_direction_has_a_colour() {
        assert!((SUN_DIRECTION.length() - 1.0).abs() < 1e-12);
        let mut draw = crate::stress::draw::Draw::new(7, 0);
        for _ in 0..10_000 {
            let colour = colour(draw.direction());
            assert!(colour.min_element() >= 0.0 && colour.max_element() <= 1.0);
        }
        assert_eq!(colour(SUN_DIRECTION), SUN);
        assert_eq!(colour(DVec3::Y), ZENITH);
    }
}
