//! Changes to lights and to the eye.
use specula_scene::Colour;

use super::vector::{badly_rounded, turned_a_bit};
use super::{Genome, Operator, any};
use crate::climb::random::{self, MOST_LIGHTS, happens};
use crate::stress::draw::Draw;
use crate::stress::scene::Light;

/// Changes to lights and to the eye.
pub(super) const OPERATORS: &[Operator] = &[
    |genome, draw| change(genome, draw, turn),
    |genome, draw| change(genome, draw, turn),
    |genome, draw| change(genome, draw, |light, draw| *light = random::light(draw)),
    round_badly,
    aim,
    |genome, draw| any(&mut genome.scene.colours, draw).into_iter().for_each(|colour: &mut Colour| *colour = random::colour(draw)),
    add,
    drop_one,
    |genome, draw| genome.scene.eye = happens(draw, 0.4).then(|| random::place(draw)),
];

fn change(genome: &mut Genome, draw: &mut Draw, of: fn(&mut Light, &mut Draw)) {
    if let Some(light) = any(&mut genome.scene.lights, draw) {
        of(light, draw);
    }
}

fn turn(light: &mut Light, draw: &mut Draw) {
    match light {
        Light::Towards(direction) => *direction = turned_a_bit(*direction, draw),
        Light::At(position) => *position = position.length() * turned_a_bit(*position, draw),
        Light::Spot { position, target, exponent } => match draw.between(0, 2) {
            0 => *target = *position + turned_a_bit(*target - *position, draw),
            1 => *position += random::place(draw) / 10.0,
            _ => *exponent = random::exponent(draw),
        },
    }
}

/// A component of a direction that is rounded badly.
fn round_badly(genome: &mut Genome, draw: &mut Draw) {
    let Some(format) = any(&mut genome.core.points, draw).map(|point| point.format) else { return };
    if let Some(Light::Towards(direction)) = any(&mut genome.scene.lights, draw) {
        *direction = badly_rounded(*direction, format, draw);
    }
}

/// A light whose highlight lies on a span.
fn aim(genome: &mut Genome, draw: &mut Draw) {
    let Some(span) = any(&mut genome.scene.spans, draw) else { return };
    let direction = draw.aimed([span.normals[0], span.normals[1]], span.material.shininess);
    if let Some(light) = any(&mut genome.scene.lights, draw) {
        *light = Light::Towards(direction);
    }
}

fn add(genome: &mut Genome, draw: &mut Draw) {
    if genome.scene.lights.len() < MOST_LIGHTS {
        genome.scene.lights.push(random::light(draw));
        genome.scene.colours.push(random::colour(draw));
    }
}

fn drop_one(genome: &mut Genome, draw: &mut Draw) {
    let last = genome.scene.lights.len() - 1;
    if last > 0 {
        let dropped = draw.between(0, last as i64) as usize;
        genome.scene.lights.remove(dropped);
        genome.scene.colours.remove(dropped);
    }
}
