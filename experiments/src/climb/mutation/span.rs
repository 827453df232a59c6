//! Changes to spans.
use glam::DVec3;
use specula_scene::Colour;

use super::vector::{badly_rounded, turned_a_bit, with_alike_components};
use super::{Genome, Operator, any};
use crate::climb::random::{self, LONGEST, MOST_SPANS, happens};
use crate::stress::draw::Draw;
use crate::stress::scene::RawSpan;

/// Changes to lengths, normals, weights, and how many spans there are.
pub(super) const SHAPE: &[Operator] = &[
    |genome, draw| change(genome, draw, turn_a_normal),
    |genome, draw| change(genome, draw, turn_a_normal),
    |genome, draw| change(genome, draw, |span, draw| span.normals = random::normals(draw)),
    |genome, draw| change(genome, draw, |span, _| span.normals = [span.normals[0]; 3]),
    |genome, draw| change(genome, draw, |span, _| span.normals[2] = span.normals[0]),
    round_a_normal_badly,
    |genome, draw| change(genome, draw, make_components_alike),
    |genome, draw| change(genome, draw, |span, draw| span.length = draw.length(LONGEST)),
    |genome, draw| change(genome, draw, stretch),
    |genome, draw| change(genome, draw, stretch),
    |genome, draw| change(genome, draw, |span, draw| span.start = random::weights(draw)),
    |genome, draw| change(genome, draw, |span, draw| span.end = random::weights(draw)),
    |genome, draw| {
        change(genome, draw, |span, draw| span.cone_cosines = random::cone_cosines(draw))
    },
    |genome, draw| change(genome, draw, move_a_vertex),
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

/// A component a little brighter or darker, or as another one, or nearly so.
fn nudge(colour: &mut Colour, draw: &mut Draw) {
    let (channel, other) = (draw.between(0, 2) as usize, draw.between(0, 2) as usize);
    let apart = draw.one_of(&[0.0, 1.0, -1.0]) * random::of_any_size(draw, 1e-6, 1e-2);
    colour[channel] = (colour[other] + apart).clamp(0.0, 1.0);
}

fn make_components_alike(span: &mut RawSpan, draw: &mut Draw) {
    let before = span.normals[draw.between(0, 2) as usize];
    replace(span, before, with_alike_components(before, draw), draw);
}

/// One vertex's normal, and those of other vertices that have the same along with it now and then.
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

fn replace(span: &mut RawSpan, before: DVec3, after: DVec3, draw: &mut Draw) {
    let is_alone = happens(draw, 0.3);
    let mut alike = span.normals.iter_mut().filter(|normal| **normal == before);
    if is_alone {
        alike.next().into_iter().for_each(|normal| *normal = after);
    } else {
        alike.for_each(|normal| *normal = after);
    }
}

/// A few pixels more or fewer, or many.
fn stretch(span: &mut RawSpan, draw: &mut Draw) {
    let factor = draw.one_of(&[0.5, 0.8, 1.0, 1.0, 1.25, 2.0]);
    let length = (f64::from(span.length) * factor).round() as i64 + draw.between(-2, 2);
    span.length = length.clamp(1, LONGEST.into()) as u32;
}

fn move_a_vertex(span: &mut RawSpan, draw: &mut Draw) {
    span.positions[draw.between(0, 2) as usize] += random::place(draw) / 10.0;
}

/// One more span, new or like another but for its normals.
fn add(genome: &mut Genome, draw: &mut Draw) {
    if genome.scene.spans.len() >= MOST_SPANS {
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
