//! The camera [glTF 2.0, 3.10].
use glam::DVec3;
use serde::Deserialize;

use super::json::{Document, Number};
use super::nodes::Attached;
use super::part::Part;
use crate::mesh::limits::FARTHEST;
use crate::mesh::warning::{Notices, quoted};
use crate::picture::camera::Camera;

/// A camera as the file states it.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Stated {
    #[serde(rename = "type")]
    kind: String,
    orthographic: Orthographic,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Orthographic {
    ymag: Option<Number>,
}

/// The first camera at a node, with the node's place in the tree; `None` if there is none, or if it is not shown, which is noted.
pub fn camera(
    document: &Document,
    attached: &[Attached],
    notices: &mut Notices,
) -> Option<(Camera, usize)> {
    let Attached { number, place, node } = attached.first()?;
    if attached.len() > 1 {
        notices.add("cameras", None, || {
            format!("it has {} cameras; the first one is taken", attached.len())
        });
    }
    let stated = document.cameras.read::<Vec<Part>>();
    let stated = stated.and_then(|all| match all.unwrap_or_default().get(*number) {
        Some(part) => part.read::<Stated>(),
        None => Err(format!("there is no camera {number}")),
    });
    let camera = stated.and_then(|stated| stated.unwrap_or_default().at(place));
    let camera = camera.map(|camera| (camera, *node));
    camera
        .map_err(|wrong| {
            notices.add("camera", None, || {
                format!("camera {number} is not taken, and the file seen as one without: {wrong}")
            });
        })
        .ok()
}

impl Stated {
    /// The camera at a node, which looks along the node's -z, its y up; or what is wrong with it.
    fn at(&self, place: &glam::DMat4) -> Result<Camera, String> {
        match &*self.kind {
            "orthographic" => self.orthographic.at(place),
            // A camera of this kind is to be made here once scenes have it: `yfov` is its angle,
            // and the node's place its eye.
            "perspective" => Err("it has a perspective, which is not shown yet".into()),
            other => Err(format!("there is no type {}", quoted(other.as_bytes()))),
        }
    }
}

impl Orthographic {
    fn at(&self, place: &glam::DMat4) -> Result<Camera, String> {
        let target = place.transform_point3(DVec3::ZERO);
        // Half of the picture's height; the width follows from the picture's size.
        let half = self.ymag.map_or(0.0, |Number(half)| half.abs());
        let camera = Camera {
            direction: place.transform_vector3(DVec3::Z),
            up: place.transform_vector3(DVec3::Y),
            target: Some(target),
            height: Some(2.0 * half),
            ..Camera::default()
        };
        let is_near = target.to_array().iter().all(|x| x.abs() <= FARTHEST);
        if camera.rotation().is_none() || !is_near {
            Err("its node does not say where it is".into())
        } else if half > 0.0 && half <= FARTHEST {
            Ok(camera)
        } else {
            Err("its `ymag` is not above 0".into())
        }
    }
}
