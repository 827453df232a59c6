//! Reflections of the eye's rays that enter the surface, pixel by pixel of a picture.
use rayon::prelude::*;
use specula_golden::exact::PhongSpan;
use specula_golden::exact::formula::reflection::reflect;
use specula_golden::fixed::Model;
use specula_scene::frame::EYE;
use specula_scene::mesh::normals::newell;
use specula_scene::{Frame, Needs, Span};
use specula_spec::{CoreSpec, Method, SetUp};

use super::super::span_core::vector;
use specula_testbench::{BenchError, Image};

/// The colour of pixels whose reflection enters the surface.
const MARK: [u8; 3] = [255, 0, 200];

/// A picture drawn with Phong's normals, and by the core with consistent ones.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedPictures {
    /// The exact picture with Phong's normals; pixels whose reflection enters are marked.
    pub phong: Image,
    /// The core's picture; pixels whose reflection enters are marked.
    pub consistent: Image,
    /// Number of pixels shaded.
    pub pixels: usize,
    /// Number of marked pixels in each picture.
    pub inward: [usize; 2],
}

/// A pixel of both pictures.
struct Pixel {
    shades: [[u8; 3]; 2],
    enters: [bool; 2],
}

/// Traces the core on every pixel of a frame.
///
/// # Errors
/// [`BenchError`] if no core can be built for the frame.
pub fn marked_pictures(frame: &Frame) -> Result<MarkedPictures, BenchError> {
    let spec = CoreSpec::for_scene(&Needs::of(frame), None, Some(Method::Consistent))?;
    let (model, set_up) = (Model::new(&spec), SetUp::new(&spec, frame));
    let of_span = |span: &Span| pixels(frame, span, &model, &set_up);
    let spans: Vec<Vec<Pixel>> = frame.spans.par_iter().map(of_span).collect::<Result<_, _>>()?;
    let blank = Image::filled(frame.width, frame.height, frame.background);
    let mut seen =
        MarkedPictures { phong: blank.clone(), consistent: blank, pixels: 0, inward: [0; 2] };
    for (span, pixels) in frame.spans.iter().zip(spans) {
        seen.add(span, &pixels);
    }
    Ok(seen)
}

fn pixels(
    frame: &Frame,
    span: &Span,
    model: &Model,
    set_up: &SetUp,
) -> Result<Vec<Pixel>, BenchError> {
    let packet = set_up.packet(span);
    let mut codes = vec![];
    model.shade(&packet, &mut codes)?;
    let exact = PhongSpan::new(frame, span);
    let face = newell(&frame.triangles[span.triangle].positions).map(|face| face * face.z.signum());
    let pixel = |(i, &code): (u32, &[u8; 3])| {
        let normal = frame.normal_at(span, span.weights(i)).normalize_or(EYE);
        let by_core = vector(&model.trace(&packet, i)?, "reflection").unwrap_or(EYE);
        let enters = |r: glam::DVec3| face.is_some_and(|face| r.dot(face) < 0.0);
        let phong = exact.pixel(i).map(|shade| shade.round() as u8);
        Ok(Pixel { shades: [phong, code], enters: [enters(reflect(normal)), enters(by_core)] })
    };
    (0..).zip(&codes).map(pixel).collect()
}

impl MarkedPictures {
    fn add(&mut self, span: &Span, pixels: &[Pixel]) {
        self.pixels += pixels.len();
        for (k, image) in [&mut self.phong, &mut self.consistent].into_iter().enumerate() {
            for (to, pixel) in image.run_mut(span).iter_mut().zip(pixels) {
                *to = if pixel.enters[k] { MARK } else { pixel.shades[k] };
            }
            self.inward[k] += pixels.iter().filter(|pixel| pixel.enters[k]).count();
        }
    }
}
