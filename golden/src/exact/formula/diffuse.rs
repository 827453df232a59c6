//! Diffuse reflection.
use glam::DVec3;

/// Lambert's cosine, max(N·L, 0).
pub fn lambert(normal: DVec3, light: DVec3) -> f64 {
    normal.dot(light).max(0.0)
}

/// Gouraud's intensity: those of a triangle's vertices, interpolated with barycentric `weights` and
/// clamped to 0 to 1 [lecture, eq. 3.2 to 3.6].
pub fn gouraud(at_vertices: [f64; 3], weights: [f64; 3]) -> f64 {
    let intensity: f64 = at_vertices.iter().zip(weights).map(|(intensity, w)| w * intensity).sum();
    intensity.clamp(0.0, 1.0)
}
