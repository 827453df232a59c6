//! Directions that leave a core beside its colours, compared with the bit-true model.
use specula_golden::fixed::{Model, Observation};
use specula_sim::SpanSource;
use specula_spec::{CoreSpec, DirectionOutput, SpanPacket};

use crate::BenchError;

/// A component of a direction that is not the model's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrongDirection {
    /// The output's name.
    pub output: String,
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in it.
    pub pixel: u32,
    /// The model's raw value.
    pub expected: i64,
    /// The core's.
    pub simulated: Option<i64>,
}

impl WrongDirection {
    /// What it is, as text.
    pub fn in_words(&self) -> String {
        let WrongDirection { output, span, pixel, expected, simulated } = self;
        let simulated = simulated.map_or("missing".to_owned(), |raw| raw.to_string());
        format!("{output} is {simulated}, expected {expected} (span {span}, pixel {pixel})")
    }
}

/// Names of the ports of directions, in their order.
fn port_names(outputs: &[DirectionOutput]) -> Vec<String> {
    let components =
        |output: &DirectionOutput| ["x", "y", "z"].map(|axis| format!("{}_{axis}", output.name));
    outputs.iter().flat_map(components).collect()
}

/// The first component in which what a core gives, raw values pixel by pixel and port by port,
/// differs from the model.
///
/// # Errors
/// [`BenchError::Packet`] if the model refuses a span's packet.
pub(crate) fn first_wrong(
    spec: &CoreSpec,
    spans: &dyn SpanSource,
    given: &[i64],
) -> Result<Option<WrongDirection>, BenchError> {
    let ports = port_names(spec.direction_outputs());
    if ports.is_empty() {
        return Ok(None);
    }
    let (model, mut given) = (Model::new(spec), given.iter().copied());
    for span in 0..spans.count() {
        let mut packet = SpanPacket { length: spans.length(span), inputs: vec![] };
        spans.append_inputs(span, &mut packet.inputs);
        for pixel in 0..packet.length {
            let trace = model.trace(&packet, pixel)?;
            for port in &ports {
                // The model has a value of each direction's name.
                let expected = Observation::named(&trace, port).map_or(0, |value| value.raw);
                let simulated = given.next();
                if simulated != Some(expected) {
                    let output = port.clone();
                    return Ok(Some(WrongDirection { output, span, pixel, expected, simulated }));
                }
            }
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use specula_scene::{Needs, load};
    use specula_spec::consistent::Directions;
    use specula_spec::{Method, MethodSpec};

    use super::*;
    use crate::spans::FrameSpans;

    /// A component that is off by one is found where it is, and so is one that is missing.
    #[test]
    fn the_first_wrong_component_is_found() {
        let frame = load("icosahedron", Some((16, 12))).unwrap().frame;
        let mut spec =
            CoreSpec::for_scene(&Needs::of(&frame), None, Some(Method::Consistent)).unwrap();
        if let MethodSpec::Consistent(consistent) = &mut spec.method {
            consistent.directions = Directions::Both;
        }
        let spans = FrameSpans::new(&frame, &spec);
        let missing = first_wrong(&spec, &spans, &[]).unwrap().unwrap();
        assert_eq!((missing.output.as_str(), missing.span, missing.pixel), ("reflection_x", 0, 0));
        assert_eq!(missing.simulated, None);

        let model = Model::new(&spec);
        let mut right = vec![];
        for span in 0..spans.count() {
            let mut packet = SpanPacket { length: spans.length(span), inputs: vec![] };
            spans.append_inputs(span, &mut packet.inputs);
            for pixel in 0..packet.length {
                let trace = model.trace(&packet, pixel).unwrap();
                let raw = |name: &String| Observation::named(&trace, name).unwrap().raw;
                right.extend(port_names(spec.direction_outputs()).iter().map(raw));
            }
        }
        assert_eq!(first_wrong(&spec, &spans, &right).unwrap(), None);
        right[6 + 4] += 1;
        let wrong = first_wrong(&spec, &spans, &right).unwrap().unwrap();
        assert_eq!(wrong.output, "consistent_normal_y");
        assert_eq!(wrong.simulated, Some(wrong.expected + 1));
    }
}
