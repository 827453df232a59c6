//! DP16KD: contents, latencies, writes, enables and resets.
use std::fmt::Write;

use crate::bench::{Device, bits, refusal};

/// Words of 18 bits.
const WORDS: usize = 1024;

/// What a block of random contents holds, and the parameters that say so.
fn contents(seed: u64) -> (Vec<u64>, String) {
    let mut random = fastrand::Rng::with_seed(seed);
    let words: Vec<u64> = (0..WORDS).map(|_| random.u64(..1 << 18)).collect();
    let mut parameters = String::new();
    for (place, words) in words.chunks(16).enumerate() {
        let hex: String = words.iter().rev().map(|word| format!("{word:05x}")).collect();
        let _ = write!(parameters, ".INITVAL_{place:02X}(320'h{hex}), ");
    }
    (words, parameters)
}

/// Read-only memories of all widths, with an output register and without.
#[test]
fn words_are_read_one_clock_later_or_two() {
    let (words, parameters) = contents(1);
    let mut instances = String::new();
    for (number, width) in [9, 18, 36, 9, 18, 36].into_iter().enumerate() {
        let mode = if number < 3 { "NOREG" } else { "OUTREG" };
        let low = bits("DOA", &format!("out_{number}"), width.min(18));
        let high = bits("DOB", &format!("high_{number}"), 18);
        let _ = writeln!(
            instances,
            "  wire [{}:0] out_{number};\n  wire [17:0] high_{number};\n  DP16KD #({parameters}\
             .DATA_WIDTH_A({width}), .DATA_WIDTH_B({width}), .REGMODE_A(\"{mode}\"), \
             .REGMODE_B(\"{mode}\")) block_{number} ({low}{high}{}{}.CLKA(clock), .CLKB(clock), \
             .CEA(1'b1), .CEB(1'b1), .OCEA(1'b1), .OCEB(1'b1), .WEA(1'b0), .WEB(1'b0), \
             .RSTA(1'b0), .RSTB(1'b0), .CSA0(1'b0), .CSA1(1'b0), .CSA2(1'b0), .CSB0(1'b0), \
             .CSB1(1'b0), .CSB2(1'b0));",
            width - 1,
            bits("ADA", "address", 14),
            bits("ADB", "address", 14),
        );
        if width == 36 {
            let _ = writeln!(instances, "  assign out_{number}[35:18] = high_{number};");
        }
    }
    let device = Device { model: "DP16KD.v", inputs: &[("address", 14)], instances, outputs: 6 };
    // Every byte of nine bits, twice, and in no order.
    let mut random = fastrand::Rng::with_seed(2);
    let mut addresses: Vec<u64> = (0..4096).map(|k| 8 * (k % 2048)).collect();
    random.shuffle(&mut addresses);
    let lines: Vec<Vec<u64>> = addresses.iter().map(|&address| vec![address]).collect();
    let Some(found) = device.run(&lines) else { return };
    let at = |address: u64| {
        let word = words[(address >> 4) as usize];
        let pair = (address >> 5 << 1) as usize;
        [word >> (9 * (address >> 3 & 1)) & 0x1ff, word, words[pair] | words[pair + 1] << 18]
    };
    for clock in 2..addresses.len() {
        let expected = [at(addresses[clock - 1]), at(addresses[clock - 2])].concat();
        assert_eq!(found[clock], expected, "clock {clock}");
    }
}

/// Two ports of one memory: A writes and reads, B reads.
struct Memory {
    words: Vec<u64>,
    /// What A and B have read, and what their output registers hold.
    read: [u64; 2],
    held: [u64; 2],
    /// Whether A reads what it overwrites.
    reads_first: bool,
}

impl Memory {
    /// A clock: what is shown before its edge.
    fn step(&mut self, line: &[u64]) -> Vec<u64> {
        let &[address_a, address_b, data, write, enables, resets] = line else { unreachable!() };
        let shown = vec![self.read[0], self.held[1]];
        let [a, b] = [address_a, address_b].map(|address| (address >> 4) as usize);
        let [old_a, old_b] = [self.words[a], self.words[b]];
        let is = |bits: u64, port: usize| bits >> port & 1 == 1;
        self.held = [0, 1].map(|p| if is(resets, p) { 0 } else { self.read[p] });
        if is(resets, 0) {
            self.read[0] = 0;
        } else if is(enables, 0) {
            if write == 0 || self.reads_first {
                self.read[0] = old_a;
            }
            let low = if write == 1 && address_a & 1 == 1 { 0x1ff } else { 0 };
            let high = if write == 1 && address_a & 2 == 2 { 0x3fe00 } else { 0 };
            self.words[a] = old_a & !(low | high) | data & (low | high);
        }
        if is(resets, 1) {
            self.read[1] = 0;
        } else if is(enables, 1) {
            self.read[1] = old_b;
        }
        shown
    }
}

#[test]
fn ports_write_bytes_and_wait_for_their_enables() {
    let (words, parameters) = contents(3);
    for reads_first in [false, true] {
        let mode = if reads_first { "READBEFOREWRITE" } else { "NORMAL" };
        let instances = format!(
            "  wire [17:0] out_0, out_1;\n  DP16KD #({parameters}.REGMODE_B(\"OUTREG\"), \
             .WRITEMODE_A(\"{mode}\")) block ({}{}{}{}{}.CLKA(clock), .CLKB(clock), \
             .CEA(enables[0]), .CEB(enables[1]), .OCEA(1'b1), .OCEB(1'b1), .WEA(write), \
             .WEB(1'b0), .RSTA(resets[0]), .RSTB(resets[1]), .CSA0(1'b0), .CSA1(1'b0), \
             .CSA2(1'b0), .CSB0(1'b0), .CSB1(1'b0), .CSB2(1'b0));",
            bits("ADA", "address_a", 14),
            bits("ADB", "address_b", 14),
            bits("DIA", "data", 18),
            bits("DOA", "out_0", 18),
            bits("DOB", "out_1", 18),
        );
        let inputs = [
            ("address_a", 14),
            ("address_b", 14),
            ("data", 18),
            ("write", 1),
            ("enables", 2),
            ("resets", 2),
        ];
        let device = Device { model: "DP16KD.v", inputs: &inputs, instances, outputs: 2 };
        let mut random = fastrand::Rng::with_seed(4);
        // Few words, so that ports meet.
        let lines: Vec<Vec<u64>> = (0..4000)
            .map(|_| {
                let mut address = || random.u64(..8) << 4 | random.u64(..4);
                let [a, b] = [address(), address()];
                let resets = if random.u8(..8) == 0 { random.u64(..4) } else { 0 };
                let data = random.u64(..1 << 18);
                vec![a, b, data, random.u64(..2), random.u64(..4), resets]
            })
            .collect();
        let Some(found) = device.run(&lines) else { return };
        let mut memory = Memory { words: words.clone(), read: [0; 2], held: [0; 2], reads_first };
        for (clock, (line, found)) in lines.iter().zip(found).enumerate() {
            assert_eq!(found, memory.step(line), "clock {clock}, {mode}");
        }
    }
}

#[test]
fn what_is_not_modelled_is_refused() {
    let cases = [
        (".DATA_WIDTH_A(4)", "DP16KD: DATA_WIDTH_A = 4 is not modelled\n"),
        (".WRITEMODE_B(\"WRITETHROUGH\")", "DP16KD: WRITEMODE_B = WRITETHROUGH is not modelled\n"),
        (".CSDECODE_A(\"0b001\")", "DP16KD: CSDECODE_A = 0b001 is not modelled\n"),
        (".REGMODE_A(\"IN\")", "DP16KD: REGMODE_A = IN is not modelled\n"),
    ];
    for (parameters, expected) in cases {
        let Some(said) = refusal("DP16KD", parameters) else { return };
        assert_eq!(said, expected, "{parameters}");
    }
}
