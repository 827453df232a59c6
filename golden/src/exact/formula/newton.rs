//! The square root of fast Phong shading, by Newton's method, warm-started from the previous pixel
//! [lecture, §4.2; methods A6].
use glam::DVec3;

/// Smallest value of a root: d → 0 near the middle of a span of 180 degrees has no limit to
/// converge to (extremes row 19).
pub const SHORTEST: f64 = f64::EPSILON;

/// One Newton step, x - (x² - D)/(2x).
pub fn step(x: f64, square: f64) -> f64 {
    (x - (x * x - square) / (2.0 * x)).max(SHORTEST)
}

/// √D after `steps` steps from `guess`.
pub fn root(guess: f64, square: f64, steps: u32) -> f64 {
    (0..steps).fold(guess, |x, _| step(x, square))
}

/// |N| at pixels i = 0 to S of a span between `ends`: exact at i = 0 [extremes rows 18 and 20],
/// then computed with `steps` Newton steps from the value at the previous pixel.
pub fn lengths(ends: [DVec3; 2], spans: u32, steps: u32) -> impl Iterator<Item = f64> {
    let first = ends[0].length().max(SHORTEST);
    let later = (1..=spans).scan(first, move |d, i| {
        let normal = ends[0].lerp(ends[1], f64::from(i) / f64::from(spans));
        *d = root(*d, normal.length_squared(), steps);
        Some(*d)
    });
    std::iter::once(first).chain(later)
}
