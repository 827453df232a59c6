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
        let own = |values: &str, unit, what: &str, computed: &str| {
            (values.to_owned(), unit, what.to_owned(), computed.to_owned())
        };
        let (values, unit, what, computed) = match field.content {
            FieldContent::Pixels => {
                own(&format!("1 to {longest}"), "pixels", "length of the span", "at least 1")
            }
            FieldContent::Last => own("0, 1", "", "1 in the last span of a frame, else 0", ""),
            FieldContent::Zero => own("0", "", "0", ""),
            FieldContent::X => own("0 to 65535", "pixels", "column of the first pixel", ""),
            FieldContent::Y => own("0 to 65535", "pixels", "row of the span", ""),
            FieldContent::Input(number) => {
                let meaning = &meanings[number];
                own(&extent(&ports[number]), meaning.unit, &meaning.what, &meaning.computed)
            }
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
