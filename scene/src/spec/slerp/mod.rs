//! Spherical interpolation along the scan line, of the scalars that shading needs [lecture, eq. 4.7 and 4.9 to 4.12], METHODS.md A9 to A11.
//!
//! With A and B the unit normals at the ends of a span, f the angle between them and T the unit vector across A towards B,
//! N(i) = cos(i f/S) A + sin(i f/S) T. So J = N·L and K = N·V are what one rotation makes of four scalars, whatever the number of lights,
//! and the base of the highlight is 2 J K - L·V. Nothing is divided by sin f: a span of no angle is one like others.
mod choose;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};

use crate::format::Format;
use crate::spec::power::{Power, PowerUnit};
pub use inputs::{SlerpInputs, SlerpLight};

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SlerpSpec {
    /// How the power of the highlight is taken.
    pub power: Power,
    /// The narrowing points.
    pub formats: SlerpFormats,
}

/// The narrowing points of the method, in the order of the data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SlerpFormats {
    /// Cosine and sine of the angle from pixel to pixel: `S1.f`, rounded by the host.
    pub turn: Format,
    /// Cosine and sine of the angle from the first pixel, rounded at every pixel: `S1.f`.
    pub state: Format,
    /// The same, as they are multiplied with: `S1.f`.
    pub weight: Format,
    /// A·L, T·L, A·V, T·V and L·V: `S1.f`, rounded by the host.
    pub component: Format,
    /// J, K, the correction of K's length, and K after it: `S1.f`.
    pub cosine: Format,
    /// J, clamped: `U1.f`.
    pub diffuse: Format,
    /// The base of the highlight, and each square of it: `U1.f`.
    pub base: Format,
    /// What tables make of the base (with power by tables only): `U1.f`.
    pub shape: Format,
}

impl SlerpSpec {
    /// The power of the highlight.
    pub fn power_unit(&self) -> PowerUnit {
        PowerUnit { power: self.power, log2_factor: 0, base: self.formats.base, shape: self.formats.shape }
    }
}
