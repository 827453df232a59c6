//! The span packet, bit by bit.
use std::fmt::Write;

use specula_spec::FieldContent;

use super::StreamCore;
use super::extent::extent;

/// A table with a row for each field: where it stands, what it is, and how a host computes it.
pub fn packet_table(core: &StreamCore) -> String {
    let word = core.word.bits();
    let mut text = "\
| bits | word: bits | field | format | values | unit | what it is | how a host computes it |
|---|---|---|---|---|---|---|---|
"
    .to_owned();
    let (meanings, ports) = (core.spec.input_meanings(), core.spec.inputs());
    let longest = core.spec.parameters.longest_span;
    for field in &core.layout.fields {
        let (low, high) = (field.first_bit, field.first_bit + field.format.width() - 1);
        let range = |low: u32, high: u32| {
            if low == high { low.to_string() } else { format!("{low}-{high}") }
        };
        let place = match (low / word, high / word) {
            (first, last) if first == last => {
                format!("{first}: {}", range(low % word, high % word))
            }
            (first, last) => {
                let end = range(0, high % word);
                format!("{first}: {} to {last}: {end}", range(low % word, word - 1))
            }
        };
        let (unit, what, computed) = match field.content {
            FieldContent::Pixels => ("pixels", "length of the span".into(), "at least 1".into()),
            FieldContent::Last => ("", "1 in the last span of a frame, else 0".into(), "".into()),
            FieldContent::Zero => ("", "0".into(), "".into()),
            FieldContent::X => ("pixels", "column of the first pixel".into(), "".into()),
            FieldContent::Y => ("pixels", "row of the span".into(), "".into()),
            FieldContent::Input(number) => {
                let meaning = &meanings[number];
                (meaning.unit, meaning.what.clone(), meaning.computed.clone())
            }
        };
        let values = match field.content {
            FieldContent::Input(number) => extent(&ports[number]),
            FieldContent::Pixels => format!("1 to {longest}"),
            FieldContent::Last => "0, 1".to_owned(),
            FieldContent::Zero => "0".to_owned(),
            FieldContent::X | FieldContent::Y => "0 to 65535".to_owned(),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "| {} | {place} | `{}` | {} | {values} | {unit} | {what} | {computed} |",
            range(low, high),
            field.name,
            field.format
        );
    }
    text
}
