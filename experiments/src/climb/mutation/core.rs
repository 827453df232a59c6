//! Changes to the core.
use specula_spec::{Format, LightPipelines, Specialise};

use super::{Genome, Operator, any};
use crate::climb::random;
use crate::stress::draw::Draw;

/// Changes to formats.
pub(super) const FORMATS: &[Operator] =
    &[shift, shift, shift, redraw, shift_integer_bits, forget, shift_all];

/// Changes to the method's options, and to what the core is made for.
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

/// A bit or a few more or fewer; what is too many or too few is brought into line later.
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

/// Few narrowing points may have other integer bits than they have; others are brought into line
/// later.
fn shift_integer_bits(genome: &mut Genome, draw: &mut Draw) {
    if let Some(point) = any(&mut genome.core.points, draw).cloned() {
        let integer_bits = point.format.integer_bits.saturating_add_signed(draw.one_of(&[-1, 1]));
        genome.core.set_format(point.name, Format { integer_bits, ..point.format });
    }
}

/// Back to the default.
fn forget(genome: &mut Genome, draw: &mut Draw) {
    if let Some(&mut (name, _)) = any(&mut genome.core.formats, draw) {
        genome.core.formats.retain(|(other, _)| *other != name);
    }
}

fn choose(genome: &mut Genome, draw: &mut Draw) {
    let choices = genome.core.method.choices();
    if !choices.is_empty() {
        let choice = draw.one_of(choices);
        genome.core.set_option(choice.key, draw.one_of(choice.values));
    }
}
