//! Scenes of spans, written as scene files.
use std::fmt::Write;

use glam::DVec3;
use specula_scene::{Colour, Material};

/// White, at full scale.
const WHITE: Colour = [1.0; 3];

/// A light of such a scene.
#[derive(Clone, Copy, Debug)]
pub enum Light {
    /// A light at infinity in this direction.
    Towards(DVec3),
    /// A light at a place.
    At(DVec3),
    /// A light at a place of which the square of distance leaves min(1, 1/(q d²)).
    Weaker {
        /// The place of the light.
        position: DVec3,
        /// q, above 0.
        quadratic: f64,
    },
    /// A light at a place, aimed at another, with Warn's exponent.
    Spot {
        /// The place of the light.
        position: DVec3,
        /// The place at which it is aimed.
        target: DVec3,
        /// Warn's exponent, 1 to 8191.
        exponent: u32,
    },
}

/// A span, with the keys that `docs/scene-format.md` describes.
#[derive(Clone, Debug, PartialEq)]
pub struct RawSpan {
    /// Length in pixels.
    pub length: u32,
    /// Normals of the triangle's vertices: unit vectors, or 0.
    pub normals: [DVec3; 3],
    /// Unit normal of the polygon, or 0, if it is not the mean direction of the vertex normals.
    pub face: Option<DVec3>,
    /// Its vertices.
    pub positions: [DVec3; 3],
    /// Smallest cosines between vertex normals and faces around them.
    pub cone_cosines: [f64; 3],
    /// Weights at the first pixel.
    pub start: [f64; 3],
    /// Weights at the last pixel.
    pub end: [f64; 3],
    /// Its material.
    pub material: Material,
}

impl RawSpan {
    /// A span between two normals.
    pub fn between([first, last]: [DVec3; 2], length: u32, material: Material) -> RawSpan {
        RawSpan {
            length,
            normals: [first, last, first],
            face: None,
            positions: [DVec3::ZERO; 3],
            cone_cosines: [1.0; 3],
            start: [1.0, 0.0, 0.0],
            end: [0.0, 1.0, 0.0],
            material,
        }
    }
}

/// Grey reflectances.
pub fn material(ambient: f64, diffuse: f64, specular: f64, shininess: u32) -> Material {
    Material { ambient: [ambient; 3], diffuse: [diffuse; 3], specular: [specular; 3], shininess }
}

/// A material with nothing but a highlight, at full scale.
pub fn mirror(shininess: u32) -> Material {
    material(0.0, 0.0, 1.0, shininess)
}

/// A material with nothing but Lambert's reflectance, at full scale.
pub fn matt() -> Material {
    material(0.0, 1.0, 0.0, 1)
}

/// A material with some of every reflectance, which stays below full scale under one light.
pub fn lit(shininess: u32) -> Material {
    material(0.1, 0.4, 0.45, shininess)
}

/// Spans under common lights.
#[derive(Clone, Debug)]
pub struct SpanScene {
    /// Colour of the ambient light, 0 to 1.
    pub ambient: Colour,
    /// The lights: one to four.
    pub lights: Vec<Light>,
    /// Colours of the lights, 0 to 1, in their order; those beyond are white.
    pub colours: Vec<Colour>,
    /// The place of the eye that sees highlights, if it is not at infinity.
    pub eye: Option<DVec3>,
    /// The spans, one in each row of the picture.
    pub spans: Vec<RawSpan>,
}

impl Default for SpanScene {
    /// A scene without spans and lights in white ambient light.
    fn default() -> SpanScene {
        SpanScene {
            ambient: WHITE,
            lights: Vec::new(),
            colours: Vec::new(),
            eye: None,
            spans: Vec::new(),
        }
    }
}

impl SpanScene {
    /// Spans under white lights at infinity, with white ambient light.
    pub fn new(lights: &[DVec3], spans: Vec<RawSpan>) -> SpanScene {
        let lights = lights.iter().map(|&light| Light::Towards(light)).collect();
        SpanScene { lights, spans, ..SpanScene::default() }
    }

    /// The scene with only one of its spans.
    pub fn only(&self, span: usize) -> SpanScene {
        SpanScene { spans: self.spans.get(span).cloned().into_iter().collect(), ..self.clone() }
    }

    /// The scene file, which ends with the tables `core`. Numbers are written so that they are read
    /// exactly.
    pub fn text(&self, core: &str) -> String {
        let mut text = format!("ambient = {:?}\n", self.ambient);
        // Writing to a String cannot fail.
        if let Some(eye) = self.eye {
            // The target is neither at the eye nor above or below it.
            let target = eye - DVec3::new(1.0, 0.0, 1.0);
            let _ = writeln!(
                text,
                "\n[camera]\nviewer = \"local\"\neye = {}\ntarget = {}",
                vector(eye),
                vector(target)
            );
        }
        let colours = self.colours.iter().chain(std::iter::repeat(&WHITE));
        for (light, colour) in self.lights.iter().zip(colours) {
            let _ = writeln!(text, "{}colour = {colour:?}", light.text());
        }
        self.spans.iter().for_each(|span| text.push_str(&span.text()));
        format!("{text}\n{core}")
    }
}

impl Light {
    fn text(&self) -> String {
        match *self {
            Light::Towards(direction) => {
                format!("\n[[light]]\ndirection = {}\n", vector(direction))
            }
            Light::At(position) => {
                format!("\n[[light]]\nkind = \"point\"\nposition = {}\n", vector(position))
            }
            Light::Weaker { position, quadratic } => format!(
                "{}attenuation = {{ quadratic = {quadratic:?} }}\n",
                Light::At(position).text()
            ),
            Light::Spot { position, target, exponent } => format!(
                "\n[[light]]\nkind = \"spot\"\nposition = {}\ntarget = {}\nexponent = {exponent}\n",
                vector(position),
                vector(target)
            ),
        }
    }
}

impl RawSpan {
    fn text(&self) -> String {
        let three = |vectors: [DVec3; 3]| vectors.map(vector).join(", ");
        let mut text =
            format!("\n[[span]]\nlength = {}\nnormals = [{}]\n", self.length, three(self.normals));
        // Writing to a String cannot fail.
        if let Some(face) = self.face {
            let _ = writeln!(text, "face = {}", vector(face));
        }
        if self.positions != [DVec3::ZERO; 3] {
            let _ = writeln!(text, "positions = [{}]", three(self.positions));
        }
        let _ = writeln!(
            text,
            "cone_cosines = {:?}\nstart = {:?}\nend = {:?}",
            self.cone_cosines, self.start, self.end
        );
        let m = &self.material;
        let _ = writeln!(
            text,
            "[span.material]\nambient = {:?}\ndiffuse = {:?}\nspecular = {:?}\nshininess = {}",
            m.ambient, m.diffuse, m.specular, m.shininess
        );
        text
    }
}

fn vector(v: DVec3) -> String {
    format!("{:?}", v.to_array())
}
