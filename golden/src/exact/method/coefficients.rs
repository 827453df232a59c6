//! Products of light and material colours, which are the same at every pixel of a span.
use glam::DVec3;
use specula_scene::{Colour, Frame, Span};
use specula_spec::FULL_SCALE;

/// Products of a material's and the lights' colours, in LSBs.
pub(super) struct Coefficients {
    ambient: [f64; 3],
    lights: Vec<Light>,
}

/// One light, multiplied by a material's reflectances.
pub(super) struct Light {
    /// The direction L of a light at infinity; 0 for a light at a place.
    pub direction: DVec3,
    diffuse: [f64; 3],
    specular: [f64; 3],
}

/// The shares of a light that diffuse and specular reflection send to the eye, each 0 to 1.
#[derive(Clone, Copy, Default)]
pub(super) struct Amounts {
    pub diffuse: f64,
    pub specular: f64,
}

impl Coefficients {
    pub fn new(frame: &Frame, span: &Span) -> Coefficients {
        let material = frame.material(span);
        let directions = frame
            .lights
            .iter()
            .map(|light| light.direction)
            .chain(frame.local_lights.iter().map(|_| DVec3::ZERO));
        let light = |(direction, colour)| Light {
            direction,
            diffuse: product(material.diffuse, colour),
            specular: product(material.specular, colour),
        };
        let lights = directions.zip(frame.light_colours()).map(light).collect();
        Coefficients { ambient: product(material.ambient, frame.ambient), lights }
    }

    /// Ambient + Σ over lights (diffuse + specular), at most 255 [methods A3].
    pub fn sum(&self, amounts: impl Fn(&Light) -> Amounts) -> [f64; 3] {
        self.sum_of(self.lights.iter().map(amounts))
    }

    /// The same sum as [`Coefficients::sum`], with the amounts of each light in order.
    pub fn sum_of(&self, amounts: impl Iterator<Item = Amounts>) -> [f64; 3] {
        let mut colour = self.ambient;
        for (light, amounts) in self.lights.iter().zip(amounts) {
            for (c, channel) in colour.iter_mut().enumerate() {
                *channel +=
                    light.diffuse[c] * amounts.diffuse + light.specular[c] * amounts.specular;
            }
        }
        colour.map(|channel| channel.min(FULL_SCALE))
    }
}

fn product(reflectance: Colour, light: Colour) -> [f64; 3] {
    std::array::from_fn(|c| FULL_SCALE * reflectance[c] * light[c])
}
