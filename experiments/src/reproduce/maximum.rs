//! Maxima of functions of one number.

/// Number of samples for a maximum.
pub const SAMPLES: u32 = 20_000;

/// The largest value of `f` over 0 to 1.
pub fn largest(f: impl Fn(f64) -> f64) -> f64 {
    (0..=SAMPLES).map(|k| f(f64::from(k) / f64::from(SAMPLES))).fold(f64::NEG_INFINITY, f64::max)
}
