//! Builds a scene from the contents of a scene file.
use std::path::Path;

use glam::DVec3;
use toml::Spanned;

use super::sequence::SequenceTable;
use super::shown::Shown;
use super::values::{Integer, Number, Triple};

use super::{SourceFile, check, light, object, raw, sequence, span};
use crate::limits::MOST_LIGHTS;
use crate::mesh::Warning;
use crate::picture::camera::Camera;
use crate::picture::{Light, Scene, SpanRows, limits};
use crate::{Colour, SceneError, defaults};

/// Checks every value and reads the meshes, which are looked for in `folder`; notes about skipped
/// parts of meshes are added to `warnings`.
pub(super) fn build(
    file: raw::File,
    source: &SourceFile,
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<Shown, SceneError> {
    if !file.span.is_empty() {
        return rows(file, source).map(Shown::Rows);
    }
    let (table, scene) = (file.sequence.clone(), scene(file, source, folder, warnings)?);
    Ok(match table {
        None => Shown::Objects(scene),
        Some(table) => {
            let SequenceTable { frames, motions } = sequence::sequence(source, &table, &scene)?;
            Shown::Moving { scene, frames, script: motions.into() }
        }
    })
}

fn scene(
    file: raw::File,
    source: &SourceFile,
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<Scene, SceneError> {
    Ok(Scene {
        size: size(source, file.size.as_ref())?,
        background: background(source, file.background.as_ref())?,
        camera: camera(source, file.camera.as_ref())?,
        ambient: ambient(source, file.ambient.as_ref())?,
        lights: lights(source, &file.light)?,
        objects: object::objects(source, &file.object, folder, warnings)?,
    })
}

fn rows(file: raw::File, source: &SourceFile) -> Result<SpanRows, SceneError> {
    let other = [
        file.object.first().map(Spanned::span),
        file.size.as_ref().map(Spanned::span),
        file.sequence.as_ref().map(Spanned::span),
    ];
    if let Some(at) = other.into_iter().flatten().next() {
        let help = "a scene has objects and perhaps a `size` and a `[sequence]`, or spans, which say how large the picture is; leave one of them out";
        let problem = "a scene of spans has neither objects, nor a `size`, nor a `[sequence]`";
        return Err(source.error(at, problem, help));
    }
    Ok(SpanRows {
        background: background(source, file.background.as_ref())?,
        ambient: ambient(source, file.ambient.as_ref())?,
        lights: lights(source, &file.light)?,
        eye: camera(source, file.camera.as_ref())?.eye,
        rows: span::spans(source, &file.span)?,
    })
}

fn background(source: &SourceFile, given: Option<&Spanned<Triple>>) -> Result<[u8; 3], SceneError> {
    let background =
        check::colour(source, "background", given, 0.0..=1.0, defaults::BACKGROUND.map(level))?;
    Ok(background.map(|c| (c * 255.0 + 0.5).floor() as u8))
}

fn ambient(source: &SourceFile, given: Option<&Spanned<Triple>>) -> Result<Colour, SceneError> {
    check::colour(source, "ambient", given, 0.0..=1.0, defaults::AMBIENT)
}

fn level(byte: u8) -> f64 {
    f64::from(byte) / 255.0
}

fn size(
    source: &SourceFile,
    given: Option<&Spanned<[Integer; 2]>>,
) -> Result<(u32, u32), SceneError> {
    let Some(given) = given else { return Ok(defaults::SIZE) };
    let [Integer(width), Integer(height)] = *given.get_ref();
    // A number that is not a u32 becomes 0, which is not allowed either.
    let size = (u32::try_from(width).unwrap_or(0), u32::try_from(height).unwrap_or(0));
    if limits::is_allowed(size) {
        return Ok(size);
    }
    let problem = format!("a picture of {width} x {height} pixels cannot be made");
    Err(source.error(given.span(), problem, limits::described()))
}

fn camera(source: &SourceFile, given: Option<&Spanned<raw::Camera>>) -> Result<Camera, SceneError> {
    let Some(given) = given else { return Ok(Camera::default()) };
    let raw = given.get_ref();
    check::only_kind(source, raw.kind.as_ref(), "orthographic", &["perspective"])?;
    let target = raw.target.as_ref().map(|t| check::vector(source, "target", t)).transpose()?;
    let camera = Camera {
        direction: direction_to_eye(source, raw, target)?,
        up: raw.up.as_ref().map_or(Ok(DVec3::Y), |up| check::direction(source, "up", up))?,
        target,
        height: raw.height.as_ref().map(|height| positive(source, height)).transpose()?,
        eye: local_eye(source, raw)?,
    };
    match camera.rotation() {
        Some(_) => Ok(camera),
        None => {
            let at =
                [&raw.up, &raw.direction, &raw.eye].into_iter().flatten().next().map(Spanned::span);
            let problem = "the camera looks along its own `up`";
            let help = "turn `direction` or `up`: seen from straight above, for one, `up = [0, 0, -1]`; `up` is [0, 1, 0] if left out";
            Err(source.error(at.unwrap_or(given.span()), problem, help))
        }
    }
}

/// The place of the eye that sees highlights; `None` for an eye at infinity.
fn local_eye(source: &SourceFile, raw: &raw::Camera) -> Result<Option<DVec3>, SceneError> {
    let viewers = [("infinite", false), ("local", true)];
    match (check::word(source, "viewer", raw.viewer.as_ref(), &viewers)?, &raw.eye, &raw.viewer) {
        (Some(true), Some(eye), _) => check::vector(source, "eye", eye).map(Some),
        (Some(true), None, Some(viewer)) => Err(source.error(
            viewer.span(),
            "a local viewer needs an `eye`",
            "add `eye`, the place highlights are seen from, and `target`",
        )),
        _ => Ok(None),
    }
}

/// The direction to the eye: the camera's `direction`, or the one from its `target` to its `eye`.
fn direction_to_eye(
    source: &SourceFile,
    raw: &raw::Camera,
    target: Option<DVec3>,
) -> Result<DVec3, SceneError> {
    match (&raw.direction, &raw.eye, target) {
        (None, None, _) => Ok(Camera::default().direction),
        (Some(direction), None, _) => check::direction(source, "direction", direction),
        (Some(_), Some(eye), _) => {
            let problem = "the camera has both a `direction` and an `eye`";
            Err(source.error(eye.span(), problem, "leave one of them out"))
        }
        (None, Some(eye), None) => {
            let help = "add `target`, the point that is looked at, or give the direction to the eye as `direction`";
            Err(source.error(eye.span(), "the camera has an `eye` but no `target`", help))
        }
        (None, Some(eye), Some(target)) => match check::vector(source, "eye", eye)? - target {
            DVec3::ZERO => Err(source.error(
                eye.span(),
                "`eye` is at `target`",
                "move `eye` away from `target`",
            )),
            direction => Ok(direction),
        },
    }
}

fn positive(source: &SourceFile, given: &Spanned<Number>) -> Result<f64, SceneError> {
    match check::number(source, "height", given)? {
        height if height > 0.0 => Ok(height),
        height => {
            let help = "`height` is the number of world units from the picture's bottom to its top, above 0";
            Err(source.error(given.span(), format!("`height` is {height:?}"), help))
        }
    }
}

fn lights(source: &SourceFile, given: &[Spanned<raw::Light>]) -> Result<Vec<Light>, SceneError> {
    if let Some(extra) = given.get(MOST_LIGHTS) {
        let problem = format!("there are {} lights", given.len());
        return Err(source.error(
            extra.span(),
            problem,
            format!("a scene has 1 to {MOST_LIGHTS} lights"),
        ));
    }
    if given.is_empty() {
        return Ok(vec![defaults::light()]);
    }
    given.iter().map(|given| light::light(source, given)).collect()
}
