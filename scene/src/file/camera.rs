//! Cameras of a scene file.
use std::ops::{Range, RangeInclusive};

use glam::DVec3;
use toml::Spanned;

use super::values::Number;
use super::{SourceFile, check, raw};
use crate::SceneError;
use crate::perspective::Interpolation;
use crate::picture::camera::{Camera, Lens};

/// The field of view in degrees.
const FIELDS_OF_VIEW: RangeInclusive<f64> = 1.0..=170.0;

/// The distance of the near plane in world units.
const NEAR: RangeInclusive<f64> = 1e-30..=1e30;

/// The camera of a scene of objects.
pub(super) fn camera(
    source: &SourceFile,
    given: Option<&Spanned<raw::Camera>>,
) -> Result<Camera, SceneError> {
    let Some(given) = given else { return Ok(Camera::default()) };
    let raw = given.get_ref();
    let target = raw.target.as_ref().map(|t| check::vector(source, "target", t)).transpose()?;
    let lens = match kind(source, raw)? {
        Kind::Orthographic => without_lens(source, raw).map(|()| None),
        Kind::Perspective => lens(source, raw).map(Some),
    }?;
    let camera = Camera {
        direction: direction_to_eye(source, raw, target)?,
        up: raw.up.as_ref().map_or(Ok(DVec3::Y), |up| check::direction(source, "up", up))?,
        target,
        height: raw.height.as_ref().map(|height| positive(source, height)).transpose()?,
        eye: local_eye(source, raw)?,
        lens,
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

/// The camera of a scene of spans, which say themselves what is seen.
pub(super) fn camera_of_spans(
    source: &SourceFile,
    given: Option<&Spanned<raw::Camera>>,
) -> Result<Camera, SceneError> {
    let camera = camera(source, given)?;
    let kind = given.and_then(|given| given.get_ref().kind.as_ref());
    match (camera.lens, kind) {
        (Some(_), Some(kind)) => {
            let help = "leave `kind` out; what perspective makes of weights is for `start` and `end` of a span to say";
            Err(source.error(kind.span(), "a scene of spans has no perspective", help))
        }
        _ => Ok(camera),
    }
}

#[derive(Clone, Copy)]
enum Kind {
    Orthographic,
    Perspective,
}

fn kind(source: &SourceFile, raw: &raw::Camera) -> Result<Kind, SceneError> {
    let kinds = [("orthographic", Kind::Orthographic), ("perspective", Kind::Perspective)];
    let kind = check::word(source, "kind", raw.kind.as_ref(), &kinds)?;
    Ok(kind.unwrap_or(Kind::Orthographic))
}

/// Checks that an orthographic camera has no key of a perspective one.
fn without_lens(source: &SourceFile, raw: &raw::Camera) -> Result<(), SceneError> {
    let keys: [(&str, Option<Range<usize>>); 3] = [
        ("field_of_view", raw.field_of_view.as_ref().map(Spanned::span)),
        ("near", raw.near.as_ref().map(Spanned::span)),
        ("interpolation", raw.interpolation.as_ref().map(Spanned::span)),
    ];
    match keys.into_iter().find_map(|(key, at)| at.map(|at| (key, at))) {
        Some((key, at)) => {
            let help = format!("add `kind = \"perspective\"`, or leave `{key}` out");
            Err(source.error(at, format!("an orthographic camera has no `{key}`"), help))
        }
        None => Ok(()),
    }
}

fn lens(source: &SourceFile, raw: &raw::Camera) -> Result<Lens, SceneError> {
    if let Some(height) = &raw.height {
        let help = "give `field_of_view`, the angle from the picture's bottom to its top in degrees, in place of `height`";
        return Err(source.error(height.span(), "a perspective camera has no `height`", help));
    }
    let words = [("screen", Interpolation::Screen), ("perspective", Interpolation::Perspective)];
    let interpolation = check::word(source, "interpolation", raw.interpolation.as_ref(), &words)?;
    let degrees =
        "`field_of_view` is the angle from the picture's bottom to its top, 1 to 170 degrees";
    let near = "`near` is the distance from the eye to the near plane in world units, 1e-30 to 1e30; what is nearer is not seen";
    let number = |name, given: &Option<Spanned<Number>>, range, help| {
        given.as_ref().map(|given| within(source, name, given, (range, help))).transpose()
    };
    Ok(Lens {
        field_of_view: number("field_of_view", &raw.field_of_view, FIELDS_OF_VIEW, degrees)?
            .unwrap_or(Lens::FIELD_OF_VIEW),
        eye: raw.eye.as_ref().map(|eye| check::vector(source, "eye", eye)).transpose()?,
        near: number("near", &raw.near, NEAR, near)?,
        interpolation: interpolation.unwrap_or_default(),
    })
}

/// A number in a range, of which `help` tells.
fn within(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Number>,
    (range, help): (RangeInclusive<f64>, &str),
) -> Result<f64, SceneError> {
    match check::number(source, name, given)? {
        number if range.contains(&number) => Ok(number),
        number => {
            Err(source.error(given.span(), format!("`{name}` = {number:?} is out of range"), help))
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
