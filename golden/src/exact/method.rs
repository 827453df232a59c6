//! The method that a spec names.
use specula_scene::{Frame, ParallelSpan, Span};
use specula_spec::{CoreSpec, MethodSpec, Viewpoint};

use super::{
    ConsistentSpan, DirectSpan, DuffSpan, GouraudSpan, HybridSpan, LyonSpan, PhongSpan,
    ReflectionSpan, SlerpSpan,
};

/// One span, shaded by a spec's method.
pub struct MethodSpan<'a>(Box<dyn ShadeSpan + 'a>);

/// Shades one span.
pub(super) trait ShadeSpan {
    /// Pixel `i`, 0 to length - 1: 0..=255 LSB a channel.
    fn pixel(&self, i: u32) -> [f64; 3];

    /// As many pixels as `out` has, the span's first pixel first: one virtual call for all of them.
    fn shade(&self, out: &mut [[f64; 3]]) {
        for (shade, i) in out.iter_mut().zip(0..) {
            *shade = self.pixel(i);
        }
    }
}

impl<'a> MethodSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a CoreSpec, frame: &'a Frame, span: &'a Span) -> Self {
        if spec.places_seen_from() == Viewpoint::Span && !frame.directions_are_constant() {
            return MethodSpan(Box::new(Shaded::from_the_middle(spec, frame, span)));
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

    /// Pixel `i`, 0 to length - 1: 0..=255 LSB a channel.
    pub fn pixel(&self, i: u32) -> [f64; 3] {
        self.0.pixel(i)
    }

    /// As many pixels as `out` has, the span's first pixel first: 0..=255 LSB a channel.
    pub fn shade(&self, out: &mut [[f64; 3]]) {
        self.0.shade(out);
    }
}

/// The pixels of a span.
struct Shaded(Vec<[f64; 3]>);

impl Shaded {
    /// Under lights and an eye at infinity, where the span's middle sees them.
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
