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

/// The 8-bit codes of red, green and blue: c = ambient + Σ (diffuse · d + specular · f), rounded, at most 255. [METHODS A3]
pub fn channels(b: &Builder, ambient: &Coefficients, lights: &[Light]) -> [Sig; 3] {
    let channel = |c: usize| {
        let terms: Vec<(Sig, Sig)> = lights.iter().flat_map(|light| terms(light, c)).collect();
        let inputs = (("ambient", &ambient[c]), ("term", &terms));
        b.unit("channel", "c = min(ambient + sum of coefficient x intensity, 255) [METHODS A3]", inputs, |_, (ambient, terms)| {
            let sum = terms.iter().fold(ambient, |sum, (coefficient, intensity)| sum + coefficient * intensity);
            sum.rounded(0).clamped_above(255).named("code")
        })
    };
    [channel(0), channel(1), channel(2)]
}

fn terms(light: &Light, channel: usize) -> [(Sig, Sig); 2] {
    [
        (light.diffuse_coefficients[channel].clone(), light.diffuse.clone()),
        (light.specular_coefficients[channel].clone(), light.specular.clone()),
    ]
}
