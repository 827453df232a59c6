//! What a core has to give, without a core.
use specula_golden::fixed::Model;
use specula_sim::SpanSource;
use specula_spec::{CoreSpec, SpanPacket};

use crate::BenchError;

/// The codes that the bit-true model of a core gives for the first `count` spans of a source: red,
/// green and blue of each pixel, in the order in which pixels go in.
///
/// # Errors
/// [`BenchError::Packet`] if the model refuses one of them.
pub fn expected_codes(
    spec: &CoreSpec,
    spans: &dyn SpanSource,
    count: usize,
) -> Result<Vec<[u8; 3]>, BenchError> {
    let (model, mut codes) = (Model::new(spec), vec![]);
    for index in 0..count {
        let mut packet = SpanPacket { length: spans.length(index), inputs: vec![] };
        spans.append_inputs(index, &mut packet.inputs);
        model.shade(&packet, &mut codes)?;
    }
    Ok(codes)
}
