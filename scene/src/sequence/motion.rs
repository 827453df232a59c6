//! Motions of a camera, an object or a light over frames.
use glam::DVec3;

use super::keys::Keys;
use super::movement::Movement;
use crate::picture::camera::{Camera, Lens};
use crate::picture::{Light, LightSource, Object, Scene};

/// A motion of one thing over frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// What moves.
    pub subject: Subject,
    /// How it moves.
    pub change: Change,
}

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The camera.
    Camera,
    /// An object, counted from 0.
    Object(usize),
    /// A light, counted from 0, in the coordinates of its own space.
    Light(usize),
}

/// How something moves.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// It turns where it is: an object about its own origin, a camera about its eye, or about its
    /// target where its eye is at infinity, a light by its direction alone.
    Turn {
        /// Degrees.
        degrees: Keys<f64>,
        /// Unit vector along the axis.
        axis: DVec3,
    },
    /// It goes around a centre, and turns as it goes.
    Orbit {
        /// Degrees.
        degrees: Keys<f64>,
        /// Unit vector along the axis.
        axis: DVec3,
        /// A point on the axis; `None` for the camera's target, or else the origin.
        centre: Option<DVec3>,
    },
    /// It is shifted.
    Translate {
        /// World units.
        way: Keys<DVec3>,
    },
}

impl Motion {
    /// Moves the scene's subject to where it is at a frame, from where it is now. A subject that the
    /// scene does not have stays away.
    pub fn apply(&self, frame: f64, scene: &mut Scene) {
        match self.subject {
            Subject::Camera => {
                let camera = &mut scene.camera;
                *camera = moved_camera(camera, self.change.at(frame, pivot_of_camera(camera)));
            }
            Subject::Object(index) => {
                if let Some(object) = scene.objects.get_mut(index) {
                    let own = object.place.translation;
                    move_object(object, self.change.at(frame, Pivot { own, orbit: DVec3::ZERO }));
                }
            }
            Subject::Light(index) => {
                if let Some(light) = scene.lights.get_mut(index) {
                    let own = place_of(light);
                    move_light(light, self.change.at(frame, Pivot { own, orbit: DVec3::ZERO }));
                }
            }
        }
    }
}

/// Where the axes of a thing's motions are.
struct Pivot {
    /// Its own place.
    own: DVec3,
    /// The middle of its orbits where none is given.
    orbit: DVec3,
}

impl Change {
    fn at(&self, frame: f64, pivot: Pivot) -> Movement {
        match self {
            Change::Turn { degrees, axis } => {
                Movement::rotation(degrees.at(frame), *axis, pivot.own)
            }
            Change::Orbit { degrees, axis, centre } => {
                Movement::rotation(degrees.at(frame), *axis, centre.unwrap_or(pivot.orbit))
            }
            Change::Translate { way } => Movement::shift(way.at(frame)),
        }
    }
}

fn pivot_of_camera(camera: &Camera) -> Pivot {
    let target = camera.target.unwrap_or(DVec3::ZERO);
    let eye = camera.lens.and_then(|lens| lens.eye).or(camera.eye);
    Pivot { own: eye.unwrap_or(target), orbit: target }
}

fn moved_camera(camera: &Camera, by: Movement) -> Camera {
    Camera {
        direction: by.of_direction(camera.direction),
        up: by.of_direction(camera.up),
        target: camera.target.map(|target| by.of_point(target)),
        eye: camera.eye.map(|eye| by.of_point(eye)),
        lens: camera.lens.map(|lens| Lens { eye: lens.eye.map(|eye| by.of_point(eye)), ..lens }),
        ..camera.clone()
    }
}

fn move_object(object: &mut Object, by: Movement) {
    object.place = by.of_place(object.place);
}

/// The place of a light; the origin for one at infinity, which has none.
fn place_of(light: &Light) -> DVec3 {
    match light.source {
        LightSource::Directional { .. } => DVec3::ZERO,
        LightSource::Point { position, .. } | LightSource::Spot { position, .. } => position,
    }
}

fn move_light(light: &mut Light, by: Movement) {
    match &mut light.source {
        LightSource::Directional { direction } => *direction = by.of_direction(*direction),
        LightSource::Point { position, .. } => *position = by.of_point(*position),
        LightSource::Spot { position, axis, .. } => {
            *position = by.of_point(*position);
            *axis = by.of_direction(*axis);
        }
    }
}
