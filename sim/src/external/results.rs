//! Values of ports that come back: for each clock one little-endian 64-bit number for each watched
//! port.
use std::io::{BufReader, ErrorKind, Read};
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::{NodeId, wrapped};

use super::batches::Batches;
use crate::{Batch, Flow, SimError};

/// Reads the `watched` ports of `clocks` and hands them to `sink` in batches.
///
/// # Errors
/// [`SimError::File`] if reading fails, [`SimError::TooFewClocks`] if the file of `tool` ends too
/// early.
pub fn read_results(
    file: impl Read,
    tool: &'static str,
    design: &Design,
    watched: &[NodeId],
    clocks: Range<u64>,
    sink: &mut dyn FnMut(&Batch) -> Flow,
) -> Result<(), SimError> {
    let shapes: Vec<(u32, bool)> =
        watched.iter().map(|&n| (design.node(n).width(), design.node(n).range.signed())).collect();
    let mut file = BufReader::new(file);
    let mut row = vec![0; 8 * watched.len()];
    let mut batches = Batches::new(watched, clocks.start, sink);
    while batches.clock() < clocks.end {
        match file.read_exact(&mut row) {
            Err(error) if error.kind() == ErrorKind::UnexpectedEof => break,
            other => other.map_err(SimError::file("read a simulator's results"))?,
        }
        let values = row
            .chunks_exact(8)
            .zip(&shapes)
            .map(|(bytes, &(width, signed))| wrapped(number(bytes), width, signed));
        if batches.push(values) == Flow::Stop {
            break;
        }
    }
    batches.finish(clocks.end, tool)
}

fn number(little_endian: &[u8]) -> i64 {
    little_endian.iter().rev().fold(0, |number, &byte| number << 8 | i64::from(byte))
}
