//! Changes to spans.
use glam::DVec3;
use specula_scene::Colour;
use specula_scene::frame::EYE;
use specula_scene::limits::LONGEST_SPAN;

use super::operator::{Operator, any};
use super::vector::{badly_rounded, turned_a_bit, with_alike_components};
use crate::climb::genome::Genome;
use crate::climb::random::{self, LONGEST, MAX_SPANS, happens};
use crate::stress::draw::{Draw, turned};
use crate::stress::scene::RawSpan;

/// Changes to lengths, normals, weights and the number of spans.
pub(super) const SHAPE: &[Operator] = &[
    |genome, draw| change(genome, draw, turn_a_normal),
    |genome, draw| change(genome, draw, turn_a_normal),
    |genome, draw| change(genome, draw, |span, draw| span.normals = random::normals(draw)),
    |genome, draw| change(genome, draw, |span, _| span.normals = [span.normals[0]; 3]),
    |genome, draw| change(genome, draw, |span, _| span.normals[2] = span.normals[0]),
    |genome, draw| change(genome, draw, oppose_normals),
    |genome, draw| change(genome, draw, flatten_normals),
    |genome, draw| {
        change(genome, draw, |span, draw| {
            span.normals[draw.between(0, 2) as usize] = DVec3::ZERO;
        })
    },
    |genome, draw| change(genome, draw, |span, draw| span.face = random::face(draw)),
    |genome, draw| change(genome, draw, turn_the_face),
    round_a_normal_badly,
    |genome, draw| change(genome, draw, make_components_alike),
    |genome, draw| change(genome, draw, |span, draw| span.length = random::length(draw)),
    |genome, draw| change(genome, draw, stretch),
    |genome, draw| change(genome, draw, stretch),
    |genome, draw| change(genome, draw, |span, draw| span.start = random::weights(draw)),
    |genome, draw| change(genome, draw, |span, draw| span.end = random::weights(draw)),
    |genome, draw| change(genome, draw, |span, _| span.end = span.start),
    |genome, draw| {
        change(genome, draw, |span, draw| span.cone_cosines = random::cone_cosines(draw))
    },
    |genome, draw| change(genome, draw, move_a_vertex),
    |genome, draw| {
        change(genome, draw, |span, draw| {
            span.positions[draw.between(0, 2) as usize] =
                span.positions[draw.between(0, 2) as usize];
        })
    },
    add,
    drop_one,
];

/// Changes to materials and ambient light.
pub(super) const MATERIAL: &[Operator] = &[
    |genome, draw| change(genome, draw, |span, draw| span.material = random::material(draw)),
    |genome, draw| {
        change(genome, draw, |span, draw| span.material.shininess = random::exponent(draw))
    },
    |genome, draw| change(genome, draw, |span, draw| span.material.ambient = random::colour(draw)),
    |genome, draw| change(genome, draw, |span, draw| span.material.diffuse = random::colour(draw)),
    |genome, draw| change(genome, draw, |span, draw| span.material.specular = random::colour(draw)),
    |genome, draw| change(genome, draw, |span, draw| nudge(&mut span.material.diffuse, draw)),
    |genome, draw| change(genome, draw, |span, draw| nudge(&mut span.material.specular, draw)),
    |genome, draw| genome.scene.ambient = random::colour(draw),
];

fn change(genome: &mut Genome, draw: &mut Draw, of: fn(&mut RawSpan, &mut Draw)) {
    if let Some(span) = any(&mut genome.scene.spans, draw) {
        of(span, draw);
    }
}

/// Makes a component a little brighter or darker, or equal or nearly equal to another.
fn nudge(colour: &mut Colour, draw: &mut Draw) {
    let (channel, other) = (draw.between(0, 2) as usize, draw.between(0, 2) as usize);
    let apart = draw.one_of(&[0.0, 1.0, -1.0]) * random::log_uniform(draw, 1e-6, 1e-2);
    colour[channel] = (colour[other] + apart).clamp(0.0, 1.0);
}

fn make_components_alike(span: &mut RawSpan, draw: &mut Draw) {
    let before = span.normals[draw.between(0, 2) as usize];
    replace(span, before, with_alike_components(before, draw), draw);
}

/// Turns one vertex's normal and, sometimes, the equal normals of other vertices with it.
fn turn_a_normal(span: &mut RawSpan, draw: &mut Draw) {
    let before = span.normals[draw.between(0, 2) as usize];
    replace(span, before, turned_a_bit(before, draw), draw);
}

fn round_a_normal_badly(genome: &mut Genome, draw: &mut Draw) {
    let Some(format) = any(&mut genome.core.points, draw).map(|point| point.format) else { return };
    let Some(span) = any(&mut genome.scene.spans, draw) else { return };
    let before = span.normals[draw.between(0, 2) as usize];
    replace(span, before, badly_rounded(before, format, draw), draw);
}

/// Makes the normals of an edge opposite, or nearly so: N becomes shorter than formats can
/// represent. Sometimes all of them also become perpendicular to an axis.
fn oppose_normals(span: &mut RawSpan, draw: &mut Draw) {
    if happens(draw, 0.5) {
        flatten_normals(span, draw);
    }
    let opposite = -span.normals[0];
    let angle = random::log_uniform(draw, 1e-7, 0.3);
    span.normals[1] = match opposite.try_normalize() {
        Some(axis) if happens(draw, 0.8) => {
            let across = span.normals[2].reject_from_normalized(axis);
            let across = across.try_normalize().unwrap_or_else(|| any_across(axis, draw));
            (axis + angle * across).normalize()
        }
        _ => opposite,
    };
}

/// A unit vector perpendicular to `axis`; also perpendicular to the view direction, if such a
/// vector is unique.
fn any_across(axis: DVec3, draw: &mut Draw) -> DVec3 {
    match axis.cross(EYE).try_normalize() {
        Some(across) if axis.z == 0.0 && happens(draw, 0.7) => across,
        _ => turned(axis, std::f64::consts::FRAC_PI_2, draw.unit()),
    }
}

/// Makes all normals perpendicular to one axis, most often to the view direction: a cosine is then
/// exactly 0.
fn flatten_normals(span: &mut RawSpan, draw: &mut Draw) {
    let axis = draw.one_of(&[0, 1, 2, 2]);
    for normal in &mut span.normals {
        normal[axis] = 0.0;
        *normal = normal.normalize_or_zero();
    }
}

/// Turns the polygon's own normal a little or more away from what it was, or from a vertex's.
fn turn_the_face(span: &mut RawSpan, draw: &mut Draw) {
    let before = span.face.filter(|_| happens(draw, 0.7));
    let before = before.unwrap_or(span.normals[draw.between(0, 2) as usize]);
    span.face = Some(turned_a_bit(before, draw));
}

fn replace(span: &mut RawSpan, before: DVec3, after: DVec3, draw: &mut Draw) {
    let is_alone = happens(draw, 0.3);
    let mut alike = span.normals.iter_mut().filter(|normal| **normal == before);
    if is_alone {
        alike.next().into_iter().for_each(|normal| *normal = after);
    } else {
        alike.for_each(|normal| *normal = after);
    }
}

/// Makes a span a few pixels, or many, longer or shorter.
fn stretch(span: &mut RawSpan, draw: &mut Draw) {
    let factor = draw.one_of(&[0.5, 0.8, 1.0, 1.0, 1.25, 2.0]);
    let length = (f64::from(span.length) * factor).round() as i64 + draw.between(-2, 2);
    // Only a span that is long already may become even longer, since every pixel takes time.
    let longest = if span.length > LONGEST { LONGEST_SPAN } else { LONGEST };
    span.length = length.clamp(1, longest.into()) as u32;
}

fn move_a_vertex(span: &mut RawSpan, draw: &mut Draw) {
    span.positions[draw.between(0, 2) as usize] += random::place(draw) / 10.0;
}

/// Adds a span: a new one, or a copy of another with other normals.
fn add(genome: &mut Genome, draw: &mut Draw) {
    if genome.scene.spans.len() >= MAX_SPANS {
        return;
    }
    let mut span = random::span(draw);
    if let Some(other) = any(&mut genome.scene.spans, draw)
        && happens(draw, 0.7)
    {
        span = RawSpan { normals: span.normals, length: span.length, ..other.clone() };
    }
    genome.scene.spans.push(span);
}

fn drop_one(genome: &mut Genome, draw: &mut Draw) {
    let last = genome.scene.spans.len() - 1;
    if last > 0 {
        genome.scene.spans.remove(draw.between(0, last as i64) as usize);
    }
}
