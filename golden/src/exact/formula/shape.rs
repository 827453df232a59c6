//! Shape functions of the highlight: 1 where the reflection meets the light, falling to 0.

/// Phong's shape, max(cosine, 0)^n; 1 for n = 0.
pub fn power(cosine: f64, n: u32) -> f64 {
    // Exponents are at most 8191, so nothing is lost in i32.
    cosine.max(0.0).powi(n.cast_signed())
}

/// Lyon's f_k(x) = (1 - x/2^k)^(2^k), and 0 from x = 2^k on [Lyon, eq. for the shape; methods
/// B].
///
/// With x = (n/2)|R - L|² and n = 2^k it equals Phong's cos^n.
pub fn f_k(x: f64, k: u32) -> f64 {
    lobe(x, 1 << k)
}

/// The same with any number of factors K from 1 on, (1 - x/K)^K, and 0 from x = K on [Lyon,
/// "Gaussian and Exponential Relationships"; methods B10].
pub fn lobe(x: f64, factors: u32) -> f64 {
    (1.0 - x / f64::from(factors)).max(0.0).powi(factors.cast_signed())
}
