//! From intensities to a pixel.
use crate::builder::{Builder, Sig};

/// A colour coefficient for each channel, in LSBs of the output.
pub type Coefficients = [Sig; 3];

/// What one light contributes.
pub struct Light {
    /// Diffuse intensity, 0 to 1.
    pub diffuse: Sig,
    /// Specular intensity, 0 to 1.
    pub specular: Sig,
    /// Diffuse coefficients.
    pub diffuse_coefficients: Coefficients,
    /// Specular coefficients.
    pub specular_coefficients: Coefficients,
}

/// The 8-bit codes of red, green and blue. [METHODS A3]
pub fn channels(b: &Builder, ambient: &Coefficients, lights: &[Light]) -> [Sig; 3] {
    let channel = |c: usize, name: &str| b.instance(&format!("{name}_channel"), || channel(b, &ambient[c], lights, c));
    [channel(0, "red"), channel(1, "green"), channel(2, "blue")]
}

/// c = ambient + Σ (diffuse coefficient · diffuse + specular coefficient · specular), rounded, at most 255.
fn channel(b: &Builder, ambient: &Sig, lights: &[Light], c: usize) -> Sig {
    let coefficients = |light: &Light| [light.diffuse_coefficients[c].clone(), light.specular_coefficients[c].clone()];
    let intensities = |light: &Light| [light.diffuse.clone(), light.specular.clone()];
    let coefficients: Vec<Sig> = lights.iter().flat_map(coefficients).collect();
    let intensities: Vec<Sig> = lights.iter().flat_map(intensities).collect();
    let inputs = (("ambient", ambient), ("coefficient", &coefficients), ("intensity", &intensities));
    let formula = "c = min(ambient + sum of coefficient x intensity, 255) [METHODS A3]";
    b.unit("channel", formula, inputs, |_, (ambient, coefficients, intensities)| {
        let sum =
            coefficients.iter().zip(&intensities).fold(ambient, |sum, (coefficient, intensity)| sum + coefficient * intensity);
        sum.rounded(0).clamped_above(255).named("code")
    })
}
