//! Materials [glTF 2.0, 3.9]: base colour, metalness and roughness, as Phong's model has them.
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::json::{Document, Number};
use super::part::Part;
use crate::limits::LARGEST_SHININESS;
use crate::mesh::warning::Notices;
use crate::{Colour, PartialMaterial};

/// The reflectance of a dielectric seen straight on [glTF 2.0, B.2].
const DIELECTRIC: f64 = 0.04;

/// A material as the file states it.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
struct Stated {
    pbr_metallic_roughness: Option<MetallicRoughness>,
    normal_texture: Option<IgnoredAny>,
    occlusion_texture: Option<IgnoredAny>,
    emissive_texture: Option<IgnoredAny>,
    emissive_factor: Option<[Number; 3]>,
    alpha_mode: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
struct MetallicRoughness {
    base_color_factor: Option<[Number; 4]>,
    metallic_factor: Option<Number>,
    roughness_factor: Option<Number>,
    base_color_texture: Option<IgnoredAny>,
    metallic_roughness_texture: Option<IgnoredAny>,
}

/// The materials of a document.
pub struct Materials {
    stated: Vec<Part>,
    /// For each number the material, if it has been looked up.
    known: Vec<Option<PartialMaterial>>,
}

impl Materials {
    /// The materials of a document, none of which has been looked up yet.
    pub fn new(document: &Document, notices: &mut Notices) -> Materials {
        let stated: Vec<Part> =
            document.materials.read().map(Option::unwrap_or_default).unwrap_or_else(|wrong| {
                notices.add("materials", None, || format!("its materials are left out: {wrong}"));
                Vec::new()
            });
        let known = stated.iter().map(|_| None).collect();
        Materials { stated, known }
    }

    /// Looks a material up by its number, and adds notes about what of it is not shown.
    pub fn look_up(&mut self, number: usize, notices: &mut Notices) {
        match self.known.get_mut(number) {
            None => notices.add("no such material", None, || {
                format!(
                    "material {number} is named, but there are only {}; the default is taken",
                    self.stated.len()
                )
            }),
            Some(Some(_)) => {}
            Some(known) => {
                let material = self.stated[number].read::<Stated>().unwrap_or_else(|wrong| {
                    notices.add("material", None, || {
                        format!("material {number} is left out, and the default taken: {wrong}")
                    });
                    None
                });
                *known =
                    Some(material.map(|stated| stated.shown(number, notices)).unwrap_or_default());
            }
        }
    }

    /// The number by which faces refer to a material in [`Materials::all`].
    pub fn index(&self, number: Option<usize>) -> u32 {
        // JSON has at most some million objects.
        number.filter(|&number| number < self.known.len()).map_or(0, |number| number as u32 + 1)
    }

    /// All materials, an open one for faces without any before them.
    pub fn all(self) -> Vec<PartialMaterial> {
        let known = self.known.into_iter().map(Option::unwrap_or_default);
        std::iter::once(PartialMaterial::default()).chain(known).collect()
    }
}

impl Stated {
    fn shown(&self, number: usize, notices: &mut Notices) -> PartialMaterial {
        self.note(notices);
        let none = MetallicRoughness::default();
        let surface = self.pbr_metallic_roughness.as_ref().unwrap_or(&none);
        let mut within = |name: &str, Number(x): Number| {
            let shown = x.clamp(0.0, 1.0);
            if shown != x {
                notices.add("range", None, || {
                    format!("`{name}` of material {number} is {x:?}; it is 0 to 1, and taken as {shown:?}")
                });
            }
            shown
        };
        let [red, green, blue, _] = surface.base_color_factor.unwrap_or([Number(1.0); 4]);
        let base = [red, green, blue].map(|x| within("baseColorFactor", x));
        let factor = within("metallicFactor", surface.metallic_factor.unwrap_or(Number(1.0)));
        // Where a texture states the metalness, most of what is seen is as a rule no metal.
        let is_stated = surface.metallic_roughness_texture.is_none();
        let metallic = if is_stated { factor } else { 0.0 };
        let roughness = within("roughnessFactor", surface.roughness_factor.unwrap_or(Number(1.0)));
        of_phong(base, metallic, roughness)
    }

    /// Adds notes about what is not shown.
    fn note(&self, notices: &mut Notices) {
        let surface = self.pbr_metallic_roughness.as_ref();
        let textures = [
            surface.and_then(|surface| surface.base_color_texture),
            surface.and_then(|surface| surface.metallic_roughness_texture),
            self.normal_texture,
            self.occlusion_texture,
            self.emissive_texture,
        ];
        if textures.iter().any(Option::is_some) {
            notices.add("textures", None, || {
                "textures are left out; surfaces have the factors of their materials".into()
            });
        }
        if self.emissive_factor.is_some_and(|colour| colour != [Number(0.0); 3]) {
            notices.add("emissive", None, || {
                "a material shines by itself; it is shown without that".into()
            });
        }
        if self.alpha_mode.as_deref() == Some("BLEND") {
            notices.add("transparent", None, || {
                "a material is transparent; it is shown as opaque".into()
            });
        }
    }
}

/// The material of Phong's model for a surface of glTF's, both numbers and the colour 0 to 1.
///
/// glTF has a diffuse and a mirrored part [glTF 2.0, B.2], with the base colour c and the metalness m:
///
/// - c_diff = (1 - m) c is Lambert's reflectance.
/// - f0 = .04 (1 - m) + m c is what is mirrored straight on.
/// - c is what is reflected of light from everywhere: what a metal does not scatter it mirrors.
///
/// **The exponent.** α = roughness² is the width of the distribution D of facets, of which Blinn's
/// power with the exponent 2/α² - 2 is the nearest [Walter et al., after eq. 30; Blinn]. The angle
/// from R to L is twice that from N to H, and so Phong's exponent is a quarter of Blinn's:
///
/// n = (2/α² - 2)/4 = (1/α² - 1)/2, rounded, 1 to 8191.
///
/// **The strength.** In the middle of a highlight that is seen straight on, N = H = L = V:
///
/// - D = 1/(π α²), and f = D f0/4 = f0/(4 π α²) [glTF 2.0, B.3].
/// - White light under which a white surface has the brightness 1 has the strength π, since that
///   surface reflects 1/π of it.
/// - So the highlight has the brightness k_s = π f = f0/(4 α²).
///
/// A surface as smooth as that has highlights brighter than the picture can show; they are 1 there,
/// in the same hue.
fn of_phong(base: Colour, metallic: f64, roughness: f64) -> PartialMaterial {
    let largest = f64::from(LARGEST_SHININESS);
    let smoothest = (2.0 * largest + 1.0).recip();
    let alpha_squared = (roughness * roughness * roughness * roughness).max(smoothest);
    let exponent = (alpha_squared.recip() - 1.0) / 2.0;
    let mirrored = base.map(|c| DIELECTRIC * (1.0 - metallic) + metallic * c);
    let highlight = mirrored.map(|f0| f0 / (4.0 * alpha_squared));
    let brightest = highlight.iter().fold(1.0, |brightest: f64, &x| brightest.max(x));
    PartialMaterial {
        ambient: Some(base),
        diffuse: Some(base.map(|c| (1.0 - metallic) * c)),
        specular: Some(highlight.map(|x| x / brightest)),
        // It is within the range of u32.
        shininess: Some((exponent + 0.5).floor().clamp(1.0, largest) as u32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(base: Colour, metallic: f64, roughness: f64) -> crate::Material {
        of_phong(base, metallic, roughness).complete()
    }

    #[test]
    fn a_plastic_scatters_its_colour_and_mirrors_white() {
        let plastic = made([0.8, 0.2, 0.1], 0.0, 0.5);
        assert_eq!((plastic.diffuse, plastic.ambient), ([0.8, 0.2, 0.1], [0.8, 0.2, 0.1]));
        // α² = 1/16: f0/(4 α²) = .04 · 4 and (16 - 1)/2 = 7.5.
        assert!(plastic.specular.iter().all(|x| (x - 0.16).abs() < 1e-15));
        assert_eq!(plastic.shininess, 8);
    }

    #[test]
    fn a_metal_mirrors_its_colour_alone() {
        let metal = made([1.0, 0.5, 0.25], 1.0, 0.2);
        assert_eq!((metal.diffuse, metal.specular), ([0.0; 3], [1.0, 0.5, 0.25]));
        assert_eq!((metal.ambient, metal.shininess), ([1.0, 0.5, 0.25], 312));
    }

    #[test]
    fn exponents_end_where_the_hardware_does() {
        assert_eq!(made([1.0; 3], 0.0, 0.0).shininess, LARGEST_SHININESS);
        assert_eq!(made([1.0; 3], 0.0, 1.0).shininess, 1);
        assert_eq!(made([0.0; 3], 1.0, 0.0).specular, [0.0; 3]);
    }
}
