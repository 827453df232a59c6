//! Specs with every number of fraction bits that may be asked for.
use specula_scene::spec::lyon::{Difference, Normalisation};
use specula_scene::spec::{CoreSpec, HybridSpec, LyonSpec, MethodSpec};

/// Replaces fraction bits and options; each of `draw` is from 0 to 1 and decides one of them.
pub fn spread(core: &mut CoreSpec, draw: &[f64; 8]) {
    let steps_bits = core.longest_span.ilog2();
    match &mut core.method {
        MethodSpec::Lyon(lyon) => spread_lyon(lyon, steps_bits, draw),
        MethodSpec::Hybrid(hybrid) => spread_hybrid(hybrid, steps_bits, draw),
    }
}

fn spread_lyon(lyon: &mut LyonSpec, steps_bits: u32, draw: &[f64; 8]) {
    let f = &mut lyon.formats;
    f.weight.fraction_bits = between(4, 24, draw[0]);
    // Half an ulp for each step must not take the weight past 1 by more than 1/16.
    let coarsest = f.weight.fraction_bits.max(steps_bits + 3);
    f.weight_accumulator.fraction_bits = between(coarsest, 56, draw[1]);
    f.vector.fraction_bits = between(4, 24, draw[2]);
    f.length_squared.fraction_bits = between(4, 24, draw[3]);
    f.gain.fraction_bits = between(4, 24, draw[4]);
    f.diffuse.fraction_bits = between(4, 24, draw[5]);
    f.difference.fraction_bits = between(4, 20, draw[6]);
    f.shape.fraction_bits = between(4, 24, draw[7]);
    // Eight draws decide twelve things: digits further down are as good as draws of their own.
    lyon.newton_steps = between(0, 3, (7.0 * draw[0]).fract());
    lyon.squarings = between(0, 3, (7.0 * draw[1]).fract());
    lyon.normalisation = if draw[2] < 0.5 { Normalisation::G1 } else { Normalisation::G2 };
    lyon.difference = if draw[3] < 0.5 { Difference::HalfwayCrossNormal } else { Difference::ReflectionMinusLight };
}

fn spread_hybrid(hybrid: &mut HybridSpec, steps_bits: u32, draw: &[f64; 8]) {
    let f = &mut hybrid.formats;
    f.diffuse.fraction_bits = between(4, 24, draw[0]);
    // First differences add up to S/2 units of the last place, second ones to S²/4; both must stay well below 1.
    f.diffuse_accumulator.fraction_bits = between(f.diffuse.fraction_bits.max(steps_bits + 3), 56, draw[1]);
    f.operand.fraction_bits = between(4, 24, draw[2]);
    f.accumulator.fraction_bits = between(f.operand.fraction_bits.max(2 * steps_bits + 3), 56, draw[3]);
    f.base.fraction_bits = between(4, 24, draw[4]);
}

fn between(low: u32, high: u32, draw: f64) -> u32 {
    low + (f64::from(high - low) * draw).round() as u32
}
