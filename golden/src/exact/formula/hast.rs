//! Cosines for normals of any length [Hast, Barrera and Bengtsson, eq. 8, 17, 33 and 34; methods C2,
//! C3 and C8 to C11].
use glam::DVec3;
use specula_scene::frame::EYE;

/// p/√q = N·L/√(N·N), clamped to 0 to 1, and 0 for N = 0 [Hast et al., eq. 8].
pub fn diffuse(normal: DVec3, light: DVec3) -> f64 {
    cosine(normal, light).clamp(0.0, 1.0)
}

/// u·N/√(N·N), and 0 for N = 0.
pub fn cosine(normal: DVec3, u: DVec3) -> f64 {
    let q = normal.length_squared();
    if q > 0.0 { normal.dot(u) / q.sqrt() } else { 0.0 }
}

/// R·L for a normal of any length: p/q with p = 2(N·V)(N·L) - (L·V)(N·N) and q = N·N, clamped to 0
/// to 1, and 0 for N = 0 [Hast et al., eq. 17].
pub fn base(normal: DVec3, light: DVec3) -> f64 {
    let q = normal.length_squared();
    let p = 2.0 * normal.dot(EYE) * normal.dot(light) - light.dot(EYE) * q;
    if p <= 0.0 || q <= 0.0 { 0.0 } else { (p / q).min(1.0) }
}

/// R·L = 2(N·V)(p/q) - L·V, clamped to 0 to 1, and 0 for N = 0 [Hast et al., eq. 33].
pub fn eq33(normal: DVec3, light: DVec3) -> f64 {
    let q = normal.length_squared();
    if q <= 0.0 {
        return 0.0;
    }
    (2.0 * normal.dot(EYE) * (normal.dot(light) / q) - light.dot(EYE)).clamp(0.0, 1.0)
}

/// R·L = 2(N·V s)(N·L s) - L·V with s = 1/√(N·N), clamped to 0 to 1, and 0 for N = 0 [Hast et al.,
/// eq. 34].
pub fn eq34(normal: DVec3, light: DVec3) -> f64 {
    if normal == DVec3::ZERO {
        return 0.0;
    }
    (2.0 * cosine(normal, EYE) * cosine(normal, light) - light.dot(EYE)).clamp(0.0, 1.0)
}
