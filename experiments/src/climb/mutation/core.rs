//! Changes to the core.
use specula_spec::{Format, LightPipelines, Specialise};

use super::operator::{Operator, any};
use crate::climb::genome::Genome;
use crate::climb::random;
use crate::stress::draw::Draw;

/// Changes to formats.
pub(super) const FORMATS: &[Operator] =
    &[shift, shift, shift, redraw, shift_integer_bits, forget, shift_all];

/// Changes to the method's options, and to the scenes for which the core is made.
pub(super) const OPTIONS: &[Operator] = &[
    choose,
    choose,
    choose,
    |genome, draw| genome.core.light_pipelines = draw.one_of(&LightPipelines::ALL),
    |genome, draw| {
        genome.core.specialise =
            draw.one_of(&[Specialise::Scene, Specialise::Scene, Specialise::General])
    },
];

/// Changes a format by a bit or a few; a number of bits that is too small or too large is repaired
/// later.
fn shift(genome: &mut Genome, draw: &mut Draw) {
    if let Some(point) = any(&mut genome.core.points, draw).cloned() {
        let fraction_bits =
            point.format.fraction_bits.saturating_add_signed(draw.one_of(&[-3, -1, -1, 1, 1, 3]));
        genome.core.set_format(point.name, Format { fraction_bits, ..point.format });
    }
}

fn shift_all(genome: &mut Genome, draw: &mut Draw) {
    let bits = draw.one_of(&[-2, -1, 1, 2]);
    for point in genome.core.points.clone() {
        let fraction_bits = point.format.fraction_bits.saturating_add_signed(bits);
        genome.core.set_format(point.name, Format { fraction_bits, ..point.format });
    }
}

fn redraw(genome: &mut Genome, draw: &mut Draw) {
    if let Some(point) = any(&mut genome.core.points, draw).cloned() {
        let format = random::any_format(draw, &point);
        genome.core.set_format(point.name, format);
    }
}

/// Changes the integer bits of a format. Few narrowing points may have other integer bits than
/// their own; others are repaired later.
fn shift_integer_bits(genome: &mut Genome, draw: &mut Draw) {
    if let Some(point) = any(&mut genome.core.points, draw).cloned() {
        let integer_bits = point.format.integer_bits.saturating_add_signed(draw.one_of(&[-1, 1]));
        genome.core.set_format(point.name, Format { integer_bits, ..point.format });
    }
}

/// Returns an option or a format to its default.
fn forget(genome: &mut Genome, draw: &mut Draw) {
    if let Some(&mut (name, _)) = any(&mut genome.core.formats, draw) {
        genome.core.formats.retain(|(other, _)| *other != name);
    }
}

fn choose(genome: &mut Genome, draw: &mut Draw) {
    let choices = genome.core.method.option_domains();
    if !choices.is_empty() {
        let choice = draw.one_of(choices);
        genome.core.set_option(choice.key, draw.one_of(choice.values));
    }
}
