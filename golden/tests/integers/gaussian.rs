//! exp(-2n α²) on raw values, with tables from f64.
use crate::power::{raw, two_to_minus};
use crate::raw::round;

/// `d` = 1 - cos α has `from` fraction bits, the Gaussian `to`.
pub fn of(d: i128, from: u32, n: i128, to: u32) -> i128 {
    // With 10 bits more than any d has, halves of parts are whole.
    let bits = from + 10;
    let d = d << 10;
    let i = d >> (bits - 4);
    let delta = d - ((2 * i + 1) << (bits - 5));
    let [a, b, c] = parabola(i as f64).map(|coefficient| raw(coefficient, to + 4));
    let slope = b + round(delta * c, bits + to + 4, to + 4);
    let g = a + round(delta * slope, bits + to + 4, to + 4);
    two_to_minus(2 * (n * d).min(4 << bits) * g, bits + to + 4, to)
}

/// The parabola's coefficients in part `i`.
fn parabola(i: f64) -> [f64; 3] {
    let [left, middle, right] = [i, i + 0.5, i + 1.0].map(|sixteenths| g(sixteenths / 16.0));
    [middle, (right - left) * 16.0, (right + left - 2.0 * middle) * 512.0]
}

fn g(d: f64) -> f64 {
    let squared_angle_over_d =
        if d == 0.0 { 2.0 } else { 4.0 * (d / 2.0).sqrt().asin().powi(2) / d };
    squared_angle_over_d * std::f64::consts::LOG2_E
}
