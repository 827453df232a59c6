//! The loop around any scheme.
use specula_scene::{Frame, Span};

use super::along_span::AlongSpan;
use super::set_up::SetUp;
use super::surface::{Surface, clamped};
use super::{Mesh, Software};

/// A frame whose spans are shaded one light after another.
pub struct Loop<'a, U: SetUp<'a>> {
    frame: &'a Frame,
    set_up: U,
    surfaces: Vec<Surface>,
    /// The material of each span that has been set up.
    materials: Vec<usize>,
    /// Each light along the first span, along the second, and so on.
    lights: Vec<U::Light>,
}

impl<'a, U: SetUp<'a>> Loop<'a, U> {
    /// Computes what belongs to the frame.
    pub fn new(mesh: &'a Mesh<'a>) -> Self {
        Loop {
            frame: mesh.frame,
            set_up: U::new(mesh),
            surfaces: Surface::all_of(mesh.frame),
            materials: Vec::new(),
            lights: Vec::new(),
        }
    }
}

impl<'a, U: SetUp<'a>> Software for Loop<'a, U> {
    fn set_up(&mut self, spans: &[Span]) {
        self.materials.clear();
        self.lights.clear();
        for span in spans {
            self.materials.push(self.frame.triangles[span.triangle].material);
            self.set_up.span(span, &mut self.lights);
        }
    }

    fn shade(&mut self, number: usize, out: &mut [[f32; 3]]) {
        let surface = &self.surfaces[self.materials[number]];
        out.fill(surface.ambient);
        let of_span = self.lights.len() / self.materials.len();
        let lights = &self.lights[number * of_span..][..of_span];
        for (reflected, light) in surface.lights.iter().zip(lights) {
            light.add(surface.shininess, reflected, out);
        }
        for pixel in out {
            *pixel = clamped(*pixel);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::loops::software::set_up::Vertices;

    #[test]
    fn a_block_takes_over_the_memory_of_the_one_before() {
        let frame = specula_scene::load("teapot", Some((80, 60))).unwrap().frame;
        let mesh = Mesh::of(&frame);
        let mut software = Loop::<Vertices>::new(&mesh);
        let memory = |software: &Loop<Vertices>| {
            let (lights, materials) = (&software.lights, &software.materials);
            (lights.as_ptr(), lights.capacity(), materials.as_ptr(), materials.capacity())
        };
        software.set_up(&frame.spans[..256]);
        let first = memory(&software);
        for block in frame.spans.chunks(256) {
            software.set_up(block);
            assert_eq!(memory(&software), first);
        }
    }
}
