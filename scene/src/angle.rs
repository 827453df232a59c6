//! Sines and cosines that are the same on every machine.
//!
//! The standard library takes these functions from the platform, which may round differently; the
//! `libm` crate computes them itself.

/// Cosine and sine of an angle in degrees; exact at multiples of 90.
///
/// The results are not finite if the angle is not.
pub(crate) fn cos_sin(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    let quarter = (turned / 90.0).floor();
    let rest = (turned - 90.0 * quarter) * (std::f64::consts::PI / 180.0);
    let (cos, sin) = (libm::cos(rest), libm::sin(rest));
    match quarter as u32 % 4 {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

/// Cosine and sine of the share `part`/`whole` of a full turn.
pub(crate) fn cos_sin_of_turn(part: u32, whole: u32) -> (f64, f64) {
    cos_sin(360.0 * f64::from(part) / f64::from(whole))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let quarters = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for turn in -8..8_i32 {
            assert_eq!(cos_sin(f64::from(turn) * 90.0), quarters[turn.rem_euclid(4) as usize]);
        }
    }

    #[test]
    fn other_angles_agree_with_the_standard_library() {
        for step in -1000..1000_i32 {
            let degrees = f64::from(step) * 0.777;
            let (cos, sin) = cos_sin(degrees);
            let radians = degrees.to_radians();
            assert!((cos - radians.cos()).abs() < 1e-14 && (sin - radians.sin()).abs() < 1e-14);
        }
    }
}
