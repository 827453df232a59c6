//! Differences between two shadings of a frame in f64.
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_scene::{Frame, Span};
use specula_spec::CoreSpec;
use specula_testbench::ErrorFigures;
use specula_testbench::statistics::Sums;

/// The pixels of a span, in LSBs.
pub type Shades = Vec<[f64; 3]>;

/// The figures of what the second shading of every span is more than the first.
pub fn differences(frame: &Frame, shades: impl Fn(&Span) -> [Shades; 2] + Sync) -> ErrorFigures {
    let of_span = |span: &Span| {
        let [first, second] = shades(span);
        let mut sums = Sums::default();
        let channels = first.iter().flatten().zip(second.iter().flatten());
        channels.for_each(|(first, second)| sums.add(second - first));
        sums
    };
    Sums::of_spans(frame, of_span).figures()
}

/// A span by exact Phong shading.
pub fn exact(frame: &Frame, span: &Span) -> Shades {
    let phong = PhongSpan::new(frame, span);
    (0..span.length).map(|i| phong.pixel(i)).collect()
}

/// A span by a core's method in exact arithmetic.
pub fn by_method(spec: &CoreSpec, frame: &Frame, span: &Span) -> Shades {
    let mut shades = vec![[0.0; 3]; span.length as usize];
    MethodSpan::new(spec, frame, span).shade(&mut shades);
    shades
}
