//! What light and material have to do with each other, the same at every pixel of a span.
use glam::DVec3;
use specula_scene::spec::FULL_SCALE;
use specula_scene::{Colour, Frame, Span};

/// Products of a material's and the lights' colours, in LSBs.
pub(super) struct Coefficients {
    ambient: [f64; 3],
    lights: Vec<Light>,
}

/// One light as a material answers it.
pub(super) struct Light {
    /// L.
    pub direction: DVec3,
    diffuse: [f64; 3],
    specular: [f64; 3],
}

/// How much of a light reaches the eye, each 0 to 1.
#[derive(Default)]
pub(super) struct Amounts {
    pub diffuse: f64,
    pub specular: f64,
}

impl Coefficients {
    pub fn new(frame: &Frame, span: &Span) -> Coefficients {
        let material = frame.material(span);
        let light = |light: &specula_scene::DirectionalLight| Light {
            direction: light.direction,
            diffuse: product(material.diffuse, light.colour),
            specular: product(material.specular, light.colour),
        };
        Coefficients { ambient: product(material.ambient, frame.ambient), lights: frame.lights.iter().map(light).collect() }
    }

    /// Ambient + Σ over lights (diffuse + specular), at most 255 [METHODS.md A3].
    pub fn sum(&self, amounts: impl Fn(&Light) -> Amounts) -> [f64; 3] {
        let mut colour = self.ambient;
        for light in &self.lights {
            let amounts = amounts(light);
            for (c, channel) in colour.iter_mut().enumerate() {
                *channel += light.diffuse[c] * amounts.diffuse + light.specular[c] * amounts.specular;
            }
        }
        colour.map(|channel| channel.min(FULL_SCALE))
    }
}

fn product(reflectance: Colour, light: Colour) -> [f64; 3] {
    std::array::from_fn(|c| FULL_SCALE * reflectance[c] * light[c])
}
