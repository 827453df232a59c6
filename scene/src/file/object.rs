//! The objects of a scene file: shape, place and material.
use std::path::Path;

use glam::{DAffine3, DMat3, DVec3};
use toml::Spanned;

use super::values::Number;
use super::{SourceFile, check, raw};
use crate::angle::cos_sin;
use crate::limits::LARGEST_SHININESS;
use crate::mesh::error::listed;
use crate::mesh::{MAX_TRIANGLES, Mesh, Warning};
use crate::picture::Object;
use crate::primitive::{self, Primitive};
use crate::{PartialMaterial, SceneError};

/// The largest component of a material's specular colour; Lyon's figure 9 uses 400/255.
const BRIGHTEST_SPECULAR: f64 = 4.0;

/// All objects: at least one, and together no more triangles than a single mesh may have. Notes
/// about skipped parts of their meshes are added to `warnings`.
pub(super) fn objects(
    source: &SourceFile,
    given: &[Spanned<raw::Object>],
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Object>, SceneError> {
    if given.is_empty() {
        let help = "add a table `[[object]]` with a `mesh` or a `primitive`";
        return Err(source.error(0..0, "the scene has no objects", help));
    }
    let mut objects = Vec::with_capacity(given.len());
    let mut triangles = 0;
    for raw in given {
        let object = object(source, raw, folder, warnings)?;
        triangles += object.mesh.triangles.len();
        if triangles > MAX_TRIANGLES {
            let problem = format!("with this object the scene has {triangles} triangles");
            let help = format!(
                "all objects together have at most {MAX_TRIANGLES}; use a lower `level` or simpler meshes"
            );
            return Err(source.error(raw.span(), problem, help));
        }
        objects.push(object);
    }
    Ok(objects)
}

fn object(
    source: &SourceFile,
    raw: &Spanned<raw::Object>,
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<Object, SceneError> {
    // Cheap checks come before those that read files.
    let (place, material) =
        (place(source, raw.get_ref())?, material(source, &raw.get_ref().material)?);
    let (mesh, primitive) = shape(source, raw, folder, warnings)?;
    Ok(Object { mesh: mesh.into(), primitive, place, material })
}

/// The object's mesh, and the primitive that it was made from, if any.
fn shape(
    source: &SourceFile,
    object: &Spanned<raw::Object>,
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<(Mesh, Option<Primitive>), SceneError> {
    let raw = object.get_ref();
    match (&raw.mesh, &raw.primitive) {
        (Some(file), None) => {
            for (name, at) in [
                ("level", raw.level.as_ref().map(Spanned::span)),
                ("tube", raw.tube.as_ref().map(Spanned::span)),
            ] {
                if let Some(at) = at {
                    return Err(source.error(
                        at,
                        format!("a mesh has no `{name}`"),
                        format!("`{name}` goes with `primitive`"),
                    ));
                }
            }
            let path = folder.unwrap_or(Path::new("")).join(file.get_ref());
            let read = Mesh::read(&path);
            let (mesh, mut passed_over) =
                read.map_err(|error| source.error(file.span(), error.to_string(), error.help()))?;
            // If several objects show a mesh, its warnings are given once.
            passed_over.retain(|warning| !warnings.contains(warning));
            warnings.append(&mut passed_over);
            Ok((mesh, None))
        }
        (None, Some(name)) => {
            primitive(source, raw, name).map(|primitive| (primitive.mesh(), Some(primitive)))
        }
        (Some(_), Some(second)) => Err(source.error(
            second.span(),
            "the object has both a `mesh` and a `primitive`",
            "leave one of them out",
        )),
        (None, None) => {
            let help = format!(
                "add `mesh = \"file\"`, or `primitive = ` one of {}",
                listed(&primitive::NAMES)
            );
            Err(source.error(
                object.span(),
                "the object has neither a `mesh` nor a `primitive`",
                help,
            ))
        }
    }
}

fn primitive(
    source: &SourceFile,
    raw: &raw::Object,
    name: &Spanned<String>,
) -> Result<Primitive, SceneError> {
    let unknown = || {
        let problem = format!("there is no primitive `{}`", name.get_ref());
        source.error(name.span(), problem, format!("primitives are {}", listed(&primitive::NAMES)))
    };
    let shape = Primitive::by_name(name.get_ref()).ok_or_else(unknown)?;
    let shape = with_tube(source, shape, raw.tube.as_ref())?;
    let Some(level) = &raw.level else { return Ok(shape) };
    // A number that is not a u32 is out of every range.
    shape.at_level(u32::try_from(level.get_ref().0).unwrap_or(u32::MAX)).map_err(|range| {
        let help =
            format!("`level` of a {} is {} to {}", name.get_ref(), range.start(), range.end());
        source.error(level.span(), format!("`level` = {} is out of range", level.get_ref().0), help)
    })
}

fn with_tube(
    source: &SourceFile,
    shape: Primitive,
    given: Option<&Spanned<Number>>,
) -> Result<Primitive, SceneError> {
    match (shape, given) {
        (_, None) => Ok(shape),
        (Primitive::Torus { level, .. }, Some(tube)) => match tube.get_ref().0 {
            radius if (0.001..=0.999).contains(&radius) => {
                Ok(Primitive::Torus { level, tube: radius })
            }
            radius => {
                let help = "the tube's radius is 0.001 to 0.999; the torus's own is 1";
                Err(source.error(tube.span(), format!("`tube` is {radius:?}"), help))
            }
        },
        (_, Some(tube)) => {
            Err(source.error(tube.span(), "only a torus has a `tube`", "leave `tube` out"))
        }
    }
}

/// The transformation that scales, then rotates about x, y and z in that order, then moves.
fn place(source: &SourceFile, raw: &raw::Object) -> Result<DAffine3, SceneError> {
    let scale = raw.scale.as_ref().map_or(Ok(DVec3::ONE), |s| check::scale(source, s))?;
    let degrees =
        raw.rotate.as_ref().map_or(Ok(DVec3::ZERO), |r| check::vector(source, "rotate", r))?;
    let translate = raw
        .translate
        .as_ref()
        .map_or(Ok(DVec3::ZERO), |t| check::vector(source, "translate", t))?;
    let linear = rotation(degrees) * DMat3::from_diagonal(scale);
    Ok(DAffine3::from_mat3_translation(linear, translate))
}

/// The rotation about the fixed axes x, then y, then z.
fn rotation(degrees: DVec3) -> DMat3 {
    let [(cx, sx), (cy, sy), (cz, sz)] = degrees.to_array().map(cos_sin);
    let about_x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let about_y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let about_z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    about_z * about_y * about_x
}

/// The keys of a material that a table gives.
pub(super) fn material(
    source: &SourceFile,
    raw: &raw::Material,
) -> Result<PartialMaterial, SceneError> {
    let colour = |name, given: &Option<_>, brightest| {
        check::given_colour(source, name, given.as_ref(), 0.0..=brightest)
    };
    let shininess = |given| check::integer(source, "shininess", given, 1..=LARGEST_SHININESS);
    Ok(PartialMaterial {
        diffuse: colour("diffuse", &raw.diffuse, 1.0)?,
        ambient: colour("ambient", &raw.ambient, 1.0)?,
        specular: colour("specular", &raw.specular, BRIGHTEST_SPECULAR)?,
        shininess: raw.shininess.as_ref().map(shininess).transpose()?,
    })
}
