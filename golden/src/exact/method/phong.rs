//! Exact Phong shading, and the method `phong`.
use glam::DVec3;
use specula_scene::{Frame, Span};
use specula_spec::PhongSpec;
use specula_spec::phong::{Highlight, Places};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use super::directions::Directions;
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::distributions::{torrance_sparrow, trowbridge_reitz};
use crate::exact::formula::illumination::Illumination;
use crate::exact::formula::normalisation::unit;
use crate::exact::formula::shape::power;

/// Exact shading of one span. The normal is interpolated linearly between the triangle's vertices
/// and normalised at each pixel; the shade is ambient + Σ kd max(N·L, 0) + ks max(R·L, 0)^n with R
/// = 2(N·V)N - V [methods A3, A5, B1]. A spec may ask for one of Blinn's lobes in place of the last
/// term, and for wrapped directions.
///
/// Exact shading interpolates perspective-correctly at every pixel, a spec's method as the span's
/// ends say and linearly between them.
pub struct PhongSpan<'a> {
    frame: &'a Frame,
    span: &'a Span,
    directions: Directions<'a>,
    highlight: Highlight,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> PhongSpan<'a> {
    /// Sets up a span of a frame for Phong's own highlight and true directions.
    pub fn new(frame: &'a Frame, span: &'a Span) -> Self {
        let directions = Directions::new(frame, span, Places::Exact, Frame::seen_weights);
        PhongSpan::with(Highlight::Reflection, directions, frame, span)
    }

    /// Sets up a span of a frame for the highlight and the directions that a spec asks for.
    pub fn of_spec(spec: &PhongSpec, frame: &'a Frame, span: &'a Span) -> Self {
        let directions = Directions::new(frame, span, spec.places, |_, span, i| span.weights(i));
        PhongSpan::with(spec.highlight, directions, frame, span)
    }

    fn with(
        highlight: Highlight,
        directions: Directions<'a>,
        frame: &'a Frame,
        span: &'a Span,
    ) -> Self {
        let shininess = frame.material(span).shininess;
        PhongSpan {
            frame,
            span,
            directions,
            highlight,
            shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// Pixel `i`, from 0 to length - 1: 0..=255 LSB a channel. Where the interpolated normal
    /// vanishes, there is only ambient light.
    pub fn pixel(&self, i: u32) -> [f64; 3] {
        match unit(self.frame.normal_at(self.span, self.directions.at(i))) {
            Some(normal) => self.pixel_with(normal, i),
            None => self.coefficients.sum(|_| Amounts::default()),
        }
    }

    /// Pixel `i` with another unit normal in place of the interpolated one.
    pub fn pixel_with(&self, normal: DVec3, i: u32) -> [f64; 3] {
        let view = self.directions.view(i);
        let amounts = |light: Option<Illumination>| match light {
            Some(Illumination { direction, share }) => Amounts {
                diffuse: share * lambert(normal, direction),
                specular: share * view.map_or(0.0, |view| self.highlight(normal, direction, view)),
            },
            None => Amounts::default(),
        };
        self.coefficients.sum_of(self.directions.lights(i).map(amounts))
    }

    fn highlight(&self, normal: DVec3, light: DVec3, view: DVec3) -> f64 {
        match self.highlight {
            Highlight::Reflection => {
                power(2.0 * normal.dot(view) * normal.dot(light) - view.dot(light), self.shininess)
            }
            Highlight::Blinn => power(cosine_to_halfway(normal, light, view), 4 * self.shininess),
            Highlight::TorranceSparrow => {
                torrance_sparrow(cosine_to_halfway(normal, light, view), f64::from(self.shininess))
            }
            Highlight::TrowbridgeReitz => {
                trowbridge_reitz(cosine_to_halfway(normal, light, view), f64::from(self.shininess))
            }
        }
    }
}

impl ShadeSpan for PhongSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        PhongSpan::pixel(self, i)
    }
}

/// The largest 1/|L + V|: the `gain` of the core has 4 integer bits.
const LARGEST_GAIN: f64 = 16.0;

/// H*·N with H* = (L + V)/|L + V|. H* is too short where |L + V| < 1/16, down to 0 for L = -V
/// (extremes row 12).
pub fn cosine_to_halfway(normal: DVec3, light: DVec3, view: DVec3) -> f64 {
    let halfway = light + view;
    let gain = halfway.length().recip().min(LARGEST_GAIN);
    (gain * halfway).dot(normal)
}
