//! The loops, by name.
use specula_scene::{Frame, Span};

use super::arc_edges::ArcEdges;
use super::looped::Loop;
use super::placed::PlacedLoop;
use super::set_up::{
    Always, Arcs, DiffuseVertices, DiffuseVerticesFromMiddle, Each, FromMiddle, Polygons, Serves,
    Vertices, Where, Wraps,
};
use super::{Mesh, OfMesh};
use crate::loops::{
    Blinn, Chained, Chebyshev, Consistent, ConsistentNormal, Direct, DuffBlinn, DuffHybrid,
    DuffQuotient, DuffRoot, FastPhong, FrameSlerp, Half, HalfG2, LyonCross, LyonLightReflection,
    LyonNormal, LyonProjection, LyonReflection, Normalised, Phong, PlaceDirection, Rational,
    ReflectionBlinn, ReflectionHybrid, ReflectionRoot, Scheme, Slerp, Sum, TorranceSparrow,
    Trigonometric, TrowbridgeReitz, Unit, Wrapped,
};

/// A method of docs/methods.md in software.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name.
    pub name: &'static str,
    /// The places of lights and eye for which it is of use.
    pub places: Places,
    /// Computes what belongs to a frame.
    pub of_mesh: OfMesh,
}

/// The places of lights and eye for which a loop is of use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Places {
    /// Lights and eye at places, with directions computed at each pixel; without places another
    /// loop does the same.
    Local,
    /// Lights and eye at infinity.
    Infinite,
    /// Lights and eye anywhere. Directions to those at places are computed before the loop: at
    /// vertices, at polygons, or in the middle of each span.
    Any,
}

impl Method {
    /// Whether it shades a frame, and no other loop does the same with it.
    pub fn serves(&self, frame: &Frame) -> bool {
        match self.places {
            Places::Local => !frame.directions_are_constant(),
            Places::Infinite => frame.directions_are_constant(),
            Places::Any => true,
        }
    }

    /// Shades one span of a frame by itself.
    pub fn shade(&self, frame: &Frame, span: &Span, out: &mut [[f32; 3]]) {
        let mesh = Mesh::of(frame);
        let mut software = (self.of_mesh)(&mesh);
        software.set_up(std::slice::from_ref(span));
        software.shade(0, out);
    }
}

/// Every method.
pub const METHODS: [Method; 40] = [
    anywhere("uniform", |mesh| Box::new(Loop::<Polygons>::new(mesh))),
    anywhere("gouraud", |mesh| Box::new(Loop::<Vertices>::new(mesh))),
    method::<Phong<f32>>("phong"),
    method::<Blinn<f32>>("phong-blinn"),
    method::<TorranceSparrow<f32>>("phong-torrance-sparrow"),
    method::<TrowbridgeReitz<f32>>("phong-trowbridge-reitz"),
    placed::<Normalised<f32>>("phong-places"),
    placed::<Wrapped<f32>>("phong-wrapped-places"),
    method::<FastPhong<f32, 1>>("fast-phong"),
    method::<FastPhong<f32, 2>>("fast-phong-2"),
    arc::<Slerp<f32>>("slerp"),
    Method {
        name: "slerp-edges",
        places: Places::Infinite,
        of_mesh: |mesh| Box::new(Loop::<ArcEdges<Slerp<f32>>>::new(mesh)),
    },
    arc::<FrameSlerp<f32>>("slerp-frame"),
    arc::<Chebyshev<f32>>("chebyshev"),
    method::<LyonCross<f32>>("lyon"),
    method::<LyonReflection<f32, 4>>("lyon-reflection"),
    method::<LyonReflection<f32, 2>>("lyon-reflection-1"),
    method::<LyonReflection<f32, 1>>("lyon-reflection-0"),
    method::<LyonReflection<f32, 3>>("lyon-reflection-cubed"),
    method::<LyonLightReflection<f32>>("lyon-light-reflection"),
    method::<LyonProjection<f32, Sum, 4>>("lyon-projection"),
    method::<LyonProjection<f32, Unit, 4>>("lyon-unit-projection"),
    method::<LyonProjection<f32, Half, 4>>("lyon-half-projection"),
    method::<LyonProjection<f32, HalfG2, 4>>("lyon-half-g2-projection"),
    method::<LyonProjection<f32, HalfG2, 2>>("lyon-half-g2-projection-1"),
    method::<LyonNormal<f32, Unit>>("lyon-unit-normal"),
    method::<LyonNormal<f32, HalfG2>>("lyon-half-g2-normal"),
    method::<DuffRoot<f32>>("duff"),
    method::<DuffBlinn<f32>>("duff-blinn"),
    method::<DuffHybrid<f32>>("duff-hybrid"),
    method::<DuffQuotient<f32>>("duff-quotient"),
    method::<Direct<f32>>("direct"),
    anywhere("hybrid", |mesh| {
        if mesh.frame.directions_are_constant() {
            Box::new(Loop::<DiffuseVertices>::new(mesh))
        } else {
            Box::new(Loop::<DiffuseVerticesFromMiddle>::new(mesh))
        }
    }),
    wrapped::<ReflectionRoot<f32>>("reflection"),
    wrapped::<ReflectionBlinn<f32>>("reflection-blinn"),
    wrapped::<ReflectionHybrid<f32>>("reflection-hybrid"),
    method::<Chained<f32>>("reflection-chained"),
    method::<Consistent<f32, Rational>>("consistent"),
    method::<Consistent<f32, Trigonometric>>("consistent-trigonometric"),
    method::<ConsistentNormal<f32, Rational>>("consistent-normal"),
];

/// The method with that name.
pub fn by_name(name: &str) -> Option<Method> {
    METHODS.into_iter().find(|method| method.name == name)
}

const fn anywhere(name: &'static str, of_mesh: OfMesh) -> Method {
    Method { name, places: Places::Any, of_mesh }
}

const fn method<S: Scheme<f32> + 'static>(name: &'static str) -> Method {
    anywhere(name, |mesh| {
        if mesh.frame.directions_are_constant() {
            Box::new(Loop::<Each<S>>::new(mesh))
        } else {
            Box::new(Loop::<FromMiddle<S, Always>>::new(mesh))
        }
    })
}

const fn placed<P: PlaceDirection<f32> + 'static>(name: &'static str) -> Method {
    Method {
        name,
        places: Places::Local,
        of_mesh: |mesh| Box::new(PlacedLoop::<P>::new(mesh.frame)),
    }
}

/// A scheme that is used where slerp can interpolate the span's end normals; Phong's chord is used
/// elsewhere.
const fn arc<S: Scheme<f32> + 'static>(name: &'static str) -> Method {
    served::<S, Arcs>(name)
}

/// A scheme that is used where the triangle can be wrapped around the polygon's normal; Phong is
/// used elsewhere.
const fn wrapped<S: Scheme<f32> + 'static>(name: &'static str) -> Method {
    served::<S, Wraps>(name)
}

const fn served<S: Scheme<f32> + 'static, W: Serves + 'static>(name: &'static str) -> Method {
    anywhere(name, |mesh| {
        if mesh.frame.directions_are_constant() {
            Box::new(Loop::<Where<S, W>>::new(mesh))
        } else {
            Box::new(Loop::<FromMiddle<S, W>>::new(mesh))
        }
    })
}
