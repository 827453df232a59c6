//! What goes into a block for a frame, and what has to come out.
use specula_flow::stream::FrameVectors;
use specula_testbench::{FrameSpans, expected_codes};

use crate::error::ToolError;
use crate::job::Job;

/// The packets of the first spans of a job's frame, `most` of them, and the pixels that its bit-true
/// model gives for them.
///
/// # Errors
/// [`ToolError::NoVectors`] if the frame has no spans, [`ToolError::Bench`] if the model refuses a
/// span's set-up.
pub fn frame_vectors(job: &Job, most: usize) -> Result<FrameVectors, ToolError> {
    let frame = &job.scene.frame;
    let spans = FrameSpans::new(frame, job.spec());
    let count = frame.spans.len().min(most);
    if count == 0 {
        return Err(ToolError::NoVectors { scene: job.scene.name.clone() });
    }
    let codes = expected_codes(job.spec(), &spans, count)?;
    Ok(FrameVectors::new(&frame.spans[..count], &spans, &codes))
}
