//! The times at which something happens, read one by one without being stored.
use std::io::{self, BufReader, Read, Seek, SeekFrom};

use flate2::read::ZlibDecoder;

use super::check::ValueBlock;
use super::error::wrong;
use super::integer::variable;

/// Calls back with the times of a block, in order.
///
/// # Errors
/// An error that says what is wrong with the times, or the operating system's error.
pub fn read(
    input: &mut (impl Read + Seek),
    block: &ValueBlock,
    mut take: impl FnMut(u64),
) -> io::Result<()> {
    let (at, packed, unpacked) = block.times;
    input.seek(SeekFrom::Start(at))?;
    let input = input.take(packed);
    // Where compression does not make a table shorter, the writer stores it uncompressed.
    let input: Box<dyn Read + '_> =
        if packed == unpacked { Box::new(input) } else { Box::new(ZlibDecoder::new(input)) };
    let mut input = BufReader::new(input);
    let mut time = 0u64;
    for _ in 0..block.instants {
        let delta = variable(&mut input).map_err(|_| wrong("its times cannot be read"))?;
        time = time.saturating_add(delta);
        take(time);
    }
    Ok(())
}
