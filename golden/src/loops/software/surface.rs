//! Products of materials and lights.
use specula_scene::{Colour, Frame, Material};
use specula_spec::FULL_SCALE;

/// A material under a frame's lights.
pub(super) struct Surface {
    pub ambient: [f32; 3],
    pub shininess: u32,
    /// For each light, those at infinity first.
    pub lights: Vec<Reflected>,
}

/// The products by which a light's amounts are multiplied.
#[derive(Clone, Copy)]
pub(super) struct Reflected {
    diffuse: [f32; 3],
    specular: [f32; 3],
}

impl Surface {
    /// The surfaces of all of a frame's materials.
    pub fn all_of(frame: &Frame) -> Vec<Surface> {
        let reflected = |material: &Material, light: Colour| Reflected {
            diffuse: product(material.diffuse, light),
            specular: product(material.specular, light),
        };
        let surface = |material: &Material| Surface {
            ambient: product(material.ambient, frame.ambient),
            shininess: material.shininess,
            lights: frame.light_colours().map(|light| reflected(material, light)).collect(),
        };
        frame.materials.iter().map(surface).collect()
    }
}

impl Reflected {
    /// The products for a light of which these shares, 0 to 1, arrive as diffuse and as specular
    /// light.
    pub fn dimmed(&self, [diffuse, specular]: [f32; 2]) -> Reflected {
        Reflected {
            diffuse: self.diffuse.map(|c| c * diffuse),
            specular: self.specular.map(|c| c * specular),
        }
    }

    /// Adds a light's reflection to a pixel.
    #[inline(always)]
    pub fn add(&self, diffuse: f32, specular: f32, pixel: &mut [f32; 3]) {
        for (c, channel) in pixel.iter_mut().enumerate() {
            *channel += self.diffuse[c] * diffuse + self.specular[c] * specular;
        }
    }
}

fn product(reflectance: Colour, light: Colour) -> [f32; 3] {
    std::array::from_fn(|c| (FULL_SCALE * reflectance[c] * light[c]) as f32)
}

/// A pixel, clamped to full scale.
#[inline(always)]
pub(super) fn clamped(pixel: [f32; 3]) -> [f32; 3] {
    pixel.map(|channel| channel.min(FULL_SCALE as f32))
}
