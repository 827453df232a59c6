//! Unit vectors without a root: n wrapped around H = n + N [Hast, Barrera and Bengtsson, eq. 27 to
//! 32; methods C4 to C7].
use glam::DVec3;

/// For H·H below this, H has lost its direction (extremes rows 7 and 9): 2^-20, that is |H| <
/// 0.001.
const SHORTEST_SQUARE: f64 = 1.0 / 1_048_576.0;

/// N' = 2H(H·n)/(H·H) - n with H = n + N [eq. 27]. It has length 1 for a unit n and any N, and N's
/// direction if N has length 1.
///
/// The result is `None` where n + N → 0.
pub fn wrap(reference: DVec3, vector: DVec3) -> Option<DVec3> {
    let h = reference + vector;
    let square = h.length_squared();
    (square >= SHORTEST_SQUARE).then(|| 2.0 * h.dot(reference) / square * h - reference)
}

/// Whether n can be wrapped around everything between `normals`: each is within 90 degrees of it
/// (extremes row 8).
pub fn serves(reference: DVec3, normals: &[DVec3]) -> bool {
    normals.iter().all(|n| n.dot(reference) > 0.0)
}

/// Lambert's cosine of N' as p/q: N'·L = [2(H·L)(H·n) - (n·L)(H·H)]/(H·H) [eq. 29 to 32], clamped
/// to 0 to 1.
///
/// It is 0 where n + N → 0.
pub fn diffuse(reference: DVec3, normal: DVec3, light: DVec3) -> f64 {
    let h = reference + normal;
    let q = h.length_squared();
    let p = 2.0 * h.dot(light) * h.dot(reference) - reference.dot(light) * q;
    if q < SHORTEST_SQUARE { 0.0 } else { (p / q).clamp(0.0, 1.0) }
}

/// The angle in radians by which N' turns less than N: θ - 2 atan(l sin θ/(1 + l cos θ)), with θ
/// from n to N and l = |N| [numerics N2b].
pub fn error(theta: f64, length: f64) -> f64 {
    theta - 2.0 * (length * theta.sin()).atan2(1.0 + length * theta.cos())
}

/// N' of each pixel, wrapped around the previous one, the first around `start` [methods C7]. Where
/// a wrap vanishes, the previous vector is kept.
pub fn chained(start: DVec3, normals: impl Iterator<Item = DVec3>) -> impl Iterator<Item = DVec3> {
    normals.scan(start, |before, normal| {
        *before = wrap(*before, normal).unwrap_or(*before);
        Some(*before)
    })
}
