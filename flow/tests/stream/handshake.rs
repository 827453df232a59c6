//! The waveforms of data sheets.
use std::collections::BTreeMap;
use std::fs;

use specula_fixtures::tools;
use specula_flow::stream::{Handshake, Row, Window};
use specula_spec::Method;

use crate::block::{Block, core, frames, shapes};

/// Every value of every clock that a data sheet draws is what Icarus shows of the block, with inputs
/// that hold for a frame and without, a pixel in each clock or in several.
#[test]
fn waveforms_are_what_a_simulator_shows() {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frames = &frames(17)[..1];
    let mut values = 0;
    for method in [Method::Lyon, Method::Gouraud, Method::Phong] {
        for (number, shape) in shapes().into_iter().enumerate() {
            let spec = core(method, frames, number % 2 == 1);
            for spec in [spec.specialised(&frames[0]), spec] {
                let block = Block::new(&spec, frames, shape);
                values += compared(&block);
            }
        }
    }
    assert!(values > 1000, "{values}");
}

/// How many values are drawn, each of which is the simulator's.
fn compared(block: &Block) -> usize {
    let Handshake { packet, pixels, .. } = &block.handshake;
    let shown = simulated(block);
    let mut values = 0;
    for Window { first, rows, .. } in [packet, pixels] {
        for Row { signal, values: drawn, .. } in rows {
            for (clock, value) in (*first..).zip(drawn) {
                let Some(value) = value else { continue };
                assert_eq!(shown[&clock][signal], Some(*value), "{signal} in clock {clock}");
                values += 1;
            }
        }
    }
    values
}

const SIGNALS: [&str; 9] = [
    "s_axis_tdata",
    "s_axis_tvalid",
    "s_axis_tready",
    "s_axis_tlast",
    "m_axis_tdata",
    "m_axis_tvalid",
    "m_axis_tready",
    "m_axis_tuser",
    "m_axis_tlast",
];

/// What Icarus shows of each signal in each clock; `None` of what is unknown.
fn simulated(block: &Block) -> BTreeMap<u32, BTreeMap<&'static str, Option<u64>>> {
    let Handshake { packet, pixels, refused } = &block.handshake;
    // The packet, and the first word of the next one.
    let words: Vec<String> = packet.rows[0].values[..block.words_a_packet as usize]
        .iter()
        .chain(&packet.rows[0].values[..1])
        .map(|word| format!("{:x}", word.expect("it is a word")))
        .collect();
    fs::write(block.path("handshake.hex"), words.join("\n")).expect("it can be written");
    let bench = include_str!("handshake.v");
    fs::write(block.path("handshake.v"), bench).expect("it can be written");
    let writes = fs::read_to_string(block.path("shader_registers.hex")).unwrap_or_default();
    let last = pixels.first as usize + pixels.rows[0].values.len();
    let defines = [
        ("WORDS", words.len()),
        ("WORD", packet.rows[0].bits as usize),
        ("PIXEL", pixels.rows[0].bits as usize),
        ("WRITES", writes.lines().filter(|line| !line.starts_with("//")).count()),
        ("REFUSED", refused[0] as usize),
        ("LAST", last),
    ]
    .map(|(name, value)| format!("-D{name}={value}"));
    let mut arguments = vec!["-g2005", "-s", "handshake", "-o", "handshake.vvp"];
    arguments.extend(defines.iter().map(String::as_str));
    arguments.extend(["handshake.v", "shader.v", "shader_axis.v", "shader_regs.v", "shader_ip.v"]);
    let (compiled, said) = block.run("iverilog", &arguments);
    assert!(compiled, "{said}");
    let (_, said) = block.run("vvp", &["-n", "handshake.vvp"]);
    let line = |line: &str| {
        let mut words = line.split(' ');
        let clock = words.next().and_then(|word| word.parse().ok()).expect("a line has its clock");
        let values = words.map(|word| u64::from_str_radix(word, 16).ok());
        (clock, SIGNALS.into_iter().zip(values).collect())
    };
    said.lines().map(line).collect()
}
