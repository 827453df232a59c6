//! Lyon's method without rounding [Lyon, TR 43; methods B].
use glam::DVec3;
use specula_scene::frame::{EYE, Spot};
use specula_scene::{Frame, Span, Wrap};
use specula_spec::LyonSpec;
use specula_spec::lyon::{Difference, Halfway, NormalWrap, Normals};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::illumination::Illumination;
use crate::exact::formula::normalisation::{g2, gain, unit};
use crate::exact::formula::point_light;
use crate::exact::formula::reflection::{projection, reflected_minus};
use crate::exact::formula::shape::lobe;
use crate::exact::formula::wrap::{chained, wrap};

/// How the normal of a span is computed.
enum Path {
    /// The same normal at every pixel.
    Flat(DVec3),
    /// N0 and N1 - N0.
    Linear { start: DVec3, delta: DVec3 },
    /// The same vectors for unit ends; the interpolated normal is wrapped around the axis.
    Wrapped { start: DVec3, delta: DVec3, axis: DVec3 },
    /// The normal of each pixel, wrapped around the previous one.
    Chained(Vec<DVec3>),
}

impl Path {
    fn new(spec: &LyonSpec, frame: &Frame, span: &Span) -> Path {
        match spec.normals {
            Normals::Flat => Path::Flat(frame.facet_normal(span)),
            Normals::Linear => {
                let [start, end] = frame.end_normals(span);
                Path::Linear { start, delta: end - start }
            }
            Normals::Wrapped => {
                let NormalWrap { wrap: Wrap { ends: [start, end], axis }, follows } =
                    spec.wrap(frame, span);
                let normals = (0..span.length).map(|i| start.lerp(end, span.parameter(i)));
                if follows {
                    Path::Chained(chained(axis, normals).collect())
                } else {
                    Path::Wrapped { start, delta: end - start, axis }
                }
            }
        }
    }
}

/// One span, shaded by `lyon`.
pub struct LyonSpan<'a> {
    spec: &'a LyonSpec,
    frame: &'a Frame,
    span: &'a Span,
    path: Path,
    half_shininess: f64,
    coefficients: Coefficients,
}

impl<'a> LyonSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a LyonSpec, frame: &'a Frame, span: &'a Span) -> Self {
        LyonSpan {
            spec,
            frame,
            span,
            path: Path::new(spec, frame, span),
            half_shininess: f64::from(frame.material(span).shininess) / 2.0,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// The normal n, of a length about 1.
    pub fn normal(&self, i: u32) -> DVec3 {
        let t = self.span.parameter(i);
        match self.path {
            Path::Flat(normal) => normal,
            Path::Chained(ref normals) => normals[i as usize],
            Path::Linear { start, delta } => {
                let interpolated = start + t * delta;
                gain(self.spec, interpolated.length_squared()) * interpolated
            }
            // Without any direction, everything is 0.
            Path::Wrapped { start, delta, axis } => {
                wrap(axis, start + t * delta).unwrap_or(DVec3::ZERO)
            }
        }
    }

    /// A way to a `place` at pixel `i`, brought near unit length as normals are; `None` for one
    /// without direction.
    fn towards(&self, place: DVec3, i: u32) -> Option<DVec3> {
        let [start, end] = self.frame.end_vectors_to(self.span, place);
        let way = start.lerp(end, self.span.parameter(i));
        (way != DVec3::ZERO).then(|| gain(self.spec, way.length_squared()) * way)
    }

    /// L of every light and what a spot leaves of it, those at infinity first.
    fn lights(&self, i: u32) -> impl Iterator<Item = Option<Illumination>> {
        let at_infinity = self
            .frame
            .lights
            .iter()
            .map(|light| Some(Illumination { direction: light.direction, share: 1.0 }));
        at_infinity.chain(self.frame.local_lights.iter().map(move |light| {
            let direction = self.towards(light.position, i)?;
            let of_spot = |spot: &Spot| point_light::spot(-spot.axis, direction, spot.exponent);
            Some(Illumination { direction, share: light.spot.as_ref().map_or(1.0, of_spot) })
        }))
    }

    /// (1 - x/K)^K of D; 0 where the normal vanishes and has no direction (extremes row 1).
    fn highlight(&self, normal: DVec3, light: DVec3, view: DVec3) -> f64 {
        if normal == DVec3::ZERO {
            return 0.0;
        }
        let about_unit = unit_halfway(self.spec.halfway, light + view);
        let (difference, half_exponent) = match (self.spec.difference, about_unit) {
            (Difference::ReflectionMinusLight, _) => {
                (reflected_minus(normal, view, light), self.half_shininess)
            }
            (Difference::LightReflection, _) => {
                (reflected_minus(normal, light, view), self.half_shininess)
            }
            (Difference::HalfwayProjection, _) => {
                (projection(normal, light + view), self.half_shininess)
            }
            (Difference::HalfwayCrossNormal, _) => {
                ((light + view).cross(normal), self.half_shininess)
            }
            (Difference::UnitHalfwayMinusNormal, Some(h)) => {
                (h - normal, 4.0 * self.half_shininess)
            }
            (Difference::UnitHalfwayProjection, Some(h)) => {
                (projection(normal, h), 4.0 * self.half_shininess)
            }
            (Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection, None) => {
                return 0.0;
            }
        };
        lobe(half_exponent * difference.length_squared(), self.spec.terms())
    }
}

/// A half-way vector of about unit length, of H = L + V [methods B6, B7]; `None` for L = -V, where
/// it has no direction (extremes row 12).
fn unit_halfway(kind: Halfway, sum: DVec3) -> Option<DVec3> {
    let h = sum / 2.0;
    match kind {
        Halfway::Unit => unit(h),
        Halfway::Half => Some(h),
        Halfway::HalfG2 => Some(g2(h.length_squared()) * h),
    }
}

impl ShadeSpan for LyonSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.normal(i);
        let view = self.frame.eye.map_or(Some(EYE), |eye| self.towards(eye, i));
        self.coefficients.sum_of(self.lights(i).map(|light| match light {
            Some(Illumination { direction, share }) => Amounts {
                diffuse: share * lambert(normal, direction),
                specular: view.map_or(0.0, |view| share * self.highlight(normal, direction, view)),
            },
            None => Amounts::default(),
        }))
    }
}
