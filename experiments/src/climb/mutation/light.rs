//! Changes to lights and to the eye.
use glam::DVec3;

use super::operator::{Operator, any};
use super::vector::{badly_rounded, turned_a_bit, with_alike_components};
use crate::climb::genome::Genome;
use crate::climb::random::{self, MAX_LIGHTS, happens};
use crate::stress::draw::{AXES, Draw};
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
    |genome, draw| change(genome, draw, turn_to_an_axis),
    oppose_another,
    put_on_a_span,
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
        Light::At(position) | Light::Weaker { position, .. } => {
            *position = position.length() * turned_a_bit(*position, draw);
        }
        Light::Spot { position, target, exponent } => match draw.between(0, 2) {
            0 => *target = *position + turned_a_bit(*target - *position, draw),
            1 => *position += random::place(draw) / 10.0,
            _ => *exponent = random::exponent(draw),
        },
    }
}

/// Gives a direction a component that is rounded badly.
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

/// Moves a light to where another one is, or close to it.
fn make_a_twin(genome: &mut Genome, draw: &mut Draw) {
    let Some(mut twin) = any(&mut genome.scene.lights, draw).copied() else { return };
    if draw.one_of(&[true, false]) {
        turn(&mut twin, draw);
    }
    change(genome, draw, |light, _| *light = twin);
}

/// Aims a light so that its highlight lies on a span.
fn aim(genome: &mut Genome, draw: &mut Draw) {
    let Some(span) = any(&mut genome.scene.spans, draw) else { return };
    let direction = draw.aimed([span.normals[0], span.normals[1]], span.material.shininess);
    if let Some(light) = any(&mut genome.scene.lights, draw) {
        *light = Light::Towards(direction);
    }
}

/// Turns a light towards the eye, away from it, or across.
fn turn_to_an_axis(light: &mut Light, draw: &mut Draw) {
    *light = Light::Towards(draw.one_of(&AXES));
}

/// Moves a light opposite to another one.
fn oppose_another(genome: &mut Genome, draw: &mut Draw) {
    let Some(Light::Towards(other)) = any(&mut genome.scene.lights, draw).copied() else { return };
    change(genome, draw, |light, _| *light = Light::Towards(-other));
}

/// Puts a light or the eye on a span, or very close to it.
fn put_on_a_span(genome: &mut Genome, draw: &mut Draw) {
    let Some(span) = any(&mut genome.scene.spans, draw) else { return };
    let weights = random::weights(draw);
    let on_it: DVec3 = span.positions.iter().zip(weights).map(|(&p, weight)| weight * p).sum();
    let away = draw.one_of(&[0.0, 1.0]) * random::log_uniform(draw, 1e-6, 1e-1);
    let position = on_it + away * draw.direction();
    if genome.scene.eye.is_some() && happens(draw, 0.3) {
        genome.scene.eye = Some(position);
        return;
    }
    change(genome, draw, |light, draw| {
        *light = match light {
            Light::Spot { exponent, .. } => {
                Light::Spot { position, target: position + draw.direction(), exponent: *exponent }
            }
            _ => Light::At(position),
        };
    });
}

fn add(genome: &mut Genome, draw: &mut Draw) {
    if genome.scene.lights.len() < MAX_LIGHTS {
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
