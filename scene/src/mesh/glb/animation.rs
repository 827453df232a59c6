//! Animations of nodes [glTF 2.0, 3.11].
use glam::DVec3;
use serde::Deserialize;

use super::accessors::{Component, Elements};
use super::json::{Document, Whole};
use super::nodes::rotation;
use super::part::{Part, Reference};
use super::primitives::Accessors;
use crate::mesh::warning::{Notices, quoted};
use crate::sequence::{Between, FRAMES_A_SECOND, MOST_FRAMES, Track, Tracks};

/// Largest number of key frames of all channels together: without a limit, many channels could name
/// the same ones.
const MAX_KEYS: usize = 10_000_000;

/// By how much of a frame an animation may be longer than its frames: times are single precision.
const ROUNDING: f64 = 1e-3;

/// An animation as the file states it.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Stated {
    channels: Vec<Channel>,
    samplers: Vec<Sampler>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Channel {
    sampler: Reference,
    target: Target,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Target {
    node: Reference,
    path: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Sampler {
    input: Reference,
    output: Reference,
    interpolation: Option<String>,
}

/// What moves in a document.
pub struct Animation {
    /// For each node the parts of its pose that move; `None` for a node that stands still.
    pub nodes: Vec<Option<Tracks>>,
    /// The number of frames.
    pub frames: u32,
}

/// The longest animation of a document that moves nodes, the first of those that are equally long;
/// `None` if there is none. What of the others, and of it, is not shown is noted.
pub fn animation(
    document: &Document,
    accessors: &mut Accessors<'_>,
    notices: &mut Notices,
) -> Option<Animation> {
    let stated = document.animations.read::<Vec<Part>>().unwrap_or_else(|wrong| {
        notices.add("animations", None, || format!("its animations are left out: {wrong}"));
        None
    });
    let stated = stated.unwrap_or_default();
    let mut longest: Option<(f64, Vec<Option<Tracks>>)> = None;
    let mut keys = 0;
    let mut moving = 0;
    for (number, part) in stated.iter().enumerate() {
        let mut reader = Reader { document, accessors, notices, number, keys, length: 0.0 };
        let Some(nodes) = reader.nodes(part) else { continue };
        (keys, moving) = (reader.keys, moving + 1);
        let length = reader.length;
        if longest.as_ref().is_none_or(|(most, _)| length > *most) {
            longest = Some((length, nodes));
        }
    }
    if moving > 1 {
        notices.add("longest", None, || {
            format!("it has {moving} animations of nodes; the longest one is shown")
        });
    }
    let (seconds, nodes) = longest?;
    Some(Animation { nodes, frames: frames(seconds, notices) })
}

/// The frames of an animation. Where it ends would be the frame after the last, so that a motion
/// that goes on from its start has no frame twice.
fn frames(seconds: f64, notices: &mut Notices) -> u32 {
    let all = (seconds * FRAMES_A_SECOND - ROUNDING).ceil().max(1.0);
    if all > f64::from(MOST_FRAMES) {
        notices.add("frames", None, || {
            format!(
                "its animation takes {seconds:?} seconds; the first {MOST_FRAMES} frames are shown"
            )
        });
    }
    // It is within the range of u32.
    all.min(f64::from(MOST_FRAMES)) as u32
}

/// Reads one animation.
struct Reader<'r, 'a> {
    document: &'r Document,
    accessors: &'r mut Accessors<'a>,
    notices: &'r mut Notices,
    /// The animation's number.
    number: usize,
    /// Key frames of all animations so far.
    keys: usize,
    /// The latest time of a key frame, in seconds.
    length: f64,
}

impl Reader<'_, '_> {
    /// For each node what of it moves; `None` if nothing does.
    fn nodes(&mut self, part: &Part) -> Option<Vec<Option<Tracks>>> {
        let stated = match part.read::<Stated>() {
            Ok(stated) => stated.unwrap_or_default(),
            Err(wrong) => {
                self.leave_out("animation", &wrong);
                return None;
            }
        };
        let mut nodes: Vec<Option<Tracks>> = self.document.nodes.iter().map(|_| None).collect();
        for channel in &stated.channels {
            if let Err(wrong) = self.channel(channel, &stated.samplers, &mut nodes) {
                self.leave_out("channel", &wrong);
            }
        }
        nodes.iter().any(Option::is_some).then_some(nodes)
    }

    fn leave_out(&mut self, what: &str, wrong: &str) {
        let number = self.number;
        self.notices.add(what, None, || match what {
            "channel" => format!("a channel of animation {number} is left out: {wrong}"),
            _ => format!("animation {number} is left out: {wrong}"),
        });
    }

    fn channel(
        &mut self,
        channel: &Channel,
        samplers: &[Sampler],
        nodes: &mut [Option<Tracks>],
    ) -> Result<(), String> {
        // A channel without a node is to be ignored [3.11].
        let Some(node) = channel.target.node.0 else {
            return Err(format!(
                "it moves {}, which is no node",
                quoted(channel.target.path.as_bytes())
            ));
        };
        let moving = nodes.get_mut(node).ok_or_else(|| format!("there is no node {node}"))?;
        let sampler = channel.sampler.0.and_then(|number| samplers.get(number));
        let sampler = sampler.ok_or("it names no sampler")?;
        let vector = |[x, y, z, _]: [f64; 4]| DVec3::new(x, y, z);
        match &*channel.target.path {
            "translation" => {
                let track = self.track(sampler, "VEC3", vector)?;
                moving.get_or_insert_default().translation = Some(track);
            }
            "scale" => {
                let track = self.track(sampler, "VEC3", vector)?;
                moving.get_or_insert_default().scale = Some(track);
            }
            "rotation" => {
                let track = self.track(sampler, "VEC4", rotation)?;
                moving.get_or_insert_default().rotation = Some(track);
            }
            path => {
                return Err(format!("it moves {}, which is not shown", quoted(path.as_bytes())));
            }
        }
        Ok(())
    }

    fn track<T: crate::sequence::Blend>(
        &mut self,
        sampler: &Sampler,
        kind: &str,
        value: fn([f64; 4]) -> T,
    ) -> Result<Track<T>, String> {
        let (between, values_a_key) = self.interpolation(sampler)?;
        let [times, values] = [sampler.input, sampler.output].map(|number| number.0.map(Whole));
        let (Some(times), Some(values)) = (times, values) else {
            return Err("its sampler has no input or no output".into());
        };
        for number in [times, values] {
            self.accessors.look_up(number).map_err(|problem| problem.to_string())?;
        }
        let (times, values) = (self.floats(times, "SCALAR")?, self.elements(values, kind)?);
        let (keys, stated) = (times.count, values.count);
        if keys.checked_mul(values_a_key) != Some(stated) {
            return Err(format!("it has {keys} times and {stated} values"));
        }
        if self.keys + keys > MAX_KEYS {
            return Err(format!("at most {MAX_KEYS} key frames are read"));
        }
        let times: Vec<f64> = (0..keys).map(|k| times.numbers::<1>(k)[0]).collect();
        // A cubic spline has a value between two tangents.
        let numbers = (0..keys).map(|k| values.numbers(values_a_key * k + values_a_key / 2));
        let numbers: Vec<[f64; 4]> = numbers.collect();
        let largest = f64::from(f32::MAX);
        if !numbers.iter().flatten().chain(&times).all(|x| x.abs() <= largest) {
            return Err("it has a number that is not finite".into());
        }
        let last = times.last().copied().unwrap_or(0.0);
        let values = numbers.into_iter().map(value).collect();
        let track = Track::new(times, values, between).ok_or("its times do not ascend")?;
        (self.keys, self.length) = (self.keys + keys, self.length.max(last));
        Ok(track)
    }

    /// What is between key frames, and the values of each.
    fn interpolation(&mut self, sampler: &Sampler) -> Result<(Between, usize), String> {
        match sampler.interpolation.as_deref() {
            None | Some("LINEAR") => Ok((Between::Linear, 1)),
            Some("STEP") => Ok((Between::Held, 1)),
            Some("CUBICSPLINE") => {
                self.notices.add("spline", None, || {
                    "cubic splines of animations are shown as linear between their values".into()
                });
                Ok((Between::Linear, 3))
            }
            Some(other) => Err(format!("there is no interpolation {}", quoted(other.as_bytes()))),
        }
    }

    fn elements(&self, number: Whole, kind: &str) -> Result<&Elements<'_>, String> {
        let elements = self.accessors.get(number).filter(|elements| elements.kind == kind);
        elements.ok_or_else(|| format!("accessor {} is not of type `{kind}`", number.0))
    }

    fn floats(&self, number: Whole, kind: &str) -> Result<&Elements<'_>, String> {
        let elements = self.elements(number, kind)?;
        if elements.component == Component::F32 {
            Ok(elements)
        } else {
            Err(format!("accessor {} has times that are no floats", number.0))
        }
    }
}
