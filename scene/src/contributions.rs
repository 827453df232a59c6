//! The kinds of light that a frame's surfaces reflect.
use serde::Serialize;

use crate::frame::{Colour, Frame};

/// The largest product of a used material's component and a light's, in each channel; 1.0 is full
/// scale. A 0 means that there is no such light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Contributions {
    /// Reflected ambient light.
    pub ambient: Colour,
    /// Diffuse reflection of any of the lights.
    pub diffuse: Colour,
    /// Highlights of any of the lights.
    pub specular: Colour,
    /// Whether every product is the same in all three channels.
    pub grey: bool,
}

impl Contributions {
    /// The contributions over all spans of a frame.
    pub fn of(frame: &Frame) -> Contributions {
        let mut largest = Contributions { grey: true, ..Contributions::default() };
        let mut used: Vec<usize> =
            frame.spans.iter().map(|span| frame.triangles[span.triangle].material).collect();
        used.sort_unstable();
        used.dedup();
        for material in used.into_iter().map(|index| &frame.materials[index]) {
            largest.add(|c| &mut c.ambient, material.ambient, frame.ambient);
            for light in frame.light_colours() {
                largest.add(|c| &mut c.diffuse, material.diffuse, light);
                largest.add(|c| &mut c.specular, material.specular, light);
            }
        }
        largest
    }

    fn add(
        &mut self,
        kind: impl Fn(&mut Contributions) -> &mut Colour,
        reflectance: Colour,
        light: Colour,
    ) {
        let product: Colour = std::array::from_fn(|c| reflectance[c] * light[c]);
        self.grey &= product.iter().all(|&x| x == product[0]);
        let largest = kind(self);
        *largest = std::array::from_fn(|c| largest[c].max(product[c]));
    }
}
