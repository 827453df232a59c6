//! Lyon's reformulation of Phong shading for hardware [Lyon, Apple TR 43], METHODS.md B1 to B13.
use serde::{Deserialize, Serialize};

use super::{CoreSpec, InputPort};
use crate::format::Format;

/// How the interpolated normal is brought to unit length: n = g·N', with z = N'·N' and y = 1 - z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    /// g1 = 1 + y/2 (B8).
    G1,
    /// g2 = 1 + (y + y²)/2 (B9).
    G2,
}

/// The vector D whose squared length the highlight depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Difference {
    /// D = R - L with R = 2(N·V)N - V (B1, B2; figure 7).
    ReflectionMinusLight,
    /// D = H × N with H = L + V (B13).
    HalfwayCrossNormal,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LyonSpec {
    /// First approximation of 1/|N'|.
    pub normalisation: Normalisation,
    /// Newton steps g ← g(3 - z g²)/2 after it, 0 to 3.
    pub newton_steps: u32,
    /// The vector D.
    pub difference: Difference,
    /// k of the shape function f_k(x) = (1 - x/2^k)^(2^k), 0 to 3: how often the shape is squared.
    pub squarings: u32,
    /// The narrowing points.
    pub formats: LyonFormats,
}

/// The narrowing points of the method, in the order of the data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LyonFormats {
    /// Accumulator of the interpolation weight a: `U1.f`. The host rounds the step 1/S into it.
    pub weight_accumulator: Format,
    /// The weight a, rounded from the accumulator: `U1.f`.
    pub weight: Format,
    /// Components of normals and light directions, of N' after interpolation and of n after normalisation: `S1.f`.
    /// Differences of normals and half-way vectors have the same fraction bits and one more integer bit.
    pub vector: Format,
    /// z = N'·N': `U1.f`.
    pub length_squared: Format,
    /// g, and within a Newton step g² and 3 - z g²: `U2.f`.
    pub gain: Format,
    /// N·L after clamping at 0: `U1.f`.
    pub diffuse: Format,
    /// 2 N·V (with D = R - L only) and the components of D: `S2.f`.
    pub difference: Format,
    /// x/2^k before comparison with 1, 1 - x/2^k, and after each squaring: `U1.f`.
    pub shape: Format,
}

/// The core's inputs, or whatever belongs to each of them.
#[derive(Clone, Debug, PartialEq)]
pub struct LyonInputs<T> {
    /// N0, the normal at the first pixel.
    pub normal_start: [T; 3],
    /// N1 - N0, over the whole span.
    pub normal_delta: [T; 3],
    /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel.
    pub weight_step: T,
    /// n.
    pub shininess: T,
    /// Ambient light sent back, in LSBs.
    pub ambient: [T; 3],
    /// What belongs to each light.
    pub lights: Vec<LyonLight<T>>,
}

/// Inputs that belong to one light.
#[derive(Clone, Debug, PartialEq)]
pub struct LyonLight<T> {
    /// L.
    pub direction: [T; 3],
    /// H = L + V; there with D = H × N only.
    pub halfway: Option<[T; 3]>,
    /// Diffuse coefficient, in LSBs.
    pub diffuse: [T; 3],
    /// Specular coefficient, in LSBs.
    pub specular: [T; 3],
}

impl<T> LyonInputs<T> {
    /// Applies `f` to every input, in port order.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> LyonInputs<U> {
        LyonInputs {
            normal_start: self.normal_start.each_ref().map(&mut f),
            normal_delta: self.normal_delta.each_ref().map(&mut f),
            weight_step: f(&self.weight_step),
            shininess: f(&self.shininess),
            ambient: self.ambient.each_ref().map(&mut f),
            lights: self.lights.iter().map(|light| light.map(&mut f)).collect(),
        }
    }

    /// Every input, in port order.
    pub fn to_vec(&self) -> Vec<T>
    where
        T: Clone,
    {
        let mut all = Vec::new();
        self.map(|x| all.push(x.clone()));
        all
    }
}

impl<T> LyonLight<T> {
    fn map<U>(&self, f: &mut impl FnMut(&T) -> U) -> LyonLight<U> {
        LyonLight {
            direction: self.direction.each_ref().map(&mut *f),
            halfway: self.halfway.as_ref().map(|h| h.each_ref().map(&mut *f)),
            diffuse: self.diffuse.each_ref().map(&mut *f),
            specular: self.specular.each_ref().map(&mut *f),
        }
    }
}

impl LyonFormats {
    /// Format of N1 - N0 and of H: the vector's with one more integer bit, since the sum of two vectors is up to twice as long.
    pub fn vector_sum(&self) -> Format {
        Format::signed(self.vector.integer_bits + 1, self.vector.fraction_bits)
    }
}

impl LyonSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> LyonInputs<InputPort> {
        let f = &self.formats;
        let shininess = Format::unsigned(u32::BITS - core.largest_shininess.leading_zeros(), 0);
        LyonInputs {
            normal_start: InputPort::vector("normal_start", f.vector, 1.0),
            normal_delta: InputPort::vector("normal_delta", f.vector_sum(), 2.0),
            weight_step: InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0),
            shininess: InputPort::between("shininess", shininess, 1.0, f64::from(core.largest_shininess)),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        }
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> LyonLight<InputPort> {
        let f = &self.formats;
        let halfway = || InputPort::vector(&format!("light{index}_halfway"), f.vector_sum(), 2.0);
        LyonLight {
            direction: InputPort::vector(&format!("light{index}_direction"), f.vector, 1.0),
            halfway: (self.difference == Difference::HalfwayCrossNormal).then(halfway),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }
}
