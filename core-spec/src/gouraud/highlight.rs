//! What a highlight is at a vertex: Phong's power, or Lyon's f_k.
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The shape of the highlight, as a function of R and L.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Highlight {
    /// max(R·L, 0)^n [lecture, eq. 2.1].
    #[default]
    Power,
    /// f_k(x) = (1 - x/2^k)^(2^k) of x = n/2 D·D with D = R - L, and 0 from x = 2^k on [Lyon; methods
    /// B]: k squarings in place of a power.
    FK,
}

/// The highlight of a surface with an exponent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexHighlight {
    /// Its shape.
    pub highlight: Highlight,
    /// k of f_k, 0 to 4.
    pub squarings: u32,
    /// Phong's exponent n, 1 to 8191.
    pub shininess: u32,
}

impl VertexHighlight {
    /// What is reflected of a light in the direction `light`, 0 to 1, where the eye's direction is
    /// reflected to `reflection`; both are unit vectors.
    pub fn of(&self, reflection: DVec3, light: DVec3) -> f64 {
        let n = f64::from(self.shininess);
        match self.highlight {
            Highlight::Power => libm::pow(reflection.dot(light).clamp(0.0, 1.0), n),
            Highlight::FK => {
                let difference = reflection - light;
                let factors = f64::from(1_u32 << self.squarings);
                let base = 1.0 - n * difference.dot(difference) / (2.0 * factors);
                (0..self.squarings).fold(base.max(0.0), |shape, _| shape * shape)
            }
        }
    }
}
