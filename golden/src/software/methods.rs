//! The methods by name.
use specula_scene::{Frame, Span};

use super::{Loop, PlacedLoop, SetUp, Software};
use crate::exact::{slerp, wrap};
use crate::recurrence::{
    Blinn, Chained, Chebyshev, Consistent, ConsistentNormal, Direct, DuffBlinn, DuffHybrid, DuffQuotient, DuffRoot, FastPhong,
    Frame as SlerpFrame, Gouraud, Half, HalfG2, Hybrid, Line, LyonCross, LyonLightReflection, LyonNormal, LyonProjection,
    LyonReflection, Normalised, Phong, Place, Rational, ReflectionBlinn, ReflectionHybrid, ReflectionRoot, Scheme, Slerp, Sum,
    TorranceSparrow, Trigonometric, TrowbridgeReitz, Uniform, Unit, Wrapped,
};

/// A method of METHODS.md in software.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name.
    pub name: &'static str,
    /// Sets a span up.
    pub set_up: SetUp,
}

/// Every method.
pub const METHODS: [Method; 38] = [
    method::<Uniform<f32>>("uniform"),
    method::<Gouraud<f32>>("gouraud"),
    method::<Phong<f32>>("phong"),
    method::<Blinn<f32>>("phong-blinn"),
    method::<TorranceSparrow<f32>>("phong-torrance-sparrow"),
    method::<TrowbridgeReitz<f32>>("phong-trowbridge-reitz"),
    Method { name: "phong-places", set_up: placed::<Normalised<f32>> },
    Method { name: "phong-wrapped-places", set_up: placed::<Wrapped<f32>> },
    method::<FastPhong<f32, 1>>("fast-phong"),
    method::<FastPhong<f32, 2>>("fast-phong-2"),
    Method { name: "slerp", set_up: arc::<Slerp<f32>> },
    Method { name: "slerp-frame", set_up: arc::<SlerpFrame<f32>> },
    Method { name: "chebyshev", set_up: arc::<Chebyshev<f32>> },
    method::<LyonCross<f32>>("lyon"),
    method::<LyonReflection<f32, 2>>("lyon-reflection"),
    method::<LyonReflection<f32, 1>>("lyon-reflection-1"),
    method::<LyonReflection<f32, 0>>("lyon-reflection-0"),
    method::<LyonLightReflection<f32>>("lyon-light-reflection"),
    method::<LyonProjection<f32, Sum, 2>>("lyon-projection"),
    method::<LyonProjection<f32, Unit, 2>>("lyon-unit-projection"),
    method::<LyonProjection<f32, Half, 2>>("lyon-half-projection"),
    method::<LyonProjection<f32, HalfG2, 2>>("lyon-half-g2-projection"),
    method::<LyonProjection<f32, HalfG2, 1>>("lyon-half-g2-projection-1"),
    method::<LyonNormal<f32, Unit>>("lyon-unit-normal"),
    method::<LyonNormal<f32, HalfG2>>("lyon-half-g2-normal"),
    method::<DuffRoot<f32>>("duff"),
    method::<DuffBlinn<f32>>("duff-blinn"),
    method::<DuffHybrid<f32>>("duff-hybrid"),
    method::<DuffQuotient<f32>>("duff-quotient"),
    method::<Direct<f32>>("direct"),
    method::<Hybrid<f32>>("hybrid"),
    Method { name: "reflection", set_up: wrapped::<ReflectionRoot<f32>> },
    Method { name: "reflection-blinn", set_up: wrapped::<ReflectionBlinn<f32>> },
    Method { name: "reflection-hybrid", set_up: wrapped::<ReflectionHybrid<f32>> },
    method::<Chained<f32>>("reflection-chained"),
    method::<Consistent<f32, Rational>>("consistent"),
    method::<Consistent<f32, Trigonometric>>("consistent-trigonometric"),
    method::<ConsistentNormal<f32, Rational>>("consistent-normal"),
];

/// The method of that name.
pub fn by_name(name: &str) -> Option<Method> {
    METHODS.into_iter().find(|method| method.name == name)
}

const fn method<S: Scheme<f32> + 'static>(name: &'static str) -> Method {
    Method { name, set_up: looped::<S> }
}

fn looped<S: Scheme<f32> + 'static>(frame: &Frame, span: &Span) -> Box<dyn Software> {
    Box::new(Loop::<S>::new(frame, span))
}

fn placed<P: Place<f32> + 'static>(frame: &Frame, span: &Span) -> Box<dyn Software> {
    Box::new(PlacedLoop::<P>::new(frame, span))
}

/// An arc where slerp serves the span's end normals, Phong's chord elsewhere (EXTREMES rows 13 to 15).
fn arc<S: Scheme<f32> + 'static>(frame: &Frame, span: &Span) -> Box<dyn Software> {
    let serves = slerp::angle(Line::new(frame, span).unit_ends()).is_some();
    if serves { looped::<S>(frame, span) } else { looped::<Phong<f32>>(frame, span) }
}

/// A wrap where the face's normal serves the span's triangle, Phong elsewhere (EXTREMES row 8).
fn wrapped<S: Scheme<f32> + 'static>(frame: &Frame, span: &Span) -> Box<dyn Software> {
    let line = Line::new(frame, span);
    let serves = wrap::serves(line.face, &line.vertices);
    if serves { looped::<S>(frame, span) } else { looped::<Phong<f32>>(frame, span) }
}
