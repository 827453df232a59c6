//! Changes to lights and to the eye.
use super::vector::{badly_rounded, turned_a_bit, with_alike_components};
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
    |genome, draw| change(genome, draw, make_components_alike),
    make_a_twin,
    aim,
    recolour,
    add,
    drop_one,
    |genome, draw| genome.scene.eye = happens(draw, 0.4).then(|| random::place(draw)),
];

fn change(genome: &mut Genome, draw: &mut Draw, of: impl FnOnce(&mut Light, &mut Draw)) {
    if let Some(light) = any(&mut genome.scene.lights, draw) {
        of(light, draw);
    }
}

fn recolour(genome: &mut Genome, draw: &mut Draw) {
    if let Some(colour) = any(&mut genome.scene.colours, draw) {
        *colour = random::colour(draw);
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

fn make_components_alike(light: &mut Light, draw: &mut Draw) {
    if let Light::Towards(direction) = light {
        *direction = with_alike_components(*direction, draw);
    }
}

/// A light where another one is, or nearly so.
fn make_a_twin(genome: &mut Genome, draw: &mut Draw) {
    let Some(mut twin) = any(&mut genome.scene.lights, draw).copied() else { return };
    if draw.one_of(&[true, false]) {
        turn(&mut twin, draw);
    }
    change(genome, draw, |light, _| *light = twin);
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
