//! The methods without rounding, a file each, and the one that a spec selects.
mod attenuated;
mod coefficients;
pub mod consistent;
mod direct;
mod directions;
mod duff;
mod gouraud;
mod hybrid;
mod lyon;
mod phong;
pub mod reflection;
mod shade_span;
mod slerp;

use specula_scene::{Frame, ParallelSpan, Span};
use specula_spec::{CoreSpec, MethodSpec, Viewpoint};

use attenuated::Attenuated;
use shade_span::ShadeSpan;

pub use consistent::ConsistentSpan;
pub use direct::DirectSpan;
pub use duff::DuffSpan;
pub use gouraud::GouraudSpan;
pub use hybrid::HybridSpan;
pub use lyon::LyonSpan;
pub use phong::PhongSpan;
pub use reflection::ReflectionSpan;
pub use slerp::SlerpSpan;

/// One span, shaded by a spec's method.
pub struct MethodSpan<'a>(Box<dyn ShadeSpan + 'a>);

impl<'a> MethodSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a CoreSpec, frame: &'a Frame, span: &'a Span) -> Self {
        if let Some(attenuated) = Attenuated::new(spec, frame, span) {
            return MethodSpan(Box::new(attenuated));
        }
        if spec.places_seen_from() == Viewpoint::Span && !frame.directions_are_constant() {
            return MethodSpan(Box::new(Shaded::from_the_middle(spec, frame, span)));
        }
        let has_ways = |spec: &CoreSpec| spec.places_seen_from() == Viewpoint::Pixel;
        let sees_for_itself = matches!(
            spec.method,
            MethodSpec::Phong(_) | MethodSpec::Hybrid(_) | MethodSpec::Lyon(_)
        );
        if has_ways(spec) && !sees_for_itself && !frame.directions_are_constant() {
            return MethodSpan(Box::new(FromEveryPixel { spec, frame, span }));
        }
        MethodSpan(match &spec.method {
            MethodSpec::Lyon(lyon) => Box::new(LyonSpan::new(lyon, frame, span)),
            MethodSpec::Phong(phong) => Box::new(PhongSpan::of_spec(phong, frame, span)),
            MethodSpec::Hybrid(_) => Box::new(HybridSpan::new(frame, span)),
            MethodSpec::Duff(duff) => Box::new(DuffSpan::new(duff, frame, span)),
            MethodSpec::Gouraud(gouraud) => Box::new(GouraudSpan::new(gouraud, frame, span)),
            MethodSpec::Reflection(reflection) => {
                Box::new(ReflectionSpan::new(reflection, frame, span))
            }
            MethodSpec::Consistent(consistent) => {
                Box::new(ConsistentSpan::new(consistent, frame, span))
            }
            MethodSpec::Slerp(slerp) => Box::new(SlerpSpan::new(slerp, frame, span)),
            MethodSpec::Direct(direct) => Box::new(DirectSpan::new(direct, frame, span)),
        })
    }

    /// Pixel `i`, from 0 to length - 1: 0..=255 LSB a channel.
    pub fn pixel(&self, i: u32) -> [f64; 3] {
        self.0.pixel(i)
    }

    /// Shades as many pixels as `out` has, from the span's first pixel on: 0..=255 LSB a channel.
    pub fn shade(&self, out: &mut [[f64; 3]]) {
        self.0.shade(out);
    }
}

/// A span under directions to lights and eye that every pixel sees for itself, as if they were at
/// infinity: everything is turned until the eye is where a method has it.
struct FromEveryPixel<'a> {
    spec: &'a CoreSpec,
    frame: &'a Frame,
    span: &'a Span,
}

impl ShadeSpan for FromEveryPixel<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let FromEveryPixel { spec, frame, span } = *self;
        let parallel = ParallelSpan::seen_from(frame, span, span.weights(i));
        MethodSpan::new(spec, &parallel.frame, parallel.span()).pixel(i)
    }
}

/// The pixels of a span, computed beforehand.
struct Shaded(Vec<[f64; 3]>);

impl Shaded {
    /// Shades a span with the directions to lights and eye that its middle sees, as if they were at
    /// infinity.
    fn from_the_middle(spec: &CoreSpec, frame: &Frame, span: &Span) -> Shaded {
        let parallel = ParallelSpan::new(frame, span);
        let mut shades = vec![[0.0; 3]; span.length as usize];
        MethodSpan::new(spec, &parallel.frame, parallel.span()).shade(&mut shades);
        Shaded(shades)
    }
}

impl ShadeSpan for Shaded {
    fn pixel(&self, i: u32) -> [f64; 3] {
        self.0[i as usize]
    }
}
