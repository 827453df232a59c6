//! Trees of nodes that move by key frames, as mesh files have them, and what is at them.
use glam::{DAffine3, DQuat, DVec3};

use crate::picture::camera::Camera;
use crate::picture::{LightSource, Scene};

/// Frames of a second.
pub const FRAMES_A_SECOND: f64 = 24.0;

/// The value of a property of a node over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track<T> {
    times: Vec<f64>,
    values: Vec<T>,
    between: Between,
}

/// What is between two values of a track.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// The earlier value is held.
    Held,
    /// The value goes from one to the other at constant speed.
    Linear,
}

/// A value that can go to another one.
pub trait Blend: Copy {
    /// The value at the share `u` of the way to `other`, 0 to 1.
    fn towards(self, other: Self, u: f64) -> Self;
}

impl Blend for DVec3 {
    fn towards(self, other: DVec3, u: f64) -> DVec3 {
        self + (other - self) * u
    }
}

/// Cosine of a half angle above which two rotations count as one direction: slerp is linear there to
/// within 1e-9.
const NEARLY_EQUAL: f64 = 1.0 - 1e-9;

impl Blend for DQuat {
    /// Slerp the shorter way: (sin((1 - u) φ) p + sin(u φ) q)/sin φ, with φ from p to q or -q.
    fn towards(self, other: DQuat, u: f64) -> DQuat {
        let cos = self.dot(other);
        let (other, cos) = if cos < 0.0 { (-other, -cos) } else { (other, cos) };
        if cos > NEARLY_EQUAL {
            return (self + (other - self) * u).normalize();
        }
        // Functions of the library are the same on every machine.
        let angle = libm::acos(cos);
        let (own, others) = (libm::sin((1.0 - u) * angle), libm::sin(u * angle));
        (self * own + other * others) * libm::sin(angle).recip()
    }
}

impl<T: Blend> Track<T> {
    /// Values at times in seconds, which ascend; `None` if they do not, or there are none, or not as
    /// many of both.
    pub fn new(times: Vec<f64>, values: Vec<T>, between: Between) -> Option<Track<T>> {
        let ascend = times.windows(2).all(|pair| pair[0] < pair[1]);
        let fit = times.len() == values.len() && !times.is_empty();
        (ascend && fit).then_some(Track { times, values, between })
    }

    /// The value at a time: before the first that one, after the last that one.
    pub fn at(&self, time: f64) -> T {
        let after = self.times.partition_point(|&key| key <= time);
        match (after.checked_sub(1), self.values.get(after)) {
            (Some(before), Some(&next)) if self.between == Between::Linear => {
                let [start, end] = [before, after].map(|k| self.times[k]);
                self.values[before].towards(next, (time - start) / (end - start))
            }
            (Some(before), _) => self.values[before],
            // There is a value, so the first one is after the time where none is before it.
            (None, _) => self.values[0],
        }
    }
}

/// A transformation by parts: scaled first, then turned, then shifted.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The shift.
    pub translation: DVec3,
    /// The turn.
    pub rotation: DQuat,
    /// Factors along its own axes.
    pub scale: DVec3,
}

/// The parts of a pose that move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tracks {
    /// The shift over time.
    pub translation: Option<Track<DVec3>>,
    /// The turn over time, by unit quaternions.
    pub rotation: Option<Track<DQuat>>,
    /// The factors over time.
    pub scale: Option<Track<DVec3>>,
}

/// The transformation from a node's coordinates to its parent's.
#[derive(Clone, Debug, PartialEq)]
pub enum Transform {
    /// It does not move.
    Fixed(DAffine3),
    /// It moves.
    Moving {
        /// The parts without a track.
        rest: Pose,
        /// The others.
        tracks: Tracks,
    },
}

impl Transform {
    fn at(&self, time: f64) -> DAffine3 {
        match self {
            Transform::Fixed(place) => *place,
            Transform::Moving { rest, tracks } => {
                let of = |track: &Option<Track<DVec3>>, rest| {
                    track.as_ref().map_or(rest, |track| track.at(time))
                };
                let rotation = tracks.rotation.as_ref().map(|track| track.at(time));
                DAffine3::from_scale_rotation_translation(
                    of(&tracks.scale, rest.scale),
                    rotation.unwrap_or(rest.rotation),
                    of(&tracks.translation, rest.translation),
                )
            }
        }
    }
}

/// A node of a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeNode {
    /// Its parent, which comes before it; `None` for a root.
    pub parent: Option<usize>,
    /// Its transformation.
    pub transform: Transform,
}

/// Nodes that move, and what of a scene is at them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodeMotions {
    /// All nodes, parents before their children.
    pub nodes: Vec<TreeNode>,
    /// For each object of the scene its node; `None` for one that stands still.
    pub objects: Vec<Option<usize>>,
    /// For each light its node.
    pub lights: Vec<usize>,
    /// The node of the camera, if that is at one.
    pub camera: Option<usize>,
}

impl NodeMotions {
    /// Moves all that is at nodes to where it is at a frame. What the scene does not have stays
    /// away.
    pub fn apply(&self, frame: f64, scene: &mut Scene) {
        let places = self.places(frame / FRAMES_A_SECOND);
        for (object, node) in scene.objects.iter_mut().zip(&self.objects) {
            if let Some(node) = node {
                object.place = places[*node];
            }
        }
        for (light, &node) in scene.lights.iter_mut().zip(&self.lights) {
            move_light(&mut light.source, places[node]);
        }
        if let Some(node) = self.camera {
            let camera = &mut scene.camera;
            *camera = Camera {
                direction: places[node].matrix3.z_axis,
                up: places[node].matrix3.y_axis,
                target: Some(places[node].translation),
                ..camera.clone()
            };
        }
    }

    /// The transformation from each node's coordinates to the world's.
    fn places(&self, time: f64) -> Vec<DAffine3> {
        let mut places: Vec<DAffine3> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let own = node.transform.at(time);
            places.push(node.parent.map_or(own, |parent| places[parent] * own));
        }
        places
    }
}

/// A light shines along the -z axis of its node.
fn move_light(source: &mut LightSource, place: DAffine3) {
    let backwards = place.matrix3.z_axis;
    match source {
        LightSource::Directional { direction } => *direction = backwards,
        LightSource::Point { position, .. } => *position = place.translation,
        LightSource::Spot { position, axis, .. } => {
            *position = place.translation;
            *axis = -backwards;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_held_or_go_from_one_to_the_other() {
        let track = |between| {
            Track::new(vec![1.0, 2.0], vec![DVec3::ZERO, DVec3::X], between).expect("they ascend")
        };
        let at = |between, time| track(between).at(time).x;
        assert_eq!([0.0, 1.5, 9.0].map(|time| at(Between::Linear, time)), [0.0, 0.5, 1.0]);
        assert_eq!([0.0, 1.5, 9.0].map(|time| at(Between::Held, time)), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn tracks_ascend_and_have_as_many_times_as_values() {
        for (times, values) in
            [(vec![], vec![]), (vec![1.0, 1.0], vec![DVec3::X; 2]), (vec![1.0], vec![DVec3::X; 2])]
        {
            assert_eq!(Track::new(times, values, Between::Linear), None);
        }
        assert_eq!(Track::new(vec![f64::NAN; 2], vec![DVec3::X; 2], Between::Held), None);
    }

    #[test]
    fn turns_go_the_shorter_way_at_constant_speed() {
        let about_z = |degrees: f64| DQuat::from_rotation_z(degrees.to_radians());
        for (from, to) in [(about_z(0.0), about_z(90.0)), (about_z(0.0), -about_z(90.0))] {
            for u in [0.0, 0.25, 0.5, 1.0] {
                let turned = from.towards(to, u) * DVec3::X;
                assert!(turned.distance(about_z(90.0 * u) * DVec3::X) < 1e-12, "{u}");
            }
        }
        let near = about_z(10.0).towards(about_z(10.001), 0.5) * DVec3::X;
        assert!(near.distance(about_z(10.0005) * DVec3::X) < 1e-12);
    }
}
