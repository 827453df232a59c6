//! Pictures that cores draw.
use specula_scene::{Frame, Needs};
use specula_spec::{CoreSpec, Method};
use specula_testbench::{Bench, BenchError, EngineKind, ErrorFigures, Image};

/// A picture that a core drew.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub image: Image,
    /// Its errors against exact Phong shading.
    pub error: ErrorFigures,
}

/// Draws a frame with a method's core made for it, with these keys of the `[core]` table.
///
/// # Errors
/// [`BenchError`] if a core cannot be built for the frame, or does not agree with its model.
pub fn drawn(frame: &Frame, method: Method, options: &str) -> Result<Drawn, BenchError> {
    let spec = CoreSpec::for_scene(&Needs::of(frame), Some(&options.parse()?), Some(method))?
        .specialised(frame);
    let outcome = Bench::new(frame, &spec, "core")?.run(EngineKind::Fast, &mut |_, _| ())?;
    Ok(Drawn { image: outcome.simulated, error: outcome.comparison.errors.total })
}
