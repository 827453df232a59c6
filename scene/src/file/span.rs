//! Spans that a scene file gives as they are.
use glam::DVec3;
use toml::Spanned;

use super::values::Vector;
use super::{SourceFile, check, object, raw};
use crate::limits::LONGEST_SPAN;
use crate::picture::{SpanRow, limits};
use crate::{Facet, SceneError, Span, Triangle, VertexCone};

/// How far from 1 the weights of a span's end may add up.
const WEIGHT_SLACK: f64 = 1e-9;
/// What rounding leaves a unit vector above 1.
const LENGTH_SLACK: f64 = 1e-9;

/// All spans, one to a row of the picture.
pub(super) fn spans(
    source: &SourceFile,
    given: &[Spanned<raw::Span>],
) -> Result<Vec<SpanRow>, SceneError> {
    let rows: Vec<SpanRow> = given
        .iter()
        .enumerate()
        .map(|(number, given)| span(source, number, given))
        .collect::<Result<_, _>>()?;
    let size = (
        rows.iter().map(|row| row.span.length).max().unwrap_or(0),
        u32::try_from(rows.len()).unwrap_or(u32::MAX),
    );
    match given.last() {
        Some(last) if !limits::is_allowed(size) => {
            let problem = format!(
                "a picture of {} x {} pixels, one row for each span, cannot be made",
                size.0, size.1
            );
            Err(source.error(last.span(), problem, limits::described()))
        }
        _ => Ok(rows),
    }
}

fn span(
    source: &SourceFile,
    number: usize,
    given: &Spanned<raw::Span>,
) -> Result<SpanRow, SceneError> {
    let raw = given.get_ref();
    let normals = normals(source, &raw.normals)?;
    let cosines =
        raw.cone_cosines.as_ref().map_or(Ok(DVec3::ONE), |given| cosines(source, given))?;
    let cone = |v: usize| VertexCone { axis: normals[v], cosine: cosines[v] };
    let positions =
        raw.positions.as_ref().map_or(Ok([DVec3::ZERO; 3]), |given| positions(source, given))?;
    let of_vertices = Facet::of_vertices(&normals, &positions);
    let facet = match &raw.face {
        Some(given) => Facet { normal: face(source, given)?, ..of_vertices },
        None => of_vertices,
    };
    Ok(SpanRow {
        triangle: Triangle {
            normals,
            facet,
            positions,
            outline: None,
            cones: [0, 1, 2].map(cone),
            material: number,
        },
        span: Span {
            x: 0,
            // No more rows than limits allow are kept.
            y: number as u32,
            length: check::integer(source, "length", &raw.length, 1..=LONGEST_SPAN)?,
            triangle: number,
            start: raw
                .start
                .as_ref()
                .map_or(Ok([1.0, 0.0, 0.0]), |given| weights(source, "start", given))?,
            end: raw
                .end
                .as_ref()
                .map_or(Ok([0.0, 1.0, 0.0]), |given| weights(source, "end", given))?,
        },
        material: object::material(source, &raw.material)?.complete(),
    })
}

/// Two of the ends, where the third vertex has the first's, or three of the vertices.
fn normals(source: &SourceFile, given: &Spanned<Vec<Vector>>) -> Result<[DVec3; 3], SceneError> {
    let vectors: Vec<DVec3> = given.get_ref().iter().map(|v| DVec3::from_array(v.0)).collect();
    let help = "`normals` has the unit vectors at the span's two ends, or at the triangle's three vertices; 0 is none";
    let normals = match vectors[..] {
        [first, last] => [first, last, first],
        [a, b, c] => [a, b, c],
        _ => {
            return Err(source.error(
                given.span(),
                format!("`normals` has {} vectors", vectors.len()),
                help,
            ));
        }
    };
    match normals.iter().find(|normal| !is_normal(**normal)) {
        Some(normal) => Err(source.error(
            given.span(),
            format!("the normal {normal} has length {}", normal.length()),
            help,
        )),
        None => Ok(normals),
    }
}

/// The normal of the polygon that the span is cut from.
fn face(source: &SourceFile, given: &Spanned<Vector>) -> Result<DVec3, SceneError> {
    let normal = DVec3::from_array(given.get_ref().0);
    if is_normal(normal) {
        return Ok(normal);
    }
    let help = "`face` is the unit normal of the polygon, on the side that is seen; 0 is none";
    let problem = format!("the normal {normal} has length {}", normal.length());
    Err(source.error(given.span(), problem, help))
}

/// Whether a vector has length 1, or 0.
fn is_normal(normal: DVec3) -> bool {
    let lengths = 1.0 - LENGTH_SLACK..=1.0 + LENGTH_SLACK;
    normal == DVec3::ZERO || lengths.contains(&normal.length())
}

fn positions(source: &SourceFile, given: &Spanned<Vec<Vector>>) -> Result<[DVec3; 3], SceneError> {
    let check = |v: &Vector| check::vector(source, "positions", &Spanned::new(given.span(), *v));
    match given.get_ref()[..] {
        [a, b, c] => Ok([check(&a)?, check(&b)?, check(&c)?]),
        _ => Err(source.error(
            given.span(),
            "`positions` are three",
            "give those of the triangle's three vertices",
        )),
    }
}

fn cosines(source: &SourceFile, given: &Spanned<Vector>) -> Result<DVec3, SceneError> {
    match given.get_ref().0 {
        cosines if cosines.iter().all(|c| (-1.0..=1.0).contains(c)) => {
            Ok(DVec3::from_array(cosines))
        }
        cosines => {
            let help = "`cone_cosines` has the smallest cosine between each vertex normal and a face around it, -1 to 1";
            Err(source.error(given.span(), format!("`cone_cosines` is {cosines:?}"), help))
        }
    }
}

/// Barycentric weights.
fn weights(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Vector>,
) -> Result<[f64; 3], SceneError> {
    let weights = given.get_ref().0;
    let inside = weights.iter().all(|w| (0.0..=1.0).contains(w));
    if inside && (weights.iter().sum::<f64>() - 1.0).abs() <= WEIGHT_SLACK {
        return Ok(weights);
    }
    let help = "weights of the three vertices are 0 to 1 and add up to 1";
    Err(source.error(given.span(), format!("`{name}` is {weights:?}"), help))
}
