//! Packets that are none, and pixels that are wrong.
use std::fs;

use specula_fixtures::tools;
use specula_spec::Method;

use crate::block::{Block, core, frames, shapes};

/// The lines of a file of vectors without its comments.
fn lines(block: &Block, file: &str) -> Vec<String> {
    let text = fs::read_to_string(block.path(file)).expect("the file is there");
    text.lines().filter(|line| !line.starts_with("//")).map(str::to_owned).collect()
}

/// Between packets stand some that end too early, too late, or have no pixels or too many; what
/// belongs to the others is the same, and `status` tells of each.
#[test]
fn malformed_packets_are_told_and_skipped() {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frames = frames(11);
    let spec = core(Method::Gouraud, &frames, false);
    let block = Block::new(&spec, &frames, shapes()[0]);
    let words = block.words_a_packet as usize;
    let longest = spec.parameters.longest_span;
    let mut random = fastrand::Rng::with_seed(7);
    for (kinds, skipped) in [(0..1, 1), (1..2, 2), (2..4, 4), (0..4, 7)] {
        let packets = lines(&block, "shader_packets.hex");
        let mut all: Vec<String> = vec![];
        for (number, packet) in packets.chunks(words).enumerate() {
            // The bit that marks the first word of a frame stays on the frame's own.
            let begins = packet[0].starts_with(['2', '3']);
            let bad = if begins { 0 } else { 1 + random.usize(..2) };
            for _ in 0..if number == 0 { 0 } else { bad } {
                let kind = random.u32(kinds.clone());
                let pixels = match kind {
                    2 => 0,
                    3 => longest + 1,
                    _ => 1 + random.u32(..longest),
                };
                let length = match kind {
                    0 => 1 + random.usize(..words - 1),
                    1 => words + 1 + random.usize(..3),
                    _ => words,
                };
                for place in 0..length {
                    let word = if place == 0 { pixels } else { random.u32(..) };
                    let last = u64::from(place + 1 == length) << 32;
                    all.push(format!("{:09x}", u64::from(word) | last));
                }
            }
            all.extend(packet.iter().cloned());
        }
        fs::write(block.path("shader_packets.hex"), all.join("\n")).expect("it can be written");
        let bench = fs::read_to_string(block.path("shader_tb.v")).expect("it is there");
        let longer = bench.replacen(
            &format!("WORDS = {};", packets.len()),
            &format!("WORDS = {};", all.len()),
            1,
        );
        assert_ne!(longer, bench);
        fs::write(block.path("bad_tb.v"), longer).expect("it can be written");
        let parameter = format!("-Pshader_tb.SKIPPED={skipped}");
        let sources = ["bad_tb.v", "shader.v", "shader_axis.v", "shader_regs.v", "shader_ip.v"];
        let compile =
            [&["-g2001", "-s", "shader_tb", "-o", "bad.vvp", &parameter][..], &sources].concat();
        assert!(block.run("iverilog", &compile).0);
        for seed in 0..3 {
            let (_, said) = block.run("vvp", &["-n", "bad.vvp", &format!("+seed={seed}")]);
            assert!(said.contains("PASS: "), "{skipped} {seed}: {said}");
        }
        fs::write(block.path("shader_packets.hex"), packets.join("\n")).expect("it can be written");
    }
}

/// The bench says which pixel differs, whatever it is that is wrong.
#[test]
fn a_wrong_pixel_is_named() {
    if !["iverilog", "make"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(12);
    let spec = core(Method::Lyon, &frames, false);
    let block = Block::new(&spec, &frames, shapes()[0]);
    let pixels = lines(&block, "shader_pixels.hex");
    for (wrong, bit) in [(5, 0), (9, 23), (12, 24), (20, 40), (31, 56), (0, 57)] {
        let mut changed = pixels.clone();
        let value = u64::from_str_radix(&pixels[wrong], 16).expect("it is a number");
        changed[wrong] = format!("{:015x}", value ^ 1 << bit);
        fs::write(block.path("shader_pixels.hex"), changed.join("\n")).expect("it can be written");
        let (succeeded, said) = block.run("make", &["sim", "SEED=4"]);
        assert!(!succeeded && said.contains(&format!("FAIL: pixel {wrong} is")), "{said}");
    }
}
