//! The highlight from m = √n, with small squares [Lyon, TR 43, figure 8; methods B].
use glam::DVec3;

/// f_1 with x = ½ mD·mD, that is (1 - x/2)² with x/2 = (mD/2)².
///
/// The squarers see only fractions: if one component of m|D|/2 reaches 1, f is 0 (the augmented
/// comparator, extremes rows 30 and 31). The text's "corresponding to x/4" holds for k = 3; here mD
/// is shifted by one.
pub fn highlight(m: f64, difference: DVec3) -> f64 {
    let half = (m / 2.0 * difference).abs();
    let quotient = half.fract().length_squared();
    if half.max_element() >= 1.0 || quotient >= 1.0 { 0.0 } else { (1.0 - quotient).powi(2) }
}
