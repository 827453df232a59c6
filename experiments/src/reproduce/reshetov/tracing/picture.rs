//! Pictures of mirrors.
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use specula_scene::mesh::Mesh;
use specula_scene::picture::camera::{Camera, Window};
use specula_testbench::Image;

use super::super::inward::enters;
use super::environment;
use super::hierarchy::corners;
use super::mirror::Normals;
use super::ray::Ray;
use super::traced_mesh::TracedMesh;

/// What a mirror shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surroundings {
    /// The environment alone, at infinity: a look-up of the reflected direction.
    Environment,
    /// The mesh itself too, by tracing the reflected ray.
    Itself,
}

impl Surroundings {
    /// Reflections that are followed at most.
    const fn reflections(self) -> usize {
        match self {
            Surroundings::Environment => 1,
            Surroundings::Itself => 4,
        }
    }

    /// The colour of pixels where a ray is reflected into the surface: green and black, as in
    /// figure 1.
    const fn mark(self) -> [u8; 3] {
        match self {
            Surroundings::Environment => [0, 255, 0],
            Surroundings::Itself => [0, 0, 0],
        }
    }
}

/// The share of light that a mirror gives back.
const REFLECTANCE: f64 = 0.9;
/// The colour where no mirror is.
const BACKGROUND: [u8; 3] = [235, 235, 240];

/// A picture of a mirror, with what became of its rays.
#[derive(Clone, Debug, PartialEq)]
pub struct Mirrored {
    /// The picture.
    pub image: Image,
    /// What became of the rays.
    pub rays: Rays,
}

/// Numbers of rays; of each kind the first reflections, and those after them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rays {
    /// Rays reflected.
    pub reflected: [u64; 2],
    /// Those reflected into the face.
    pub inward: [u64; 2],
    /// The largest n·I of those of the first, n the face's normal; 0 without any.
    pub steepest: f64,
}

/// A pixel of the picture.
struct Pixel {
    colour: [u8; 3],
    rays: Rays,
}

/// A mesh as a mirror, filling a picture of `size` pixels, seen by the default camera; `None` for a
/// mesh without extent.
pub fn mirrored(
    mesh: &Mesh,
    size: (u32, u32),
    normals: Normals,
    surroundings: Surroundings,
) -> Option<Mirrored> {
    let traced = TracedMesh::new(mesh);
    let camera = Camera::default();
    let rotation = camera.rotation()?;
    let window = Window::new(&camera, rotation, seen_bounds(mesh, rotation), size)?;
    let mirror = Mirror { mesh: &traced, normals, surroundings };
    let eye = Eye { rotation, window, size, far: 2.0 * farthest(mesh) };
    let of_row = |y: u32| (0..size.0).map(|x| mirror.pixel(eye.ray(x, y))).collect::<Vec<Pixel>>();
    let pixels: Vec<Pixel> = (0..size.1).into_par_iter().flat_map(of_row).collect();
    let rays = pixels.iter().fold(Rays::default(), |sum, pixel| sum.with(&pixel.rays));
    let colours = pixels.iter().map(|pixel| pixel.colour).collect();
    Some(Mirrored { image: Image { width: size.0, height: size.1, pixels: colours }, rays })
}

/// The smallest and largest coordinates that the camera sees.
fn seen_bounds(mesh: &Mesh, rotation: DMat3) -> [DVec3; 2] {
    corners(mesh.positions.iter().map(|&place| rotation * place))
}

fn farthest(mesh: &Mesh) -> f64 {
    mesh.positions.iter().map(|place| place.length()).fold(0.0, f64::max)
}

/// The eye at infinity, whose rays are parallel.
struct Eye {
    rotation: DMat3,
    window: Window,
    size: (u32, u32),
    /// A distance beyond every point of the mesh.
    far: f64,
}

impl Eye {
    /// The ray through the centre of a pixel.
    fn ray(&self, x: u32, y: u32) -> Ray {
        let from_middle =
            |pixel: u32, pixels: u32| f64::from(pixel) + 0.5 - f64::from(pixels) / 2.0;
        let right = from_middle(x, self.size.0) * self.window.pixel;
        let up = -from_middle(y, self.size.1) * self.window.pixel;
        let centre = self.window.centre;
        let to_world = self.rotation.transpose();
        Ray {
            origin: to_world * DVec3::new(centre.x + right, centre.y + up, self.far),
            direction: to_world * DVec3::NEG_Z,
        }
    }
}

/// A mirror and what it shows.
struct Mirror<'a> {
    mesh: &'a TracedMesh,
    normals: Normals,
    surroundings: Surroundings,
}

impl Mirror<'_> {
    fn pixel(&self, mut ray: Ray) -> Pixel {
        let (mut rays, mut strength) = (Rays::default(), 1.0);
        for number in 0..self.surroundings.reflections() {
            let Some(hit) = self.mesh.hit(ray) else { break };
            let incoming = -ray.direction;
            let face = hit.face.facing(incoming);
            let reflected = self.normals.reflect(&face, hit.weights, incoming);
            let enters = enters(reflected, face.outward);
            rays.add(number, enters, face.outward.dot(incoming));
            if enters {
                return Pixel { colour: self.surroundings.mark(), rays };
            }
            strength *= REFLECTANCE;
            ray = Ray { origin: hit.place, direction: reflected };
        }
        let colour = if rays.reflected[0] == 0 {
            BACKGROUND
        } else {
            let colour = strength * environment::colour(ray.direction);
            (255.0 * colour).to_array().map(|channel| channel.round() as u8)
        };
        Pixel { colour, rays }
    }
}

impl Rays {
    /// Counts a reflection, the `number`th of its pixel.
    fn add(&mut self, number: usize, enters: bool, steepness: f64) {
        let kind = number.min(1);
        self.reflected[kind] += 1;
        self.inward[kind] += u64::from(enters);
        if enters && number == 0 {
            self.steepest = self.steepest.max(steepness);
        }
    }

    fn with(self, other: &Rays) -> Rays {
        let sum = |a: [u64; 2], b: [u64; 2]| [a[0] + b[0], a[1] + b[1]];
        Rays {
            reflected: sum(self.reflected, other.reflected),
            inward: sum(self.inward, other.inward),
            steepest: self.steepest.max(other.steepest),
        }
    }

    /// The share of the first reflections, or of those after them, that enter the face; 0 if there
    /// are none.
    pub fn share(&self, kind: usize) -> f64 {
        self.inward[kind] as f64 / self.reflected[kind].max(1) as f64
    }
}
