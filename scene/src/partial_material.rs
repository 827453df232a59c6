//! Materials of which some keys are given and others left open.
use crate::{Colour, Material, defaults};

/// The keys of a [`Material`] that someone gives: a scene file, or a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartialMaterial {
    /// Reflectance of ambient light; left open, it is as `diffuse`.
    pub ambient: Option<Colour>,
    /// Lambert's reflectance.
    pub diffuse: Option<Colour>,
    /// Reflectance of the highlight.
    pub specular: Option<Colour>,
    /// Phong's exponent n, 1 to 8191.
    pub shininess: Option<u32>,
}

impl PartialMaterial {
    /// Its own keys, and those of `other` where it leaves them open.
    pub fn or(&self, other: &PartialMaterial) -> PartialMaterial {
        PartialMaterial {
            ambient: self.ambient.or(other.ambient),
            diffuse: self.diffuse.or(other.diffuse),
            specular: self.specular.or(other.specular),
            shininess: self.shininess.or(other.shininess),
        }
    }

    /// The material, with the defaults of a scene for what is left open.
    pub fn complete(&self) -> Material {
        let default = defaults::material();
        let diffuse = self.diffuse.unwrap_or(default.diffuse);
        Material {
            // A surface reflects ambient light as it does a lamp's, unless someone says otherwise.
            ambient: self.ambient.unwrap_or(diffuse),
            diffuse,
            specular: self.specular.unwrap_or(default.specular),
            shininess: self.shininess.unwrap_or(default.shininess),
        }
    }
}

impl From<Material> for PartialMaterial {
    fn from(material: Material) -> PartialMaterial {
        let Material { ambient, diffuse, specular, shininess } = material;
        PartialMaterial {
            ambient: Some(ambient),
            diffuse: Some(diffuse),
            specular: Some(specular),
            shininess: Some(shininess),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nobody_gives_is_the_default() {
        assert_eq!(PartialMaterial::default().complete(), defaults::material());
    }

    #[test]
    fn each_key_is_the_first_one_that_is_given() {
        let file = PartialMaterial {
            diffuse: Some([0.1, 0.2, 0.3]),
            shininess: Some(7),
            ..PartialMaterial::default()
        };
        let scene = PartialMaterial { shininess: Some(9), ..PartialMaterial::default() };
        let both = scene.or(&file).complete();
        assert_eq!((both.diffuse, both.shininess), ([0.1, 0.2, 0.3], 9));
        assert_eq!((both.ambient, both.specular), (both.diffuse, defaults::material().specular));
    }
}
