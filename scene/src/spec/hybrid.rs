//! Gouraud diffuse with Hast's specular recurrence [Hast, Barrera and Bengtsson, eq. 17 to 26], METHODS.md C3.
//!
//! Along a span N(i) = m + k i, so that both p = 2(N·V)(N·L) - (L·V)(N·N) and q = N·N are quadratic in the pixel number i, and the
//! base of the highlight is R·L = p/q for a normal of any length.
use serde::{Deserialize, Serialize};

use super::{CoreSpec, InputPort};
use crate::format::Format;

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HybridSpec {
    /// The narrowing points.
    pub formats: HybridFormats,
}

/// The narrowing points of the method, in the order of the data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HybridFormats {
    /// Accumulator of the diffuse intensity: `S1.f`. The host rounds start and step into it.
    pub diffuse_accumulator: Format,
    /// Diffuse intensity, rounded from the accumulator: `U1.f`.
    pub diffuse: Format,
    /// Accumulators of p and q and their differences: `S3.f`. The host rounds start values and differences into it.
    pub accumulator: Format,
    /// p and q as they enter the divider: `S1.f`.
    pub operand: Format,
    /// The base p/q, and after each squaring: `U1.f`.
    pub base: Format,
}

/// Start value and differences of a quadratic in the pixel number.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadratic<T> {
    /// Value at the first pixel.
    pub start: T,
    /// Value at the second pixel less that at the first; 0 in a span of one pixel.
    pub first_difference: T,
    /// The constant second difference; 0 in a span of fewer than three pixels, where it is not used.
    pub second_difference: T,
}

/// The core's inputs, or whatever belongs to each of them.
#[derive(Clone, Debug, PartialEq)]
pub struct HybridInputs<T> {
    /// q = N·N.
    pub denominator: Quadratic<T>,
    /// j, with n = 2^j.
    pub log2_shininess: T,
    /// Ambient light sent back, in LSBs.
    pub ambient: [T; 3],
    /// What belongs to each light.
    pub lights: Vec<HybridLight<T>>,
}

/// Inputs that belong to one light.
#[derive(Clone, Debug, PartialEq)]
pub struct HybridLight<T> {
    /// p = 2(N·V)(N·L) - (L·V)(N·N).
    pub numerator: Quadratic<T>,
    /// Gouraud's intensity at the first pixel.
    pub intensity_start: T,
    /// What it grows by with each pixel; 0 in a span of one pixel.
    pub intensity_step: T,
    /// Diffuse coefficient, in LSBs.
    pub diffuse: [T; 3],
    /// Specular coefficient, in LSBs.
    pub specular: [T; 3],
}

impl<T> Quadratic<T> {
    fn map<U>(&self, f: &mut impl FnMut(&T) -> U) -> Quadratic<U> {
        Quadratic {
            start: f(&self.start),
            first_difference: f(&self.first_difference),
            second_difference: f(&self.second_difference),
        }
    }
}

impl<T> HybridInputs<T> {
    /// Applies `f` to every input, in port order.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> HybridInputs<U> {
        HybridInputs {
            denominator: self.denominator.map(&mut f),
            log2_shininess: f(&self.log2_shininess),
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

impl<T> HybridLight<T> {
    fn map<U>(&self, f: &mut impl FnMut(&T) -> U) -> HybridLight<U> {
        HybridLight {
            numerator: self.numerator.map(f),
            intensity_start: f(&self.intensity_start),
            intensity_step: f(&self.intensity_step),
            diffuse: self.diffuse.each_ref().map(&mut *f),
            specular: self.specular.each_ref().map(&mut *f),
        }
    }
}

impl HybridSpec {
    /// The ports of a core with this method.
    ///
    /// With |N| ≤ 1 along the span, |p| ≤ q ≤ 1; differences of neighbours follow, 2 and 4 for p, 1 and 2 for q.
    pub fn inputs(&self, core: &CoreSpec) -> HybridInputs<InputPort> {
        let exponent = Format::unsigned(4, 0);
        HybridInputs {
            denominator: self.quadratic("denominator", [(0.0, 1.0), (-1.0, 1.0), (0.0, 2.0)]),
            log2_shininess: InputPort::between("log2_shininess", exponent, 0.0, f64::from(core.largest_shininess.ilog2())),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        }
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> HybridLight<InputPort> {
        let accumulator = self.formats.diffuse_accumulator;
        let limits = [(-1.0, 1.0), (-2.0, 2.0), (-4.0, 4.0)];
        HybridLight {
            numerator: self.quadratic(&format!("light{index}_numerator"), limits),
            intensity_start: InputPort::between(format!("light{index}_intensity_start"), accumulator, 0.0, 1.0),
            intensity_step: InputPort::between(format!("light{index}_intensity_step"), accumulator, -1.0, 1.0),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }

    fn quadratic(&self, name: &str, limits: [(f64, f64); 3]) -> Quadratic<InputPort> {
        let port = |part: &str, (low, high)| InputPort::between(format!("{name}_{part}"), self.formats.accumulator, low, high);
        Quadratic {
            start: port("start", limits[0]),
            first_difference: port("first_difference", limits[1]),
            second_difference: port("second_difference", limits[2]),
        }
    }
}
