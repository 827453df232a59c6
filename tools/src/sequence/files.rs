//! The table of all frames as a file.
use std::fmt::Write;

use super::{ShadedFrame, ShadedSequence};

/// Name of the file.
pub const TABLE: &str = "frames.csv";

/// Every frame in a line: counts, and errors in LSBs of the 8-bit output.
pub fn table(sequence: &ShadedSequence) -> String {
    let mut text = "frame,spans,pixels,cycles,mismatches,agrees,worst_x,worst_y,total_max_lsb,\
                    total_rms_lsb,method_max_lsb,quantisation_max_lsb\n"
        .to_owned();
    for frame in &sequence.by_frame {
        let ShadedFrame { frame, spans, pixels, cycles, mismatches, agrees, worst_pixel, error } =
            frame;
        let [x, y] = worst_pixel.map_or(Default::default(), |place| place.map(|p| p.to_string()));
        let (total, method) = (&error.total, &error.method);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{frame},{spans},{pixels},{cycles},{mismatches},{agrees},{x},{y},{},{},{},{}",
            total.max_lsb, total.rms_lsb, method.max_lsb, error.quantisation.max_lsb
        );
    }
    text
}
