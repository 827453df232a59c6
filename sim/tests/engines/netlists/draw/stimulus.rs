//! What goes in.
use specula_datapath::design::Range;
use specula_datapath::{Design, SpanPacket};
use specula_fixtures::Draw;

use crate::netlists::profile::Profile;

/// Spans of random inputs; some inputs stay the same for long.
pub fn packets(draw: &mut Draw, design: &Design, profile: Profile) -> Vec<SpanPacket> {
    let ranges: Vec<Range> = design
        .inputs
        .iter()
        .map(|id| id.map_or(Range::single(0), |id| design.node(id).range))
        .collect();
    let steady: Vec<bool> = ranges.iter().map(|_| draw.below(3) == 0).collect();
    let mut inputs: Vec<i64> = ranges.iter().map(|&range| value(draw, range)).collect();
    let mut packets = vec![];
    for _ in 0..profile.spans {
        for ((input, &range), &steady) in inputs.iter_mut().zip(&ranges).zip(&steady) {
            if !steady || draw.below(10) == 0 {
                *input = value(draw, range);
            }
        }
        packets.push(SpanPacket {
            length: draw.between(1, profile.longest.into()) as u32,
            inputs: inputs.clone(),
        });
    }
    packets
}

fn value(draw: &mut Draw, range: Range) -> i64 {
    match draw.below(6) {
        0 => range.low,
        1 => range.high,
        2 => draw.between(-2, 2).clamp(range.low, range.high),
        _ => draw.between(range.low, range.high),
    }
}
