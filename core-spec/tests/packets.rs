//! Packets of a triangle's span, and the page that shows one.
use std::fmt::Write;
use std::fs;

use glam::DVec3;
use specula_fixtures::frames;
use specula_scene::{Frame, Material, Needs, Span};
use specula_spec::{
    CoreSpec, FieldContent, Method, PacketField, PacketLayout, Positions, SpanHeader, WordWidth,
};

/// A triangle whose normals lean to the left, to the right and up, seen along a span of five pixels
/// in row 3 from column 2 on.
fn frame() -> Frame {
    let material =
        Material { ambient: [0.1; 3], diffuse: [0.6, 0.5, 0.4], specular: [0.5; 3], shininess: 16 };
    let lean = |x: f64, y: f64| DVec3::new(x, y, 1.0).normalize();
    let normals = [lean(-0.5, 0.0), lean(0.5, 0.0)];
    let light = DVec3::new(0.0, 0.6, 0.8);
    let mut frame = frames::frame(normals, 5, &[light], material);
    frame.triangles[0].normals = [normals[0], normals[1], lean(0.0, 0.5)];
    frame.spans[0] = Span {
        x: 2,
        y: 3,
        length: 5,
        triangle: 0,
        start: [0.75, 0.0, 0.25],
        end: [0.25, 0.5, 0.25],
    };
    frame
}

/// The bits of a field in the words of a packet, one by one, with the sign of its format.
fn field(words: &[u64], word: WordWidth, field: &PacketField) -> i64 {
    let width = field.format.width();
    let bit = |at: u32| words[(at / word.bits()) as usize] >> (at % word.bits()) & 1;
    let raw = (0..width).map(|i| bit(field.first_bit + i) << i).sum::<u64>() as i64;
    if field.format.signed && raw >> (width - 1) & 1 == 1 { raw - (1 << width) } else { raw }
}

/// The packet of the triangle's span, as the page shows it.
fn example() -> String {
    let frame = frame();
    let spec = CoreSpec::for_scene(&Needs::of(&frame), None, Some(Method::Lyon)).unwrap();
    let layout = PacketLayout::of(&spec, Positions::Sent);
    let inputs = spec.packet(&frame, &frame.spans[0]).inputs;
    let header = SpanHeader { pixels: 5, last: true, position: [2, 3] };
    let words = layout.pack(&header, &inputs, WordWidth::Bits32);
    let mut text = String::new();
    for part in &layout.fields {
        let raw = field(&words, WordWidth::Bits32, part);
        let (low, high) = (part.first_bit, part.first_bit + part.format.width() - 1);
        let value = part.format.in_digits(raw);
        let bits = format!("{low}-{high}");
        let format = part.format.to_string();
        writeln!(text, "{bits:>9}  {:<14} {format:>6} {raw:>7} = {value}", part.name).unwrap();
    }
    text.push('\n');
    for (place, word) in words.iter().enumerate() {
        writeln!(text, "word {place}  0x{word:08x}").unwrap();
    }
    text
}

#[test]
fn the_page_shows_what_is_sent() {
    let page = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/packets.md"));
    let example = example();
    assert!(page.unwrap().contains(&format!("```text\n{example}```\n")), "\n{example}");
}

#[test]
fn every_field_is_found_again() {
    let frame = frame();
    for method in Method::ALL {
        let spec = CoreSpec::for_scene(&Needs::of(&frame), None, Some(method)).unwrap();
        let inputs = spec.packet(&frame, &frame.spans[0]).inputs;
        for positions in [Positions::Absent, Positions::Sent] {
            let layout = PacketLayout::of(&spec, positions);
            let header = SpanHeader { pixels: 5, last: true, position: [2, 3] };
            for word in WordWidth::ALL {
                let words = layout.pack(&header, &inputs, word);
                assert_eq!(words.len() as u32, layout.words(word));
                for part in &layout.fields {
                    let wanted = match part.content {
                        FieldContent::Pixels => 5,
                        FieldContent::Last => 1,
                        FieldContent::Zero => 0,
                        FieldContent::X => 2,
                        FieldContent::Y => 3,
                        FieldContent::Input(number) => inputs[number],
                    };
                    assert_eq!(
                        field(&words, word, part),
                        wanted,
                        "{} {}",
                        method.name(),
                        part.name
                    );
                }
                let used = words.last().unwrap() >> ((layout.bits - 1) % word.bits());
                assert!(used < 2, "what is behind the last field is 0");
            }
        }
    }
}
